#> Figure: an unfolded table
# gnuplot -c 06_reflection_unfolded.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(200)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom right
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-0.2:17.2]; set yrange [-0.3:6.3]
set object 1 rectangle from 0,0 to 10,6 fillstyle empty border lc rgb INK lw 2
set object 2 rectangle from 1,1 to 9,5 fillstyle empty border lc rgb DIM lw 1 dt (3,4)
set object 3 rectangle from 9,1 to 17,5 fillstyle empty border lc rgb DIM lw 1 dt (3,4)
set label 'the mirror' at 9.2,5.5 right textcolor rgb DIM
set label 'ball' at 2.4,1.7 left textcolor rgb INK
set label 'target' at 3.5,4.4 left textcolor rgb INK
set label 'its image' at 15,4.62 center textcolor rgb INK
set label 'straight on' at 12,2.9 center textcolor lt 4
yours = with_yours("ARG3 using 3:4 every 10 with points lt 2 pt 6 ps 0.9 lw 1.5 title 'yours'")
plot ARG1 using ($1 > 9 ? $1 : 1/0):2 with lines lt 4 notitle, \
     ARG1 using 3:4 with lines lt 1 notitle, \
     ARG1 using 1:2 every 130 with points lc rgb INK pt 7 ps 1.2 notitle, \
     ARG1 using 3:4 every ::130::130 with points lc rgb INK pt 6 ps 1.6 notitle, \
     @yours
