#> Figure: the time for all pairs, and for the close ones
# gnuplot -c 08_nt_collisions_measured_pairs.gp TRACE SVG
load 'style.gp'
set output ARG2
set logscale xy
set lmargin 8.5
set key top left
set format x '10^{%T}'
set xrange [80:1.3e5]; set yrange [0.005:50000]
set ytics ('0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000, '10000' 10000)
set xlabel 'balls'; set ylabel 'time [ms]'
set label 'all pairs' at 6e3,130 right textcolor lt 6
set label 'a map' at 2.2e4,120 left textcolor lt 2
set label 'sorted' at 8e3,1.1 left textcolor lt 1
set label 'one frame: 16.7 ms' at 100,35 left textcolor rgb DIM
plot 16.7 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     ARG1 using 1:2 with linespoints lt 6 dt solid notitle, \
     ARG1 using 1:3 with linespoints lt 2 notitle, \
     ARG1 using 1:4 with linespoints lt 1 notitle
