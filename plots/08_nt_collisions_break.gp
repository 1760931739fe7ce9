#> Figure: a break shot
# gnuplot -c 08_nt_collisions_break.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(290)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-0.2:16.2]; set yrange [-0.2:9.2]
set object 1 rectangle from 0,0 to 16,9 fillstyle empty border lc rgb INK lw 2
set label 'cue ball' at 3.2,5.3 left textcolor lt 2
yours = with_yours("for [i = 0:15] ARG3 using (column(2 * i + 2)):(column(2 * i + 3)):(0.12) every ::50::50 with circles lt 2 fillstyle solid noborder title (i == 0 ? 'yours' : '')")
plot for [i = 1:15] ARG1 using (column(2 * i + 2)):(column(2 * i + 3)):(0.3) every ::0::0 with circles lc rgb DIM lw 1 notitle, \
     for [i = 1:15] ARG1 using (column(2 * i + 2)):(column(2 * i + 3)) with lines lt 1 lw 1.5 notitle, \
     for [i = 1:15] ARG1 using (column(2 * i + 2)):(column(2 * i + 3)):(0.3) every ::50::50 with circles lt 1 lw 2 notitle, \
     ARG1 using 2:3 with lines lt 2 lw 1.5 notitle, \
     ARG1 using 2:3:(0.3) every ::0::0 with circles lc rgb DIM lw 1 notitle, \
     ARG1 using 2:3:(0.3) every ::50::50 with circles lt 2 lw 2 notitle, \
     @yours
