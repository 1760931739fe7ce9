#> Figure: a ball with a size
# gnuplot -c 07_segment_intersection_disc.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(360)
set output ARG2
set size ratio -1
set key outside top center horizontal maxrows (ARGC > 2 ? 2 : 1) samplen 0.8 width -3
set xrange [0:12]; set yrange [-0.3:7.3]
set xlabel 'x [m]'; set ylabel 'y [m]'
yours = with_yours("ARG3 using 2:3 with lines lt 2 lw 1 title 'yours'")
plot ARG1 using 4:5 every ::0::7 with lines lc rgb DIM lw 3 notitle, \
     ARG1 using 2:3 with lines lt 1 lw 1 title ours('the centre'), \
     ARG1 using 2:3:(0.4) every 20 with circles lc rgb INK lw 0.7 fs empty title 'each second', \
     ARG1 using 2:3 every ::0::0 with points lt 3 ps 1.1 title 'start', \
     @yours
