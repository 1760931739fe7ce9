#> Figure: a straight line, and how far below it the shell is
# gnuplot -c 04_trajectories_falls.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set key top left
set size ratio -1
set xrange [-4:84]; set yrange [-4:86]
set xtics 15; set ytics 20
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'without gravity' at 44,68 right textcolor rgb DIM
set label '5 m' at 13,22 right textcolor lt 6
set label 'our shell' at 30,11 center textcolor lt 1
yours = with_yours("ARG3 using 3:4 every 2 with points lt 2 pt 6 ps 0.6 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lc rgb DIM lw 1.5 dt (3,4) notitle, \
     ARG1 using 3:4 with lines lt 1 notitle, \
     ARG1 using 1:2:(0):($4 - $2) every 10::10 with vectors lt 6 dt solid lw 2 filled size screen 0.02,25 notitle, \
     ARG1 using 1:(($2 + $4) / 2):(sprintf('%g m', $2 - $4)) every 10::20 with labels left offset 0.6,0 textcolor lt 6 notitle, \
     ARG1 using 1:2 every 10 with points lc rgb DIM pt 7 ps 0.7 notitle, \
     ARG1 using 3:4 every 10 with points lt 1 ps 1 notitle, \
     @yours
