# Which fixed offset fails at which scale, float left, double right; the line is what the relative rule takes.
set terminal pngcairo size 1600,840
file = folder."/offset_map.csv"
set multiplot layout 1,2 title "A ball of some size, 1/2000 of it above a floor: which distance may a ray start at?\n{/*0.75 colour: share of rays that go wrong}" font ",20"
set xlabel "size of the scene, and of its coordinates"
set xrange [-4.25:7.25]
set yrange [-16.25:2.25]
set xtics ("10^{-3}" -3, "1" 0, "10^{3}" 3, "10^{6}" 6)
set ytics ("10^{-16}" -16, "10^{-12}" -12, "10^{-8}" -8, "10^{-4}" -4, "1" 0)
unset grid
unset key
set tics front
# Vermilion for self-hits, blue for lost contacts, white for neither.
strength(failures, trials) = failures > 0 ? 0.25 + 0.75 * failures / trials : 0.0
blended(a, b) = int(255 - a * 42 - b * 255 * (1 - a)) * 65536 + int(255 - a * 161 - b * 141 * (1 - a)) * 256 \
    + int(255 - a * 255 - b * 77 * (1 - a))
mixed(selfHits, lost, trials) = blended(strength(selfHits, trials), strength(lost, trials))
stats file using 4 every ::0::1 nooutput
half = 0.56 * (STATS_max - STATS_min)
do for [precision in "float double"] {
    set title precision font ",18"
    set ylabel precision eq "float" ? "distance from the surface" : ""
    set label 1 "too small: the surface shadows itself" at 7,(precision eq "float" ? -12.5 : -14.6) right front font ",15"
    set label 2 "too large: the gap is lost" at -3.9,0.9 left front textcolor rgb "white" font ",15"
    set label 3 "the relative rule" at (precision eq "float" ? -0.6 : 1.2),(precision eq "float" ? -5.2 : -11.9) left rotate by 31 front font ",15"
    plot file using (strcol(1) eq precision ? $3 : NaN):4:(half):(half):(mixed($5, $6, $7)) \
             with boxxyerror fillcolor rgb variable fillstyle solid noborder, \
         file using (strcol(1) eq precision ? $3 : NaN):8 with lines lc rgb "black" lw 2.5
}
unset multiplot
