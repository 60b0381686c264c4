set datafile separator comma
set datafile columnheaders
set encoding utf8

is(what) = strcol("status") eq what
error(d) = is("ok") && strcol("error_px") ne "" && column("error_px") > 0 ? column("error_px") : NaN
work(d) = is("failed") ? NaN : column("work")

set border 3
set xtics nomirror noenhanced
set ytics nomirror
set logscale y
set format y "10^{%L}"
set key top right reverse Left noenhanced
set lmargin 10

do for [format in "png svg"] {
    if (format eq "png") { set terminal pngcairo size 1000, 800 font "DejaVu Sans,11" } \
    else { set terminal svg size 1000, 800 font "DejaVu Sans,11" background "#ffffff" }
    set output "sweep.".format
    set multiplot layout 2, 1
    set title heading noenhanced
    unset xlabel
    set ylabel "error, worst frame, pixels"
    set yrange [error_least : error_most]
    plot "sweep.csv" using (position(0)):(error(0)) with linespoints lc rgb "#0072b2" lw 2 pt 7 ps 0.8 notitle, \
         "" using (is("diverged") ? position(0) : NaN):(error_most) with points lc rgb "#d55e00" pt 2 ps 1.4 lw 2 title "diverged", \
         "" using (is("failed") ? position(0) : NaN):(error_most) with points lc rgb "#808080" pt 1 ps 1.4 lw 2 title "failed", \
         0.5 with lines dt (2,3) lc rgb "#404040" lw 1.2 title "half a pixel"
    unset title
    set xlabel x_label noenhanced
    set ylabel "work per frame, evaluations of a mass"
    set yrange [work_least : work_most]
    plot "sweep.csv" using (position(0)):(work(0)) with linespoints lc rgb "#009e73" lw 2 pt 7 ps 0.8 notitle
    unset multiplot
}
