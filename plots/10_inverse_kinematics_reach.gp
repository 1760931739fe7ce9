#> Figure: a reach with a hole
# gnuplot -c 10_inverse_kinematics_reach.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key bottom left
set xrange [-7.2:7.2]; set yrange [-6.9:5.4]
set label 'reach: 5 m' at -0.6,-4.3 center textcolor rgb INK
set label 'hole: 1 m' at 0,-1.5 center textcolor rgb INK
set label 'this one stays' at 2.0,-2.55 center textcolor lt 1
yours = with_yours("ARG3 using ($1 + $3):($2 + $4) with points lt 2 pt 6 ps 1.6 title 'yours'")
circle(r) = sprintf("'+' using (%g * cos(2 * pi * $0 / 199)):(%g * sin(2 * pi * $0 / 199)) with lines lc rgb DIM lw 2 dt solid notitle", r, r)
far = circle(5); near = circle(1)
plot @far, @near, ARG1 using 1:2:3:4 with vectors lt 1 lw 2 dt solid notitle, \
     ARG1 using 1:2 with points lt 6 pt 2 ps 1.1 lw 2 title 'target', \
     ARG1 using ($1 + $3):($2 + $4) with points lt 1 ps 0.9 notitle, \
     @yours
