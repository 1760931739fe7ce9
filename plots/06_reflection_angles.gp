#> Figure: the angle out against the angle in
# gnuplot -c 06_reflection_angles.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key bottom right
set lmargin 7
set xrange [0:90]; set yrange [0:90]
set xtics 30; set ytics 30
set xlabel 'angle in [°]'; set ylabel 'angle out [°]'
set label 'reflected' at 52,47 left textcolor lt 1
set label "half of the normal speed" at 4,79 left textcolor lt 3
set label "and mu_k = 0.3" at 46,22 left textcolor lt 6 noenhanced
yours = with_yours("ARG3 using 1:4 every 2 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 1:3 with lines lt 3 notitle, \
     ARG1 using 1:4 with lines lt 6 notitle, \
     @yours
