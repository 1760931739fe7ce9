#> Figure: equal areas, equal numbers
# gnuplot -c 11_particles_density.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key outside top center horizontal
set xrange [0:1]; set yrange [0:5.4]
set xtics 0.2; set ytics 1
set xlabel 'fraction of the area inside: (speed / maximum)²'; set ylabel 'density / average density' offset 1,0
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 4 ps 1 title 'yours'")
plot 1 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     1 / (2 * sqrt(x)) with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using 1:4 with impulses lt 5 lw 2 title 'as printed', \
     ARG1 using 1:3 with points lt 6 ps 0.6 title 'random speed', \
     ARG1 using 1:2 with points lt 1 ps 0.7 title 'spread evenly', \
     @yours
