# One look for all figures: `load 'style.gp'` is the first line of every script.
#
# A colour stands here as a figure shows it on a light page; behind "dark:" is what `course draw` makes of it on a dark
# one. Draw with these alone, by name (INK, DIM) or by line type (lt 1 to 6): another colour is refused, because nobody
# has looked at it on both. Blue and orange, lt 1 and 2, differ for every eye: our curve and the student's.
#
# Colour is never the only difference: a line type has its own dashes and its own mark, too; an arrow has `dt solid`,
# and words beside it. Words at a curve's end, in its colour, are better than a key.
INK = "#1d2430"                            # dark: #e3e8f0   words
DIM = "#66707f"                            # dark: #97a2b3   axes, grid, walls, what is known beforehand
set linetype 1 lc rgb "#2563eb" lw 2 pt 7  dt solid           # dark: #6ea8fe   blue
set linetype 2 lc rgb "#d9480f" lw 2 pt 5  dt (6,4)           # dark: #ff9c66   orange
set linetype 3 lc rgb "#0b8562" lw 2 pt 9  dt (12,4)          # dark: #3ddca0   green
set linetype 4 lc rgb "#a16207" lw 2 pt 13 dt (2,3)           # dark: #f5c542   amber
set linetype 5 lc rgb "#7c3aed" lw 2 pt 11 dt (12,3,2,3)      # dark: #b79cff   violet
set linetype 6 lc rgb "#c02672" lw 2 pt 15 dt (12,3,2,3,2,3)  # dark: #ff8ac4   pink
set linetype cycle 6

# A phone shows a figure 350 px wide, a desk 540 px: with letters of 17 px on 480, they are 12 px there and 19 px here.
# A figure with another height than 340 px says `eval canvas(240)` below `load`.
set encoding utf8
set minussign # −10, not -10, at the axes, as in the text
canvas(height) = sprintf('set terminal svg size 480,%d enhanced font "Inter,Segoe UI,Helvetica,Arial,sans-serif,17" linewidth 1.3 rounded', height)
eval canvas(340)
set border 3 lc rgb DIM lw 0.8
set lmargin 5.5; set rmargin 1.2; set bmargin 2.8 # gnuplot's own are twice as wide; the upper one leaves room for a key
set tics nomirror out scale 0.5 textcolor rgb DIM
set xtics offset 0,0.3
set grid lc rgb DIM lw 0.35 dt (1,3)
set key top right Left reverse samplen 1.5 spacing 1.25 textcolor rgb INK noopaque # Left reverse: a wider font overlaps nothing
set title textcolor rgb INK; set xlabel textcolor rgb INK offset 0,0.6; set ylabel textcolor rgb INK offset 1.5,0

set samples 200
set datafile separator "\t"

# A curve from the student's trace, which is a script's third argument (ARG3); without one, nothing.
with_yours(curve) = ARGC > 2 ? curve : "NaN notitle"

# What our curve is called: by its name, or "ours" beside the student's.
ours(name) = ARGC > 2 ? 'ours' : name
