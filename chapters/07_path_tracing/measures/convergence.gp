# The same points over samples; the grey lines fall with the square root.
set terminal pngcairo size 1700,1240
file = folder."/convergence.csv"
array scenes[4] = ["diffuse_box", "mirror_box", "caustic", "peers_box"]
array titles[4] = ["diffuse box", "box with a small lamp and a mirror", "caustic of a glass ball", "the peers' box"]
array methods[5] = ["path tracing by chance", "path tracing with direct light", "path tracing with MIS", "light tracing", "bidirectional path tracing"]
array lowest[4] = [5e-4, 1e-2, 5e-2, 1e-2]
array highest[4] = [2, 10, 100, 4]
is(m, s) = strcol(1) eq methods[m] && setting_text(strcol(2), "scene") eq scenes[s]
set multiplot layout 2,2 margins 0.07,0.98,0.07,0.87 spacing 0.08,0.15 title "What a sample buys: error over paths a pixel\n{/*0.75 grey: N^{−1/2}. Where a curve turns flat, light is missing that the method cannot make}" font ",20"
set datafile missing NaN
set logscale xy
set format y "10^{%L}"
set xlabel "paths a pixel"
set ylabel "error of the radiance, rms"
set grid xtics ytics
do for [s=1:4] {
    set title titles[s] font ",17"
    if (s == 1) { set key at graph 0.02,0.03 left bottom Left reverse opaque noenhanced } else { unset key }
    plot [1:*][lowest[s]:highest[s]] for [k=-4:4] 10**(k / 2.0) / sqrt(x) with lines lc rgb "#cccccc" lw 1 notitle, \
         for [m=1:5] file every ::0 using (is(m, s) ? setting_number(strcol(2), "samples") : NaN):3 with linespoints lt m lw 2.2 ps 1.3 title methods[m]
}
unset multiplot
