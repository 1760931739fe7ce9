#> Figure: Table 13.2 as a curve, with its gaps
# gnuplot -c 01_motion_table.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set lmargin 7
set key top left
set xrange [-0.2:5.6]; set yrange [*<45:100<*] # wider only for what is far off: yours
set xlabel 't [frames]'; set ylabel 'x [px]'
set label 'the missile' at 3.2,79 right textcolor lt 1
set label "dashed: from one\nframe to the next" at 3.5,57 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:2 every 5 with points lt 2 pt 6 ps 1.2 lw 2 title 'yours'")
before = NaN
gain(x) = (change = x - before, before = x, change) # from one row of the table to the next
plot ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 1:2 every 10 with points lt 1 ps 0.8 notitle, \
     ARG1 using 1:2 every 10 with steps lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using ($1 - 0.5):($2 - (gain($2) > 0 ? change : 0)):(sprintf('%+g', change)) every 10 with labels center offset 0,-0.7 textcolor lt 3 notitle, \
     @yours
