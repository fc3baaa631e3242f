# A mark a rule, a scene and a number of paths: gains with as many paths, in the same time, and among the noisiest pixels.
set terminal pngcairo size 1500,640
file = folder."/adaptive.csv"
array kinds[3] = ["with as many paths", "in the same time", "as many paths: the noisiest 2 % of pixels"]
array columns[3] = [5, 7, 9]
# What was measured, each setting once; of a scene with several, the marks of fewer paths are hollow.
settings = ""
added(setting) = (settings = strstrt(settings." ", setting." ") ? settings : settings." ".setting, 0)
stats file using (added(strcol(2))) nooutput
scene_of(s) = setting_text(word(settings, s), "scene")
called(s) = scene_of(s).", ".setting_text(word(settings, s), "paths")." paths"
kind(s) = scene_of(s) eq "bunny" ? 1 : scene_of(s) eq "box" ? 2 : 3
is_hollow(s) = s < words(settings) && scene_of(s) eq scene_of(s + 1)
array rules[5] = ["① path hash", "② edges", "③ widest interval", "largest gain", "largest gain apart"]
place(rule) = rule eq rules[1] ? 1 : rule eq rules[2] ? 2 : rule eq rules[3] ? 3 : rule eq rules[4] ? 4 : rule eq rules[5] ? 5 : NaN
set multiplot layout 1,3 margins 0.05,0.99,0.2,0.8 spacing 0.045,0.1 title "Uniform sampling's variance over the adaptive one's\n{/*0.75 with the standard error; the report says 50 for the bunny and 200 for the cup}" font ",20"
set datafile missing NaN
set logscale y
set xrange [0.5:5.5]
set yrange [0.05:300]
set xtics rotate by -25 ("① hash" 1, "② edges" 2, "③ interval" 3, "gain" 4, "apart" 5)
unset grid
set grid ytics
do for [k=1:3] {
    set title kinds[k] font ",15"
    if (k == 1) { set key at graph 0.02,0.97 left top Left reverse opaque noenhanced } else { unset key }
    plot 1 with lines lc rgb "#888888" dt 2 notitle, \
         for [s=1:words(settings)] file every ::0 using (strcol(2) eq word(settings, s) ? place(strcol(1)) + 0.16 * (s - (words(settings) + 1) / 2.0) : NaN):(column(columns[k])):(column(columns[k] + 1)) with yerrorbars lt kind(s) pt 2 * kind(s) + 5 - is_hollow(s) ps 1.6 lw 2 title called(s)
}
unset multiplot
