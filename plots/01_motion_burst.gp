#> Figure: a missile breaks in two
# gnuplot -c 01_motion_burst.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key outside top center horizontal maxcols 2
set xrange [*<-0.2:6.8<*]; set yrange [*<-0.3:3.9<*]
set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
yours = with_yours("ARG3 using 7:8 every 10 with points lt 2 pt 6 ps 1.6 lw 2 title 'yours'")
plot ARG1 using 1:2 with lines lc rgb DIM lw 1.5 dt (5,4) title 'if it had not broken', \
     ARG1 using 3:4 every ::30 with lines lt 6 title 'nose, 1 kg', \
     ARG1 using 5:6 every ::30 with lines lt 3 title 'hull, 3 kg', \
     ARG1 using 7:8 every 10 with points lt 1 pt 7 ps 0.8 title 'their centre of mass', \
     @yours
