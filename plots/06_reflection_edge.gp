#> Figure: at the edge
# gnuplot -c 06_reflection_edge.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(280)
set output ARG2
set key bottom left
set lmargin 7.5
set xrange [0:10]; set yrange [58:116]
set xtics 2; set ytics 20
set xlabel 'frame'; set ylabel 'x [px]'
set label 'the edge' at 9.9,96.5 right textcolor rgb DIM
set label 'as printed' at 5,112 center textcolor lt 6
set label 'only if it approaches' at 5.3,84 left textcolor lt 1
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot 100 with lines lc rgb DIM lw 1 dt solid notitle, \
     ARG1 using 1:3 with linespoints lt 6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 notitle, \
     @yours
