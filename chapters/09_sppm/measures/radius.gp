# The radius over passes.
file = folder."/radius.csv"
array methods[2] = ["SPPM by pass ①", "SPPM by point ②"]
set title "The radius, from pass to pass\n{/*0.8 rule ②: median of all pixels; the band is from the smallest to the largest, half of them are in the darker part}"
set datafile missing NaN
set logscale xy
set xlabel "passes"
set ylabel "radius, m"
is(m) = strcol(1) eq methods[m]
passes(x) = setting_number(strcol(2), "passes")
set style fill solid 1 noborder
set key at graph 0.02,0.05 left bottom Left reverse opaque noenhanced
plot file every ::0 using (is(2) ? passes(0) : NaN):3:7 with filledcurves lc rgb "#f6dcc8" notitle, \
     file every ::0 using (is(2) ? passes(0) : NaN):4:6 with filledcurves lc rgb "#eab48a" notitle, \
     for [m=1:2] file every ::0 using (is(m) ? passes(0) : NaN):5 with linespoints lt m lw 2.4 ps 1.2 title methods[m]
