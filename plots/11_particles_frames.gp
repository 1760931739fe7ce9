#> Figure: four frames and what is left over
# gnuplot -c 11_particles_frames.gp TRACE SVG
load 'style.gp'
set terminal svg size 640,320 enhanced font "Inter,Segoe UI,Helvetica,Arial,sans-serif,16" linewidth 1.3 rounded
set output ARG2
set key outside top center horizontal
set xrange [0.4:4.6]; set yrange [0:3.4]
unset xtics; set ytics 1
do for [i=1:4] { set label sprintf('frame %d', i) at i,-0.32 center textcolor rgb INK }
set bmargin 2.5
set ylabel 'particles' offset 1,0
set style fill solid 0.85
plot ARG1 using 1:(0.5 * $3):(0.34):(0.5 * $3) with boxxyerror lt 1 title 'emitted', \
     ARG1 using 1:($3 + 0.5 * $4):($4 > 0 ? 0.34 : NaN):(0.5 * $4) with boxxyerror lt 2 title 'left for the next frame', \
     ARG1 using 1:($3 + $4 + 0.22):(sprintf('%g + 2.5', $2)) with labels textcolor rgb INK notitle
