#> Figure: three screens
# gnuplot -c 12_time_based_motion_screens.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
set lmargin 6.5
set xrange [0:0.5]; set yrange [0:110]
set xtics 0.1; set ytics 20
set xlabel 'time [s]'; set ylabel 'x [px]'
set label '2 px a frame, 144 Hz' at 0.335,104 right textcolor lt 6
set label 'by dt, all three' at 0.49,32 right textcolor lt 1
set label '2 px a frame, 10 Hz' at 0.49,15 right textcolor lt 4
yours = with_yours("ARG3 index 1 using 2:3 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 index 2 using 2:4 with lines lt 6 notitle, \
     ARG1 index 0 using 2:4 with lines lt 4 notitle, \
     ARG1 index 0 using 2:3 with steps lt 1 lw 2.5 notitle, \
     ARG1 index 1 using 2:3 with steps lt 3 dt solid lw 1.5 notitle, \
     ARG1 index 2 using 2:3 with steps lt 5 dt solid lw 1 notitle, \
     @yours
