#> Figure: three sweeps of a tentacle
# gnuplot -c 10_inverse_kinematics_sweeps.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(250)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key at 17.6,-0.9
set xrange [-1.2:17.8]; set yrange [-1.9:4.3]
across(i) = i == 0 ? 0 : 1.2 + 4.1 * i
set label 'target' at 1.6,2.5 right textcolor lt 6
set for [i = 0:3] label (i == 0 ? 'at first' : i == 1 ? '1 sweep' : sprintf('%d sweeps', i)) at across(i) + (i == 0 ? 2 : 1),-0.7 center textcolor rgb INK
yours = with_yours("for [i = 0:3] ARG3 index i using (across(i) + $1):2 with points lt 2 pt 6 ps 0.8 lw 1.2 title (i == 0 ? 'yours' : '')")
plot for [i = 0:3] ARG1 index i using (across(i) + $1):2 with linespoints lt 1 ps 0.5 notitle, \
     for [i = 0:3] '+' using (across(i) + 2):(2.5) every ::0::0 with points lt 6 pt 2 ps 1.1 lw 2 notitle, \
     @yours
