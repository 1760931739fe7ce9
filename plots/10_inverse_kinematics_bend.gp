#> Figure: how far the arm bends
# gnuplot -c 10_inverse_kinematics_bend.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(280)
set output ARG2
set lmargin 7
set xrange [0.8:5.2]; set yrange [-5:190]
set xtics 1; set ytics 45
set xlabel 'distance of the hand from the first joint [m]'; set ylabel 'second angle [°]'
set label 'folded' at 1.2,180 left textcolor rgb INK
set label 'straight' at 4.82,10 right textcolor rgb INK
yours = with_yours("ARG3 using 1:2 every 4 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 title ours('lengths 3 m and 2 m'), \
     @yours
