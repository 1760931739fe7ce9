#> Figure: both elbows for many targets
# gnuplot -c 10_inverse_kinematics_grid.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(290)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key at 20,14.4 horizontal maxrows 1 width -1.5 samplen 1.2
set xrange [-21.3:21.3]; set yrange [-9.6:14.6]
yours = with_yours("ARG3 using ($1 > 0 ? $2 : NaN):3 with points lt 2 pt 6 ps 0.8 lw 1.2 title 'yours'")
plot ARG1 using ($1 == 1 ? $2 : NaN):3 with linespoints lt 1 lw 2.5 ps 0.5 title 'left', \
     ARG1 using ($1 == 2 ? $2 : NaN):3 with linespoints lt 3 lw 2.5 ps 0.5 title 'right', \
     ARG1 using ($1 == 0 ? $2 : NaN):3 with points lt 6 pt 2 ps 0.9 lw 1.5 title 'target', \
     @yours
