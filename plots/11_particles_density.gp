#> Figure: equal areas, equal numbers
# gnuplot -c 11_particles_density.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key outside top center horizontal
set xrange [0:1]; set yrange [0:5.4]
set xtics 0.2; set ytics 1
set xlabel 'fraction of the area inside'; set ylabel 'density / average' offset 1,0
set label "as printed" at 0.385,4.6 left textcolor lt 5
set label "random\nspeed" at 0.19,2.4 left textcolor lt 6
set label "spread\nevenly" at 0.65,1.95 left textcolor lt 1
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 4 ps 1 title 'yours'")
plot 1 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     1 / (2 * sqrt(x)) with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using 1:4 with impulses lt 5 dt solid lw 2 notitle, \
     ARG1 using 1:3 with points lt 6 ps 0.7 notitle, \
     ARG1 using 1:2 with points lt 1 ps 0.7 notitle, \
     @yours
