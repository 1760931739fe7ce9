#> Figure: two carts meet
# gnuplot -c 02_momentum_meeting.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key off
set xrange [0:2.4]; set yrange [0:12]
set xtics 0.5; set ytics 2
set xlabel 't [s]'; set ylabel 'x [m]'
set label 'A, 2 kg' at 0.5,2.6 left textcolor lt 1
set label 'B, 3 kg' at 0.5,8.5 left textcolor lt 3
set label '4 m/s' at 0.5,1.6 left textcolor lt 1
set label '−2 m/s' at 0.95,7.6 left textcolor lt 3
set label '−3.2 m/s' at 1.62,3.1 left textcolor lt 1
set label '2.8 m/s' at 1.62,9.4 right textcolor lt 3
yours = with_yours("for [column = 2:3] ARG3 using 1:column with points lt 2 pt 6 ps 0.8 title ''")
plot ARG1 using 1:2 with linespoints lt 1 pt 7 ps 0.5, \
     ARG1 using 1:3 with linespoints lt 3 pt 9 ps 0.5, \
     @yours
