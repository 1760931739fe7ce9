#> Figure: a hand that is led around
# gnuplot -c 10_inverse_kinematics_led.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(310)
set output ARG2
set lmargin 7
set key bottom right
set xrange [0:540]; set yrange [-200:560]
set xtics 90; set ytics 180
set xlabel 'the hand is led around to [°]'; set ylabel 'first angle [°]'
set label 'goes on' at 330,345 right textcolor lt 1
set label "from 180° to −180°:\na turn back" at 232,140 left textcolor lt 6
yours = with_yours("ARG3 using 1:3 every 5 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 6 lw 2.5 notitle, \
     ARG1 using 1:3 with lines lt 1 notitle, \
     @yours
