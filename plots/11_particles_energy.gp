#> Figure: the energy of sparks that bounce
# gnuplot -c 11_particles_energy.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set lmargin 7
set key outside top center horizontal
set xrange [0:10]; set yrange [0:1.14]
set ytics 0.2
set xlabel 'time [s]'; set ylabel 'energy / energy at the start'
set label 'e = 1' at 5,1.07 textcolor lt 1
set label '0.9' at 5.6,0.47 textcolor lt 3
set label '0.7' at 3.1,0.32 textcolor lt 4
set label '0.4' at 1,0.24 textcolor lt 6
yours = with_yours("ARG3 using 1:3 with steps lt 2 title 'yours, e = 0.9'")
plot ARG1 using 1:2 with steps lt 1 notitle, \
     ARG1 using 1:3 with steps lt 3 notitle, \
     ARG1 using 1:4 with steps lt 4 notitle, \
     ARG1 using 1:5 with steps lt 6 notitle, \
     @yours
