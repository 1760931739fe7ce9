#> Figure: a quarter of the area, a quarter of the sparks
# gnuplot -c 11_particles_area.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(235)
set output ARG2
set margins 0,0,0,0
set size ratio -1
set xrange [-1.08:3.6]; set yrange [-1.12:1.36]
unset border; unset tics; unset grid; unset key
set angles degrees
do for [i=1:3] { set label word("area radius sparks", i) at 1.5 + 0.75 * (i - 1),1.22 center textcolor rgb DIM }
do for [k=1:4] {
    u = k / 4.0
    r = sqrt(u)
    stats ARG1 using ($1 * $1 + $2 * $2 < u ? 1 : NaN) nooutput
    y = 0.84 - 0.32 * (4 - k)
    set arrow from r * cos(35 - 14 * (4 - k)),r * sin(35 - 14 * (4 - k)) to 1.22,y nohead lc rgb DIM lw 0.8
    set label sprintf('%.2f', u) at 1.5,y center textcolor rgb INK
    set label sprintf('%.2f', r) at 2.25,y center textcolor rgb INK
    set label sprintf('%d', STATS_records) at 3.0,y center textcolor lt 1
}
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 0.6 lw 1 title 'yours'")
circle(k) = sqrt(k / 4.0)
plot for [k=1:4] [t=0:360] '+' using (circle(k) * cos(t)):(circle(k) * sin(t)) with lines lc rgb DIM lw 1 dt solid, \
     ARG1 using 1:2 with points lt 1 pt 7 ps 0.25, \
     @yours
