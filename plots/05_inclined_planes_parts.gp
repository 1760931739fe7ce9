#> Figure: the parts of a weight
# gnuplot -c 05_inclined_planes_parts.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5
set size ratio -1
set xrange [-0.3:4.6]; set yrange [-0.45:3.1]
set label '5 m' at 1.0,1.05 right textcolor rgb INK
set label '3 m' at 4.1,1.4 left textcolor rgb INK
set label '4 m' at 1.4,-0.22 center textcolor rgb INK
set label '100 N' at 2.05,0.32 left textcolor rgb INK
set label '60 N' at 1.45,1.33 right textcolor lt 6
set label '80 N' at 2.55,1.0 left textcolor lt 1
set label 'normal force, 80 N' at 1.65,2.35 right textcolor lt 3
yours = with_yours("ARG3 using 1:2:3:4 every ::2 with vectors lt 2 lw 2 title 'yours'")
plot '+' using (4 * $0 / 199):(3 * $0 / 199) with lines lc rgb INK lw 3 dt solid notitle, \
     '+' using (4 * $0 / 199):(0) with lines lc rgb DIM lw 1 dt solid notitle, \
     '+' using (4):(3 * $0 / 199) with lines lc rgb DIM lw 1 dt (3,4) notitle, \
     ARG1 using 1:2:3:4 every ::0::0 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors lt 6 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::2 with vectors lt 1 lw 2.5 notitle, \
     ARG1 using 1:2:3:4 every ::3::3 with vectors lt 3 lw 2.5 dt solid notitle, \
     @yours
