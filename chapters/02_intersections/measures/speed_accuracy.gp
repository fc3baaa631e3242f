# Left: error against time, a mark a distance. Right: error against distance. Thin lines float, thick lines double.
set terminal pngcairo size 1700,900
file = folder."/speed_accuracy.csv"
array methods[4] = ["textbook quadratic", "projection by Pythagoras", "projection", "stable quadratic"]
is(method, scalar) = strcol(1) eq method && strstrt(strcol(2), "scalar=".scalar)

set multiplot layout 1,2 title "A ray and a sphere, four ways: speed and accuracy\n{/*0.75 root mean square of the relative error in t against a 113-bit reference, a lost hit counting as 1; sphere 1 to 10^{7} radii away}" font ",20"
set datafile missing NaN
set logscale xy
set yrange [3e-17:5]
set ytics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "all lost" 1)
set ylabel "relative error in t"
set grid xtics ytics

set title "by time" font ",17"
unset logscale x
set xrange [0:*]
set xlabel "time, ns per test"
unset key
set lmargin at screen 0.1
set rmargin at screen 0.395
plot for [i=1:4] file using (is(methods[i], "double") ? $3 : NaN):5 with points lt i ps 1.6 notitle, \
     for [i=1:4] file using (is(methods[i], "float") ? $3 : NaN):5 with points lt i pt (i == 1 ? 6 : i == 2 ? 4 : i == 3 ? 8 : 10) ps 1.4 notitle

set title "by distance" font ",17"
set logscale x
set xrange [0.7:2e7]
set xtics ("1" 1, "10" 10, "10^{2}" 1e2, "10^{3}" 1e3, "10^{4}" 1e4, "10^{5}" 1e5, "10^{6}" 1e6, "10^{7}" 1e7)
set xlabel "distance from origin to sphere, radii"
unset ylabel
set lmargin at screen 0.455
set rmargin at screen 0.75
set key at screen 0.765, screen 0.84 left top Left reverse samplen 2
plot for [i=1:4] file using (is(methods[i], "double") ? setting_number(strcol(2), "distance") : NaN):5 with linespoints lt i lw 2.5 ps 1.6 title methods[i], \
     for [i=1:4] file using (is(methods[i], "float") ? setting_number(strcol(2), "distance") : NaN):5 with linespoints lt i lw 1.2 dt 2 pt (i == 1 ? 6 : i == 2 ? 4 : i == 3 ? 8 : 10) ps 1.4 title methods[i].", float"
unset multiplot
