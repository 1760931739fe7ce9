#> Figure: a shot, and where it ends
# gnuplot -c 13_table_hockey_shot.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(270)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-1.05:1.05]; set yrange [-0.55:0.55]
set object 1 circle at -0.5,0 size 0.05 fillstyle solid 0.3 border lc rgb DIM fc rgb DIM
set object 2 circle at 0.5,0 size 0.05 fillstyle solid 0.3 border lc rgb DIM fc rgb DIM
do for [side in '-1 1'] {
  set arrow from side,-0.5 to side,-0.15 nohead lc rgb INK lw 3
  set arrow from side,0.5 to side,0.15 nohead lc rgb INK lw 3
}
do for [side in '-0.5 0.5'] { set arrow from -1,side to 1,side nohead lc rgb INK lw 3 }
set label 'here it starts' at -0.72,-0.36 left textcolor lt 1
yours = with_yours("ARG3 using 2:3 with lines lt 2 lw 2 title 'yours'")
plot ARG1 using 2:3 with lines lt 1 lw 1.5 notitle, \
     ARG1 using 2:3:(0.03) every ::0::0 with circles lt 1 lw 2 notitle, \
     @yours
