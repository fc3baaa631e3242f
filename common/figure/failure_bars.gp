# A bar a method, as long as its share of failures; methods on cases of the same kind stand together below the kind's name.
file = folder."/failure.csv"
heading = ""
kinds = 0
longest = 0
counted(method, kind) = (kinds = kinds + (kind ne heading), heading = kind, \
                         longest = strlen(method) > longest ? strlen(method) : longest, 0)
stats file using (counted(strcol(1), strcol(2))) nooutput
height = STATS_records + 1.4 * kinds
set terminal pngcairo size 1500,int(150 + 34 * height)
set title "Where each method breaks\n{/*0.75 failures among random cases of each kind}" font ",20"
unset key
set xrange [0:118]
set yrange [-height - 0.6:0]
set xlabel "failures, per cent of the cases"
set xtics 0,20,100
unset ytics
set border 1
set grid xtics
set lmargin longest + 4

# The row of a line of the table: counted down, with room for a heading where a new kind begins.
row = 0
begins = 0
place(line, kind) = (line == 0 ? (row = 0.6, heading = "") : 0, begins = (kind ne heading), heading = kind, \
                     row = row - (begins ? 2.4 : 1), row)
share(failures, trials) = 100.0 * failures / trials
ink(failures) = failures > 0 ? 2 : 3
plot file using (0.5 * share($3, $4)):(place($0, strcol(2))):(0.5 * share($3, $4)):(0.36):(ink($3)) \
         with boxxyerror lc variable fillstyle solid 0.85 noborder, \
     file using (0):(place($0, strcol(2))):1 with labels right offset -1.2,0 noenhanced, \
     file using (0):(place($0, strcol(2)) + 1.05):(begins ? strcol(2) : "") with labels left offset -longest - 2,0 font "DejaVu Sans:Bold,15" noenhanced, \
     file using (share($3, $4)):(place($0, strcol(2))):(sprintf("%d of %d", $3, $4)):(ink($3)) \
         with labels left offset 0.8,0 textcolor variable
