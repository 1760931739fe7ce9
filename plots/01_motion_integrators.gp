#> Figure: three integrators
# gnuplot -c 01_motion_integrators.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set lmargin 7
set key top left
set xrange [-0.2:8.7]; set yrange [*<45:105<*]
set xtics 0,1,5
set xlabel 't [s]'; set ylabel 'x [m]'
set label 'semi-implicit Euler' at 5.25,100 textcolor lt 3
set label 'exact' at 5.25,95 textcolor lt 1
set label 'explicit Euler' at 5.25,90 textcolor lt 6
yours = with_yours("for [column = 2:4] ARG3 using 1:column with points lt 2 pt 6 ps 1.4 lw 2 title (column == 2 ? 'yours' : '')")
plot ARG1 using 1:3 with linespoints lt 3 dt solid ps 0.9 notitle, \
     [0:5] 50 + 4 * x + x**2 with lines lc rgb INK lw 1 notitle, \
     ARG1 using 1:4 with points lt 1 ps 0.8 notitle, \
     ARG1 using 1:2 with linespoints lt 6 dt solid ps 0.8 notitle, \
     @yours
