#> Figure: two balls that overlap, and part
# gnuplot -c 08_nt_collisions_overlap.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(280)
set output ARG2
set key top left
set lmargin 7
set xrange [0:20]; set yrange [0.7:1.25]
set xtics 5; set ytics 0.1
set xlabel 'frame'; set ylabel 'distance [m]'
set label 'they touch' at 0.4,1.03 left textcolor rgb DIM
set label 'only if they approach' at 19.8,0.955 right textcolor lt 1
set label 'as printed: they stick' at 19.8,0.86 right textcolor lt 6
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.4 lw 1.5 title 'yours'")
plot 1 with lines lc rgb DIM lw 1 dt solid notitle, \
     ARG1 using 1:3 with linespoints lt 6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 notitle, \
     @yours
