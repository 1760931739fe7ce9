#> Figure: two normals of one wall
# gnuplot -c 06_reflection_normals.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(400)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key center right
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5
set size ratio -1
set xrange [-5.4:5]; set yrange [-5.2:5.2]
set label 'before' at -3.6,-0.5 center textcolor rgb INK
set label "unit normal,\ntwice as long" at -1.75,1.3 right textcolor lt 3
set label 'after' at -1.6,4.6 right textcolor lt 1
set label "without\nthe minus" at 1.75,1.3 left textcolor lt 4
set label "after, without\nthe minus" at -0.8,-3.6 left textcolor lt 6
set label 'wall' at 3.4,4 left textcolor rgb DIM
yours = with_yours("ARG3 using 1:2:3:4 every ::2::2 with vectors lt 2 lw 2 title 'yours'")
plot '+' using (7.2 * $0 / 199 - 3.6):(9.6 * $0 / 199 - 4.8) with lines lc rgb DIM lw 3 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::0::0 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors lt 3 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::2 with vectors lt 1 lw 2.5 notitle, \
     ARG1 using 1:2:3:4 every ::3::3 with vectors lt 4 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::4::4 with vectors lt 6 lw 2.5 dt solid notitle, \
     @yours
