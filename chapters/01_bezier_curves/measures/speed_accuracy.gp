# Error against time for each way to evaluate: a line a method, a point a degree; float left, double right.
set terminal pngcairo size 1600,900
file = folder."/speed_accuracy.csv"
methods = "'de Casteljau' 'Bernstein sum' 'power basis (Horner)' 'forward differencing'"
labelled = "15 60 30 15"
set datafile missing NaN
chosen(method, scalar) = strcol(1) eq method && strstrt(strcol(2), "scalar=".scalar) ? $5 : NaN
named(i, scalar) = setting_text(strcol(2), "degree") eq word(labelled, i) ? chosen(word(methods, i), scalar) : NaN

set multiplot layout 1,2 title "Four ways to evaluate a Bézier curve: speed and accuracy\n{/*0.75 worst error over 100 random curves against a 113-bit reference; time per point of a curve of 201 points, preparation included; numbers: the degree}" font ",20"
unset key
set grid xtics ytics
set logscale xy
set xrange [1.5:4000]
set yrange [0.003:1e31]
set xtics ("2" 2, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100, "200" 200, "500" 500, "1000" 1000, "2000" 2000)
set ytics ("1" 1, "10^{4}" 1e4, "10^{8}" 1e8, "10^{12}" 1e12, "10^{16}" 1e16, "10^{20}" 1e20, "10^{24}" 1e24, "10^{28}" 1e28)
set xlabel "time, ns per point"
do for [scalar in "float double"] {
    bits = scalar eq "float" ? 24 : 53
    set title sprintf("%s (significand of %d bits)", scalar, bits) font ",17"
    set ylabel scalar eq "float" ? "worst error, ulp of the largest control coordinate" : ""
    set object 1 rectangle from 1.5,2.0**bits to 4000,1e31 fillcolor rgb "#f3eee6" fillstyle solid noborder behind
    set label 1 "error larger than the curve itself" at 3600,2.0**bits*8 right textcolor rgb "#8a7550" font ",13"
    plot for [i=1:4] file using 3:(chosen(word(methods, i), scalar)) with linespoints lt i, \
         for [i=1:4] file using 3:(chosen(word(methods, i), scalar)):(setting_text(strcol(2), "degree")) with labels \
             offset (i == 4 ? -1.3 : i == 3 ? 1.3 : 0.2),(i == 4 ? 0.2 : i == 3 ? -0.2 : i == 2 ? 0.8 : -0.9) font ",12" textcolor lt i, \
         file using 3:(named(1, scalar)):(word(methods, 1)) with labels left offset 1,-2.1 font ",15" textcolor lt 1, \
         file using 3:(named(2, scalar)):(word(methods, 2)) with labels left offset 1.3,1.5 font ",15" textcolor lt 2, \
         file using 3:(named(3, scalar)):(word(methods, 3)) with labels left offset 2.6,0 font ",15" textcolor lt 3, \
         file using 3:(named(4, scalar)):("forward\ndifferencing") with labels right offset -2.6,0.8 font ",15" textcolor lt 4
}
unset multiplot
