#> Figure: in a turned box
# gnuplot -c 06_reflection_turned.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set key top right
set lmargin 6
set size ratio -1
set xrange [-8:8]; set yrange [-7.5:7.5]
set xtics 4; set ytics 4
set xlabel 'x [m]'; set ylabel 'y [m]'
set object 1 polygon from -1,-7 to 7,-1 to 1,7 to -7,1 to -1,-7 fillstyle empty border lc rgb INK lw 2
yours = with_yours("ARG3 using 1:2 every 3 with points lt 2 pt 6 ps 0.7 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     ARG1 using 1:2 every ::0::0 with points lt 1 ps 1.2 notitle, \
     @yours
