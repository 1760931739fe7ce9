#> Figure: sweeps against damped steps
# gnuplot -c 10_inverse_kinematics_errors.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(360)
set output ARG2
set lmargin 7.5
set logscale y
set key at 39.5,4e-8
set xrange [0:40]; set yrange [1e-9:20]
set xtics 10; set ytics 1e-8,100,1 format '10^{%T}'
set xlabel 'sweeps or steps'; set ylabel 'the hand is off by [m]'
set label 'sweeps, far target' at 39,0.3 right textcolor lt 6
set label 'steps, far target' at 30,8e-6 right textcolor lt 4
set label 'sweeps' at 9.0,3e-7 left textcolor lt 3
set label 'steps' at 5.6,1e-8 right textcolor lt 1
yours = with_yours("ARG3 using 1:($2 > 1e-9 ? $2 : NaN) with points lt 2 pt 6 ps 1.0 lw 1.5 title 'yours', ARG3 using 1:($3 > 1e-9 ? $3 : NaN) with points lt 2 pt 6 ps 1.0 lw 1.5 notitle, ARG3 using 1:4 every 2 with points lt 2 pt 6 ps 1.0 lw 1.5 notitle, ARG3 using 1:5 every 2 with points lt 2 pt 6 ps 1.0 lw 1.5 notitle")
plot ARG1 using 1:4 every ::0::40 with lines lt 6 lw 2.5 notitle, \
     ARG1 using 1:5 with lines lt 4 lw 2.5 notitle, \
     ARG1 using 1:($2 > 1e-9 ? $2 : NaN) with lines lt 3 lw 2.5 notitle, \
     ARG1 using 1:($3 > 1e-9 ? $3 : NaN) with lines lt 1 notitle, \
     @yours
