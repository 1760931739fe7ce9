# One look for all figures: `load 'style.gp'` is the first line of every script.
#
# A colour stands here as a figure shows it on a light page; behind "dark:" is what `course draw` makes of it on a dark
# one. Draw with these alone, by name (INK, DIM) or by line type (lt 1 to 6): another colour is refused, because nobody
# has looked at it on both. Blue and orange, lt 1 and 2, differ for every eye: the reference and the student's curve.
INK = "#1d2430"                            # dark: #e3e8f0   words
DIM = "#66707f"                            # dark: #97a2b3   axes, grid, walls, what is known beforehand
set linetype 1 lc rgb "#2563eb" lw 2 pt 7  # dark: #6ea8fe   blue
set linetype 2 lc rgb "#d9480f" lw 2 pt 5  # dark: #ff9c66   orange
set linetype 3 lc rgb "#0b8562" lw 2 pt 9  # dark: #3ddca0   green
set linetype 4 lc rgb "#a16207" lw 2 pt 13 # dark: #f5c542   amber
set linetype 5 lc rgb "#7c3aed" lw 2 pt 11 # dark: #b79cff   violet
set linetype 6 lc rgb "#c02672" lw 2 pt 15 # dark: #ff8ac4   pink
set linetype cycle 6

# 640 px is as wide as a text column and is scaled down to half on a phone: hence the large letters.
set encoding utf8
set terminal svg size 640,400 enhanced font "Inter,Segoe UI,Helvetica,Arial,sans-serif,16" linewidth 1.3 rounded
set border 3 lc rgb DIM lw 0.8
set tics nomirror out scale 0.5 textcolor rgb DIM
set xtics offset 0,0.3
set grid lc rgb DIM lw 0.35 dt (1,3)
set key top right Left reverse samplen 1.5 spacing 1.25 textcolor rgb INK noopaque # Left reverse: a wider font overlaps nothing
set title textcolor rgb INK; set xlabel textcolor rgb INK offset 0,0.6; set ylabel textcolor rgb INK offset 1.5,0

set samples 200
set datafile separator "\t"

# A curve from the student's trace, which is a script's third argument (ARG3); without one, nothing.
with_yours(curve) = ARGC > 2 ? curve : "NaN notitle"
