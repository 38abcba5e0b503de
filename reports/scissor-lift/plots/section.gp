# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.9758 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,570 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 1.05+ m at t = 11.4448 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'bottom flange' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-96.68 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '84.9 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '-96.68 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '84.9 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '92.86 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '83.2 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '-87.76 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '77.0 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '83.94 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '75.3 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label '-1.910 MPa' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '8.9 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '6.0 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0298246 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0298246 right noenhanced front tc rgb '#202020'
set label '6.0 %' at screen 0.983871,0.0298246 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [7.862500000e+01:-7.862500000e+01]
set yrange [-1.009375000e+02:1.009375000e+02]
set xtics 5.000000000e+01
set ytics 2.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.938596 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.185965 center noenhanced front tc rgb '#202020'
$loop0 << e
-4.000000000e+01 -8.500000000e+01
4.000000000e+01 -8.500000000e+01
4.000000000e+01 8.500000000e+01
-4.000000000e+01 8.500000000e+01
-4.000000000e+01 -8.500000000e+01
e
$loop1 << e
-3.400000000e+01 7.700000000e+01
3.400000000e+01 7.700000000e+01
3.400000000e+01 -7.700000000e+01
-3.400000000e+01 -7.700000000e+01
-3.400000000e+01 7.700000000e+01
e
$welds << e
4.000000000e+01 7.700000000e+01
4.000000000e+01 -7.700000000e+01
-4.000000000e+01 7.700000000e+01
-4.000000000e+01 -7.700000000e+01
e
$places << e
0.000000000e+00 -8.500000000e+01
0.000000000e+00 8.500000000e+01
3.700000000e+01 -7.700000000e+01
3.700000000e+01 7.700000000e+01
3.700000000e+01 0.000000000e+00
e
$governing << e
3.400000000e+01 -8.500000000e+01
e
set label '1' at screen 0.237097,0.280258 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.280258 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '4, 8' at screen 0.227989,0.342652 left noenhanced front tc rgb '#0b5fa5'
set label '5, 7' at screen 0.165537,0.851218 left noenhanced front tc rgb '#0b5fa5'
set label '6' at screen 0.227989,0.596935 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-1.497574957e+02:1.459635438e+02]
set yrange [-1.009375000e+02:1.009375000e+02]
set xtics 1.000000000e+02
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
-2.080486943e+01 -8.500000000e+01
-1.834824257e+01 -7.437500000e+01
-1.589161339e+01 -6.375000000e+01
-1.343496522e+01 -5.312500000e+01
-1.097827559e+01 -4.250000000e+01
-8.521478588e+00 -3.187500000e+01
-5.934159211e+00 -2.125000000e+01
-3.238671036e+00 -1.062500000e+01
-5.431828605e-01 0.000000000e+00
9.955806717e+00 1.062500000e+01
2.180255445e+01 2.125000000e+01
3.364949277e+01 3.187500000e+01
4.549653992e+01 4.250000000e+01
5.734367818e+01 5.312500000e+01
6.919087964e+01 6.375000000e+01
8.103812690e+01 7.437500000e+01
9.288540848e+01 8.500000000e+01
1.850097750e+01 8.500000000e+01
1.604432469e+01 7.437500000e+01
1.358766438e+01 6.375000000e+01
1.113099278e+01 5.312500000e+01
8.674302991e+00 4.250000000e+01
6.217581012e+00 3.187500000e+01
3.760793192e+00 2.125000000e+01
1.303830359e+00 1.062500000e+01
-3.859878022e+00 0.000000000e+00
-1.487187654e+01 -1.062500000e+01
-2.611128784e+01 -2.125000000e+01
-3.764364028e+01 -3.187500000e+01
-4.934955644e+01 -4.250000000e+01
-6.115094810e+01 -5.312500000e+01
-7.298883298e+01 -6.375000000e+01
-8.483347784e+01 -7.437500000e+01
-9.667936041e+01 -8.500000000e+01
-2.080486943e+01 -8.500000000e+01
e
$high << e
-2.080486943e+01 -8.500000000e+01
-1.834824257e+01 -7.437500000e+01
-1.589161339e+01 -6.375000000e+01
-1.343496522e+01 -5.312500000e+01
-1.097827559e+01 -4.250000000e+01
-8.521478588e+00 -3.187500000e+01
-5.934159211e+00 -2.125000000e+01
-3.238671036e+00 -1.062500000e+01
-5.431828605e-01 0.000000000e+00
9.955806717e+00 1.062500000e+01
2.180255445e+01 2.125000000e+01
3.364949277e+01 3.187500000e+01
4.549653992e+01 4.250000000e+01
5.734367818e+01 5.312500000e+01
6.919087964e+01 6.375000000e+01
8.103812690e+01 7.437500000e+01
9.288540848e+01 8.500000000e+01
e
$low << e
-9.667936041e+01 -8.500000000e+01
-8.483347784e+01 -7.437500000e+01
-7.298883298e+01 -6.375000000e+01
-6.115094810e+01 -5.312500000e+01
-4.934955644e+01 -4.250000000e+01
-3.764364028e+01 -3.187500000e+01
-2.611128784e+01 -2.125000000e+01
-1.487187654e+01 -1.062500000e+01
-3.859878022e+00 0.000000000e+00
1.303830359e+00 1.062500000e+01
3.760793192e+00 2.125000000e+01
6.217581012e+00 3.187500000e+01
8.674302991e+00 4.250000000e+01
1.113099278e+01 5.312500000e+01
1.358766438e+01 6.375000000e+01
1.604432469e+01 7.437500000e+01
1.850097750e+01 8.500000000e+01
e
set arrow from screen 0.818074,0.245614 to screen 0.818074,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-9.667936041e+01 -8.500000000e+01
e
set label '-96.68 (1)' at screen 0.669103,0.274561 left noenhanced front tc rgb '#c8500a'
set label '-20.80' at screen 0.828999,0.33236 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.828999,0.319202 to screen 0.796741,0.298246 nohead lw 0.6 lc rgb '#0b5fa5'
set label '92.89' at screen 0.846543,0.876396 left noenhanced front tc rgb '#0b5fa5'
set label '18.50' at screen 0.846722,0.842902 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
