#> Figure: points in a grid
# gnuplot -c 08_nt_collisions_grid.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(300)
set output ARG2
unset border; unset grid; unset xlabel; unset ylabel
set key outside bottom center horizontal samplen 1
set lmargin 0.5; set rmargin 0.5; set tmargin 0.5; set bmargin 2.2
set size ratio -1
set xrange [-0.02:5.52]; set yrange [-0.02:3.1]
set xtics 1 format '' scale 0; set ytics 1 format '' scale 0
set grid lc rgb DIM lw 0.8 dt solid
set object 1 rectangle from 1,0 to 4,3 fillstyle empty border lc rgb INK lw 2.5
yours = with_yours("ARG3 using ($3 == 1 ? $1 : NaN):2 with points lt 2 pt 6 ps 1.6 lw 2 title 'yours'")
plot ARG1 using 1:2:(1) every ::0::0 with circles lc rgb DIM lw 1.5 dt (5,4) notitle, \
     ARG1 using ($3 == 3 ? $1 : NaN):2 with points lc rgb DIM pt 1 ps 0.7 lw 1.5 notitle, \
     ARG1 using ($3 == 2 ? $1 : NaN):2 with points lt 3 pt 2 ps 1.1 title 'compared', \
     ARG1 using ($3 == 1 ? $1 : NaN):2 with points lt 1 ps 0.9 title 'close', \
     ARG1 using 1:2 every ::0::0 with points lc rgb INK pt 7 ps 1.2 notitle, \
     @yours
