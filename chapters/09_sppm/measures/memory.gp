# What the process keeps, over passes.
file = folder."/memory.csv"
array methods[2] = ["SPPM by pass ①", "SPPM by point ②"]
set title "Memory doesn't grow with passes"
set datafile missing NaN
set logscale x
set yrange [0:*]
set xlabel "passes"
set ylabel "resident memory, MiB"
is(m) = strcol(1) eq methods[m]
set key at graph 0.02,0.05 left bottom Left reverse opaque noenhanced
plot for [m=1:2] file every ::0 using (is(m) ? setting_number(strcol(2), "passes") : NaN):3 with linespoints lt m lw (m == 1 ? 6 : 2) ps 1.2 title methods[m]
