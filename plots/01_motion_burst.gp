#> Figure: a missile breaks in two
# gnuplot -c 01_motion_burst.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set key outside top center horizontal
set xrange [*<-0.2:6.9<*] noextend; set yrange [*<-1.1:4.1<*] noextend
set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set label 'nose, 1 kg' at 4.4,3.6 center textcolor lt 6
set label 'hull, 3 kg' at 3.3,-0.7 right textcolor lt 3
set label 'centre of mass' at 3.95,1.5 left textcolor lt 1
set label 'dashed: unbroken' at 3.95,0.9 left textcolor rgb DIM
yours = with_yours("ARG3 using 7:8 every 10 with points lt 2 pt 6 ps 1.6 lw 2 title 'yours'")
plot ARG1 using 1:2 with lines lc rgb DIM lw 1.5 dt (5,4) notitle, \
     ARG1 using 3:4 every ::30 with lines lt 6 notitle, \
     ARG1 using 5:6 every ::30 with lines lt 3 notitle, \
     ARG1 using 7:8 every 10 with points lt 1 ps 0.9 notitle, \
     @yours
