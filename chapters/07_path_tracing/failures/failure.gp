# A bar a method, grouped by case; the label says which and how often.
set terminal pngcairo size 1500,960
file = folder."/failure.csv"
set title "Where each method breaks\n{/*0.75 share of random cases, known in closed form, that it gets wrong}" font ",20"
stats file using 3 nooutput
rows = STATS_records
set yrange [rows + 3.6:0.2]
set xrange [0:104]
set xtics 0,20,100
set lmargin 64
set xlabel "share of the cases that go wrong, percent"
unset key
set grid xtics noytics
share(failures, trials) = 100.0 * failures / trials
# A gap before each new case.
last = ""
group = -1
place(row) = (strcol(2) eq last ? 0 : (group = group + 1, last = strcol(2), 0), row + 1 + 0.6 * group)
first(row) = strcol(2) ne seen ? (seen = strcol(2), strcol(2)) : ""
seen = ""
paint(failures) = failures > 0 ? 0xd55e00 : 0x0072b2
label(method, failures, trials) = sprintf("%s: %.1f %%", method, share(failures, trials))
set datafile missing NaN
set style fill solid 0.85 noborder
plot file using (share($3, $4) / 2):(place($0)):(share($3, $4) / 2):(0.38):(paint($3)):ytic(first($0)) with boxxyerror lc rgb variable, \
     last = "" , group = -1, file using ($3 > 0 ? 1 : NaN):(place($0)):(label(strcol(1), $3, $4)) with labels left font ",14" textcolor rgb "white", \
     last = "" , group = -1, file using ($3 > 0 ? NaN : 1):(place($0)):(label(strcol(1), $3, $4)) with labels left font ",14" textcolor rgb "#0072b2"
