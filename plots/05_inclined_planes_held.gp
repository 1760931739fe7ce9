#> Figure: held or sliding
# gnuplot -c 05_inclined_planes_held.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key bottom right
set lmargin 7.5
set xrange [0:60]; set yrange [0:1.5]
set xtics 15; set ytics 0.5
set xlabel 'angle [°]'; set ylabel 'mu_s' noenhanced
set label 'held' at 15,1 center textcolor rgb INK
set label 'slides' at 45,0.4 center textcolor rgb INK
set label 'critical angle' at 47,1.2 right textcolor lt 1
yours = with_yours("ARG3 using 1:2 every 2 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot ARG1 using 1:2 with lines lt 1 notitle, \
     @yours
