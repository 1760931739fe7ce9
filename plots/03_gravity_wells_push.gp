#> Figure: five pushes
# gnuplot -c 03_gravity_wells_push.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(440)
set output ARG2
set size ratio -1
set key bottom right
set xrange [-21:11]; set yrange [-15:15]
set xtics 5; set ytics 5
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'ship' at 8.4,-0.9 left
set label '5 m/s' at 1.2,1.7 left textcolor lt 4
set label '7' at -2.0,5.4 left textcolor lt 3
set label '10' at -6.0,7.1 right textcolor lt 1
set label '12' at -10.5,9.8 right textcolor lt 5
set label 'still faster' at -8.5,13.8 right textcolor lt 6
yours = with_yours("for [k = 1:5] ARG3 using (column(2 * k - 1)):(column(2 * k)) every 4 with points lt 2 pt 6 ps 0.6 lw 1.5 title (k == 1 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 4 notitle, \
     ARG1 using 3:4 with lines lt 3 notitle, \
     ARG1 using 5:6 with lines lt 1 notitle, \
     ARG1 using 7:8 with lines lt 5 notitle, \
     ARG1 using 9:10 with lines lt 6 notitle, \
     '+' using (0):(0) every ::0::0 with points lc rgb INK pt 7 ps 1.4 notitle, \
     '+' using (8):(0) every ::0::0 with points lc rgb INK pt 9 ps 1.2 notitle, \
     @yours
