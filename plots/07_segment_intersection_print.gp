#> Figure: the point in print, and in truth
# gnuplot -c 07_segment_intersection_print.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(290)
set output ARG2
set size ratio -1
set key outside top center horizontal
set xrange [6.8:11.2]; set yrange [4.4:6.6]
set xtics 1; set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'motion' at 10.3,5.05 rotate by -18 textcolor lt 1
set label 'wall, to (17, 10)' at 9.65,5.67 rotate by 29 textcolor rgb DIM
set label 'to (18, 11)' at 9.55,6.2 rotate by 30 textcolor rgb DIM
set label 'with the dashed wall' at 7.3,6.2 left textcolor lt 4
set arrow 1 from 8.5,6.08 to 8.59,5.58 nohead lt 4 dt solid lw 1
set label 'intersection' at 8.9,4.75 center textcolor lt 3
set arrow 2 from 8.85,4.88 to 8.82,5.28 nohead lt 3 dt solid lw 1
set label 'as printed' at 9.4,5.4 left textcolor lt 6
wall(row, x) = $0 == row ? x : NaN
yours = with_yours("ARG3 using (wall(0, $5)):6 with points lt 2 pt 6 ps 1.8 lw 2 title 'yours'")
plot ARG1 using (wall(0, $1)):2:($3 - $1):($4 - $2) with vectors nohead lc rgb DIM lw 3 notitle, \
     ARG1 using (wall(1, $1)):2:($3 - $1):($4 - $2) with vectors nohead lc rgb DIM lw 2 dt (6,5) notitle, \
     7 - (x - 4) / 3 with lines lt 1 notitle, \
     ARG1 using (wall(0, $5)):6 with points lt 3 pt 7 ps 1.2 notitle, \
     ARG1 using (wall(1, $5)):6 with points lt 4 ps 1.2 notitle, \
     '+' using (9.28):(5.24) every ::0::0 with points lt 6 pt 2 ps 1.4 lw 3 notitle, \
     @yours
