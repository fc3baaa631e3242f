# Four scenes, a mark a doubling of samples.
set terminal pngcairo size 1700,1240
file = folder."/speed_accuracy.csv"
array scenes[4] = ["diffuse_box", "mirror_box", "caustic", "peers_box"]
array titles[4] = ["diffuse box\n{/*0.8 against radiosity by form factors}", "box with a small lamp and a mirror\n{/*0.8 against radiosity, the box once more behind the mirror}", \
                   "caustic of a glass ball\n{/*0.8 against a program for this scene alone}", "the peers' box\n{/*0.8 against a long converged picture}"]
array methods[5] = ["path tracing by chance", "path tracing with direct light", "path tracing with MIS", "light tracing", "bidirectional path tracing"]
array lowest[4] = [1e-4, 1e-2, 5e-2, 1e-2]
array highest[4] = [2, 10, 100, 4]
is(m, s) = strcol(1) eq methods[m] && setting_text(strcol(2), "scene") eq scenes[s]
set multiplot layout 2,2 margins 0.07,0.98,0.07,0.87 spacing 0.08,0.15 title "What time buys: error over seconds of one thread, pictures of 32 × 32 pixels" font ",20"
set datafile missing NaN
set logscale xy
set format xy "10^{%L}"
set xlabel "time, s"
set ylabel "error of the radiance, rms"
set grid xtics ytics
do for [s=1:4] {
    set title titles[s] font ",17"
    if (s == 1) { set key at graph 0.02,0.03 left bottom Left reverse opaque noenhanced } else { unset key }
    plot [][lowest[s]:highest[s]] for [m=1:5] file every ::0 using (is(m, s) ? $3 : NaN):5 with linespoints lt m lw 2.2 ps 1.3 title methods[m]
}
unset multiplot
