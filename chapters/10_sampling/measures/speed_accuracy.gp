# Error over seconds of path tracing by each sampler, a mark four times the paths of the one before.
set terminal pngcairo size 1500,760
file = folder."/speed_accuracy.csv"
array samplers[4] = ["random", "stratified", "halton", "sobol"]
array titles[4] = ["random", "stratified", "Halton, digits permuted", "Sobol, Owen-scrambled"]
array scenes[2] = ["smooth", "caustic"]
array lowest[2] = [1e-5, 0.1]
array highest[2] = [0.2, 20]
array names[2] = ["a floor under a lamp, against Lambert's closed form", "a caustic, against chapter 07's program for it alone"]
set multiplot layout 1,2 margins 0.075,0.985,0.11,0.83 spacing 0.09,0.1 title "What time buys: path tracing by four samplers, 32 × 32 pixels" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s of one thread"
set ylabel "error of the radiance, rms"
do for [s=1:2] {
    set title names[s] font ",15"
    if (s == 1) { set key at graph 0.02,0.03 left bottom Left reverse opaque noenhanced } else { unset key }
    plot [*:*][lowest[s]:highest[s]] for [m=1:4] file every ::0 using (strcol(1) eq samplers[m] && setting_text(strcol(2), "scene") eq scenes[s] ? $3 : NaN):5 with linespoints lt m lw 2.2 ps 1.3 title titles[m]
}
unset multiplot
