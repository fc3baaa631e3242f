# One row a case, one mark a method: the share of the trials that went wrong, or the column at the left for none at all.
set terminal pngcairo size 1700,1300
file = folder."/failure.csv"
array names[80]
count = 0
known(name) = sum [i=1:count] (names[i] eq name ? i : 0)
added(name) = (count = count + 1, names[count] = name, count)
row(name) = (found = known(name), found > 0 ? found : added(name))
none = 1.6e-5
array methods[4] = ["robust", "random start", "4x4 starts", "bracketing with 8 samples"]
stats file using (row(strcol(2))) nooutput
set title "Where each method breaks\n{/*0.75 share of the rays of each set whose nearest meeting is lost, invented or not the nearest; each set goes through}\n{/*0.75 eight difficult surfaces; what lies in the band of tangency is left out}" font ",22"
set yrange [count + 0.7:0.3]
set xrange [0.8e-5:2]
set logscale x
set xtics ("none" none, "0.01 %%" 1e-4, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 0.1, "100 %%" 1)
set xlabel "share of the trials that went wrong"
set grid xtics ytics
set lmargin 42
set arrow 1 from 4e-5, graph 0 to 4e-5, graph 1 nohead lc rgb "#bbbbbb" dt 2
plot file using (strcol(1) eq methods[1] ? ($3 > 0 ? $3 / $4 : none) : NaN):(row(strcol(2))):ytic(2) with points pt 7 ps 2 lc 1 title methods[1], \
     for [i=2:4] file using (strcol(1) eq methods[i] ? ($3 > 0 ? $3 / $4 : none * (1 + 0.16 * i)) : NaN):(row(strcol(2)) + 0.12 * (i - 3)) \
         with points lt i pt (i == 2 ? 5 : i == 3 ? 9 : 13) ps 1.6 title methods[i]
