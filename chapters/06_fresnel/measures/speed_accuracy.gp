# Left and middle: Fresnel by formula, over the index and over time. Right: samplers of a rough metal.
set terminal pngcairo size 2150,820
file = folder."/speed_accuracy.csv"
is(method) = strcol(1) eq method
set multiplot layout 1,3 title "What an exact reflectance costs, and what good directions save\n{/*0.75 references: Fresnel's sine and tangent forms in extended precision; the light given back by quadrature over slopes}" font ",20"
set datafile missing NaN
set logscale y
set format y "10^{%L}"
set ylabel "error of the reflectance, rms"
set grid xtics ytics
set key at graph 0.04,0.5 left center Left reverse

array formulas[3] = ["Fresnel's equations", "Schlick", "table"]
set title "smooth glass, by its index" font ",16"
set xlabel "index of refraction"
set xrange [1:4.2]
set yrange [1e-18:1]
plot for [i=1:2] file using (is(formulas[i]) ? setting_number(strcol(2), "ior") : NaN):5 with linespoints lt i lw 2.2 ps 1.6 title formulas[i]

set title "the same by time; tables for n = 1.5, steps beside the marks" font ",16"
set xlabel "time, ns per reflectance"
set logscale x
set xrange [*:*]
set xtics (0.5, 1, 2, 3, 5, 10, 20, 50)
plot for [i=1:3] file using (is(formulas[i]) ? $3 : NaN):5 with points lt i ps 1.6 title formulas[i], \
     file using (is("table") ? $3 * 1.1 : NaN):5:(setting_text(strcol(2), "steps")) with labels left font ",12" textcolor lt 3 notitle

set title "rough gold, cosine 0.3: 4, 16, 64, 256, 1024 samples" font ",16"
set xlabel "time, µs per estimate"
set xtics auto
set xrange [*:*]
set yrange [1e-3:100]
set key at graph 0.97,0.97 right top Left reverse samplen 4
array samplers[3] = ["visible normals", "all normals", "cosine"]
rough(method, alpha) = is(method) && setting_number(strcol(2), "alpha") == alpha
plot for [i=1:3] file using (rough(samplers[i], 0.1) ? $3 : NaN):5 with linespoints lt i lw 2.2 ps 1.6 title samplers[i].", α = 0.1", \
     for [i=1:3] file using (rough(samplers[i], 0.5) ? $3 : NaN):5 with linespoints lt i dt 2 lw 2.2 ps 1.6 title samplers[i].", α = 0.5"
unset multiplot
