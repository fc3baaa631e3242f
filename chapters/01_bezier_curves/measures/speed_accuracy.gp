# Error against time for each way to evaluate: a line a method, a point a degree; float left, double right. Degrees are
# written where lines lie apart.
set terminal pngcairo size 1600,900
file = folder."/speed_accuracy.csv"
methods = "'de Casteljau' 'Bernstein sum' 'power basis (Horner)' 'forward differencing'"
labelled = "15 60 30 60"
# Times are those of the machine at hand: the frame holds them all.
stats file using 3 nooutput
left = STATS_min / 1.6
right = STATS_max * 3
set datafile missing NaN
chosen(method, scalar) = strcol(1) eq method && strstrt(strcol(2), "scalar=".scalar) ? $5 : NaN
degree(setting) = setting_text(setting, "degree")
# Below degree 30, forward differencing runs beside Horner's rule, whose numbers then stand at the left.
numbered(i, scalar) = i < 3 || degree(strcol(2)) > (i == 4 ? 15 : 7) ? chosen(word(methods, i), scalar) : NaN
named(i, scalar) = degree(strcol(2)) eq word(labelled, i) ? chosen(word(methods, i), scalar) : NaN

set multiplot layout 1,2 title "Four ways to evaluate a Bézier curve: speed and accuracy\n{/*0.75 worst error over 100 random curves against a 113-bit reference; time per point of a curve of 201 points, preparation included; numbers: the degree}" font ",20"
unset key
set grid xtics ytics
set logscale xy
set xrange [left:right]
set yrange [0.003:1e31]
set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30, "100" 100, "300" 300, "1000" 1000, "3000" 3000)
set ytics ("1" 1, "10^{4}" 1e4, "10^{8}" 1e8, "10^{12}" 1e12, "10^{16}" 1e16, "10^{20}" 1e20, "10^{24}" 1e24, "10^{28}" 1e28)
set xlabel "time, ns per point"
do for [scalar in "float double"] {
    bits = scalar eq "float" ? 24 : 53
    set title sprintf("%s (significand of %d bits)", scalar, bits) font ",17"
    set ylabel scalar eq "float" ? "worst error, ulp of the largest control coordinate" : ""
    set object 1 rectangle from left,2.0**bits to right,1e31 fillcolor rgb "#f3eee6" fillstyle solid noborder behind
    set label 1 "error larger than the curve itself" at right / 1.1,2.0**bits*8 right textcolor rgb "#8a7550" font ",13"
    plot for [i=1:4] file using 3:(chosen(word(methods, i), scalar)) with linespoints lt i, \
         for [i=1:4] file using 3:(numbered(i, scalar)):(degree(strcol(2))) with labels \
             offset (i == 4 ? -1.3 : i == 3 ? 1.3 : 0.2),(i == 4 ? 0.2 : i == 3 ? -0.4 : i == 2 ? 0.8 : -0.9) font ",12" textcolor lt i, \
         file using 3:(degree(strcol(2)) < 15 ? chosen(word(methods, 3), scalar) : NaN):(degree(strcol(2))) with labels \
             offset -1.2,0.4 font ",12" textcolor lt 3, \
         file using 3:(named(1, scalar)):(word(methods, 1)) with labels left offset 1,-2.1 font ",15" textcolor lt 1, \
         file using 3:(named(2, scalar)):(word(methods, 2)) with labels left offset 1.3,1.5 font ",15" textcolor lt 2, \
         file using 3:(named(3, scalar)):(word(methods, 3)) with labels left offset 2.6,0 font ",15" textcolor lt 3, \
         file using 3:(named(4, scalar)):("forward differencing") with labels right offset -2.6,0.2 font ",15" textcolor lt 4
}
unset multiplot
