# Redraw in the folder above: gnuplot plots/reactions-differences.gp; as PDF: gnuplot -e 'pdf = 1' plots/reactions-differences.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.6613 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'reactions-differences.pdf'
} else {
  set terminal svg size 620,540 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'reactions-differences.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Reactions by differences of positions' at screen 0.0193548,0.971296 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s' at screen 0.0193548,0.939815 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed-form dyads in long double' at screen 0.0193548,0.912037 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of reactions, relative' at screen 0.0193548,0.873148 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.194444 to screen 0.243387,0.194444 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.219194,0.194444 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'differences of order 2' at screen 0.25629,0.194444 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.161111 to screen 0.243387,0.161111 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.219194,0.161111 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'differences of order 4' at screen 0.25629,0.161111 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.127778 to screen 0.243387,0.127778 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.219194,0.127778 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, from the equations of motion' at screen 0.25629,0.127778 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.0944444 to screen 0.243387,0.0944444 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.25629,0.0944444 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.0611111 to screen 0.243387,0.0611111 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off, derivatives from the equations: 7.4e-16' at screen 0.25629,0.0611111 left noenhanced front tc rgb '#202020'
set label '' at screen 0.219194,0.0277778 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.25629,0.0277778 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.037037037e-01
set tmargin at screen 8.407407407e-01
set xrange [1.457033861e+01:1.619245827e+05]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '3000' 3000, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '' 20000 1, '3·10^{4}' 30000, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '10^{5}' 100000)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'instants per motion' at screen 0.533871,0.240741 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.337022 to screen 0.967742,0.337022 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
2.400000000e+01 5.858370530e-03
4.800000000e+01 1.468057970e-03
9.600000000e+01 3.672324129e-04
1.920000000e+02 9.182174468e-05
3.840000000e+02 2.295629006e-05
7.680000000e+02 5.739138290e-06
1.536000000e+03 1.434764711e-06
3.072000000e+03 3.585603956e-07
6.144000000e+03 8.981055521e-08
1.228800000e+04 2.571930990e-08
2.457600000e+04 2.998826404e-08
4.915200000e+04 9.395959557e-08
9.830400000e+04 3.598804737e-07
e
$p0points0 << e
2.400000000e+01 5.858370530e-03
4.800000000e+01 1.468057970e-03
9.600000000e+01 3.672324129e-04
1.920000000e+02 9.182174468e-05
3.840000000e+02 2.295629006e-05
7.680000000e+02 5.739138290e-06
1.536000000e+03 1.434764711e-06
3.072000000e+03 3.585603956e-07
6.144000000e+03 8.981055521e-08
1.228800000e+04 2.571930990e-08
2.457600000e+04 2.998826404e-08
4.915200000e+04 9.395959557e-08
9.830400000e+04 3.598804737e-07
e
$p0line1_0 << e
2.400000000e+01 7.218028077e-05
4.800000000e+01 4.620449423e-06
9.600000000e+01 2.905606357e-07
1.920000000e+02 1.818861403e-08
3.840000000e+02 1.138525176e-09
7.680000000e+02 8.769919194e-11
1.536000000e+03 1.394504914e-10
3.072000000e+03 4.757120707e-10
6.144000000e+03 1.358673909e-09
1.228800000e+04 9.136349355e-09
2.457600000e+04 3.263962712e-08
4.915200000e+04 1.187910014e-07
9.830400000e+04 4.696976234e-07
e
$p0points1 << e
2.400000000e+01 7.218028077e-05
4.800000000e+01 4.620449423e-06
9.600000000e+01 2.905606357e-07
1.920000000e+02 1.818861403e-08
3.840000000e+02 1.138525176e-09
7.680000000e+02 8.769919194e-11
1.536000000e+03 1.394504914e-10
3.072000000e+03 4.757120707e-10
6.144000000e+03 1.358673909e-09
1.228800000e+04 9.136349355e-09
2.457600000e+04 3.263962712e-08
4.915200000e+04 1.187910014e-07
9.830400000e+04 4.696976234e-07
e
$p0line2_0 << e
2.400000000e+01 2.708179066e-15
9.600000000e+01 7.388899971e-16
e
$p0points2 << e
2.400000000e+01 2.708179066e-15
9.600000000e+01 7.388899971e-16
e
set label 'default' at screen 0.288518,0.357319 left noenhanced front tc rgb '#202020'
$p0default << e
9.600000000e+01 7.388899971e-16
e
set arrow from screen 0.459354,0.698635 to screen 0.533269,0.672195 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.406376,0.669047 left noenhanced front tc rgb '#404040'
set arrow from screen 0.330224,0.603681 to screen 0.395932,0.556673 nohead lw 1 lc rgb '#404040'
set label 'order 4' at screen 0.273143,0.563809 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line2_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
