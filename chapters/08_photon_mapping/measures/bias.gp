# Bias falls to the left, noise to the right.
set terminal pngcairo size 1400,900
file = folder."/bias.csv"
array filters[2] = ["no filter", "cone filter"]
set title "Blur or noise: how many photons to ask for\n{/*0.75 the caustic of a glass ball, as many photons for all; bias: of the mean of many maps; noise: of one}" font ",20"
set datafile missing NaN
set logscale xy
set xrange [1.5:700]
set xlabel "k, photons of an estimate"
set ylabel "error of the radiance, rms"
set grid xtics ytics
set key at graph 0.5,0.97 center top opaque noenhanced
k(text) = real(setting_text(text, "k"))
plot for [f=1:2] file using (strcol(1) eq filters[f] ? k(strcol(2)) : NaN):3 with linespoints lt 1 dt f pt f lw 2.4 ps 1.4 title "bias, ".filters[f], \
     for [f=1:2] file using (strcol(1) eq filters[f] ? k(strcol(2)) : NaN):4 with linespoints lt 2 dt f pt f lw 2.4 ps 1.4 title "noise, ".filters[f], \
     for [f=1:2] file using (strcol(1) eq filters[f] ? k(strcol(2)) : NaN):(sqrt($3**2 + $4**2)) with lines lt 3 dt f lw 2.4 title "both, ".filters[f]
