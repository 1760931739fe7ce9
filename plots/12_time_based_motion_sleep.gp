#> Figure: a tab that sleeps
# gnuplot -c 12_time_based_motion_sleep.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
set lmargin 7
set xrange [0:4]; set yrange [0:500]
set xtics 1; set ytics 100
set xlabel 'what the clock on the wall shows [s]'; set ylabel 'x [px]'
set label "the difference\nof two times" at 1.45,330 right textcolor lt 6
set label 'tick' at 3.4,150 left textcolor lt 1
yours = with_yours("ARG3 using 1:3 every 4 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 6 lw 2.5 notitle, \
     ARG1 using 1:3 with lines lt 1 notitle, \
     @yours
