#> Figure: quarters of the motion and the wall
# gnuplot -c 07_segment_intersection_shares.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set size ratio -1
set key outside top center horizontal
set xrange [-1:20]; set yrange [-0.5:11.5]
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'they cross' at 8.8,8.6 center textcolor lt 3
set arrow from 8.8,8.0 to 8.8,6.0 nohead lt 3 dt solid lw 1
yours = with_yours("ARG3 using 6:7 with points lt 2 pt 6 ps 1.6 lw 2 title 'yours'")
plot ARG1 using 4:5 with linespoints lc rgb DIM lw 3 pt 7 ps 0.5 notitle, \
     ARG1 using 4:5:(sprintf('s = %g', $1)) every ::0::1 with labels left offset 0.7,-0.6 textcolor rgb DIM notitle, \
     ARG1 using 4:5:(sprintf('s = %g', $1)) every ::3 with labels left offset 0.7,-0.6 textcolor rgb DIM notitle, \
     ARG1 using 2:3 with linespoints lt 1 ps 0.5 notitle, \
     ARG1 using 2:3:(sprintf('t = %g', $1)) every ::0::0 with labels left offset 0.3,0.8 textcolor lt 1 notitle, \
     ARG1 using 2:3:(sprintf('t = %g', $1)) every ::1 with labels right offset 0.3,-0.9 textcolor lt 1 notitle, \
     ARG1 using 6:7 every ::0::0 with points lt 3 pt 7 ps 1 notitle, \
     @yours
