# Error over time in one scene. Set before: $points (method, time, error), methods, names[1…methods], scene.
set terminal pngcairo size 1400,900
set title scene.": error over seconds of one thread" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s" offset 0,0.6
set ylabel "error of the radiance, rms"
set grid xtics ytics
set key outside bottom center horizontal Left reverse noenhanced maxcols 3 width 2
# The style has eight colours; what comes after them is dashed.
do for [m=1:methods] {
    eval sprintf("set style line %d lt %d dt %d lw 2.2 ps 1.4", m, (m - 1) % 8 + 1, m > 8 ? 2 : 1)
}
plot for [m=1:methods] $points using (strcol(1) eq names[m] ? $2 : NaN):3 with linespoints ls m title names[m]
