# A bar a method, as long as its share of failures; methods on the same cases stand together below the cases' name.
set terminal pngcairo size 1500,1000
file = folder."/failure.csv"
set title "Where methods fail, and what survives: random cases of six kinds" font ",20" offset -20,0.6
unset key
set xrange [0:118]
set yrange [-23:0.2]
set xlabel "failures, per cent of the cases"
set xtics 0,20,100
unset ytics
set border 1
set grid xtics
set lmargin 40
set tmargin 4

# The row of a line of the table: counted down, with room for a heading where a new kind of case begins.
row = 0
heading = ""
begins = 0
place(line, name) = (line == 0 ? (row = 0.6, heading = "") : 0, begins = (name ne heading), heading = name, \
                     row = row - (begins ? 2.4 : 1), row)
share(failures, trials) = 100.0 * failures / trials
ink(failures) = failures > 0 ? 2 : 3
plot file using (0.5 * share($3, $4)):(place($0, strcol(2))):(0.5 * share($3, $4)):(0.36):(ink($3)) \
         with boxxyerror lc variable fillstyle solid 0.85 noborder, \
     file using (0):(place($0, strcol(2))):1 with labels right offset -1.2,0 noenhanced, \
     file using (0):(place($0, strcol(2)) + 1.05):(begins ? strcol(2) : "") with labels left offset -37,0 font "DejaVu Sans:Bold,15" noenhanced, \
     file using (share($3, $4)):(place($0, strcol(2))):(sprintf("%d of %d", $3, $4)):(ink($3)) \
         with labels left offset 0.8,0 textcolor variable
