#> Figure: five angles, one speed
# gnuplot -c 04_trajectories_arcs.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set key top right
set size ratio -1
set xrange [0:66]; set yrange [0:34]
set xtics 10; set ytics 10
set xlabel 'x [m]'; set ylabel 'y [m]'
set label '75°' at 22,27.6 left textcolor lt 6
set label '60°' at 34,19.4 center textcolor lt 5
set label '45°' at 31,13.6 center textcolor lt 1
set label '30°' at 21,5.4 center textcolor lt 3
set label '15°' at 16,3.9 center textcolor lt 4
set label 'as far as it reaches' at 38.5,23 left textcolor rgb DIM
yours = with_yours("for [k = 1:5] ARG3 using (column(2 * k - 1)):(column(2 * k)) every 2 with points lt 2 pt 6 ps 0.6 lw 1.5 title (k == 1 ? 'yours' : '')")
plot [0:62.5] 31.25 - x**2 / 125 with lines lc rgb DIM lw 1.5 dt (3,4) notitle, \
     ARG1 using 1:2 with lines lt 4 notitle, \
     ARG1 using 3:4 with lines lt 3 notitle, \
     ARG1 using 5:6 with lines lt 1 notitle, \
     ARG1 using 7:8 with lines lt 5 notitle, \
     ARG1 using 9:10 with lines lt 6 notitle, \
     @yours
