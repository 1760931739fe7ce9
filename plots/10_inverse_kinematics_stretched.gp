#> Figure: how far a stretched elbow turns
# gnuplot -c 10_inverse_kinematics_stretched.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(340)
set output ARG2
set lmargin 8.5
set logscale xy
set xrange [0.09:90]; set yrange [0.1:30000]
set xtics (0.1, 1, 10, 90); set ytics (0.1, 1, 10, 100, 1000, '10 000' 10000)
set xlabel 'angle at the elbow [°]'; set ylabel 'the elbow turns by [°]'
set label 'hardly damped' at 0.4,6500 left textcolor lt 6
set label 'by 0.1 m' at 0.35,40 right textcolor lt 3
set label 'by 0.5 m' at 0.9,1.0 left textcolor lt 1
yours = with_yours("for [i = 2:4] ARG3 using 1:i every 3 with points lt 2 pt 6 ps 1.0 lw 1.5 title (i == 2 ? 'yours' : '')")
plot ARG1 using 1:2 with lines lt 6 lw 2.5 notitle, \
     ARG1 using 1:3 with lines lt 3 lw 2.5 notitle, \
     ARG1 using 1:4 with lines lt 1 notitle, \
     @yours
