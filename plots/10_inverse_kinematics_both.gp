#> Figure: two arms with one hand
# gnuplot -c 10_inverse_kinematics_both.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key bottom right
set xrange [-3.3:5.6]; set yrange [-3.15:4.15]
set label 'first joint' at -0.1,-0.45 center textcolor rgb INK
set label 'elbow, at (3, 0)' at 3.2,-0.45 left textcolor lt 1
set label 'and the other one' at 0.75,3.25 right textcolor lt 3
set label 'hand' at 3.25,2.12 left textcolor rgb INK
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.8 title 'yours'")
plot '+' using (3 * cos(2 * pi * $0 / 199)):(3 * sin(2 * pi * $0 / 199)) with lines lc rgb DIM lw 1 dt (4,4) notitle, \
     '+' using (3 + 2 * cos(2 * pi * $0 / 199)):(2 + 2 * sin(2 * pi * $0 / 199)) with lines lc rgb DIM lw 1 dt (4,4) notitle, \
     ARG1 using 1:2 every :::1::1 with linespoints lt 3 lw 4 ps 1.5 notitle, \
     ARG1 using 1:2 every :::0::0 with linespoints lt 1 lw 4 ps 1.3 notitle, \
     @yours
