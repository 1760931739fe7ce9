#> Figure: all points one radius away
# gnuplot -c 07_segment_intersection_track.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(370)
set output ARG2
set size ratio -1
set key outside top center horizontal
set xrange [-1:12]; set yrange [-3:6]
set xtics 2; set ytics 2
set xlabel 'x [m]'; set ylabel 'y [m]'
set arrow 1 from 0,3 to 8,3 head filled size 0.3,20 lt 1 lw 2 dt (6,4)
set arrow 2 from 7,-3 to 7,1.5 nohead lc rgb DIM lw 4
set label 'wall' at 7.25,-1.8 textcolor rgb DIM
set label 'motion' at -0.8,3.6 textcolor lt 1
set label "its centre\nat the impact" at 2.2,-0.6 center textcolor lt 3
set arrow 3 from 3.4,-0.1 to 4.8,2.7 nohead lt 3 dt solid lw 1
set label "one radius\nfrom the wall" at 12,5.6 right textcolor lt 4
yours = with_yours("ARG3 using 3:4 every ::0::0 with points lt 2 pt 6 ps 1.8 lw 2 title 'yours'")
plot ARG1 using 1:2 with lines lt 4 lw 2 notitle, \
     '+' using (5 + 2.5 * cos($1)):(3 + 2.5 * sin($1)) with lines lt 1 lw 1 notitle, \
     ARG1 using 3:4 every ::0::0 with points lt 3 pt 7 ps 1.2 notitle, \
     @yours
