#> Figure: a ramp of sixteen shades
# gnuplot -c 11_particles_ramp.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key top left
set xrange [0:3.5]; set yrange [-0.5:17]
set xtics 0.5; set ytics 0,3,15
set xlabel 'age [s]'; set ylabel 'shade' offset 2.5,0
set arrow from 3,-0.5 to 3,16.2 nohead lc rgb DIM lw 1 dt (5,4)
set label 'dead' at 3.05,15.5 textcolor rgb DIM
in(k, shade) = int(shade / 4) == k ? shade : NaN
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 0.4 lw 1 title 'yours'")
plot ARG1 using 1:(in(0, $2)) with points lt 4 pt 7 ps 0.4 notitle, \
     ARG1 using 1:(in(1, $2)) with points lt 6 pt 7 ps 0.4 notitle, \
     ARG1 using 1:(in(2, $2)) with points lt 5 pt 7 ps 0.4 notitle, \
     ARG1 using 1:(in(3, $2)) with points lc rgb DIM pt 7 ps 0.4 notitle, \
     @yours
