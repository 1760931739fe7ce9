#> Figure: the best shot from the cliff, its first velocity and its last
# gnuplot -c 04_trajectories_best.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set key bottom left
set lmargin 8
set size ratio -1
set xrange [-17:47]; set yrange [-31:19]
set xtics 10; set ytics 10
set xlabel 'velocity to the right [m/s]'; set ylabel 'velocity upwards [m/s]'
set label "at the muzzle:\n25 m/s" at 8,13.5 right textcolor lt 3
set label "at the ground:\n33.54 m/s" at 7.5,-15 right textcolor lt 1
set label '20.04 m/s' at 13,1.7 center textcolor rgb DIM
set label "what gravity adds:\n41.83 m/s" at 21.2,-6 left textcolor lt 6
square(x, y) = 2 / sqrt(x**2 + y**2) # how much of an arrow the mark at the right angle takes
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.4 lw 1.5 title 'yours'")
plot ARG1 using (0):(0):1:(0) every ::0::0 with vectors lc rgb DIM lw 1.5 dt (3,4) nohead notitle, \
     ARG1 using 1:2:(0):3 every ::0::0 with vectors lt 6 dt solid lw 2 filled size screen 0.02,25 notitle, \
     ARG1 using (0):(0):1:2 every ::0::0 with vectors lt 3 dt solid lw 2 filled size screen 0.02,25 notitle, \
     ARG1 using (0):(0):1:2 every ::1::1 with vectors lt 1 dt solid lw 2 filled size screen 0.02,25 notitle, \
     ARG1 using ($1 * square($1, $2)):($2 * square($1, $2)):($1 * square($1, $2 + $3)):(($2 + $3) * square($1, $2 + $3)) every ::0::0 with vectors lc rgb INK lw 1 dt solid nohead notitle, \
     ARG1 using ($1 * square($1, $2 + $3)):(($2 + $3) * square($1, $2 + $3)):($1 * square($1, $2)):($2 * square($1, $2)) every ::0::0 with vectors lc rgb INK lw 1 dt solid nohead notitle, \
     @yours
