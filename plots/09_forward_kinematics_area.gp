#> Figure: the area of the two arrows
# gnuplot -c 09_forward_kinematics_area.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(280)
set output ARG2
set key top left
set lmargin 6; set rmargin 2.5
set xrange [-180:180]; set yrange [-18:18]
set xtics 90; set ytics 5
set xlabel 'angle at the elbow [°]'; set ylabel 'area [m²]'
set label 'straight: 0' at 14,-2.0 left textcolor rgb INK
set label 'folded: 0' at 168,-2.0 right textcolor rgb INK
yours = with_yours("ARG3 using 1:2 every 3 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
plot 0 with lines lc rgb DIM lw 1 dt solid notitle, \
     ARG1 using 1:2 with lines lt 1 title ours('lengths 3 m and 5 m'), \
     @yours
