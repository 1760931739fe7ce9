#> Figure: three centres of an L
# gnuplot -c 01_motion_l.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(420)
set output ARG2
set size ratio -1
set key top right
set xrange [*<-0.3:3.7<*] noextend; set yrange [*<-0.2:3.2<*] noextend
set xtics 1; set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set object 1 polygon from 0,0 to 0,3 to 1,3 to 1,1 to 3,1 to 3,0 to 0,0 behind fillcolor rgb DIM fillstyle transparent solid 0.2 border lc rgb DIM lw 2
set label 'centroid' at 1.2,0.78 textcolor lt 1
set label 'mean of the corners' at 1.5,1.28 textcolor lt 6
set label 'middle of the box' at 1.7,1.62 textcolor lt 4
yours = with_yours("ARG3 using 3:4 every ::0::0 with points lt 2 pt 6 ps 2 lw 2 title 'yours'")
plot ARG1 using 1:2 with points pt 7 ps 0.5 lc rgb DIM notitle, \
     ARG1 using 3:4 every ::0::0 with points lt 1 ps 0.9 notitle, \
     '+' using (4/3.0):(4/3.0) every ::0::0 with points lt 6 pt 2 ps 0.8 lw 3 notitle, \
     '+' using (1.5):(1.5) every ::0::0 with points lt 4 ps 0.9 notitle, \
     @yours
