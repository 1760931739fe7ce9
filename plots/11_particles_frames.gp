#> Figure: four frames and what is left over
# gnuplot -c 11_particles_frames.gp TRACE SVG
load 'style.gp'
eval canvas(280)
set output ARG2
unset key
set xrange [0.4:4.6]; set yrange [0:3.6]
unset xtics; set ytics 1
do for [i=1:4] { set label sprintf('frame %d', i) at i,-0.35 center textcolor rgb INK }
set bmargin 2.5
set ylabel 'particles' offset 1,0
set label 'emitted' at 1,1 center front textcolor rgb INK
plot ARG1 using 1:(0.5 * $3):(0.42):(0.5 * $3) with boxxyerror lt 1 fs transparent solid 0.25 border, \
     ARG1 using 1:($3 + 0.5 * $4):($4 > 0 ? 0.42 : NaN):(0.5 * $4) with boxxyerror lt 2 fs empty, \
     ARG1 using ($4 > 0 ? $1 : NaN):($3 + 0.5 * $4):(sprintf('%g left', $4)) with labels textcolor lt 2, \
     ARG1 using 1:($3 + $4 + 0.24):(sprintf('%g + 2.5', $2)) with labels textcolor rgb INK
