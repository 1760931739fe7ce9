#> Figure: the point in print, and in truth
# gnuplot -c 07_segment_intersection_print.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set size ratio -1
set key outside top center horizontal maxcols 2
set xrange [6.8:11.2]; set yrange [4.4:6.6]
set xtics 1; set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'motion' at 10.4,5.02 rotate by -18 textcolor lt 1
set label 'wall, to (17, 10)' at 9.7,5.72 rotate by 29 textcolor rgb DIM
set label 'to (18, 11)' at 9.3,6.02 rotate by 30 textcolor rgb DIM
wall(row, x) = $0 == row ? x : NaN
yours = with_yours("ARG3 using (wall(0, $5)):6 with points lt 2 pt 6 ps 1.8 lw 2 title 'yours'")
plot ARG1 using (wall(0, $1)):2:($3 - $1):($4 - $2) with vectors nohead lc rgb DIM lw 3 notitle, \
     ARG1 using (wall(1, $1)):2:($3 - $1):($4 - $2) with vectors nohead lc rgb DIM lw 2 dt (6,5) notitle, \
     7 - (x - 4) / 3 with lines lt 1 notitle, \
     ARG1 using (wall(0, $5)):6 with points lt 3 pt 7 ps 1.2 title 'intersection', \
     ARG1 using (wall(1, $5)):6 with points lt 4 pt 13 ps 1.2 title 'with the dashed wall', \
     '+' using (9.28):(5.24) every ::0::0 with points lt 6 pt 2 ps 1.4 lw 3 title 'as printed', \
     @yours
