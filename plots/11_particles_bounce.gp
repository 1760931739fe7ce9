#> Figure: a bounce in parts
# gnuplot -c 11_particles_bounce.gp TRACE SVG
load 'style.gp'
eval canvas(260)
set output ARG2
set size ratio -1
unset border; unset tics; unset grid; unset key
set margins 0.5,0.5,0.5,0.5
set xrange [-7:6.4]; set yrange [-2.6:4.0]
set arrow from -2.4,-1.8 to 4.8,3.6 nohead lc rgb DIM lw 1
set label 'wall' at 4.3,2.7 textcolor rgb DIM
array vx[6]; array vy[6]
stats ARG1 using (vx[int($0) + 1] = $3, vy[int($0) + 1] = $4) nooutput
c(x) = (x < 0 ? '−' : '').sprintf('%.1f', abs(x))
v(i) = '('.c(vx[i]).', '.c(vy[i]).')'
set label "before\n".v(1) at -4.3,2.6 right textcolor lt 1
set label "after\n".v(4) at 0.8,3.5 left textcolor lt 1
set label "along the wall\n".v(2).', kept' at 1.6,0.5 left textcolor lt 3
set label "along the normal\n".v(3)."\nbecomes ".v(6) at -6.9,-0.1 left textcolor lt 2
plot ARG1 using (int($0) % 3 == 0 ? $1 : NaN):2:3:4 with vectors lt 1 lw 3, \
     ARG1 using (int($0) % 3 == 1 ? $1 : NaN):2:3:4 with vectors lt 3 dt solid lw 3, \
     ARG1 using (int($0) % 3 == 2 ? $1 : NaN):2:3:4 with vectors lt 2 lw 2
