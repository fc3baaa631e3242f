# Left: rays a second against build time. Right: against memory. A colour a structure, a mark a set of rays; hollow, since the
# marks of two sets often lie upon each other.
set terminal pngcairo size 1600,760
file = folder."/speed.csv"
array methods[5] = ["brute force", "median KD-tree", "SAH KD-tree", "8-wide KD-tree", "8-wide BVH"]
array sets[3] = ["primary", "diffuse bounce", "shadow"]
array marks[3] = [6, 4, 8]
is(method, set) = strcol(1) eq method && strcol(2) eq set

set multiplot layout 1,2 title "The bunny, 69,666 triangles: what a tree costs and what it gives\n{/*0.75 one thread, answers in double precision; ○ primary rays   □ diffuse bounce   △ shadow}" font ",20"
set datafile missing NaN
set logscale xy
set ylabel "million rays a second"
set yrange [0.0004:20]
set ytics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set grid xtics ytics

set title "by build time" font ",17"
set xlabel "time to build, ms"
set xrange [4:5000]
set xtics ("none" 7, "30" 30, "100" 100, "300" 300, "1000" 1000, "3000" 3000)
set key inside right bottom
plot for [i=1:5] for [j=1:3] file using (is(methods[i], sets[j]) ? ($4 > 0 ? $4 : 7) : NaN):3 with points lt i pt marks[j] ps 2 lw 2.5 title (j == 1 ? methods[i] : "")

set title "by memory" font ",17"
set xlabel "bytes a triangle of nodes and leaves"
set xrange [5:300]
set xtics ("none" 7, "30" 30, "100" 100, "300" 300)
unset ylabel
unset key
plot for [i=1:5] for [j=1:3] file using (is(methods[i], sets[j]) ? ($5 > 0 ? $5 : 7) : NaN):3 with points lt i pt marks[j] ps 2 lw 2.5
unset multiplot
