#> Figure: one shot, with and without air
# gnuplot -c 04_trajectories_air.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(260)
set output ARG2
set key top right
set lmargin 7
set size ratio -1
set xrange [0:66]; set yrange [0:19]
set xtics 10; set ytics 10
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'no air' at 46,14.5 left textcolor rgb DIM
set label '+10 m/s' at 35.5,10.6 left textcolor lt 3
set label 'still air' at 26.8,2.2 right textcolor lt 1
set label '−10 m/s' at 13,1.5 right textcolor lt 6
yours = with_yours("for [k = 2:4] ARG3 using (column(2 * k - 1)):(column(2 * k)) every 2 with points lt 2 pt 6 ps 0.6 lw 1.5 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lc rgb DIM lw 1.5 dt (3,4) notitle, \
     ARG1 using 3:4 with lines lt 1 notitle, \
     ARG1 using 5:6 with lines lt 6 notitle, \
     ARG1 using 7:8 with lines lt 3 notitle, \
     @yours
