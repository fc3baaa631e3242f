# Two bars a case: the fragile method above, the course's below.
set terminal pngcairo size 1500,760
file = folder."/failure.csv"
set title "Where each method breaks\n{/*0.75 share of random cases that it gets wrong; the course's own method gets all of them right}" font ",20"
stats file using 3 nooutput
rows = STATS_records
set yrange [rows / 2 + 0.6:0.3]
set xrange [0:104]
set xlabel "share of the cases that go wrong, percent"
set lmargin 46
unset key
set grid xtics noytics
shift(row) = int(row) % 2 == 0 ? -0.17 : 0.17
place(row) = int(row) / 2 + 1 + shift(row)
paint(row) = int(row) % 2 == 0 ? 0xd55e00 : 0x0072b2
share(failures, trials) = 100.0 * failures / trials
fragile(row) = int(row) % 2 == 0
plot file using (share($3, $4) / 2):(place($0)):(share($3, $4) / 2):(0.14):(paint($0)):ytic(fragile($0) ? strcol(2) : "") with boxxyerror fill solid 0.85 noborder lc rgb variable, \
     file using (fragile($0) ? 1 : NaN):(place($0)):(sprintf("%s: %.1f %%", strcol(1), share($3, $4))) with labels left font ",14" textcolor rgb "white", \
     file using (fragile($0) ? NaN : 1):(place($0)):(sprintf("%s: %.1f %%", strcol(1), share($3, $4))) with labels left font ",14" textcolor rgb "#0072b2"
