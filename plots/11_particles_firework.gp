#> Figure: a firework, coloured by life
# gnuplot -c 11_particles_firework.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set size ratio -1
set key inside left top samplen 0.5 title 'quarter of life' left
set xrange [4:48]; set yrange [0:30]
set xlabel 'x [m]'; set ylabel 'y [m]'
of_shade(k, y, shade) = shade == k ? y : NaN
yours = with_yours("ARG3 using 2:3 with points lt 2 pt 6 ps 0.5 lw 1 title 'yours'")
plot ARG1 using 2:(of_shade(0, $3, $4)) with points lt 4 pt 7 ps 0.5 title 'first', \
     ARG1 using 2:(of_shade(1, $3, $4)) with points lt 6 pt 7 ps 0.34 title 'second', \
     ARG1 using 2:(of_shade(2, $3, $4)) with points lt 5 pt 7 ps 0.22 title 'third', \
     ARG1 using 2:(of_shade(3, $3, $4)) with points lc rgb DIM pt 2 ps 0.25 lw 1 title 'last', \
     @yours
