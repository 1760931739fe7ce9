#> Figure: an arm with another base
# gnuplot -c 09_forward_kinematics_base.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
set lmargin 3.5
set size ratio -1
set key top right
set xrange [-11:15]; set yrange [-1:14.5]
set xtics 5; set ytics 5
unset xlabel; unset ylabel
set label 'as printed' at -2.5,13.0 left textcolor lt 6
set label 'base' at 10.7,0.3 left textcolor rgb INK
set label 'hand' at 7.9,5.7 right textcolor lt 1
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.8 title 'yours'")
plot ARG1 using 3:4 with linespoints lt 6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 lw 3 notitle, \
     @yours
