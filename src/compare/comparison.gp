set datafile separator comma
set datafile missing ""
set datafile columnheaders
set encoding utf8

# Colours that the colour-blind tell apart, and dashes for when there are none.
array color[7] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x000000, 0x56b4e9, 0xe69f00]
distance(d) = column("greatest_px") > 0 ? column("greatest_px") : NaN

set logscale y
set format y "10^{%L}"
set border 3
set xtics nomirror
set ytics nomirror
set key outside bottom center horizontal noenhanced
set title "Greatest distance of any mass from ".first noenhanced
set xlabel "frame"
set ylabel "pixels"
set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead dt (2,3) lc rgb "#404040" lw 1.2
set label 1 "a pixel" at graph 0.995, first 1 right offset 0, 0.5 font ",9"

# Lines of the file belong to the runs by turns.
do for [format in "png svg"] {
    if (format eq "png") { set terminal pngcairo size 1000, 600 font "DejaVu Sans,11" } \
    else { set terminal svg size 1000, 600 font "DejaVu Sans,11" background "#ffffff" }
    set output "comparison.".format
    plot for [i = 1 : runs] "comparison.csv" every runs::(i - 1) using (column("frame")):(distance(0)) with lines \
         lc rgb color[i] dt i lw 2 title label[i]
}
