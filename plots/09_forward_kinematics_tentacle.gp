#> Figure: a tentacle
# gnuplot -c 09_forward_kinematics_tentacle.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(250)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key at -0.2,4.5
set xrange [-2.5:16.5]; set yrange [-1.3:4.6]
set for [i = 0:3] label sprintf('%.1f s', 0.5 * i) at 4.5 * i + 0.3,-0.7 center textcolor rgb INK
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 0.8 lw 1.2 title 'yours'")
plot ARG1 using 1:2 with linespoints lt 1 ps 0.5 notitle, \
     @yours
