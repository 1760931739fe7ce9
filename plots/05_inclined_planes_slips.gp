#> Figure: stick and slip in phase space
# gnuplot -c 05_inclined_planes_slips.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set key top left
set lmargin 7
set xrange [0:0.6]; set yrange [-0.1:1]
set xtics 0.1; set ytics 0.2
set xlabel 'stretch of the spring [m]'; set ylabel 'velocity [m/s]'
set label 'slips' at 0.3,0.77 center textcolor lt 1
set label 'sticks' at 0.3,0.08 center textcolor lt 1
yours = with_yours("ARG3 using 1:2 every 3 with points lt 2 pt 6 ps 0.7 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     @yours
