# A row a kind of case, a mark a method: the share of the trials that went wrong, or the column at the left for none at
# all. `fragile` holds the names of the methods that may fail; the others are the course's.
file = folder."/failure.csv"
array kinds[100]
count = 0
known(kind) = sum [i=1:count] (kinds[i] eq kind ? i : 0)
added(kind) = (count = count + 1, kinds[count] = kind, count)
row(kind) = (found = known(kind), found > 0 ? found : added(kind))
least = 1
longest = 0
seen(kind, failures, trials) = (least = failures > 0 && failures / trials < least ? failures / trials : least, \
                                longest = strlen(kind) > longest ? strlen(kind) : longest, row(kind))
stats file using (seen(strcol(2), $3, $4)) nooutput
ours(method) = 1 - sum [i=1:|fragile|] (fragile[i] eq method ? 1 : 0)
lowest = floor(log10(least))
none = 10 ** (lowest - 1)

set terminal pngcairo size 1700,220 + 29 * count
set title "Where each method breaks\n{/*0.75 share of the trials of each kind that went wrong; hollow: the method was tried and never failed}" font ",22"
set yrange [count + 0.7:0.3]
set xrange [none / 2.5:2]
set logscale x
set xtics ("none" none)
do for [k=lowest:0] { set xtics add (sprintf("%g %%%%", 100 * 10 ** k) 10 ** k) }
set xlabel "share of the trials that went wrong"
set grid xtics ytics
set lmargin longest + 4
set arrow 1 from 2.5 * none, graph 0 to 2.5 * none, graph 1 nohead lc rgb "#bbbbbb" dt 2
array filled[5] = [5, 9, 13, 11, 15]
mark(i) = filled[(i - 1) % 5 + 1]
colour(i) = i % 7 + 1
jitter(i) = 0.22 * ((i - 1) % 3 - 1)
plot file using (ours(strcol(1)) ? ($3 > 0 ? $3 / $4 : none / 1.4) : NaN):(row(strcol(2))):ytic(2) \
         with points pt 7 ps 1.9 lc 1 title "the course's methods", \
     for [i=1:|fragile|] file using (strcol(1) eq fragile[i] && $3 > 0 ? $3 / $4 : NaN):(row(strcol(2)) + jitter(i)) \
         with points pt mark(i) ps 1.7 lc colour(i) title fragile[i], \
     for [i=1:|fragile|] file using (strcol(1) eq fragile[i] && $3 == 0 ? none * 1.4 : NaN):(row(strcol(2)) + jitter(i)) \
         with points pt mark(i) - 1 ps 1.2 lc colour(i) notitle
