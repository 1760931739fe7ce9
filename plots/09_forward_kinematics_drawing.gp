#> Figure: what the hand draws
# gnuplot -c 09_forward_kinematics_drawing.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
set key center center
set size ratio -1
set xrange [-5.4:5.4]; set yrange [-5.4:5.4]
set xtics 2; set ytics 2
set xlabel 'x [m]'; set ylabel 'y [m]'
yours = with_yours("ARG3 using 1:2 every 6 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     @yours
