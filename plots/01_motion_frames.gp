#> Figure: four frames, and what they hand on
# gnuplot -c 01_motion_frames.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
unset border; unset ytics; unset grid
set key outside top center horizontal
set xrange [33:112]; set yrange [3.85:-0.8]
set xtics 50,10,80 textcolor rgb DIM; set xlabel 'x [m]' offset -7,0.6
do for [frame = 0:3] {
    set object frame + 1 rectangle from 46,frame - 0.36 to 84.5,frame + 0.36 behind fillstyle empty border lc rgb DIM lw 1
    set label sprintf('t = %d s', frame) at 45,frame right textcolor rgb DIM
}
set label 'handed on' at 99,-0.65 center textcolor rgb INK
yours = with_yours("ARG3 using 2:1 with points lt 2 pt 6 ps 2 lw 2 title 'yours'")
plot ARG1 using 2:1:3:(0) with vectors lt 3 dt solid lw 2 filled size screen 0.02,25 title 'velocity', \
     ARG1 using 2:1 with points lt 1 ps 1.3 title 'missile', \
     ARG1 using (99):1:(sprintf('%g m, %g m/s', $2, $3)) with labels center textcolor rgb INK notitle, \
     ARG1 using (99):($1 + 0.28):(0):(0.42) with vectors lc rgb DIM lw 1 filled size screen 0.015,25 notitle, \
     @yours
