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
set label 's = 1.5+ m at t = 0.0300 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'fibre -z' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-52.67 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '22.3 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '-49.30 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '20.8 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '48.34 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '20.4 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '44.97 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '19.0 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '-2.168 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '2.2 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '1.7 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '1.7 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [1.387500000e+02:-1.387500000e+02]
set yrange [-1.781250000e+02:1.781250000e+02]
set xtics 1.000000000e+02
set ytics 2.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.938596 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.185965 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.100000000e+02 -1.500000000e+02
1.100000000e+02 -1.500000000e+02
1.100000000e+02 1.500000000e+02
-1.100000000e+02 1.500000000e+02
-1.100000000e+02 -1.500000000e+02
e
$loop1 << e
-1.000000000e+02 1.400000000e+02
1.000000000e+02 1.400000000e+02
1.000000000e+02 -1.400000000e+02
-1.000000000e+02 -1.400000000e+02
-1.000000000e+02 1.400000000e+02
e
$welds << e
1.100000000e+02 1.400000000e+02
1.100000000e+02 -1.400000000e+02
-1.100000000e+02 1.400000000e+02
-1.100000000e+02 -1.400000000e+02
e
$places << e
1.050000000e+02 -1.400000000e+02
0.000000000e+00 1.500000000e+02
1.050000000e+02 1.400000000e+02
1.050000000e+02 0.000000000e+00
e
$governing << e
0.000000000e+00 -1.500000000e+02
e
set label '1' at screen 0.340323,0.280258 left noenhanced front tc rgb '#c8500a'
set label '2, 7' at screen 0.159677,0.334947 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '4, 6' at screen 0.0972258,0.858923 left noenhanced front tc rgb '#0b5fa5'
set label '5' at screen 0.159677,0.596935 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-8.095389616e+01:7.661789625e+01]
set yrange [-1.781250000e+02:1.781250000e+02]
set xtics 1.000000000e+02
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
-4.893679197e+01 -1.500000000e+02
-4.297278268e+01 -1.312500000e+02
-3.700877340e+01 -1.125000000e+02
-3.104476411e+01 -9.375000000e+01
-2.508075482e+01 -7.500000000e+01
-1.911674554e+01 -5.625000000e+01
-1.315273625e+01 -3.750000000e+01
-7.188726963e+00 -1.875000000e+01
-1.224717677e+00 0.000000000e+00
4.739291610e+00 1.875000000e+01
1.070330090e+01 3.750000000e+01
1.677091740e+01 5.625000000e+01
2.308388985e+01 7.500000000e+01
2.939686230e+01 9.375000000e+01
3.570983476e+01 1.125000000e+02
4.202280721e+01 1.312500000e+02
4.833577966e+01 1.500000000e+02
4.648735662e+01 1.500000000e+02
4.052334733e+01 1.312500000e+02
3.455933804e+01 1.125000000e+02
2.859532876e+01 9.375000000e+01
2.263131947e+01 7.500000000e+01
1.666731018e+01 5.625000000e+01
1.045794495e+01 3.750000000e+01
4.144972497e+00 1.875000000e+01
-2.167999955e+00 0.000000000e+00
-8.480972407e+00 -1.875000000e+01
-1.479394486e+01 -3.750000000e+01
-2.110691731e+01 -5.625000000e+01
-2.741988976e+01 -7.500000000e+01
-3.373286222e+01 -9.375000000e+01
-4.004583467e+01 -1.125000000e+02
-4.635880712e+01 -1.312500000e+02
-5.267177957e+01 -1.500000000e+02
-4.893679197e+01 -1.500000000e+02
e
$high << e
-4.893679197e+01 -1.500000000e+02
-4.297278268e+01 -1.312500000e+02
-3.700877340e+01 -1.125000000e+02
-3.104476411e+01 -9.375000000e+01
-2.508075482e+01 -7.500000000e+01
-1.911674554e+01 -5.625000000e+01
-1.315273625e+01 -3.750000000e+01
-7.188726963e+00 -1.875000000e+01
-1.224717677e+00 0.000000000e+00
4.739291610e+00 1.875000000e+01
1.070330090e+01 3.750000000e+01
1.677091740e+01 5.625000000e+01
2.308388985e+01 7.500000000e+01
2.939686230e+01 9.375000000e+01
3.570983476e+01 1.125000000e+02
4.202280721e+01 1.312500000e+02
4.833577966e+01 1.500000000e+02
e
$low << e
-5.267177957e+01 -1.500000000e+02
-4.635880712e+01 -1.312500000e+02
-4.004583467e+01 -1.125000000e+02
-3.373286222e+01 -9.375000000e+01
-2.741988976e+01 -7.500000000e+01
-2.110691731e+01 -5.625000000e+01
-1.479394486e+01 -3.750000000e+01
-8.480972407e+00 -1.875000000e+01
-2.167999955e+00 0.000000000e+00
4.144972497e+00 1.875000000e+01
1.045794495e+01 3.750000000e+01
1.666731018e+01 5.625000000e+01
2.263131947e+01 7.500000000e+01
2.859532876e+01 9.375000000e+01
3.455933804e+01 1.125000000e+02
4.052334733e+01 1.312500000e+02
4.648735662e+01 1.500000000e+02
e
set arrow from screen 0.820301,0.245614 to screen 0.820301,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-5.267177957e+01 -1.500000000e+02
e
set label '-52.67 (1)' at screen 0.669103,0.274561 left noenhanced front tc rgb '#c8500a'
set label '-48.94' at screen 0.735806,0.314993 left noenhanced front tc rgb '#0b5fa5'
set label '48.34' at screen 0.846543,0.876396 left noenhanced front tc rgb '#0b5fa5'
set label '46.49' at screen 0.908241,0.883333 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
