#> Figure: a letter that an arm has drawn
# gnuplot -c 10_inverse_kinematics_letter.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set key bottom right
set xrange [-1.4:3.9]; set yrange [-2.5:3.5]
set label 'first joint' at -0.2,0 right textcolor rgb INK
set label 'here it starts' at 1.35,0.85 right textcolor rgb INK
yours = with_yours("ARG3 using ($1 == 0 ? $2 : NaN):3 with points lt 2 pt 6 ps 1.0 lw 1.5 title 'yours'")
plot ARG1 using ($1 == 1 ? $2 : NaN):3 with linespoints lc rgb DIM lw 2 pt 7 ps 0.9 dt solid notitle, \
     ARG1 using ($1 == 0 ? $2 : NaN):3 with linespoints lt 6 lw 3 pt 7 ps 0.5 dt solid title ours('a dot for each pose'), \
     @yours
