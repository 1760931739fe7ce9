#> Figure: the line of momentum and the ellipse of energy
# gnuplot -c 02_momentum_plane.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set size ratio -1
set key bottom left
set xrange [-5.9:5.9]; set yrange [-4.9:4.9]
set xtics 2; set ytics 2
set xlabel 'velocity of A [m/s]'; set ylabel 'velocity of B [m/s]' offset 0.4,0
set label 'momentum 2 N s' at -5.6,4.5 left textcolor lt 1
set label "energy\n22 J" at 2.6,4.3 left textcolor lt 3
set label 'before' at 3.15,-2.3 right
set label 'after' at -3.6,2.75 right
set label 'in the middle' at 0.4,0.4 left offset 0.8,0.4
set label 'printed' at -3.2,1.3 left textcolor lt 6
yours = with_yours("ARG3 using 1:2 every ::1::1 with points lt 2 pt 6 ps 2 lw 2 title 'yours'")
plot sample [0:2*pi] '+' using (sqrt(22.0) * cos($1)):(sqrt(44.0 / 3) * sin($1)) with lines lt 3 notitle, \
     [-7:7] '+' using 1:((2 - 2 * $1) / 3) with lines lt 1 notitle, \
     ARG1 using 1:2 every ::0::0 with points lt 1 pt 7 ps 1 notitle, \
     ARG1 using 1:2 every ::1::1 with points lt 1 pt 9 ps 1.4 notitle, \
     '+' using (0.4):(0.4) every ::0::0 with points lt 1 pt 6 ps 1 notitle, \
     '+' using (-3.2):(2.4) every ::0::0 with points lt 6 pt 2 ps 1 lw 2 notitle, \
     @yours
