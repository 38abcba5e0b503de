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
set label 's = 4.2- m at t = 0.3684 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'fibre +z' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-18.55 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '180 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '-18.55 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '180 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '17.89 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '179 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '-15.51 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '150 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '14.86 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '149 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '16.5 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '16.5 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0298246 left noenhanced front tc rgb '#202020'
set label '-0.3284 MPa' at screen 0.893548,0.0298246 right noenhanced front tc rgb '#202020'
set label '7.0 %' at screen 0.983871,0.0298246 right noenhanced front tc rgb '#202020'
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
set xrange [-2.875235070e+01:2.809562912e+01]
set yrange [-3.562500000e+02:3.562500000e+02]
set xtics 2.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.789214556e+01 -3.000000000e+02
1.561458244e+01 -2.625000000e+02
1.333701936e+01 -2.250000000e+02
1.105945633e+01 -1.875000000e+02
8.781893396e+00 -1.500000000e+02
6.504330650e+00 -1.125000000e+02
4.226768395e+00 -7.500000000e+01
1.949208285e+00 -3.750000000e+01
-1.791161585e-01 0.000000000e+00
1.986312192e+00 3.750000000e+01
4.241939056e+00 7.500000000e+01
6.497566205e+00 1.125000000e+02
8.753193422e+00 1.500000000e+02
1.100882067e+01 1.875000000e+02
1.326444792e+01 2.250000000e+02
1.552007519e+01 2.625000000e+02
1.777570246e+01 3.000000000e+02
-1.854886714e+01 3.000000000e+02
-1.627130402e+01 2.625000000e+02
-1.399374093e+01 2.250000000e+02
-1.171617789e+01 1.875000000e+02
-9.438614926e+00 1.500000000e+02
-7.161052126e+00 1.125000000e+02
-4.883489717e+00 7.500000000e+01
-2.605928761e+00 3.750000000e+01
-3.284128155e-01 0.000000000e+00
-2.524943920e+00 -3.750000000e+01
-4.780570847e+00 -7.500000000e+01
-7.036198007e+00 -1.125000000e+02
-9.291825228e+00 -1.500000000e+02
-1.154745247e+01 -1.875000000e+02
-1.380307973e+01 -2.250000000e+02
-1.605870700e+01 -2.625000000e+02
-1.831433427e+01 -3.000000000e+02
1.789214556e+01 -3.000000000e+02
e
$high << e
1.789214556e+01 -3.000000000e+02
1.561458244e+01 -2.625000000e+02
1.333701936e+01 -2.250000000e+02
1.105945633e+01 -1.875000000e+02
8.781893396e+00 -1.500000000e+02
6.504330650e+00 -1.125000000e+02
4.226768395e+00 -7.500000000e+01
1.949208285e+00 -3.750000000e+01
-1.791161585e-01 0.000000000e+00
1.986312192e+00 3.750000000e+01
4.241939056e+00 7.500000000e+01
6.497566205e+00 1.125000000e+02
8.753193422e+00 1.500000000e+02
1.100882067e+01 1.875000000e+02
1.326444792e+01 2.250000000e+02
1.552007519e+01 2.625000000e+02
1.777570246e+01 3.000000000e+02
e
$low << e
-1.831433427e+01 -3.000000000e+02
-1.605870700e+01 -2.625000000e+02
-1.380307973e+01 -2.250000000e+02
-1.154745247e+01 -1.875000000e+02
-9.291825228e+00 -1.500000000e+02
-7.036198007e+00 -1.125000000e+02
-4.780570847e+00 -7.500000000e+01
-2.524943920e+00 -3.750000000e+01
-3.284128155e-01 0.000000000e+00
-2.605928761e+00 3.750000000e+01
-4.883489717e+00 7.500000000e+01
-7.161052126e+00 1.125000000e+02
-9.438614926e+00 1.500000000e+02
-1.171617789e+01 1.875000000e+02
-1.399374093e+01 2.250000000e+02
-1.627130402e+01 2.625000000e+02
-1.854886714e+01 3.000000000e+02
e
set arrow from screen 0.817881,0.245614 to screen 0.817881,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.854886714e+01 3.000000000e+02
e
set label '-18.55 (1)' at screen 0.669103,0.883333 left noenhanced front tc rgb '#c8500a'
set label '17.89' at screen 0.846543,0.281499 left noenhanced front tc rgb '#0b5fa5'
set label '-18.31' at screen 0.72987,0.281499 left noenhanced front tc rgb '#00785a'
set label '17.78' at screen 0.845921,0.876396 left noenhanced front tc rgb '#0b5fa5'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
