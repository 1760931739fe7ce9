#> Figure: an arm above the ground
# gnuplot -c 09_forward_kinematics_ground.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key at 5.3,0.9
set xrange [-1.6:5.4]; set yrange [-0.75:3.8]
set object 1 rectangle from -1.6,-0.75 to 5.4,0 fillstyle solid 0.12 noborder fc rgb DIM behind
set label 'ground' at -1.4,-0.3 left textcolor rgb INK
set label 'this joint turns' at 0.85,3.0 right textcolor rgb INK
set label 'before' at 3.2,2.5 left textcolor rgb DIM
set label 'as far as it goes' at 1.75,1.3 left textcolor lt 1
yours = with_yours("ARG3 using 3:4 with points lt 2 pt 6 ps 1.8 title 'yours'")
plot ARG1 using 1:2 with linespoints lc rgb DIM lw 2.5 pt 7 dt (5,4) notitle, \
     ARG1 using 3:4 with linespoints lt 1 lw 3 notitle, \
     @yours
