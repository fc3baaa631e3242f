# Left: error against time, a mark a mesh. Right: error against the number of triangles.
set terminal pngcairo size 1500,760
file = folder."/speed_accuracy.csv"
array methods[4] = ["flat", "mean", "area", "angle"]
array titles[4] = ["flat: the face's normal", "mean of the faces", "weighted by area", "weighted by angle"]
is(method) = strcol(1) eq method

set multiplot layout 1,2 title "Normals of a torus from its triangles\n{/*0.75 angle between the shading normal and the torus' own, in closed form, at a random point of each triangle}" font ",20"
set datafile missing NaN
set logscale xy
set ylabel "error, degrees (root mean square)"
set yrange [0.05:40]
set grid xtics ytics

set title "by time" font ",17"
set xlabel "time to make the normals, µs a mesh"
set key inside right top
plot for [i=1:4] file using (is(methods[i]) ? $3 : NaN):5 with points lt i ps 1.6 title titles[i]

set title "by size" font ",17"
set xlabel "triangles"
set xrange [200:20000]
unset ylabel
unset key
plot for [i=1:4] file using (is(methods[i]) ? setting_number(strcol(2), "triangles") : NaN):5 with linespoints lt i ps 1.6
unset multiplot
