#> Figure: three bursts
# gnuplot -c 11_particles_discs.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(190)
set output ARG2
set margins 0,0,0,0
set size ratio -1
set xrange [-1.15:6.35]; set yrange [-1.15:1.6]
unset border; unset tics; unset grid; unset key
set label 'spread evenly' at 0,1.35 center textcolor lt 1
set label 'random speed' at 2.6,1.35 center textcolor lt 6
set label 'as printed' at 5.2,1.35 center textcolor lt 5
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 0.5 lw 1 title 'yours'")
plot ARG1 using 1:2 with points lt 1 pt 7 ps 0.25, \
     ARG1 using ($3 + 2.6):4 with points lt 6 pt 7 ps 0.25, \
     ARG1 using ($5 + 5.2):6 with points lt 5 pt 7 ps 0.25, \
     @yours
