# Both rules where the caustic is, and where it is dark.
set terminal pngcairo size 1500,700
file = folder."/claims.csv"
array methods[2] = ["SPPM by pass ①", "SPPM by point ②"]
array parts[2] = ["caustic", "dark"]
array titles[2] = ["in the caustic: the brightest tenth of the pixels", "in the dark: the darkest half"]
is(m, p) = strcol(1) eq methods[m] && setting_text(strcol(2), "part") eq parts[p]
set multiplot layout 1,2 margins 0.08,0.97,0.12,0.82 spacing 0.09,0.1 title "The two rules, pass by pass" font ",20"
set datafile missing NaN
set logscale xy
set format y "10^{%L}"
set xlabel "passes"
set ylabel "error, share of the radiance, rms"
do for [p=1:2] {
    set title titles[p]
    set key at graph 0.98,0.98 right top Left reverse opaque noenhanced
    plot for [m=1:2] file every ::0 using (is(m, p) ? setting_number(strcol(2), "passes") : NaN):3 with linespoints lt m lw 2.2 ps 1.3 title methods[m]
}
unset multiplot
