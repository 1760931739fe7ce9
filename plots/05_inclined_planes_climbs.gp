#> Figure: up and back
# gnuplot -c 05_inclined_planes_climbs.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set key top right
set lmargin 7
set xrange [0:5]; set yrange [0:500]
set xtics 1; set ytics 100
set xlabel 'up the board [m]'; set ylabel 'kinetic energy [J]'
set label 'up' at 2.6,250 left textcolor lt 1
set label 'back' at 1.3,135 left textcolor lt 3
set label 'lost' at 0.2,280 left textcolor rgb DIM
set arrow from 0.12,445 to 0.12,125 lc rgb DIM lw 1.5 dt solid
yours = with_yours("for [k = 2:3] ARG3 using 1:(column(k)) every 2 with points lt 2 pt 6 ps 0.9 lw 1.5 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 1:3 with lines lt 3 notitle, \
     @yours
