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
set label 's = 1.5+ m at t = 1.0322 s, start' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'bottom flange' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-56.11 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '23.7 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '-56.11 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '23.7 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '-52.54 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '22.2 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '51.16 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '21.8 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '47.59 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '20.3 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label '-2.476 MPa' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '2.3 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '1.8 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0298246 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0298246 right noenhanced front tc rgb '#202020'
set label '1.8 %' at screen 0.983871,0.0298246 right noenhanced front tc rgb '#202020'
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
0.000000000e+00 -1.500000000e+02
1.050000000e+02 -1.400000000e+02
0.000000000e+00 1.500000000e+02
1.050000000e+02 1.400000000e+02
1.050000000e+02 0.000000000e+00
e
$governing << e
1.000000000e+02 -1.500000000e+02
e
set label '1' at screen 0.16828,0.280258 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.280258 left noenhanced front tc rgb '#0b5fa5'
set label '3, 8' at screen 0.159677,0.334947 left noenhanced front tc rgb '#0b5fa5'
set label '4' at screen 0.340323,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '5, 7' at screen 0.0972258,0.858923 left noenhanced front tc rgb '#0b5fa5'
set label '6' at screen 0.159677,0.596935 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-8.624569357e+01:8.163048266e+01]
set yrange [-1.781250000e+02:1.781250000e+02]
set xtics 1.000000000e+02
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
-4.557865891e+01 -1.500000000e+02
-3.999601077e+01 -1.312500000e+02
-3.441318346e+01 -1.125000000e+02
-2.883012691e+01 -9.375000000e+01
-2.324677995e+01 -7.500000000e+01
-1.766307129e+01 -5.625000000e+01
-1.207892083e+01 -3.750000000e+01
-6.494235789e+00 -1.875000000e+01
-8.137009115e-01 0.000000000e+00
5.475571863e+00 1.875000000e+01
1.178352800e+01 3.750000000e+01
1.822062351e+01 5.625000000e+01
2.471651073e+01 7.500000000e+01
3.139450152e+01 9.375000000e+01
3.809338830e+01 1.125000000e+02
4.479530572e+01 1.312500000e+02
5.149886128e+01 1.500000000e+02
4.324189845e+01 1.500000000e+02
3.763802383e+01 1.312500000e+02
3.203278560e+01 1.125000000e+02
2.642539669e+01 9.375000000e+01
2.081180971e+01 7.500000000e+01
1.516739748e+01 5.625000000e+01
9.403383665e+00 3.750000000e+01
3.404319330e+00 1.875000000e+01
-2.600697014e+00 0.000000000e+00
-9.202936842e+00 -1.875000000e+01
-1.589967805e+01 -3.750000000e+01
-2.259881453e+01 -5.625000000e+01
-2.929977759e+01 -7.500000000e+01
-3.600211034e+01 -9.375000000e+01
-4.270544278e+01 -1.125000000e+02
-4.940949621e+01 -1.312500000e+02
-5.611407220e+01 -1.500000000e+02
-4.557865891e+01 -1.500000000e+02
e
$high << e
-4.557865891e+01 -1.500000000e+02
-3.999601077e+01 -1.312500000e+02
-3.441318346e+01 -1.125000000e+02
-2.883012691e+01 -9.375000000e+01
-2.324677995e+01 -7.500000000e+01
-1.766307129e+01 -5.625000000e+01
-1.207892083e+01 -3.750000000e+01
-6.494235789e+00 -1.875000000e+01
-8.137009115e-01 0.000000000e+00
5.475571863e+00 1.875000000e+01
1.178352800e+01 3.750000000e+01
1.822062351e+01 5.625000000e+01
2.471651073e+01 7.500000000e+01
3.139450152e+01 9.375000000e+01
3.809338830e+01 1.125000000e+02
4.479530572e+01 1.312500000e+02
5.149886128e+01 1.500000000e+02
e
$low << e
-5.611407220e+01 -1.500000000e+02
-4.940949621e+01 -1.312500000e+02
-4.270544278e+01 -1.125000000e+02
-3.600211034e+01 -9.375000000e+01
-2.929977759e+01 -7.500000000e+01
-2.259881453e+01 -5.625000000e+01
-1.589967805e+01 -3.750000000e+01
-9.202936842e+00 -1.875000000e+01
-2.600697014e+00 0.000000000e+00
3.404319330e+00 1.875000000e+01
9.403383665e+00 3.750000000e+01
1.516739748e+01 5.625000000e+01
2.081180971e+01 7.500000000e+01
2.642539669e+01 9.375000000e+01
3.203278560e+01 1.125000000e+02
3.763802383e+01 1.312500000e+02
4.324189845e+01 1.500000000e+02
e
set arrow from screen 0.820297,0.245614 to screen 0.820297,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-5.611406186e+01 -1.500000000e+02
e
set label '-56.11 (1)' at screen 0.669103,0.274561 left noenhanced front tc rgb '#c8500a'
set label '-45.58' at screen 0.747648,0.314993 left noenhanced front tc rgb '#0b5fa5'
set label '51.50' at screen 0.846543,0.876396 left noenhanced front tc rgb '#0b5fa5'
set label '43.24' at screen 0.90808,0.876396 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
