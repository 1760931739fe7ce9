#> Figure: the energy of sparks that bounce
# gnuplot -c 11_particles_energy.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key outside top center horizontal
set xrange [0:10]; set yrange [0:1.08]
set ytics 0.2
set xlabel 'time [s]'; set ylabel 'energy / energy at the start'
yours = with_yours("ARG3 using 1:3 with steps lt 2 dt (6,4) title 'yours, e = 0.9'")
plot ARG1 using 1:2 with steps lt 1 title 'e = 1', \
     ARG1 using 1:3 with steps lt 3 title '0.9', \
     ARG1 using 1:4 with steps lt 4 title '0.7', \
     ARG1 using 1:5 with steps lt 6 title '0.4', \
     @yours
