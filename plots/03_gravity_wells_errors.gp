#> Figure: error after a quarter of a turn, against the length of a step
# gnuplot -c 03_gravity_wells_errors.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
set key bottom right
set lmargin 8
set logscale xy
set xrange [8e-5:0.03]; set yrange [1e-12:40]
set ytics 1000
set format y '10^{%T}'; set format x '10^{%T}'
set xlabel 'length of a step, of a turn'; set ylabel 'error [m]'
set label 'explicit, 1' at 1.2e-4,2.5 left textcolor lt 6
set label 'semi-implicit, 1' at 1.2e-4,6e-3 left textcolor lt 1
set label 'leapfrog, 2' at 2.2e-4,4e-6 left textcolor lt 3
set label 'Runge–Kutta, 4' at 1.6e-3,2e-9 left textcolor lt 5
yours = with_yours("for [k = 2:5] ARG3 using 1:(column(k)) with points lt 2 pt 6 ps 1.2 lw 2 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with linespoints lt 6 ps 0.6 notitle, \
     ARG1 using 1:3 with linespoints lt 1 ps 0.6 notitle, \
     ARG1 using 1:4 with linespoints lt 3 ps 0.6 notitle, \
     ARG1 using 1:5 with linespoints lt 5 ps 0.6 notitle, \
     @yours
