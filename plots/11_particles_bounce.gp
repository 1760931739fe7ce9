#> Figure: a bounce in parts
# gnuplot -c 11_particles_bounce.gp TRACE SVG
load 'style.gp'
set output ARG2
set size ratio -1
unset border; unset tics; unset grid
set key at graph 0.98,0.26
set xrange [-5.4:6.4]; set yrange [-4.2:3.8]
set arrow from -2.4,-1.8 to 4.8,3.6 nohead lc rgb DIM lw 1
set label 'wall' at 4.3,2.7 textcolor rgb INK
set label 'before' at -4.2,2.1 right textcolor rgb DIM
set label 'after' at 0.5,3.0 left textcolor rgb DIM
plot ARG1 using (int($0) % 3 == 0 ? $1 : NaN):2:3:4 with vectors lt 1 lw 3 title 'velocity', \
     ARG1 using (int($0) % 3 == 1 ? $1 : NaN):2:3:4 with vectors lt 3 lw 3 title 'its part along the wall: kept', \
     ARG1 using (int($0) % 3 == 2 ? $1 : NaN):2:3:4 with vectors lt 2 lw 2 title 'its part along the normal: reversed, halved'
