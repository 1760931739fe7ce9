#> Figure: all points one radius away
# gnuplot -c 07_segment_intersection_track.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set size ratio -1
set key outside top center horizontal
set xrange [-1:12]; set yrange [-3:6]
set xlabel 'x [m]'; set ylabel 'y [m]'
set arrow 1 from 0,3 to 8,3 head filled size 0.3,20 lt 1 lw 2 dt (6,4)
set arrow 2 from 7,-3 to 7,1.5 nohead lc rgb DIM lw 4
set label 'wall' at 7.25,-1.8 textcolor rgb DIM
set label 'motion' at 0,3.6 textcolor lt 1
yours = with_yours("ARG3 using 3:4 every ::0::0 with points lt 2 pt 6 ps 1.8 lw 2 title 'yours'")
plot ARG1 using 1:2 with lines lt 4 lw 2 dt (5,3) title 'one radius from the wall', \
     '+' using (5 + 2.5 * cos($1)):(3 + 2.5 * sin($1)) with lines lt 1 lw 1 notitle, \
     ARG1 using 3:4 every ::0::0 with points lt 3 pt 7 ps 1.2 title 'centre at the impact', \
     @yours
