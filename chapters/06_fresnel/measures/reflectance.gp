# Three panels over the angle of incidence: into glass, out of glass, metals.
set terminal pngcairo size 1800,720
file = folder."/reflectance.csv"
is(curve, value) = strcol(1) eq curve ? value : NaN
set datafile missing NaN
set multiplot layout 1,3 title "How much a smooth surface reflects, by the angle" font ",20"
set xrange [0:90]
set yrange [0:1.02]
set xtics 15
set xlabel "angle of incidence, degrees"
set ylabel "reflectance"
set key at graph 0.04,0.97 left top Left reverse

set title "from air into glass, n = 1.5" font ",17"
brewster = atan(1.5) * 180 / pi
set arrow 1 from brewster,0.28 to brewster,0.02 lc rgb "#444444"
set label 1 "Brewster's angle\n56.3°" at brewster,0.36 center
plot file using (is("into glass", $2)):3 with lines lt 1 lw 3.2 title "unpolarised", \
     file using (is("into glass: across", $2)):3 with lines lt 2 title "across the plane", \
     file using (is("into glass: within", $2)):3 with lines lt 3 title "within the plane", \
     file using (is("into glass: Schlick", $2)):3 with lines lt 7 dt 2 title "Schlick"

set title "from glass into air" font ",17"
critical = asin(1 / 1.5) * 180 / pi
set arrow 1 from critical + 9,0.5 to critical + 0.6,0.5 lc rgb "#444444"
set label 1 "critical angle\n41.8°" at critical + 11,0.52 left
plot file using (is("out of glass", $2)):3 with lines lt 1 lw 3.2 title "unpolarised", \
     file using (is("out of glass: Schlick", $2)):3 with lines lt 7 dt 2 title "Schlick"

unset arrow 1
unset label 1
set title "metals in air, at 617, 549 and 451 nm" font ",17"
set key at graph 0.04,0.32 left top Left reverse
plot for [m=1:3] for [c=1:3] file using (is(word("gold silver copper", m)." ".word("red green blue", c), $2)):3 with lines dt m \
     lc rgb word("#d62728 #2ca02c #1f77b4", c) lw 2.2 notitle, \
     for [m=1:3] NaN with lines dt m lw 2.2 lc rgb "#444444" title word("gold silver copper", m)
unset multiplot
