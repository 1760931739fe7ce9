#> Figure: the angle closes, the error grows
# gnuplot -c 07_segment_intersection_angle.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set logscale xy
set key bottom left
set lmargin 8
set format xy '10^{%T}'
set xrange [1e-12:1]; set yrange [1e-17:1e2]
set xtics 1e-12,1e3,1; set ytics 1e-16,1e4,1
set xlabel 'angle between the segments (its tangent)'; set ylabel 'error of the point [m]'
set label 'largest of 501' at 4e-11,1e-3 textcolor lt 1
set label 'middle one' at 3e-9,1e-9 right textcolor lt 3
set label 'slope −1' at 1e-5,1e-8 textcolor rgb DIM
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 4 ps 0.8 title 'yours, largest'")
plot ARG1 using 1:2 with points lt 1 ps 0.5 notitle, \
     ARG1 using 1:3 with points lt 3 ps 0.5 notitle, \
     4e-16 / x with lines lc rgb DIM lw 1 dt (5,4) title '4 · 10^{-16} m / angle', \
     @yours
