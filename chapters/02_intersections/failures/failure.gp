# One row a case, one mark a method: the share of the trials that went wrong, or the column at the left for none at all.
set terminal pngcairo size 1700,1320
file = folder."/failure.csv"
array names[80]
count = 0
known(name) = sum [i=1:count] (names[i] eq name ? i : 0)
added(name) = (count = count + 1, names[count] = name, count)
row(name) = (found = known(name), found > 0 ? found : added(name))
array fragile[10] = ["Cramer's rule", "watertight as published", "watertight with fused products", "naive slabs", \
    "textbook quadratic", "projection by Pythagoras", "fixed 1e-4 (float)", "fixed 1e-4", "fixed 1e-10", "like directions"]
# Filled; one less is the same mark, hollow.
array mark[10] = [5, 7, 9, 5, 7, 9, 13, 13, 13, 5]
array colour[10] = [0xd55e00, 0x009e73, 0xe69f00, 0xcc79a7, 0xd55e00, 0x56b4e9, 0xd55e00, 0xe69f00, 0x009e73, 0xd55e00]
isFragile(method) = sum [i=1:10] (fragile[i] eq method ? 1 : 0)
none = 3e-8
jitter(i) = 0.22 * ((i - 1) % 3 - 1)

stats file using (row(strcol(2))) nooutput
set title "Where each method breaks\n{/*0.75 share of the trials of each case that went wrong; hollow: the method was tried and never failed}" font ",22"
set yrange [count + 0.7:0.3]
set xrange [1e-8:2]
set logscale x
set xtics ("none" none, "0.0001 %%" 1e-6, "0.01 %%" 1e-4, "1 %%" 1e-2, "100 %%" 1)
set xlabel "share of the trials that went wrong"
set grid xtics ytics
set lmargin 48
set arrow 1 from 1.5e-7, graph 0 to 1.5e-7, graph 1 nohead lc rgb "#bbbbbb" dt 2
plot file using (isFragile(strcol(1)) ? NaN : $3 > 0 ? $3 / $4 : none / 1.6):(row(strcol(2))):ytic(2) \
         with points pt 7 ps 1.9 lc rgb "#0072b2" title "robust methods, the course's", \
     for [i=1:10] file using (strcol(1) eq fragile[i] && $3 > 0 ? $3 / $4 : NaN):(row(strcol(2)) + jitter(i)) \
         with points pt mark[i] ps 1.7 lc rgb colour[i] title fragile[i], \
     for [i=1:10] file using (strcol(1) eq fragile[i] && $3 == 0 ? none * 1.8 : NaN):(row(strcol(2)) + jitter(i)) \
         with points pt mark[i] - 1 ps 1.0 lc rgb colour[i] notitle
