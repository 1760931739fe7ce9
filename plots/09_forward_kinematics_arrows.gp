#> Figure: how the hand moves
# gnuplot -c 09_forward_kinematics_arrows.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key top left
set xrange [-4.3:10.2]; set yrange [-1.5:8.6]
set label 'bent by 90°' at 0.3,-0.9 center textcolor rgb INK
set label 'straight' at 6.8,-0.9 center textcolor rgb INK
set label 'by the first joint' at -4.1,5.2 left textcolor lt 6
set label "by the\nelbow" at 0.1,1.75 right textcolor lt 3
yours = with_yours("for [i = 0:1] ARG3 index i using ($1 + 6 * i):2:3:4 every ::2::2 with vectors lt 2 lw 2 title (i == 0 ? 'yours' : ''), for [i = 0:1] ARG3 index i using ($1 + 6 * i):2:5:6 every ::2::2 with vectors lt 2 lw 2 notitle")
plot for [i = 0:1] ARG1 index i using ($1 + 6 * i):2 with linespoints lt 1 lw 3 ps 1.2 notitle, \
     for [i = 0:1] ARG1 index i using ($1 + 6 * i):2:3:4 every ::2::2 with vectors lt 6 lw 2.5 dt solid notitle, \
     for [i = 0:1] ARG1 index i using ($1 + 6 * i):2:5:6 every ::2::2 with vectors lt 3 lw 2.5 dt solid notitle, \
     @yours
