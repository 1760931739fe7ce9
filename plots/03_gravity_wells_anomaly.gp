#> Figure: the eccentric anomaly
# gnuplot -c 03_gravity_wells_anomaly.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(440)
set output ARG2
set size ratio -1
set key bottom right
set xrange [-13:6]; set yrange [-9:9]
set xtics 4; set ytics 4
set xlabel 'x [m]'; set ylabel 'y [m]'
E = 1.2606 # an eighth of a turn after the near end, for e = 0.5
px = -4 + 8 * cos(E)
set arrow from -4,0 to px,8 * sin(E) nohead lt 3 dt solid
set arrow from -4,0 to 4,0 nohead lt 3 dt solid
set arrow from px,6.597 to px,8 * sin(E) nohead lc rgb INK lw 1.5 dt (3,3)
set label 'E' at -1.9,1.2 left textcolor lt 3
set label 'Sun' at 0.4,-1 left textcolor rgb DIM
set label 'middle' at -4,-1 center textcolor rgb DIM
set label 'planet' at -2.7,5.3 right textcolor lt 1
set label 'circle' at 2.4,7 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.1 lw 2 title 'yours'")
plot sample [t=0:2 * pi] '+' using (-4 + 8 * cos(t)):(8 * sin(t)) with lines lc rgb DIM lw 1 dt solid notitle, \
     [t=0:2 * pi] '+' using (-4 + 8 * cos(t)):(8 * sqrt(0.75) * sin(t)) with lines lt 1 notitle, \
     [t=0:E] '+' using (-4 + 1.6 * cos(t)):(1.6 * sin(t)) with lines lt 3 dt solid notitle, \
     ARG1 using 1:2 with points lt 1 ps 0.8 notitle, \
     '+' using (0):(0) every ::0::0 with points lc rgb INK pt 7 ps 1.4 notitle, \
     '+' using (px):(6.597) every ::0::0 with points lt 1 ps 1.2 notitle, \
     '+' using (px):(8 * sin(E)) every ::0::0 with points lc rgb INK pt 7 ps 0.7 notitle, \
     @yours
