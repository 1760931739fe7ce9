#> Figure: momentum after the collision, against restitution
# gnuplot -c 08_nt_collisions_momentum.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(290)
set output ARG2
set key at 0.34,4.6
set lmargin 6
set xrange [0:1.02]; set yrange [0:9]
set xtics 0.25; set ytics 2
set xlabel 'restitution'; set ylabel 'momentum [N s]'
set label 'as printed' at 0.42,6.2 left textcolor lt 6
set label 'as before the collision' at 0.3,1.3 left textcolor lt 1
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.2 lw 2 title 'yours'")
plot ARG1 using 1:3 with linespoints lt 6 ps 0.6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 ps 0.6 notitle, \
     @yours
