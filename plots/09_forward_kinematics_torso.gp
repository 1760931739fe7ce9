#> Figure: a frame in a frame
# gnuplot -c 09_forward_kinematics_torso.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(360)
set output ARG2
set lmargin 3.5
set size ratio -1
set key bottom right
set xrange [-0.3:6.2]; set yrange [-0.3:4.3]
set xtics 1; set ytics 1
unset xlabel; unset ylabel
set label 'world' at 0.3,0.35 left textcolor rgb INK
set label 'torso, at (3, 1)' at 3.15,0.75 left textcolor lt 3
set label 'arm' at 4.2,3.05 left textcolor lt 6
set label '2 along x' at 4.05,1.4 left textcolor rgb DIM
set label '1 along y' at 4.5,2.65 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:2:3:4 every ::4::5 with vectors lt 2 lw 2 title 'yours'")
plot '+' using (3 + 1.6 * $0 / 199):(1 + 1.2 * $0 / 199) with lines lc rgb DIM lw 1.2 dt (4,4) notitle, \
     '+' using (4.6 - 0.6 * $0 / 199):(2.2 + 0.8 * $0 / 199) with lines lc rgb DIM lw 1.2 dt (4,4) notitle, \
     ARG1 using 1:2:3:4 every ::0::1 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::3 with vectors lt 3 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::4::5 with vectors lt 6 lw 2.5 dt solid notitle, \
     @yours
