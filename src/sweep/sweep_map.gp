set datafile separator comma
set datafile columnheaders
set encoding utf8

is(what) = strcol("status") eq what
x(d) = int(column("point")) % columns
y(d) = int(column("point")) / columns
# A number below the scale has the scale's end, as has the error 0.
error(d) = is("ok") && strcol("error_px") ne "" ? (column("error_px") > error_least ? column("error_px") : error_least) : NaN
work(d) = is("failed") ? NaN : column("work")

set xrange [-0.5 : columns - 0.5]
set yrange [-0.5 : rows - 0.5]
set xtics out nomirror noenhanced font ",9"
set ytics out nomirror noenhanced font ",9"
set xlabel x_label noenhanced
set border 3 lw 0.5
set style fill solid noborder
set logscale cb
set format cb "10^{%L}"
unset key

do for [format in "png svg"] {
    if (format eq "png") { set terminal pngcairo size 1400, 600 font "DejaVu Sans,10" } \
    else { set terminal svg size 1400, 600 font "DejaVu Sans,10" background "#ffffff" }
    set output "sweep.".format
    set multiplot
    set label 1 heading at screen 0.5, screen 0.955 center font ",12" noenhanced
    array color[3] = [0xd55e00, 0xb0b0b0, 0xf0f0f0]
    array meaning[3] = ["diverged", "failed", "error unknown"]
    do for [i = 1 : 3] {
        set object i rectangle from screen 0.30 + 0.15 * (i - 1), screen 0.885 \
            to screen 0.32 + 0.15 * (i - 1), screen 0.91 fc rgb color[i] fs solid border lc rgb "#808080"
        set label 1 + i meaning[i] at screen 0.326 + 0.15 * (i - 1), screen 0.8975 left
    }
    set tmargin at screen 0.80
    set bmargin at screen 0.14
    # Light to dark also where there are no colours (viridis), exact to wrong and cheap to dear.
    set palette defined (0 "#fde725", 1 "#5ec962", 2 "#21918c", 3 "#3b528b", 4 "#440154")
    set label 9 y_label at screen 0.012, screen 0.47 center rotate noenhanced
    set lmargin at screen 0.135
    set rmargin at screen 0.42
    set title "error, worst frame, pixels"
    set cbrange [error_least : error_most]
    plot "sweep.csv" using (x(0)):(y(0)):(0.5):(0.5):(color[is("diverged") ? 1 : is("failed") ? 2 : 3]) \
             with boxxyerror lc rgb variable, \
         "" using (error(0) > 0 ? x(0) : NaN):(y(0)):(0.5):(0.5):(error(0)) with boxxyerror lc palette
    unset label
    unset object
    set label 9 y_label at screen 0.512, screen 0.47 center rotate noenhanced
    set lmargin at screen 0.635
    set rmargin at screen 0.92
    set title "work per frame, evaluations of a mass"
    set cbrange [work_least : work_most]
    plot "sweep.csv" using (x(0)):(y(0)):(0.5):(0.5):(is("failed") ? color[2] : color[3]) \
             with boxxyerror lc rgb variable, \
         "" using (work(0) > 0 ? x(0) : NaN):(y(0)):(0.5):(0.5):(work(0)) with boxxyerror lc palette
    unset multiplot
}
