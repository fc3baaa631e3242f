# Error over seconds, a mark a setting.
file = folder."/speed_accuracy.csv"
array methods[4] = ["fog: ray marching", "fog: photons along the ray", "fog: equi-angular in 16 places", "fog: path tracing by free flight"]
set title "Light that fog scatters once around a lamp: error over seconds of one thread\n{/*0.8 48 × 48 pixels, against the air-light integral in closed form}"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s"
set ylabel "error, share of the radiance, rms"
set key outside below Left reverse noenhanced
plot for [m=1:4] file every ::0 using (strcol(1) eq methods[m] ? $3 : NaN):5 with linespoints lt m lw 2.2 ps 1.3 title methods[m]
