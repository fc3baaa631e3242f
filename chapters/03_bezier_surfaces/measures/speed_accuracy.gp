# Wrong rays against time: to the lower left is better.
set terminal pngcairo size 1500,860
file = folder."/speed_accuracy.csv"
array methods[5] = ["random starts", "4x4 starts", "bracketing starts", "triangles", "robust"]
wrong(perMillion) = perMillion > 0 ? perMillion : 0.3
set datafile missing NaN
set title "A ray and a vase of four cubics: speed and wrong answers\n{/*0.75 rays whose nearest meeting is lost, invented or displaced by more than a thousandth of the size;}\n{/*0.75 random chords, held against brute-force subdivision; numbers are starts, samples a segment and tolerances}" font ",20"
set logscale xy
set yrange [0.15:1e6]
set ytics ("none" 0.3, "1" 1, "10" 10, "10^{2}" 100, "10^{3}" 1e3, "10^{4}" 1e4, "10^{5}" 1e5, "10^{6}" 1e6)
set xlabel "time, ns per ray"
set ylabel "wrong rays per million"
set xtics ("100" 100, "200" 200, "300" 300, "500" 500, "1000" 1000, "2000" 2000, "4000" 4000)
stats file using 3 nooutput
set xrange [STATS_min / 1.25:STATS_max * 1.25]
set grid xtics ytics
set arrow 1 from graph 0, first 0.6 to graph 1, first 0.6 nohead lc rgb "#bbbbbb" dt 2
label(setting) = strstrt(setting, "starts=") ? setting_text(setting, "starts") : \
                 strstrt(setting, "samples=") ? setting_text(setting, "samples") : \
                 strstrt(setting, "tolerance=") ? setting_text(setting, "tolerance") : ""
plot for [i=1:5] file using (strcol(1) eq methods[i] ? $3 : NaN):(wrong($5)) with linespoints lt i lw 1.4 ps 1.7 title methods[i], \
     for [i=1:2] file using (strcol(1) eq methods[i] ? $3 : NaN):(wrong($5)):(label(strcol(2))) with labels offset 0.6,0.7 font ",12" notitle, \
     file using (strcol(1) eq methods[3] ? $3 : NaN):(wrong($5)):(label(strcol(2))) with labels right offset -0.9,-0.4 font ",12" notitle, \
     file using (strcol(1) eq methods[4] ? $3 : NaN):(wrong($5)):(label(strcol(2))) with labels left offset 0.9,0.2 font ",12" notitle
