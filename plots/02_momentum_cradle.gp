#> Figure: five carts in space and time
# gnuplot -c 02_momentum_cradle.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key bottom right
set xrange [0:2.5]; set yrange [-0.6:12.4]
set xtics 0.5; set ytics 2
set xlabel 't [s]'; set ylabel 'x [m]'
set label 'cart 5' at 1.45,9.6 right textcolor lt 6
set label 'cart 4' at 1.75,7.3 left textcolor lt 4
set label 'cart 3' at 1.75,5.6 left textcolor lt 3
set label 'cart 2' at 0.08,2.9 left textcolor lt 5
set label 'cart 1' at 0.42,0.4 left textcolor lt 1
yours = with_yours("for [column = 2:6] ARG3 using 1:column with points lt 2 pt 6 ps 1 lw 2 title (column == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with linespoints lt 1 ps 0.4 notitle, \
     ARG1 using 1:3 with linespoints lt 5 ps 0.4 notitle, \
     ARG1 using 1:4 with linespoints lt 3 ps 0.4 notitle, \
     ARG1 using 1:5 with linespoints lt 4 ps 0.4 notitle, \
     ARG1 using 1:6 with linespoints lt 6 ps 0.4 notitle, \
     @yours
