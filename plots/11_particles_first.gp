#> Figure: the first firework
# gnuplot -c 11_particles_first.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(410)
set output ARG2
set size ratio -1
set key outside top center horizontal samplen 0.5 width -3
set xrange [8:40]; set yrange [0:30]
set xlabel 'x [m]'; set ylabel 'y [m]'
of_shade(k, y, shade) = shade == k ? y : NaN
yours = with_yours("ARG3 using 2:3 with points lt 2 pt 6 ps 0.5 lw 1 title 'yours'")
plot ARG1 using 2:(of_shade(0, $3, $4)) with points lt 4 pt 7 ps 0.4 title 'after 0.3 s', \
     ARG1 using 2:(of_shade(1, $3, $4)) with points lt 6 pt 4 ps 0.5 lw 1 title '0.7 s', \
     ARG1 using 2:(of_shade(2, $3, $4)) with points lt 5 pt 8 ps 0.55 lw 1 title '1 s', \
     ARG1 using 2:(of_shade(3, $3, $4)) with points lc rgb DIM pt 2 ps 0.45 lw 1 title '1.4 s', \
     @yours
