#> Figure: a jump on three screens
# gnuplot -c 12_time_based_motion_jumps.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set lmargin 7.5
set xrange [0:0.8]; set yrange [0:1.3]
set xtics 0.2; set ytics 0.25
set xlabel 'time [s]'; set ylabel 'height [m]'
set label '144 Hz' at 0.26,1.17 right textcolor lt 6
set label '30 Hz' at 0.45,1.07 left textcolor lt 3
set label '10 Hz' at 0.3,0.73 center textcolor lt 4
yours = with_yours("ARG3 index 1 using 2:4 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours, in steps'")
plot ARG1 index 0 using 2:3 with linespoints lt 4 pt 13 ps 0.8 notitle, \
     ARG1 index 1 using 2:3 with lines lt 3 notitle, \
     ARG1 index 2 using 2:3 with lines lt 6 notitle, \
     @yours
