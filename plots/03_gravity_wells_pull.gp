#> Figure: the pull, softened
# gnuplot -c 03_gravity_wells_pull.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set lmargin 7
set key top right
set xrange [0:10]; set yrange [0:160]
set xtics 2; set ytics 50
set xlabel 'distance [m]'; set ylabel 'pull [m/s²]'
set label 'not softened' at 2.6,140 left textcolor lt 6
set label 'softened by 2 m' at 0.9,22 left textcolor lt 1
yours = with_yours("ARG3 using 1:2 every 2 with points lt 2 pt 6 ps 1 lw 2 title 'yours'")
plot [0:10] 800 / x**2 with lines lt 6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 ps 0.4 notitle, \
     @yours
