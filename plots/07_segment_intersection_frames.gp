#> Figure: twenty seconds, frame by frame
# gnuplot -c 07_segment_intersection_frames.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(360)
set output ARG2
set size ratio -1
set key outside top center horizontal maxrows (ARGC > 2 ? 2 : 1) samplen 0.8 width -3
set xrange [0:12]; set yrange [-0.3:7.3]
set xlabel 'x [m]'; set ylabel 'y [m]'
yours = with_yours("ARG3 using 2:3 with lines lt 2 lw 1 title 'yours'")
seconds = with_yours("ARG3 using 2:3 every 20 with points lt 2 pt 6 ps 0.7 lw 1 notitle")
plot ARG1 using 4:5 every ::0::7 with lines lc rgb DIM lw 3 notitle, \
     ARG1 using 2:3 with lines lt 1 lw 1 title ours('the ball'), \
     ARG1 using 2:3 every 20 with points pt 7 ps 0.5 lc rgb INK title 'each second', \
     ARG1 using 2:3 every ::0::0 with points lt 3 ps 1.1 title 'start', \
     @yours, @seconds
