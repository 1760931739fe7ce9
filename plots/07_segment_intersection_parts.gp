#> Figure: the parts of a velocity at a wall
# gnuplot -c 07_segment_intersection_parts.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(380)
set output ARG2
set size ratio -1
unset key
set xrange [12:24.2]; set yrange [-3.4:5.2]
set xtics 2; set ytics 2
set xlabel 'x [m]; arrows in m/s'; set ylabel 'y [m]'
set style arrow 1 head filled size 0.25,20 lt 1 lw 2.5
set style arrow 2 head filled size 0.25,20 lt 3 dt solid lw 2.5
set style arrow 3 head filled size 0.25,20 lt 4 dt solid lw 2
set style arrow 4 head filled size 0.25,20 lt 4 lw 2 dt (5,4)
set style arrow 5 head filled size 0.25,20 lt 2 dt solid lw 2.5
set label 'before: (5, 0)' at 13.5,2.45 textcolor lt 1
set label 'tangential part' at 19.8,0.9 textcolor lt 3
set label 'normal part' at 20.6,3.1 left textcolor lt 4
set label 'reversed' at 14.9,0.3 right textcolor lt 4
set label "after:\n(−1.4, −4.8)" at 16.4,-2.0 right textcolor lt 2
set arrow from 20,0 to 16.1,5.2 back nohead lc rgb DIM lw 5
set label 'corner (20, 0)' at 20,0 left front offset 1.3,0 textcolor rgb DIM point pt 7 ps 0.7 lc rgb DIM
set arrow from 18.5,2 to 17.7,1.4 head filled size 0.2,20 lc rgb INK lw 2
set label 'n' at 17.55,0.9 center textcolor rgb INK
set label 'wall' at 16.9,4.7 left textcolor rgb DIM
plot ARG1 using 1:2:3:4 every ::0::0 with vectors arrowstyle 1, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors arrowstyle 3, \
     ARG1 using 1:2:3:4 every ::2::2 with vectors arrowstyle 2, \
     ARG1 using 1:2:3:4 every ::3::3 with vectors arrowstyle 4, \
     ARG1 using 1:2:3:4 every ::4::4 with vectors arrowstyle 5
