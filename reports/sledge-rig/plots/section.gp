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
set label 's = 4.2- m at t = 0.3571 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'fibre +z' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-17.05 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '165 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '-17.05 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '165 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '16.42 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '164 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '-14.26 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '137 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '13.63 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '137 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '15.2 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '15.2 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0298246 left noenhanced front tc rgb '#202020'
set label '-0.3171 MPa' at screen 0.893548,0.0298246 right noenhanced front tc rgb '#202020'
set label '6.5 %' at screen 0.983871,0.0298246 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [2.775000000e+02:-2.775000000e+02]
set yrange [-3.562500000e+02:3.562500000e+02]
set xtics 2.000000000e+02
set ytics 5.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.938596 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.185965 center noenhanced front tc rgb '#202020'
$loop0 << e
-2.000000000e+02 -3.000000000e+02
2.000000000e+02 -3.000000000e+02
2.000000000e+02 3.000000000e+02
-2.000000000e+02 3.000000000e+02
-2.000000000e+02 -3.000000000e+02
e
$loop1 << e
-1.500000000e+02 2.500000000e+02
1.500000000e+02 2.500000000e+02
1.500000000e+02 -2.500000000e+02
-1.500000000e+02 -2.500000000e+02
-1.500000000e+02 2.500000000e+02
e
$welds << e
2.000000000e+02 2.500000000e+02
2.000000000e+02 -2.500000000e+02
-2.000000000e+02 2.500000000e+02
-2.000000000e+02 -2.500000000e+02
e
$places << e
1.500000000e+02 3.000000000e+02
0.000000000e+00 -3.000000000e+02
1.750000000e+02 2.500000000e+02
1.750000000e+02 -2.500000000e+02
1.750000000e+02 0.000000000e+00
e
$governing << e
0.000000000e+00 3.000000000e+02
e
set label '1' at screen 0.340323,0.877637 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.21129,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.316233 left noenhanced front tc rgb '#0b5fa5'
set label '4, 6' at screen 0.189785,0.830853 left noenhanced front tc rgb '#0b5fa5'
set label '5, 7' at screen 0.189785,0.327042 left noenhanced front tc rgb '#0b5fa5'
set label '8' at screen 0.172301,0.604386 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-2.642079548e+01:2.578661483e+01]
set yrange [-3.562500000e+02:3.562500000e+02]
set xtics 2.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.641605400e+01 -3.000000000e+02
1.432441096e+01 -2.625000000e+02
1.223276792e+01 -2.250000000e+02
1.014112488e+01 -1.875000000e+02
8.049481839e+00 -1.500000000e+02
5.957838798e+00 -1.125000000e+02
3.866195756e+00 -7.500000000e+01
1.774552715e+00 -3.750000000e+01
-1.793167880e-01 0.000000000e+00
1.810863535e+00 3.750000000e+01
3.884393446e+00 7.500000000e+01
5.957923357e+00 1.125000000e+02
8.031453268e+00 1.500000000e+02
1.010498318e+01 1.875000000e+02
1.217851309e+01 2.250000000e+02
1.425204300e+01 2.625000000e+02
1.632557291e+01 3.000000000e+02
-1.705023466e+01 3.000000000e+02
-1.495859161e+01 2.625000000e+02
-1.286694857e+01 2.250000000e+02
-1.077530553e+01 1.875000000e+02
-8.683662491e+00 1.500000000e+02
-6.592019450e+00 1.125000000e+02
-4.500376409e+00 7.500000000e+01
-2.408733367e+00 3.750000000e+01
-3.170903261e-01 0.000000000e+00
-2.336196287e+00 -3.750000000e+01
-4.409726198e+00 -7.500000000e+01
-6.483256109e+00 -1.125000000e+02
-8.556786020e+00 -1.500000000e+02
-1.063031593e+01 -1.875000000e+02
-1.270384584e+01 -2.250000000e+02
-1.477737575e+01 -2.625000000e+02
-1.685090566e+01 -3.000000000e+02
1.641605400e+01 -3.000000000e+02
e
$high << e
1.641605400e+01 -3.000000000e+02
1.432441096e+01 -2.625000000e+02
1.223276792e+01 -2.250000000e+02
1.014112488e+01 -1.875000000e+02
8.049481839e+00 -1.500000000e+02
5.957838798e+00 -1.125000000e+02
3.866195756e+00 -7.500000000e+01
1.774552715e+00 -3.750000000e+01
-1.793167880e-01 0.000000000e+00
1.810863535e+00 3.750000000e+01
3.884393446e+00 7.500000000e+01
5.957923357e+00 1.125000000e+02
8.031453268e+00 1.500000000e+02
1.010498318e+01 1.875000000e+02
1.217851309e+01 2.250000000e+02
1.425204300e+01 2.625000000e+02
1.632557291e+01 3.000000000e+02
e
$low << e
-1.685090566e+01 -3.000000000e+02
-1.477737575e+01 -2.625000000e+02
-1.270384584e+01 -2.250000000e+02
-1.063031593e+01 -1.875000000e+02
-8.556786020e+00 -1.500000000e+02
-6.483256109e+00 -1.125000000e+02
-4.409726198e+00 -7.500000000e+01
-2.336196287e+00 -3.750000000e+01
-3.170903261e-01 0.000000000e+00
-2.408733367e+00 3.750000000e+01
-4.500376409e+00 7.500000000e+01
-6.592019450e+00 1.125000000e+02
-8.683662491e+00 1.500000000e+02
-1.077530553e+01 1.875000000e+02
-1.286694857e+01 2.250000000e+02
-1.495859161e+01 2.625000000e+02
-1.705023466e+01 3.000000000e+02
e
set arrow from screen 0.817971,0.245614 to screen 0.817971,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.705023466e+01 3.000000000e+02
e
set label '-17.05 (1)' at screen 0.669103,0.883333 left noenhanced front tc rgb '#c8500a'
set label '16.42' at screen 0.846543,0.281499 left noenhanced front tc rgb '#0b5fa5'
set label '-16.85' at screen 0.729776,0.281499 left noenhanced front tc rgb '#00785a'
set label '16.33' at screen 0.846017,0.876396 left noenhanced front tc rgb '#0b5fa5'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
