#> Figure: two ways to a target
# gnuplot -c 04_trajectories_aimed.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(260)
set output ARG2
set key top left
set size ratio -1
set xrange [0:50]; set yrange [0:29]
set xtics 10; set ytics 10
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'target' at 41.2,16.6 left
set label '64.3°' at 9,18.6 right textcolor lt 5
set label '46.2°' at 23,13.6 left textcolor lt 3
yours = with_yours("for [k = 1:2] ARG3 using (column(2 * k - 1)):(column(2 * k)) every 2 with points lt 2 pt 6 ps 0.8 lw 1.5 title (k == 1 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 3 notitle, \
     ARG1 using 3:4 with lines lt 5 notitle, \
     '+' using (40):(15) every ::0::0 with points lc rgb INK pt 7 ps 1.2 notitle, \
     @yours
