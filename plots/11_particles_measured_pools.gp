#> Figure: the speed of three pools
# gnuplot -c 11_particles_measured_pools.gp TRACE SVG
load 'style.gp'
set output ARG2
set logscale xy
set lmargin 7
set key outside top center horizontal maxrows 1 width -2
set format x '10^{%T}'
set xrange [150:2e6]; set yrange [0.03:3000]
set ytics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000)
set xlabel 'particles'; set ylabel 'million particles / s'
set label 'linear search' at 1e4,20 right textcolor lt 6
set label 'slope −1' at 1.25e5,10 textcolor rgb DIM
set label 'dashed: memory' at 6e3,220 textcolor rgb DIM
plot ARG1 using 1:5 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     (x > 1500 ? 3.7e5 / x : NaN) with lines lc rgb DIM lw 1 dt (2,4) notitle, \
     ARG1 using 1:2 with linespoints lt 6 dt solid notitle, \
     ARG1 using 1:3 with linespoints lt 3 dt solid title 'free list', \
     ARG1 using 1:4 with linespoints lt 1 title 'swap-and-pop'
