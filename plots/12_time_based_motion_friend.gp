#> Figure: a friend's ship
# gnuplot -c 12_time_based_motion_friend.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set lmargin 5
set key top right
set xrange [-0.3:5.3]; set yrange [-2.6:2.6]
set xtics 1; set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set label "three packets\nare lost" at 2.1,0.3 right textcolor rgb INK
yours = with_yours("ARG3 index 1 using 2:3 every 2 with points lt 2 pt 6 ps 1.0 lw 1.5 title 'yours'")
plot ARG1 index 1 using 2:3 with lines lt 1 title ours('what you see'), \
     ARG1 index 0 using 2:3 with points lt 6 pt 15 ps 0.8 title 'packets', \
     @yours
