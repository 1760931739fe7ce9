#> Figure: error of the range, against the length of a frame
# gnuplot -c 04_trajectories_errors.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(380)
set output ARG2
set key bottom right
set lmargin 8
set logscale xy
set xrange [5e-4:0.5]; set yrange [1e-9:20]
set ytics 100
set format y '10^{%T}'; set format x '10^{%T}'
set xlabel 'length of a frame [s]'; set ylabel 'error of the range [m]'
set label 'both Eulers: slope 1' at 9e-4,0.8 left textcolor lt 6
set label "exact steps, cut by\na straight line" at 1e-2,1.2e-6 left textcolor lt 1
set label 'slope 2' at 1.5e-2,2.5e-3 right textcolor rgb DIM
yours = with_yours("for [k = 2:4] ARG3 using 1:(column(k)) with points lt 2 pt 6 ps 1.2 lw 2 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with linespoints lt 6 ps 0.6 notitle, \
     ARG1 using 1:3 with linespoints lt 3 ps 0.6 notitle, \
     ARG1 using 1:4 with linespoints lt 1 ps 0.7 notitle, \
     0.8 * x**2 with lines lc rgb DIM lw 1.5 dt (3,4) notitle, \
     @yours
