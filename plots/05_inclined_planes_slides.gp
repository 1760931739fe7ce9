#> Figure: acceleration against angle
# gnuplot -c 05_inclined_planes_slides.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key bottom right
set lmargin 6.5
set xrange [0:90]; set yrange [-6:11]
set xtics 15; set ytics 5
set xlabel 'angle [°]'; set ylabel 'down the board [m/s²]'
set label 'it stays' at 12,0.9 center textcolor lt 1
set label 'it slides' at 52,7.4 right textcolor lt 1
set label 'first try' at 15.5,-2.4 left textcolor lt 6
set label '26.6°' at 26.57,4.1 center textcolor rgb DIM
set arrow from 26.57,0 to 26.57,3.2 nohead lc rgb DIM lw 1.5 dt solid
yours = with_yours("ARG3 using 1:2 every 3 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot [0:90] 10 * (sin(x * pi / 180) - 0.5 * cos(x * pi / 180)) with lines lt 6 notitle, \
     ARG1 using 1:($1 < 27 ? $2 : NaN) with lines lt 1 notitle, \
     ARG1 using 1:($1 > 26 ? $2 : NaN) with lines lt 1 notitle, \
     @yours
