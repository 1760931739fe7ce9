#> Figure: velocity against time
# gnuplot -c 05_inclined_planes_stops.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(260)
set output ARG2
set key left center
set lmargin 6.5
set xrange [0:5]; set yrange [-4.4:6.4]
set xtics 1; set ytics 2
set xlabel 'time [s]'; set ylabel 'velocity [m/s]'
set label 'friction stops it' at 3.1,0.9 left textcolor lt 1
set label "a constant acceleration\ndrives it back" at 3.7,-1.9 right textcolor lt 6
yours = with_yours("ARG3 using 1:2 every 2 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot 6 - 2 * x with lines lt 6 notitle, \
     ARG1 using 1:2 with lines lt 1 notitle, \
     @yours
