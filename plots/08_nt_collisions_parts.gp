#> Figure: the components of a velocity
# gnuplot -c 08_nt_collisions_parts.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(410)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom right
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-1.6:5.6]; set yrange [-2.9:3.4]
set label 'A' at -0.6,0.02 center textcolor rgb INK
set label 'B' at 1.95,0.95 center textcolor rgb INK
set label 'line of centres' at 4.5,2.95 center rotate by 37 textcolor rgb DIM
set label 'velocity, 5 m/s' at 4.9,-0.32 right textcolor rgb INK
set label "normal,\n4 m/s" at 3.3,1.95 left textcolor lt 6
set label "tangential,\n−3 m/s" at 1.75,-1.35 left textcolor lt 3
yours = with_yours("for [i = 1:2] ARG3 using 1:2:3:4 every ::i::i with vectors lt 2 lw 2 title (i == 1 ? 'yours' : '')")
plot ARG1 using (0):(0):(1) every ::0::0 with circles lc rgb INK lw 2 dt solid notitle, \
     ARG1 using (1.6):(1.2):(1) every ::0::0 with circles lc rgb INK lw 2 dt solid notitle, \
     '+' using (8.4 * $0 / 199 - 2):(6.3 * $0 / 199 - 1.5) with lines lc rgb DIM lw 1 dt (3,4) notitle, \
     '+' using (-4.2 * $0 / 199 + 2.1):(5.6 * $0 / 199 - 2.8) with lines lc rgb DIM lw 1 dt (3,4) notitle, \
     ARG1 using 1:2:3:4 every ::0::0 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors lt 6 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::2 with vectors lt 3 lw 2.5 dt solid notitle, \
     @yours
