#> Figure: two pairs and their sides
# gnuplot -c 07_segment_intersection_sides.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(260)
set output ARG2
set multiplot layout 1,2
set size ratio -1
unset key
set tmargin 2; set bmargin 1.6; set lmargin 3.2; set rmargin 1
set xtics 4; set ytics 4
set title 'they meet' offset 0,-0.6
set xrange [0:18]; set yrange [0:12]
set arrow 1 from 1,1 to 5,3.25 head filled size 0.9,20 lc rgb DIM lw 3; set label 3 'wall' at 13.4,9.6 center textcolor rgb DIM
set label 1 'left' at 4,8.4 center textcolor lt 1; set label 2 'right' at 16,1.6 center textcolor lt 1
plot ARG1 using 3:4 every ::0::1 with linespoints lc rgb DIM lw 3 pt 7 ps 0.5, \
     ARG1 using 1:2 every ::0::1 with linespoints lt 1 ps 0.8
unset label
set xtics 1; set ytics 1
set title 'they do not'
set xrange [-0.7:4.7]; set yrange [-0.3:3.3]
set arrow 1 from 3,0 to 2.2,0.8 head filled size 0.27,20 lc rgb DIM lw 3; set label 3 'wall' at 1.9,1.6 left textcolor rgb DIM
set label 1 'left' at 0.4,0 left textcolor lt 1; set label 2 'left' at 0.8,1.25 right textcolor lt 1
plot ARG1 using 3:4 every ::2::3 with linespoints lc rgb DIM lw 3 pt 7 ps 0.5, \
     ARG1 using 1:2 every ::2::3 with linespoints lt 1 ps 0.8
unset multiplot
