#> Figure: where three bodies balance
# gnuplot -c 01_motion_centre.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(360)
set output ARG2
set size ratio -1
set key outside top center horizontal
set xrange [*<-0.9:5.1<*] noextend; set yrange [*<-0.6:3.6<*] noextend
set xtics 1; set ytics 1
set xlabel 'x [m]'; set ylabel 'y [m]'
set object 1 rectangle from 0,0 to 4,3 behind fillstyle empty border lc rgb DIM lw 1 dt (5,4)
set label 'centre of mass' at 0.8,1.9 left textcolor lt 1
set label "middle\nof the box" at 2.3,1.6 left textcolor lt 4
set label 'mean without masses' at 1.0,0.65 left textcolor lt 6
yours = with_yours("ARG3 using 4:5 every ::0::0 with points lt 2 pt 6 ps 2 lw 2 title 'yours'")
plot ARG1 using 1:2:(1.3 * sqrt($3)) with points pt 7 ps variable lc rgb DIM notitle, \
     ARG1 using 1:2:(sprintf('%g kg', $3)) with labels left offset 1,0.8 textcolor rgb DIM notitle, \
     ARG1 using 4:5 every ::0::0 with points lt 1 ps 1.2 notitle, \
     '+' using (4/3.0):(1) every ::0::0 with points lt 6 pt 2 ps 1.2 lw 3 notitle, \
     '+' using (2):(1.5) every ::0::0 with points lt 4 ps 1.2 notitle, \
     @yours
