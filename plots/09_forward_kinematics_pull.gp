#> Figure: stretch and pull
# gnuplot -c 09_forward_kinematics_pull.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
set output ARG2
set xlabel 'stretch [m]'; set ylabel 'pull [N]'
yours = with_yours("ARG3 using 1:2 with lines lt 2 title 'yours'")
plot ARG1 using 1:2 with linespoints lt 1 title 'a spring of 30 N/m', \
     @yours
