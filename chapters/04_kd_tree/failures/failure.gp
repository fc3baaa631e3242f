# One row a case, one mark a method: the share of the trials that went wrong, or the column at the left for none at all.
set terminal pngcairo size 1700,760
file = folder."/failure.csv"
array names[40]
count = 0
known(name) = sum [i=1:count] (names[i] eq name ? i : 0)
added(name) = (count = count + 1, names[count] = name, count)
row(name) = (found = known(name), found > 0 ? found : added(name))
none = 1.6e-6
array fragile[6] = ["stops at the first cell with a hit", "crossings taken as exact", "triangles in single precision", \
    "fan around the first corner", "normals: mean", "normals: by area"]
isFragile(method) = sum [i=1:6] (fragile[i] eq method ? 1 : 0)
isOurs(method) = 1 - isFragile(method)
share(failures, trials) = failures > 0 ? failures / trials : none

stats file using (row(strcol(2))) nooutput
set title "Where each method breaks\n{/*0.75 share of the trials of each case that went wrong; a fragile method that isn't marked in a row didn't fail there, or wasn't tried}" font ",22"
set yrange [count + 0.7:0.3]
set xrange [0.8e-6:2]
set logscale x
set xtics ("none" none, "0.001 %%" 1e-5, "0.01 %%" 1e-4, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 0.1, "100 %%" 1)
set xlabel "share of the trials that went wrong"
set grid xtics ytics
set lmargin 34
set arrow 1 from 4e-6, graph 0 to 4e-6, graph 1 nohead lc rgb "#bbbbbb" dt 2
jitter(i) = 0.18 * (i % 3 - 1)
plot file using (isOurs(strcol(1)) ? share($3, $4) : NaN):(row(strcol(2))):ytic(2) with points pt 7 ps 1.9 lc rgb "#0072b2" title "the course's methods", \
     for [i=1:6] file using (strcol(1) eq fragile[i] && $3 > 0 ? $3 / $4 : NaN):(row(strcol(2)) + jitter(i)) \
         with points ls i + 1 pt (i < 3 ? 5 : i < 5 ? 9 : 13) ps 1.7 lc (i + 1) title fragile[i]
