#> Figure: the spiral of death
# gnuplot -c 12_time_based_motion_spiral.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set lmargin 8
set logscale y
set xrange [0.5:12.5]; set yrange [8:1500]
set xtics 1,1,12; set ytics (10,100,1000)
set xlabel 'frame'; set ylabel 'work [ms]'
set label "all that's due" at 7.4,260 right textcolor lt 6
set label 'with a budget' at 9,16 left textcolor lt 1
yours = with_yours("ARG3 using 1:3 with points lt 2 pt 6 ps 1.6 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with linespoints lt 6 pt 15 ps 0.7 notitle, \
     ARG1 using 1:3 with linespoints lt 1 pt 7 ps 0.7 notitle, \
     @yours
