#> Figure: what a lap takes
# gnuplot -c 12_time_based_motion_laps.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set lmargin 7.5
set xrange [0:0.7]; set yrange [15.8:16.8]
set xtics 0.1; set ytics 0.2 format '%.1f'
set format x '%.1f'
set xlabel 'a frame takes [s]'; set ylabel 'a lap takes [s]'
set label 'thrown away' at 0.3,16.45 right textcolor lt 6
set label 'kept' at 0.04,15.92 left textcolor lt 1
yours = with_yours("ARG3 using 1:3 every 6 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with points lt 6 pt 15 ps 0.35 notitle, \
     ARG1 using 1:3 with lines lt 1 lw 2.5 notitle, \
     @yours
