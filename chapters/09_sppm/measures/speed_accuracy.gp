# Error over seconds, a mark a doubling of passes.
file = folder."/speed_accuracy.csv"
array methods[5] = ["path tracing", "bidirectional path tracing", "photon mapping", "SPPM by pass ①", "SPPM by point ②"]
set title "A caustic seen in a mirror: error over seconds of one thread\n{/*0.8 64 × 64 pixels, against chapter 07's program for that scene alone}"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s"
set ylabel "error of the radiance, rms"
set key at graph 0.98,0.98 right top Left reverse opaque noenhanced
plot for [m=1:5] file every ::0 using (strcol(1) eq methods[m] ? $3 : NaN):5 with linespoints lt m lw 2.2 ps 1.3 title methods[m]
