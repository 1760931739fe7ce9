#> Figure: two paths of a puck
# gnuplot -c 05_inclined_planes_turns.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set key bottom right
set lmargin 5
set size ratio -1
set xrange [-1:7]; set yrange [0:10]
set xtics 2; set ytics 2
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'straight on' at 2.6,9 left textcolor lt 1
set label 'per axis' at 0.2,7.4 right textcolor lt 6
yours = with_yours("ARG3 using 1:2 every 2 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot ARG1 using 3:4 with lines lt 6 notitle, \
     ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 3:4 every ::40 with points lt 6 ps 1.2 notitle, \
     ARG1 using 1:2 every ::40 with points lt 1 ps 1.2 notitle, \
     @yours
