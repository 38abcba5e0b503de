# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.4411 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,519 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 5.2 m at t = 0.3571 s, normal running' at screen 0.0193548,0.969171 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.0674374 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.0674374 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.0674374 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.0327553 right noenhanced front tc rgb '#c8500a'
set label 'weld around the t...' at screen 0.0612903,0.0327553 left noenhanced front tc rgb '#c8500a'
set label '-12.51 MPa' at screen 0.403226,0.0327553 right noenhanced front tc rgb '#c8500a'
set label '226 %' at screen 0.493548,0.0327553 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.53871,0.0327553 right noenhanced front tc rgb '#202020'
set label 'weld around the t...' at screen 0.551613,0.0327553 left noenhanced front tc rgb '#202020'
set label '-0.2875 MPa' at screen 0.893548,0.0327553 right noenhanced front tc rgb '#202020'
set label '23.8 %' at screen 0.983871,0.0327553 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 1.714836224e-01
set tmargin at screen 9.036608863e-01
set xrange [2.451250000e+02:-2.451250000e+02]
set yrange [-3.146875000e+02:3.146875000e+02]
set xtics 1.000000000e+02
set ytics 5.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.932563 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.105973 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.650000000e+02 -2.650000000e+02
1.650000000e+02 -2.650000000e+02
1.650000000e+02 2.650000000e+02
-1.650000000e+02 2.650000000e+02
-1.650000000e+02 -2.650000000e+02
e
$loop1 << e
-1.250000000e+02 2.250000000e+02
1.250000000e+02 2.250000000e+02
1.250000000e+02 -2.250000000e+02
-1.250000000e+02 -2.250000000e+02
-1.250000000e+02 2.250000000e+02
e
$places << e
-1.450000000e+02 0.000000000e+00
e
$governing << e
-1.250000000e+02 2.450000000e+02
e
set label '1' at screen 0.462051,0.802835 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.464044,0.565511 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.714836224e-01
set tmargin at screen 9.036608863e-01
set xrange [-2.516681879e+01:2.440342652e+01]
set yrange [-3.146875000e+02:3.146875000e+02]
set xtics 2.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.932563 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.105973 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.550620300e+01 -2.650000000e+02
1.352021561e+01 -2.318750000e+02
1.153422822e+01 -1.987500000e+02
9.548240827e+00 -1.656250000e+02
7.562253435e+00 -1.325000000e+02
5.576266043e+00 -9.937500000e+01
3.590278651e+00 -6.625000000e+01
1.604291259e+00 -3.312500000e+01
-9.625709959e-02 0.000000000e+00
1.707826219e+00 3.312500000e+01
3.664428699e+00 6.625000000e+01
5.621031179e+00 9.937500000e+01
7.577633658e+00 1.325000000e+02
9.534236138e+00 1.656250000e+02
1.149083862e+01 1.987500000e+02
1.344744110e+01 2.318750000e+02
1.540404358e+01 2.650000000e+02
-1.626959527e+01 2.650000000e+02
-1.428360788e+01 2.318750000e+02
-1.229762049e+01 1.987500000e+02
-1.031163309e+01 1.656250000e+02
-8.325645702e+00 1.325000000e+02
-6.339658310e+00 9.937500000e+01
-4.353670918e+00 6.625000000e+01
-2.367683525e+00 3.312500000e+01
-3.816961334e-01 0.000000000e+00
-2.205378740e+00 -3.312500000e+01
-4.161981219e+00 -6.625000000e+01
-6.118583699e+00 -9.937500000e+01
-8.075186179e+00 -1.325000000e+02
-1.003178866e+01 -1.656250000e+02
-1.198839114e+01 -1.987500000e+02
-1.394499362e+01 -2.318750000e+02
-1.590159610e+01 -2.650000000e+02
1.550620300e+01 -2.650000000e+02
e
$high << e
1.550620300e+01 -2.650000000e+02
1.352021561e+01 -2.318750000e+02
1.153422822e+01 -1.987500000e+02
9.548240827e+00 -1.656250000e+02
7.562253435e+00 -1.325000000e+02
5.576266043e+00 -9.937500000e+01
3.590278651e+00 -6.625000000e+01
1.604291259e+00 -3.312500000e+01
-9.625709959e-02 0.000000000e+00
1.707826219e+00 3.312500000e+01
3.664428699e+00 6.625000000e+01
5.621031179e+00 9.937500000e+01
7.577633658e+00 1.325000000e+02
9.534236138e+00 1.656250000e+02
1.149083862e+01 1.987500000e+02
1.344744110e+01 2.318750000e+02
1.540404358e+01 2.650000000e+02
e
$low << e
-1.590159610e+01 -2.650000000e+02
-1.394499362e+01 -2.318750000e+02
-1.198839114e+01 -1.987500000e+02
-1.003178866e+01 -1.656250000e+02
-8.075186179e+00 -1.325000000e+02
-6.118583699e+00 -9.937500000e+01
-4.161981219e+00 -6.625000000e+01
-2.205378740e+00 -3.312500000e+01
-3.816961334e-01 0.000000000e+00
-2.367683525e+00 3.312500000e+01
-4.353670918e+00 6.625000000e+01
-6.339658310e+00 9.937500000e+01
-8.325645702e+00 1.325000000e+02
-1.031163309e+01 1.656250000e+02
-1.229762049e+01 1.987500000e+02
-1.428360788e+01 2.318750000e+02
-1.626959527e+01 2.650000000e+02
e
set arrow from screen 0.818464,0.171484 to screen 0.818464,0.903661 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.250615710e+01 2.450000000e+02
e
set label '-12.51 (1)' at screen 0.692124,0.860163 left noenhanced front tc rgb '#c8500a'
set label '15.51' at screen 0.846543,0.210894 left noenhanced front tc rgb '#0b5fa5'
set label '-15.90' at screen 0.73087,0.210894 left noenhanced front tc rgb '#00785a'
set label '15.40' at screen 0.845918,0.86425 left noenhanced front tc rgb '#0b5fa5'
set label '-16.27' at screen 0.728619,0.827465 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
