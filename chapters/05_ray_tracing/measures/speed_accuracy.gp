# Left: soft shadows, a mark a number of samples. Right: reflections within a pane, a mark a depth or a least weight.
set terminal pngcairo size 1700,860
file = folder."/speed_accuracy.csv"
is(method) = strcol(1) eq method
set multiplot layout 1,2 title "What a better picture costs: shadow samples and recursion\n{/*0.75 references in closed form: form factors of the lamp less its hidden part; the sum of all reflections in a pane}" font ",20"
set datafile missing NaN
set logscale xy
set format y "10^{%L}"
set ylabel "error of the radiance, rms"
set xlabel "time, µs per eye ray"
set grid xtics ytics
set key at graph 0.03,0.03 left bottom Left reverse

set title "penumbra of a square lamp: 1, 4, 16, 64, 256 samples" font ",17"
array shadows[3] = ["independent shadow samples", "stratified shadow samples", "regular grid of shadow samples"]
plot for [i=1:3] file every ::0 using (is(shadows[i]) ? $3 : NaN):5 with linespoints lt i lw 2.2 ps 1.6 title shadows[i]

set title "reflections within panes: depth 1 … 32, weight 10^{-1} … 10^{-6}" font ",17"
array depths[2] = ["fixed depth", "least weight"]
plot for [i=1:2] file every ::0 using (is(depths[i]) ? $3 : NaN):5 with linespoints lt i+3 lw 2.2 ps 1.8 title depths[i]
unset multiplot
