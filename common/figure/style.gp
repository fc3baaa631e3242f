# The one style of every chart of the course. A script adds titles, axes and plot commands.
set terminal pngcairo size 1280,800 enhanced font "DejaVu Sans,15" linewidth 1.4 background rgb "white"
set output output
set datafile separator comma columnheaders
set encoding utf8

# Okabe and Ito's colours: told apart by colour-blind readers too, and in grey.
set linetype 1 lc rgb "#0072b2" pt 7 ps 1.1 lw 1.8
set linetype 2 lc rgb "#d55e00" pt 5 ps 1.1 lw 1.8
set linetype 3 lc rgb "#009e73" pt 9 ps 1.3 lw 1.8
set linetype 4 lc rgb "#cc79a7" pt 11 ps 1.3 lw 1.8
set linetype 5 lc rgb "#e69f00" pt 13 ps 1.4 lw 1.8
set linetype 6 lc rgb "#56b4e9" pt 6 ps 1.1 lw 1.8
set linetype 7 lc rgb "#444444" pt 4 ps 1.1 lw 1.8
set linetype 8 lc rgb "#a6761d" pt 8 ps 1.3 lw 1.8
set linetype cycle 8

set border 3 lc rgb "#444444" lw 1
set tics nomirror out textcolor rgb "#222222"
set grid back lc rgb "#dddddd" lw 0.8 lt 1
# Outside the axes, so that no legend ever hides a point.
set key outside right top vertical Left reverse samplen 2 spacing 1.15 noenhanced
set title font ",17" offset 0,0.3
set style fill solid 0.85 border rgb "#444444"
set style histogram clustered gap 1
set boxwidth 0.9

# What a setting such as "degree=30;scalar=double" says of a key, as text and as a number.
up_to_semicolon(text) = strstrt(text, ";") ? text[1:strstrt(text, ";") - 1] : text
setting_text(setting, key) = up_to_semicolon(setting[strstrt(setting, key."=") + strlen(key) + 1:*])
setting_number(setting, key) = real(setting_text(setting, key))
