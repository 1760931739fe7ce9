#> Figure: a fall that misses
# gnuplot -c 03_gravity_wells_sideways.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(545)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom right
set lmargin at screen 0; set rmargin at screen 1
array half[5]; array tenth[5] # the trace's columns after 0.5 s and after 0.1 s
do for [k = 1:5] {
    stats ARG1 using k every ::25::25 nooutput; half[k] = STATS_max
    stats ARG1 using k every ::5::5 nooutput; tenth[k] = STATS_max
}
r = half[5]
arc(from, to, lw) = sprintf("[t=%g:%g] '+' using (r * sin(t)):(r * cos(t)) with lines lc rgb DIM lw %g dt solid notitle", from, to, lw)
yours = with_yours("ARG3 using 2:($5 - $3) every 5 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours'")
set multiplot

# 0.5 s, at 40 px for a metre
set tmargin at screen 1; set bmargin at screen 145 / 545.0
set xrange [-3.4:8.6]; set yrange [-0.9:9.1]
side = half[2]; fallen = r - half[3]; bent = r - half[4]
set label 'ship' at -0.35,r + 0.35 right textcolor rgb INK
set label 'hole' at -0.35,0 right textcolor rgb INK
set label 'circle' at 7.6,2.35 center textcolor rgb DIM
set label sprintf('without the hole: v t = %.3g m', side) at 0.4,r + 0.47 left textcolor rgb INK
set label sprintf('the first %.3g s', half[1]) at 8.2,0.6 right textcolor rgb INK
set label sprintf("it falls\n½ a t² = %.3g m", half[3]) at side + 0.25,r - 0.45 left textcolor lt 6
set label sprintf('d = %.3g m', half[4]) at -0.25,r - half[4] / 2 - 0.1 right textcolor lt 5
set label sprintf("r − d =\n%.3g m", bent) at -0.25,bent / 2 + 0.3 right textcolor lt 3
set label sprintf('v t = %.3g m', side) at side / 2 - 0.3,bent - 0.45 center textcolor lt 3
set label sprintf('r = %.3g m', r) at side / 2 + 0.3,bent / 2 left textcolor lt 3
set arrow from 0,0 to 0,bent nohead lt 3 lw 2 dt solid
set arrow from 0,bent to side,bent nohead lt 3 lw 2 dt solid
set arrow from 0,0 to side,bent nohead lt 3 lw 2 dt solid
set arrow from 0,bent - 0.3 to 0.3,bent - 0.3 nohead lt 3 lw 1 dt solid
set arrow from 0.3,bent - 0.3 to 0.3,bent nohead lt 3 lw 1 dt solid
set arrow from 0,r to 0,bent nohead lt 5 lw 3 dt solid
set arrow from 0,r to side,r nohead lc rgb INK lw 1.5 dt (6,4)
set arrow from side,r to side,fallen size 0.25,25 filled lt 6 lw 2 dt solid
first = arc(-0.37, 1.22, 2)
plot sample @first, \
     ARG1 using 2:($5 - $3) with linespoints lt 1 lw 2.5 ps 0.6 pointinterval 5 notitle, \
     '+' using (side):(r) every ::0::0 with points lc rgb INK pt 8 ps 1 notitle, \
     '+' using (0):(r) every ::0::0 with points lc rgb INK pt 9 ps 1.3 notitle, \
     '+' using (0):(0) every ::0::0 with points lc rgb INK pt 7 ps 1.6 notitle, \
     @yours

# 0.1 s, at 400 px for a metre
unset label; unset arrow; unset key
set tmargin at screen 135 / 545.0; set bmargin at screen 0
set xrange [-0.1:1.1]; set yrange [r - 0.2225:r + 0.115]
side = tenth[2]
set label sprintf('the first %g s, ten times as large', tenth[1]) at -0.08,r + 0.095 left textcolor rgb INK
set label sprintf('v t = %.3g m', side) at 0.9,r + 0.035 right textcolor rgb INK
set label sprintf('it falls ½ a t² = %.3g m', tenth[3]) at side + 0.07,r - 0.115 right textcolor lt 6
set label sprintf('the circle bends by d = %.3g m', tenth[4]) at side + 0.07,r - 0.18 right textcolor lt 5
set arrow from 0,r to side,r nohead lc rgb INK lw 1.5 dt (6,4)
set arrow from side,r to side,r - tenth[3] size 0.025,25 filled lt 6 lw 2 dt solid
first = arc(-0.0115, 0.136, 5)
plot sample @first, \
     ARG1 using 2:($5 - $3) every ::0::5 with linespoints lt 1 lw 2 ps 0.7 notitle, \
     '+' using (0):(r) every ::0::0 with points lc rgb INK pt 9 ps 1.3 notitle, \
     @yours
unset multiplot
