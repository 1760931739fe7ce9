#> Figure: two shots
# gnuplot -c 13_table_hockey_shots.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(280)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key top left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-1.08:1.08]; set yrange [-0.6:0.6]
do for [side in '-1 1'] {
  set object circle at 0.5*side,0 size 0.05 fillstyle solid 0.4 noborder fc rgb DIM
  set arrow from side,-0.5 to side,-0.15 nohead lc rgb INK lw 3 dt solid
  set arrow from side,0.15 to side,0.5 nohead lc rgb INK lw 3 dt solid
  set arrow from -1,0.5*side to 1,0.5*side nohead lc rgb INK lw 3 dt solid
}
set label '20°' at -0.1,-0.12 left textcolor lt 3
set label '25°' at -0.45,-0.07 left textcolor lt 1
yours = with_yours("ARG3 index 1 using 2:3 with lines lt 2 lw 2 title 'yours, 25°'")
plot ARG1 index 0 using 2:3 with lines lt 3 lw 1.5 notitle, \
     ARG1 index 1 using 2:3 with lines lt 1 lw 2 notitle, \
     ARG1 index 1 using 2:3:(0.03) every ::0::0 with circles lt 1 lw 2 notitle, \
     @yours
