#> Figure: slots, before and after
# gnuplot -c 11_particles_slots.gp TRACE SVG
load 'style.gp'
set terminal svg size 640,240 enhanced font "Inter,Segoe UI,Helvetica,Arial,sans-serif,16" linewidth 1.3 rounded
set output ARG2
unset border; unset tics; unset grid; unset key
set xrange [-1.9:4.7]; set yrange [-1.62:0.75]
set label 'before' at -0.7,0 right textcolor rgb INK
set label 'after spawn' at -0.7,-1 right textcolor rgb INK
do for [i=0:4] { set label sprintf('%d', i) at i,0.62 center textcolor rgb DIM }
plot ARG1 using 1:(-$2):(0.42):(0.36) with boxxyerror lc rgb DIM lw 1.2 fs empty, \
     ARG1 using ($3 == 1 ? $1 : NaN):(-$2) with points lt 1 pt 7 ps 1.6, \
     ARG1 using ($3 == 2 ? $1 : NaN):(-$2) with points lt 4 pt 7 ps 1.9, \
     ARG1 using ($3 == 0 ? $1 : NaN):(-$2):('free') with labels textcolor rgb DIM
