#> Figure: two cameras on two screens
# gnuplot -c 12_time_based_motion_cameras.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set lmargin 6
set xrange [0:1]; set yrange [0:10]
set xtics 0.2; set ytics 2
set xlabel 'time [s]'; set ylabel 'left to the target [m]'
set label "a tenth a frame,\n30 Hz" at 0.42,4.6 left textcolor lt 4
set label "a tenth a frame, 144 Hz" at 0.24,8.9 left textcolor lt 6
set label 'by half-life, on both' at 0.22,6.9 left textcolor lt 1
set arrow from 0.23,8.9 to 0.025,7.4 nohead lc rgb DIM lw 0.8 dt solid
set arrow from 0.21,6.9 to 0.06,6.7 nohead lc rgb DIM lw 0.8 dt solid
yours = with_yours("ARG3 index 0 using 2:4 every 2 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 index 0 using 2:3 with lines lt 4 lw 2.5 notitle, \
     ARG1 index 1 using 2:3 with lines lt 6 notitle, \
     ARG1 index 1 using 2:4 with lines lt 1 notitle, \
     ARG1 index 0 using 2:4 with points lt 1 pt 7 ps 0.5 notitle, \
     @yours
