#> Figure: a bounce in parts
# gnuplot -c 11_particles_bounce.gp TRACE SVG
load 'style.gp'
eval canvas(240)
set output ARG2
set size ratio -1
unset border; unset tics; unset grid; unset key
set margins 0.5,0.5,0.5,0.5
set xrange [-7:6.4]; set yrange [-2.2:3.8]
set arrow from -2.4,-1.8 to 4.8,3.6 nohead lc rgb DIM lw 1
set label 'wall' at 4.3,2.7 textcolor rgb DIM
set label 'before' at -4.2,2.3 right textcolor lt 1
set label 'after' at 0.6,3.0 left textcolor lt 1
set label 'along the wall: kept' at 1.4,0.3 left textcolor lt 3
set label "along the normal:\nreversed, halved" at -6.9,-0.6 left textcolor lt 2
plot ARG1 using (int($0) % 3 == 0 ? $1 : NaN):2:3:4 with vectors lt 1 lw 3, \
     ARG1 using (int($0) % 3 == 1 ? $1 : NaN):2:3:4 with vectors lt 3 dt solid lw 3, \
     ARG1 using (int($0) % 3 == 2 ? $1 : NaN):2:3:4 with vectors lt 2 lw 2
