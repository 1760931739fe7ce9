#> Figure: the distance of two centres
# gnuplot -c 08_nt_collisions_distance.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set key top right
set xrange [0:1.4]; set yrange [-0.2:4.2]
set xtics 0.2; set ytics 1
set xlabel 'time [s]'; set ylabel 'distance [m]'
set label 'sum of the radii' at 0.03,1.25 left textcolor rgb DIM
set label "first contact,\n0.64 s" at 0.6,0.65 right textcolor lt 1
set label "they part,\n0.96 s" at 1.02,0.65 left textcolor rgb DIM
yours = with_yours("ARG3 using 3:4 every ::0::0 with points lt 2 pt 6 ps 2 lw 2 title 'yours'")
plot 1 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 3:4 every ::0::0 with points lt 1 ps 1.2 notitle, \
     @yours
