#> Figure: the speed of three pools
# gnuplot -c 11_particles_measured_pools.gp TRACE SVG
load 'style.gp'
set output ARG2
set logscale xy
set key outside top center horizontal
set format x '10^{%T}'
set xrange [150:2e6]; set yrange [0.03:2000]
set ytics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000)
set xlabel 'particles'; set ylabel 'millions of particles per second' offset 1,0
set label 'slope −1' at 1.25e5,8 textcolor rgb DIM
set label 'dashed: what memory can deliver' at 4e3,230 textcolor rgb DIM
plot ARG1 using 1:5 with lines lc rgb DIM lw 1 dt (5,4) notitle, \
     (x > 1500 ? 3.7e5 / x : NaN) with lines lc rgb DIM lw 1 dt (2,4) notitle, \
     ARG1 using 1:2 with linespoints lt 6 title 'linear search', \
     ARG1 using 1:3 with linespoints lt 3 title 'free list', \
     ARG1 using 1:4 with linespoints lt 1 title 'swap-and-pop'
