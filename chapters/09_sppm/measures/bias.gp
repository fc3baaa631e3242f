# Bias over passes, beside lines that fall as theory says.
file = folder."/bias.csv"
array names[5] = ["rule ①, α = 1/3", "rule ①, α = 2/3", "rule ①, α = 0.9", "rule ②, α = 2/3", "radius fixed: photon mapping"]
array methods[5] = ["SPPM by pass ①", "SPPM by pass ①", "SPPM by pass ①", "SPPM by point ②", "photon mapping"]
array alphas[5] = [1.0/3, 2.0/3, 0.9, 2.0/3, 1]
is(c) = strcol(1) eq methods[c] && abs(setting_number(strcol(2), "alpha") - alphas[c]) < 1e-6
set title "Bias falls as passes^{α − 1}: nothing here is unbiased\n{/*0.8 a pixel under a mirror whose radiance is known; lines have the slope of theory}"
set datafile missing NaN
set logscale xy
set xlabel "passes"
set ylabel "how much too dark, share of the radiance"
set key outside right top
array last[5]
do for [c=1:5] {
    last[c] = NaN
    stats file every ::0 using (is(c) ? (px = setting_number(strcol(2), "passes"), pe = $3, last[c] = pe * px ** (1 - alphas[c]), 1) : NaN) nooutput
}
plot for [c=1:5] file every ::0 using (is(c) ? setting_number(strcol(2), "passes") : NaN):3 with points lt c ps 1.5 title names[c], \
     for [c=1:5] [1:4096] last[c] * x ** (alphas[c] - 1) with lines lt c lw 1.4 dt 2 notitle
