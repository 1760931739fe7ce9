#> Figure: a patch of ships
# gnuplot -c 03_gravity_wells_patch.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(540)
set output ARG2
set key top left
set xtics 2; set ytics 2
set ylabel 'velocity [m/s]' offset 0.7,0
yours = with_yours("for [i = 0:2] ARG3 index i using k:k + 1 every 3 with points lt 2 pt 6 ps 0.6 lw 1.5 title (i == 0 ? 'yours' : '')")
set multiplot layout 2,1 margins screen 0.15,0.985,0.125,0.985 spacing screen 0.07
do for [panel = 0:1] {
    k = 1 + 3 * panel; colour = panel == 0 ? 6 : 1
    set label 1 (panel == 0 ? 'explicit Euler' : 'semi-implicit Euler') at 4.5,4.9 right textcolor lt colour
    do for [i = 0:2] { # what the first one is stands above it, beside the others there's room
        stats ARG1 index i using k:k + 1 nooutput
        x = i == 0 ? (STATS_min_x + STATS_max_x) / 2 : STATS_max_x + 0.2; y = i == 0 ? STATS_max_y + 2 : (STATS_min_y + STATS_max_y) / 2 + 0.5
        stats ARG1 index i using 7:k + 2 nooutput
        words = (i == 0 ? 'at first' : sprintf('%d steps', STATS_max_x)) . sprintf("\n%.2f m²/s", STATS_max_y)
        if (i == 0) { set label 2 words at x,y center textcolor rgb INK } else { set label i + 2 words at x,y left textcolor rgb INK }
    }
    if (panel == 1) { set xlabel 'position [m]' }
    plot [-6.3:4.7] [-5.6:5.4] for [i = 0:2] ARG1 index i using k:k + 1 with filledcurves closed lt colour dt solid fs transparent solid 0.3 border notitle, \
         @yours
}
unset multiplot
