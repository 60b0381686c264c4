set datafile separator comma
set datafile missing NaN
set datafile columnheaders
set encoding utf8

# Which cell a row of the data is, from 1 on: the count of edges below.
column_of(d) = sum [i = 1 : steps] (column("steps_per_frame") > step_edge[i])
row_of(d) = sum [i = 1 : values] (column(against) > value_edge[i])

# Dark to light also where there are no colours (viridis): exact, usable, wrong, diverged.
array color[4] = [0xfde725, 0x35b779, 0x31688e, 0x440154]
array meaning[4] = ["within half a pixel", "within 8 pixels", "bounded, but wrong", "diverged"]

set logscale xy
set xrange [step_edge[1] : step_edge[steps + 1]]
set yrange [value_edge[1] : value_edge[values + 1]]
set xtics ("1" 1, "4" 4, "16" 16, "64" 64, "256" 256, "1024" 1024, "4096" 4096) out nomirror font ",8"
set ytics out nomirror format "10^{%L}" font ",8" 100
set mytics 1
set style fill solid noborder
unset key
set border 3 lw 0.5

columns = 4
rows = (panels + columns - 1) / columns
width = 1200
height = 130 + 230 * rows
x0(n) = 0.055 + 0.94 * (n % columns) / columns
y1(n) = 1 - (95.0 + 230 * (n / columns)) / height

do for [format in "png svg"] {
    if (format eq "png") { set terminal pngcairo size width, height font "DejaVu Sans,10" } \
    else { set terminal svg size width, height font "DejaVu Sans,10" background "#ffffff" }
    set output "stability.".format
    set multiplot
    set label 1 heading at screen 0.5, screen 1 - 22.0 / height center font ",12" noenhanced
    set label 2 "steps per frame" at screen 0.5, screen 18.0 / height center
    set label 3 against at screen 0.012, screen 0.5 center rotate
    do for [class = 1 : 4] {
        left = 0.10 + 0.17 * (class - 1)
        set object class rectangle from screen left, screen 1 - 58.0 / height \
            to screen left + 0.02, screen 1 - 42.0 / height fc rgb color[class] fs solid border lc rgb "#808080"
        set label 10 + class meaning[class] at screen left + 0.026, screen 1 - 50.0 / height left
    }
    set arrow 1 from screen 0.80, screen 1 - 50.0 / height to screen 0.83, screen 1 - 50.0 / height nohead lc rgb "#d55e00" lw 2.5
    set label 15 "stability limit" at screen 0.836, screen 1 - 50.0 / height left
    do for [m = 1 : panels] {
        set lmargin at screen x0(m - 1)
        set rmargin at screen x0(m - 1) + 0.94 / columns - 0.035
        set tmargin at screen y1(m - 1)
        set bmargin at screen y1(m - 1) - 170.0 / height
        set title method[m] offset 0, -0.7 noenhanced
        is_method(d) = strcol("method") eq method[m]
        if (limited[m]) {
            plot data using (is_method(0) ? column("steps_per_frame") : NaN):(column(against)): \
                     (step_edge[column_of(0)]):(step_edge[column_of(0) + 1]):(value_edge[row_of(0)]):(value_edge[row_of(0) + 1]): \
                     (color[1 + column("class")]) with boxxyerror lc rgb variable, \
                 $limits using (column(m + 1)):1 with lines lc rgb "#d55e00" lw 2.5
        } else {
            plot data using (is_method(0) ? column("steps_per_frame") : NaN):(column(against)): \
                     (step_edge[column_of(0)]):(step_edge[column_of(0) + 1]):(value_edge[row_of(0)]):(value_edge[row_of(0) + 1]): \
                     (color[1 + column("class")]) with boxxyerror lc rgb variable
        }
        unset label
        unset object
        unset arrow
    }
    unset multiplot
}
