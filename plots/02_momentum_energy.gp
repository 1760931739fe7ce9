#> Figure: momentum and kinetic energy after the collision, against restitution
# gnuplot -c 02_momentum_energy.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key at 0.34,18
set xrange [0:1.02]; set yrange [0:25]
set xtics 0.25; set ytics 5
set xlabel 'restitution'
unset ylabel
set label 'kinetic energy [J]' at 0.66,13 right textcolor lt 3
set label 'momentum [N s]' at 0.98,4.4 right textcolor lt 1
set label 'energy before: 22 J' at 0.8,23.3 right textcolor rgb DIM
yours = with_yours("for [column = 2:3] ARG3 using 1:column with points lt 2 pt 6 ps 1.2 lw 2 title (column == 2 ? 'yours' : '')")
plot 22 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using 1:3 with linespoints lt 3 ps 0.6 notitle, \
     ARG1 using 1:2 with linespoints lt 1 ps 0.5 notitle, \
     @yours
