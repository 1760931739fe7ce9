#> Figure: range against angle
# gnuplot -c 04_trajectories_ranges.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key bottom center
set lmargin 7
set xrange [0:90]; set yrange [0:95]
set xtics 15; set ytics 20
set xlabel 'angle [°]'; set ylabel 'range [m]'
set label 'from a cliff of 25 m' at 52,86 left textcolor lt 3
set label 'from the ground' at 45,48 center textcolor lt 1
set label 'as printed' at 45,25 center textcolor lt 6
set arrow from 36.7,84.6 to 36.7,88 nohead lc rgb DIM lw 1.5 dt solid
set label '36.7°' at 36.7,91.5 center textcolor rgb DIM
yours = with_yours("for [k = 2:3] ARG3 using 1:(column(k)) every 3 with points lt 2 pt 6 ps 0.9 lw 1.5 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:3 with lines lt 3 notitle, \
     ARG1 using 1:2 with lines lt 1 notitle, \
     62.5 * cos(x * pi / 180) * sin(x * pi / 180) with lines lt 6 notitle, \
     @yours
