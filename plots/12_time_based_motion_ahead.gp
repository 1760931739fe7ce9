#> Figure: looking back and looking ahead
# gnuplot -c 12_time_based_motion_ahead.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set lmargin 7
set key top right
set xrange [0.66:0.8]; set yrange [-0.09:0.4]
set xtics 0.05; set ytics 0.1
set xlabel 'time [s]'; set ylabel 'height [m]'
set arrow from graph 0, first 0 to graph 1, first 0 nohead lc rgb DIM lw 1.5 dt solid
set label 'the ground' at 0.665,-0.03 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:3 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours, back'")
plot ARG1 using 1:4 with linespoints lt 6 pt 15 ps 0.5 title 'looking ahead', \
     ARG1 using 1:2 with steps lt 4 title 'the last step', \
     ARG1 using 1:3 with linespoints lt 1 pt 7 ps 0.5 title ours('looking back'), \
     @yours
