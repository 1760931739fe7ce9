#> Figure: pushed apart
# gnuplot -c 08_nt_collisions_pushed.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(215)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key top left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-0.75:7.0]; set yrange [-1.45:1.95]
set label 'equal masses' at 0.18,-1.15 center textcolor rgb INK
set label 'masses 4 to 1' at 2.78,-1.15 center textcolor rgb INK
set label 'A is a post' at 5.38,-1.15 center textcolor rgb INK
yours = with_yours("ARG3 using 4:5:(0.4) with circles lt 2 lw 2 title 'yours'")
plot ARG1 using 1:2:3 with circles lc rgb DIM lw 1 dt (3,3) notitle, \
     ARG1 using 4:5:3 every 2::0 with circles lt 3 lw 2 dt solid notitle, \
     ARG1 using 4:5:3 every 2::1 with circles lt 1 lw 2 notitle, \
     ARG1 using 4:5:(sprintf('%s', int($0) % 2 == 0 ? 'A' : 'B')) with labels textcolor rgb INK notitle, \
     @yours
