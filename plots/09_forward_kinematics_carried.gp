#> Figure: a box that is carried
# gnuplot -c 09_forward_kinematics_carried.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key top right
set xrange [-1.2:7]; set yrange [-1.6:5]
yours = with_yours("ARG3 using ($1 == 1 ? $2 : NaN):3 with lines lt 2 lw 2 title 'yours'")
plot ARG1 using ($1 == 0 ? $2 : NaN):3 with linespoints lt 1 lw 3 ps 1.0 title 'arm', \
     ARG1 using ($1 == 1 ? $2 : NaN):3 with lines lt 6 lw 2.5 dt solid title 'box', \
     @yours
