#> Figure: a hundred matches each
# gnuplot -c 13_table_hockey_matches.gp TRACE SVG [THE STUDENT'S TRACE]
load 'style.gp'
eval canvas(320)
set output ARG2
set key top left
set lmargin 7.5
set xrange [-5.6:5.6]; set yrange [0:*]
set xtics 1; set ytics 10
set xlabel 'goals that the beginner is ahead'; set ylabel 'matches'
yours = with_yours("ARG3 using 1:2 with points lt 2 pt 6 ps 1.2 lw 1.5 title 'yours, easy'")
set style fill solid 0.5
set boxwidth 0.38
plot ARG1 using ($1-0.2):2 with boxes lt 1 dt solid title 'easy machine', \
     ARG1 using ($1+0.2):3 with boxes lt 5 dt solid fs empty border lt 5 title 'hard machine', \
     @yours
