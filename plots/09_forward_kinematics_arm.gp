#> Figure: an arm of two links
# gnuplot -c 09_forward_kinematics_arm.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key bottom right
set xrange [-0.5:5.6]; set yrange [-0.6:3.9]
set label 'first joint' at 0.05,-0.33 left textcolor rgb INK
set label 'elbow' at 2.75,1.32 left textcolor rgb INK
set label 'hand' at 3.3,3.5 left textcolor rgb INK
set label '3 m' at 1.05,1.05 right textcolor lt 1
set label '2 m' at 2.62,2.55 right textcolor lt 1
set label '30°' at 1.25,0.3 left textcolor lt 6
set label '45°' at 3.35,2.35 left textcolor lt 6
yours = with_yours("ARG3 using 1:2 with linespoints lt 2 pt 6 ps 1.8 title 'yours'")
plot '+' using (5.2 * $0 / 199):(0) with lines lc rgb DIM lw 1 dt solid notitle, \
     '+' using (2.598 + 2.0 * $0 / 199):(1.5 + 1.1547 * $0 / 199) with lines lc rgb DIM lw 1 dt (4,4) notitle, \
     '+' using (1.1 * cos(pi / 6 * $0 / 199)):(1.1 * sin(pi / 6 * $0 / 199)) with lines lt 6 lw 1.5 dt solid notitle, \
     '+' using (2.598 + cos(pi / 6 + pi / 4 * $0 / 199)):(1.5 + sin(pi / 6 + pi / 4 * $0 / 199)) with lines lt 6 lw 1.5 dt solid notitle, \
     ARG1 using 1:2 with linespoints lt 1 lw 4 ps 1.3 notitle, \
     @yours
