#> Figure: energy error against time
# gnuplot -c 03_gravity_wells_energy.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
set key bottom right
set lmargin 8
set logscale y
set xrange [0:10]; set yrange [1e-8:30]
set xtics 2
set ytics 100
set format y '10^{%T}'
set xlabel 'turns'; set ylabel 'error of the energy, relative'
set label 'explicit Euler' at 9.8,6 right textcolor lt 6
set label 'semi-implicit Euler' at 9.8,0.2 right textcolor lt 1
set label 'leapfrog' at 9.8,1e-4 right textcolor lt 3
set label 'Runge–Kutta' at 9.8,1.5e-6 right textcolor lt 5
yours = with_yours("for [k = 2:5] ARG3 using 1:(column(k)) every 4 with points lt 2 pt 6 ps 0.6 lw 1.5 title (k == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 6 notitle, \
     ARG1 using 1:3 with lines lt 1 notitle, \
     ARG1 using 1:4 with lines lt 3 notitle, \
     ARG1 using 1:5 with lines lt 5 notitle, \
     @yours
