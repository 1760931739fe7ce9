#> Figure: the parts of a bounce
# gnuplot -c 06_reflection_parts.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(345)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key top left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5
set size ratio -1
set xrange [-7.4:4.6]; set yrange [-2.9:5.3]
set label 'before' at -0.25,4.4 right textcolor rgb INK
set label "normal\npart" at 1.5,4.3 left textcolor lt 6
set label "tangential\npart" at 1.5,0.45 left textcolor lt 3
set label "tangential\npart" at -0.8,-1.5 left textcolor lt 3
set label "normal part,\nreversed" at -4.1,-0.5 right textcolor lt 6
set label 'after' at -3.4,1.6 left textcolor lt 1
set label 'wall' at 3.4,2.2 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:2:3:4 every ::5 with vectors lt 2 lw 2 title 'yours'")
plot '+' using (8 * $0 / 199 - 4):(6 * $0 / 199 - 3) with lines lc rgb DIM lw 3 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::0::0 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors lt 6 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::3 with vectors lt 3 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::4::4 with vectors lt 6 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::5::5 with vectors lt 1 lw 2.5 notitle, \
     @yours
