#> Figure: slots, before and after
# gnuplot -c 11_particles_slots.gp TRACE SVG
load 'style.gp'
eval canvas(190)
set output ARG2
set margins 0.5,0.5,0.5,0.5
unset border; unset tics; unset grid; unset key
set xrange [-2.2:4.6]; set yrange [-1.5:0.9]
set label 'before' at -0.6,0 right textcolor rgb INK
set label 'after spawn' at -0.6,-1 right textcolor rgb INK
do for [i=0:4] { set label sprintf('%d', i) at i,0.62 center textcolor rgb DIM }
plot ARG1 using 1:(-$2):(0.42):(0.42) with boxxyerror lc rgb DIM lw 1.2 fs empty, \
     ARG1 using ($3 == 1 ? $1 : NaN):(-$2) with points lt 1 ps 1.6, \
     ARG1 using ($3 == 2 ? $1 : NaN):(-$2) with points lt 4 ps 1.9, \
     ARG1 using ($3 == 0 ? $1 : NaN):(-$2):('free') with labels textcolor rgb DIM
