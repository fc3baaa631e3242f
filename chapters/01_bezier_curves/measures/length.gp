# Error of the length against evaluations (above) and time (below); a smooth curve left, one with a cusp right.
set terminal pngcairo size 1500,1150
file = folder."/length.csv"
set datafile missing NaN
method(name, curve) = strcol(1) eq name && strstrt(strcol(2), "curve=".curve.";")
# A result without any error can't be shown on a logarithmic axis: it lies on the bottom line.
error(name, curve) = method(name, curve) ? ($5 > 1e-17 ? $5 : 1e-17) : NaN
bound(curve) = method("Gauss-Legendre (adaptive)", curve) ? setting_number(strcol(2), "bound") : NaN
names = "'chords' 'Gauss-Legendre (one rule)' 'Gauss-Legendre (adaptive)'"

set multiplot layout 2,2 title "Length of a cubic: chords against Gauss–Legendre\n{/*0.75 error against a 113-bit reference; hollow: the bound that the adaptive rule proves, in advance of any reference}" font ",20"
unset key
set grid
set logscale xy
set yrange [1e-17:1]
set format y "10^{%T}"
set ytics 1e-16,1e4
set format x "10^{%T}"
unset mytics
do for [row in "evaluations time"] {
    set xlabel row eq "time" ? "time, ns" : "evaluations of the curve or its derivative"
    set xrange [(row eq "time" ? 20 : 1.5):(row eq "time" ? 3e6 : 3e4)]
    do for [curve in "smooth cusp"] {
        set title curve eq "smooth" ? "a smooth arch" : "a curve with a cusp" font ",17"
        unset label
        if (row eq "evaluations" && curve eq "smooth") {
            set label 1 "chords" at 90,2e-4 textcolor lt 1
            set label 2 "one Gauss–\nLegendre rule" at 13,1e-10 textcolor lt 2
            set label 3 "adaptive" at 330,2e-16 textcolor lt 3
            set label 4 "its bound" at 160,3e-8 textcolor lt 3
        }
        set ylabel curve eq "smooth" ? "relative error" : ""
        x(setting) = row eq "time" ? $3 : setting_number(setting, "evaluations")
        plot for [i=1:3] file using (x(strcol(2))):(error(word(names, i), curve)) with linespoints lt i, \
             file using (x(strcol(2))):(bound(curve)) with linespoints lt 3 dashtype 2 pt 8 ps 1.6 lw 1.2
    }
}
unset multiplot
