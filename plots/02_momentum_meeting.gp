#> Figure: two carts meet
# gnuplot -c 02_momentum_meeting.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key top left
set xrange [0:2.4]; set yrange [0:12]
set xtics 0.5; set ytics 2
set xlabel 't [s]'; set ylabel 'x [m]'
set label 'A: 4 m/s' at 0.48,2.6 left textcolor lt 1
set label 'B: −2 m/s' at 0.3,8.8 left textcolor lt 3
set label '−3.2 m/s' at 1.65,2.3 right textcolor lt 1
set label '2.8 m/s' at 1.65,9.6 right textcolor lt 3
yours = with_yours("for [column = 2:3] ARG3 using 1:column with points lt 2 pt 6 ps 1.2 lw 2 title (column == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with linespoints lt 1 ps 0.5 notitle, \
     ARG1 using 1:3 with linespoints lt 3 ps 0.6 notitle, \
     @yours
