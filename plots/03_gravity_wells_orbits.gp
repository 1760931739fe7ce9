#> Figure: one ellipse, four integrators
# gnuplot -c 03_gravity_wells_orbits.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(460)
set output ARG2
set key off
set size ratio -1
set xrange [-17:9]; set yrange [-11:11]
set xtics 10; set ytics 10
set lmargin 4.4; set rmargin 0.6; set bmargin 1.6; set tmargin 1.6
name(k) = word('explicit semi-implicit leapfrog Runge–Kutta', k) . (k < 3 ? ' Euler' : '')
colour(k) = int(word('6 1 3 5', k))
yours = with_yours("ARG3 using (column(2 * k - 1)):(column(2 * k)) every 3 with points lt 2 pt 6 ps 0.5 lw 1.5 notitle")
set multiplot layout 2,2
do for [k = 1:4] {
    set title name(k) offset 0,-0.6
    plot ARG1 using (column(2 * k - 1)):(column(2 * k)) with lines lt colour(k) notitle, \
         '+' using (0):(0) every ::0::0 with points lc rgb INK pt 7 ps 0.9 notitle, \
         @yours
}
unset multiplot
