#> Figure: a fast ball, frame by frame
# gnuplot -c 08_nt_collisions_fast.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(330)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-1.8:7.8]; set yrange [-2.9:3.1]
set label 'frame 0' at -1.1,-0.85 center textcolor lt 3
set label '1' at 0.9,0 center textcolor lt 3
set label '2' at 2.585,0 center textcolor lt 3
set label '3' at 3.812,-0.816 center textcolor lt 3
set label "3, if nobody\nlooks between" at 5.55,0.15 left textcolor rgb DIM
set label 'the contact' at 2.7,1.6 right textcolor lt 6
set arrow 1 from 2.6,1.3 to 2.98,0.5 lc rgb DIM lw 1 dt solid
set label 'A' at -1.1,0 center textcolor lt 3
set label 'B' at 4,0.6 center textcolor lt 1
yours = with_yours("ARG3 using 1:2:(0.4) with circles lt 2 lw 2 title 'yours'")
plot ARG1 using (4.9):(0):(0.5) every ::0::0 with circles lc rgb DIM lw 1.5 dt (4,4) notitle, \
     ARG1 using (3.2):(0):(0.5) every ::0::0 with circles lt 6 lw 1.5 notitle, \
     ARG1 using 1:2:(0.5) with circles lt 3 lw 2 dt solid notitle, \
     ARG1 using 3:4:(0.5) with circles lt 1 lw 2 notitle, \
     @yours
