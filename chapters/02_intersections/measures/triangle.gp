# Left: leaks against time, a mark a distance. Right: leaks against the mesh's distance from the origin.
set terminal pngcairo size 1700,860
file = folder."/triangle.csv"
array methods[4] = ["Cramer's rule", "watertight", "watertight as published", "watertight with fused products"]
is(method, aim) = strcol(1) eq method && strstrt(strcol(2), "aim=".aim)
# Those without a leak lie a little apart, or they would hide each other.
leaks(perMillion, i) = perMillion > 0 ? perMillion : 0.02 * 2**i

set multiplot layout 1,2 title "A ray and a triangle, four ways: speed and leaks\n{/*0.75 rays from inside closed meshes, aimed at what their triangles share; filled: edges, hollow: vertices}" font ",20"
set datafile missing NaN
set logscale y
set yrange [0.02:2e7]
set ytics ("none" 0.11, "1" 1, "10" 10, "10^{2}" 100, "10^{3}" 1e3, "10^{4}" 1e4, "10^{5}" 1e5, "all" 1e6)
set ylabel "leaks per million rays"
set arrow 1 from graph 0, first 0.6 to graph 1, first 0.6 nohead lc rgb "#bbbbbb" dt 2
set grid xtics ytics

set title "by time" font ",17"
set xrange [0:*]
set xlabel "time, ns per test"
unset key
plot for [i=1:4] file using (is(methods[i], "edges") ? $3 : NaN):(leaks($5, i)) with points lt i pt 7 ps 1.6 title methods[i], \
     for [i=1:4] file using (is(methods[i], "vertices") ? $3 : NaN):(leaks($5, i)) with points lt i pt 6 ps 1.6 notitle

set title "by distance" font ",17"
set logscale x
set xrange [0.07:1.5e4]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "10^{2}" 1e2, "10^{3}" 1e3, "10^{4}" 1e4)
set xlabel "distance from the coordinates' origin, mesh radii"
unset ylabel
set key inside right top Left reverse
plot for [i=1:4] file using (is(methods[i], "edges") ? setting_number(strcol(2), "away") : NaN):(leaks($5, i)) \
         with linespoints lt i pt 7 ps 1.6 title methods[i], \
     for [i=1:4] file using (is(methods[i], "vertices") ? setting_number(strcol(2), "away") : NaN):(leaks($5, i)) \
         with linespoints lt i pt 6 ps 1.6 dt 2 notitle
unset multiplot
