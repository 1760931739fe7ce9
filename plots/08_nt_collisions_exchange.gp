#> Figure: two equal balls, before and after
# gnuplot -c 08_nt_collisions_exchange.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(380)
set output ARG2
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key bottom left
set lmargin 0.5; set rmargin 0.5; set bmargin 0.5; set tmargin 0.5
set size ratio -1
set xrange [-5.2:4.6]; set yrange [-3.2:3.6]
set label 'A before: 5 m/s' at -4.9,0.5 left textcolor rgb INK
set label "A after:\n3 m/s" at 2.1,-1.9 left textcolor lt 3
set label "B after:\n4 m/s" at 2.35,3.1 right textcolor lt 1
set label 'a right angle' at 1.9,0.35 left textcolor rgb DIM
yours = with_yours("for [i = 1:2] ARG3 using 1:2:3:4 every ::i::i with vectors lt 2 lw 2 title (i == 1 ? 'yours' : '')")
plot ARG1 using (0):(0):(0.5) every ::0::0 with circles lc rgb INK lw 2 dt solid notitle, \
     ARG1 using (0.8):(0.6):(0.5) every ::0::0 with circles lc rgb INK lw 2 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::0::0 with vectors lc rgb INK lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::1::1 with vectors lt 3 lw 2.5 dt solid notitle, \
     ARG1 using 1:2:3:4 every ::2::2 with vectors lt 1 lw 2.5 notitle, \
     @yours
