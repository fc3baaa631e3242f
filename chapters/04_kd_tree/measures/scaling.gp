# Left: nodes a ray against n, which log n makes a straight line. Right: events of the builder by n log n.
set terminal pngcairo size 1600,760
file = folder."/scaling.csv"
array methods[4] = ["median KD-tree", "SAH KD-tree", "8-wide KD-tree", "8-wide BVH"]
is(method) = strcol(1) eq method

set multiplot layout 1,2 title "From a hundred triangles to a million\n{/*0.75 random chords through a bumpy sphere; counted, not timed}" font ",20"
set datafile missing NaN
set logscale x
set xrange [50:2e6]
set xlabel "triangles"
set xtics ("10^{2}" 1e2, "10^{3}" 1e3, "10^{4}" 1e4, "10^{5}" 1e5, "10^{6}" 1e6)
set grid xtics ytics

set title "a ray" font ",17"
set ylabel "solid: nodes, dashed: tests of triangles or blocks"
set yrange [0:*]
set key inside left top
plot for [i=1:4] file using (is(methods[i]) ? $2 : NaN):3 with linespoints lt i+1 ps 1.6 title methods[i], \
     for [i=1:4] file using (is(methods[i]) ? $2 : NaN):4 with linespoints lt i+1 dt 2 pt 6 ps 1.2 notitle

set title "building" font ",17"
set ylabel "events looked at, divided by n log_2 n"
set key inside left bottom
plot for [i=1:2] file using (is(methods[i]) ? $2 : NaN):($6 / ($2 * log($2) / log(2))) with linespoints lt i+1 ps 1.6 title methods[i]
unset multiplot
