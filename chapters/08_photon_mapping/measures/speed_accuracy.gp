# A line a method, a mark a count of photons or paths.
set terminal pngcairo size 1400,900
file = folder."/speed_accuracy.csv"
array methods[6] = ["20 nearest photons", "100 nearest photons", "100 nearest with cone filter", "photons within 3 cm", "path tracing with MIS", "bidirectional path tracing"]
set title "What time buys: the caustic of a glass ball on a floor, 32 × 32 pixels\n{/*0.75 against a program for this scene alone; each mark has four times the photons or paths of the one before}" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s of one thread: photons, map and eye together"
set ylabel "error of the radiance, rms"
set grid xtics ytics
set key at graph 0.98,0.97 right top Left reverse opaque noenhanced
plot for [m=1:6] file using (strcol(1) eq methods[m] ? $3 : NaN):5 with linespoints lt m lw 2.2 ps 1.4 title methods[m]
