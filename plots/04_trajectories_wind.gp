#> Figure: one shot, four winds
# gnuplot -c 04_trajectories_wind.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(240)
set output ARG2
set key top right
set size ratio -1
set xrange [-24:82]; set yrange [0:26]
set xtics 20; set ytics 10
set xlabel 'x [m]'; set ylabel 'y [m]'
set label '−10 m/s²' at -23,22 left textcolor lt 6
set label '−2' at 38.5,8 right textcolor lt 4
set label '0' at 51.5,8 right textcolor lt 1
set label '+1' at 63.5,9.5 left textcolor lt 3
yours = with_yours("for [k = 1:4] ARG3 using (column(2 * k - 1)):(column(2 * k)) every 2 with points lt 2 pt 6 ps 0.6 lw 1.5 title (k == 1 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 6 notitle, \
     ARG1 using 3:4 with lines lt 4 notitle, \
     ARG1 using 5:6 with lines lt 1 notitle, \
     ARG1 using 7:8 with lines lt 3 notitle, \
     @yours
