# Error over time, a mark a setting: fog, sky, lens.
set terminal pngcairo size 2000,760
file = folder."/speed_accuracy.csv"
is(method, value) = strcol(1) eq method ? value : NaN
set multiplot layout 1,3 title "What light in fog, from a sky and through a lens costs, and what good choices save\n{/*0.75 references: the air-light integral in closed form; midpoints of the sky's pixels; similar triangles}" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set key at graph 0.5,-0.24 center top Left reverse noenhanced maxrows 5
set bmargin 12

array fog[4] = ["fog: ray marching", "fog: photons along the ray", "fog: equi-angular in 16 places", "fog: path tracing by free flight"]
set title "light that fog scatters once around a lamp" font ",16"
set xlabel "time, s"
set ylabel "error, share of the radiance, rms"
plot for [m=1:4] file using (is(fog[m], $3)):5 with linespoints lt m lw 2.2 ps 1.4 title fog[m]

array sky[4] = ["sky: even directions", "sky: by the surface's cosine", "sky: by brightness", "sky: both weighed"]
set title "irradiance of a sky with a sun of one pixel" font ",16"
set xlabel "time, µs"
set ylabel "error, share of the irradiance, rms"
plot for [m=1:4] file using (is(sky[m], $3)):5 with linespoints lt m lw 2.2 ps 1.4 title sky[m]

array lens[2] = ["lens: random points", "lens: stratified points"]
set title "diameter of a point out of focus" font ",16"
set ylabel "error, share of the circle of confusion, rms"
plot for [m=1:2] file using (is(lens[m], $3)):5 with linespoints lt m lw 2.2 ps 1.4 title lens[m]
unset multiplot
