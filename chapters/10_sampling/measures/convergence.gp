# The same points over paths a pixel; the grey lines fall with the square root.
set terminal pngcairo size 1500,760
file = folder."/convergence.csv"
array samplers[4] = ["random", "stratified", "halton", "sobol"]
array titles[4] = ["random", "stratified", "Halton, digits permuted", "Sobol, Owen-scrambled"]
array scenes[2] = ["smooth", "caustic"]
array lowest[2] = [1e-5, 0.1]
array highest[2] = [0.2, 20]
array names[2] = ["a floor under a lamp, against Lambert's closed form", "a caustic, against chapter 07's program for it alone"]
set multiplot layout 1,2 margins 0.075,0.985,0.11,0.8 spacing 0.09,0.1 title "What a path buys: error over paths a pixel\n{/*0.75 grey: N^{−1/2}}" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "paths a pixel"
set ylabel "error of the radiance, rms"
do for [s=1:2] {
    set title names[s] font ",15"
    if (s == 1) { set key at graph 0.02,0.03 left bottom Left reverse opaque noenhanced } else { unset key }
    plot [2:2048][lowest[s]:highest[s]] for [k=-16:9] 10**(k / 4.0) / sqrt(x) with lines lc rgb "#cccccc" lw 1 notitle, \
         for [m=1:4] file every ::0 using (strcol(1) eq samplers[m] && setting_text(strcol(2), "scene") eq scenes[s] ? setting_number(strcol(2), "samples") : NaN):3 with linespoints lt m lw 2.2 ps 1.3 title titles[m]
}
unset multiplot
