# Redraw in the folder above: gnuplot plots/spectrum.gp; as PDF: gnuplot -e 'pdf = 1' plots/spectrum.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,3.6274 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'spectrum.pdf'
} else {
  set terminal svg size 620,346 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'spectrum.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set logscale x
set format x '10^{%T}'
set xtics 10
set mxtics 1
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.271676301e-01
set tmargin at screen 8.497109827e-01
set xrange [1.000000000e+02:1.000000000e+09]
set yrange [0.000000000e+00:3.368718831e+01]
set ytics 5.000000000e+00
set label 'cycles in the wanted life with this range or a larger one' at screen 0.529032,0.0289017 center noenhanced front tc rgb '#202020'
set label 'D = 38.3; s = 5.2 m, weld around the tube at the box end, top flange' at screen 0.0193548,0.947977 left noenhanced front tc rgb '#202020'
set label 'stress range [MPa]: share of the damage, loads as they are with partial factors' at screen 0.0193548,0.893064 left enhanced front tc rgb '#202020'
$stair << e
1.000000000e+02 2.929320723e+01
1.000000000e+03 2.929320723e+01
1.000000000e+03 2.440857724e+01
1.000010000e+08 2.440857724e+01
1.000010000e+08 2.440857724e+01
1.000060000e+08 2.440857724e+01
1.000060000e+08 0.000000000e+00
e
set label '29.3: 0.00173 %, over-stroke' at screen 0.223733,0.781012 left noenhanced front tc rgb '#c8500a'
set label '24.4: 100 %, normal running' at screen 0.529881,0.676243 left noenhanced front tc rgb '#c8500a'
set label '24.4: 0.00500 %, start and stop' at screen 0.501625,0.625152 left noenhanced front tc rgb '#c8500a'
plot $stair using 1:2 with filledcurves y1=0 fc rgb '#e3eaf2' notitle, $stair using 1:2 with lines lw 1.8 dt 1 lc rgb '#0b5fa5' notitle
unset label
unset arrow
unset object
unset multiplot
