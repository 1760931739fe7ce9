#> Figure: the last frames of a fall
# gnuplot -c 03_gravity_wells_fall.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set lmargin 7
set key top right
set xrange [25.5:33.6]; set yrange [-38:160]
set xtics 1; set ytics 50
set xlabel 't [frames]'; set ylabel 'height [px]'
set label 'the floor' at 25.7,-9 left textcolor rgb DIM
set label 'as printed: 17 px below' at 32.3,-29 right textcolor lt 6
set label "exact: lands\nat 30.95" at 31.5,62 left textcolor lt 1
yours = with_yours("ARG3 using 1:3 with points lt 2 pt 6 ps 1.4 lw 2 title 'yours'")
plot 0 with lines lc rgb DIM lw 2 dt solid notitle, \
     ARG1 using 1:2 with linespoints lt 6 ps 0.7 notitle, \
     ARG1 using 1:3 with points lt 1 ps 0.8 notitle, \
     [25:30.9516] 479 - x**2 / 2 with lines lt 1 notitle, \
     @yours
