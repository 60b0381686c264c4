set datafile separator comma
set datafile missing NaN
set datafile columnheaders
set encoding utf8

# A run that ended early took its time for the frames that it attempted.
frames_done(d) = column("frames_reached") > frames ? frames : column("frames_reached")
passes(d) = (column("evaluations") + column("solves")) / frames_done(0)
work(d) = by_count ? passes(0) : column("median_s")
lower(d) = by_count ? passes(0) : column("lower_quartile_s")
upper(d) = by_count ? passes(0) : column("upper_quartile_s")

of(i) = strcol("library") eq library[i] && strcol("method") eq method[i]
held(d) = column("worst_px") < lost
# The n-th curve of a list. Even of an empty one gnuplot looks at the first, and warns if it has no point.
at(list, n) = n > words(list) ? 1 : word(list, n) + 0
error(i) = of(i) && (held(0) || drawn eq "") ? (column("worst_px") > finest ? column("worst_px") : finest) : NaN
# Failures stand in the strip at the edge, each curve's in a place of its own.
failure(i) = of(i) && (!held(0) || failing eq "") ? lost * 10 ** (0.08 + 0.84 * (i - 0.5) / curves) : NaN

d(n) = at(drawn, n)
h(n) = at(never_held, n)
f(n) = at(failing, n)

set logscale xy
set xrange [10 * lost : finest]
set yrange [least : most]
set format y "10^{%L}"
set xtics nomirror ()
do for [L = floor(log10(finest) + 0.5) : floor(log10(lost) + 0.5)] {
    set xtics add (L % 2 == 0 ? sprintf("10^{%d}", L) : "" 10.0 ** L)
}
set ytics nomirror
set mytics 10
set border 3
set key outside right top Left reverse noenhanced samplen 2.5 spacing 1.1
set title heading noenhanced
set xlabel "error: greatest distance of any mass from the truth, all frames, in pixels (more accurate to the right)"
set ylabel by_count ? "passes over the rope per frame: evaluations, solves, sweeps" : "time per frame, seconds"

set object 1 rectangle from 10 * lost, graph 0 to lost, graph 1 behind fc rgb "#f3e3dc" fs solid noborder
set label 1 "diverged, or off by more than ".sprintf("%g", lost)." px" at sqrt(10.0) * lost, graph 0.985 right rotate font ",9"
if (truth > finest) {
    set object 2 rectangle from truth, graph 0 to finest, graph 1 behind fc rgb "#e6e6e6" fs solid noborder
    set label 2 "the truth's own error" at sqrt(truth * finest), graph 0.985 right rotate font ",9"
}
set arrow 1 from 0.5, graph 0 to 0.5, graph 1 nohead dt (2,3) lc rgb "#404040" lw 1.2
set label 3 " half a pixel" at 0.5, graph 0.02 left rotate font ",9" offset character 0.9, 0

# What one order more is worth: error falls as step^order, work grows as 1 / step.
corner_x = finest * 10 ** (0.36 * log10(lost / finest))
corner_y = least * 1.5
set for [i = 1 : 4] arrow 10 + i from corner_x, corner_y \
    to corner_x / 10 ** (word("1.5 2.6 3.4 3.8", i) + 0), corner_y * 10 ** (word("1.5 1.3 0.85 0.6333", i) + 0) \
    nohead lc rgb "#707070" lw 1
set for [i = 1 : 4] label 10 + i word("1 2 4 6", i) \
    at corner_x / 10 ** (word("1.5 2.6 3.4 3.8", i) + 0), corner_y * 10 ** (word("1.5 1.3 0.85 0.6333", i) + 0) \
    left offset character 0.5, 0 font ",9" tc rgb "#505050"
set label 15 "order" at corner_x, corner_y right offset character -0.5, 0 font ",9" tc rgb "#505050"

do for [format in "png svg"] {
    if (format eq "png") { set terminal pngcairo size 1200, 800 font "DejaVu Sans,11" } \
    else { set terminal svg size 1200, 800 font "DejaVu Sans,11" background "#ffffff" }
    set output name.".".format
    plot for [n = 1 : words(drawn)] data \
             using (error(d(n))):(work(0)):(lower(0)):(upper(0)) with yerrorbars \
             lc rgb color[d(n)] lw 0.8 pt mark[d(n)] ps 0.01 notitle, \
         for [n = 1 : words(drawn)] data using (error(d(n))):(work(0)) with linespoints \
             lc rgb color[d(n)] lw 1.8 dt dash[d(n)] pt mark[d(n)] ps 0.9 title label[d(n)], \
         for [n = 1 : words(never_held)] keyentry with points \
             lc rgb color[h(n)] pt mark[h(n)] ps 0.6 title label[h(n)], \
         for [n = 1 : words(failing)] data using (failure(f(n))):(work(0)) with points \
             lc rgb color[f(n)] lw 1 pt mark[f(n)] ps 0.6 notitle
}
