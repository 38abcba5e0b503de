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
set xrange [1.000000000e+07:1.000000000e+08]
set yrange [0.000000000e+00:9.241757997e+01]
set ytics 1.000000000e+01
set label 'cycles in the wanted life with this range or a larger one' at screen 0.529032,0.0289017 center noenhanced front tc rgb '#202020'
set label 'D = 12.8; s = 0.8 m, hole oil edge' at screen 0.0193548,0.947977 left noenhanced front tc rgb '#202020'
set label 'stress range [MPa]: share of the damage, loads as they are with partial factors' at screen 0.0193548,0.893064 left enhanced front tc rgb '#202020'
$stair << e
1.000000000e+07 8.036311302e+01
2.000000000e+07 8.036311302e+01
2.000000000e+07 1.898548926e+00
4.000000000e+07 1.898548926e+00
4.000000000e+07 0.000000000e+00
e
set label '80.4: 100 %' at screen 0.362517,0.781012 left noenhanced front tc rgb '#c8500a'
set label '1.90: no damage' at screen 0.626646,0.167556 left noenhanced front tc rgb '#c8500a'
plot $stair using 1:2 with filledcurves y1=0 fc rgb '#e3eaf2' notitle, $stair using 1:2 with lines lw 1.8 dt 1 lc rgb '#0b5fa5' notitle
unset label
unset arrow
unset object
unset multiplot
