#> Figure: the error and the length of a step
# gnuplot -c 01_motion_error.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
set logscale xy
set lmargin 8
set key at graph 0.99,0.65 right
set format xy '10^{%T}'
set xrange [1e-5:5]; set yrange [1e-15:1e3]
set xtics 1e-4,100,1; set ytics 1e-15,1e3,1e3
set xlabel 'length of a step, dt [s]'; set ylabel 'error after 5 s [m]'
set label 'slope 1' at 5e-5,3e-1 textcolor rgb DIM
set label 'exact step: rounding alone' at 1.5e-5,5e-15 textcolor lt 1
yours = with_yours("for [column = 2:4] ARG3 using 1:column with points lt 2 pt 4 ps 0.9 title (column == 2 ? 'yours' : '')")
plot 24.5 * x with lines lc rgb DIM lw 1 dt (5,4) title 'by hand: 24.5 m/s · dt', \
     ARG1 using 1:2 with points lt 6 pt 6 ps 1.1 title 'explicit Euler', \
     ARG1 using 1:3 with points lt 3 ps 0.5 title 'semi-implicit Euler', \
     ARG1 using 1:4 with points lt 1 ps 0.6 notitle, \
     @yours
