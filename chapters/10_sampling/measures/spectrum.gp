# Power over frequency, a line a way to emit photons.
file = folder."/spectrum.csv"
array ways[4] = ["random", "plain grid", "jittered grid", "grid with offsets"]
set title "What 50,000 photons of a cone light are off from an even floor, by frequency\n{/*0.8 mean power over all directions; photons without any order have 1}"
set logscale xy
set xrange [1:128]
set format y "10^{%L}"
set xlabel "periods across the picture"
set ylabel "power"
set key at graph 0.98,0.03 right bottom Left reverse opaque noenhanced
set datafile missing NaN
plot for [m=1:4] file every ::0 using (strcol(1) eq ways[m] ? $2 : NaN):4 with lines lt m lw 2.4 title ways[m]
