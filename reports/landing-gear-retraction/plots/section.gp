# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.1645 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,588 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 1.1- m at t = 0.1000 s, landing' at screen 0.0193548,0.972789 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.319728 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.319728 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.319728 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.289116 right noenhanced front tc rgb '#c8500a'
set label 'corner -y -z' at screen 0.0612903,0.289116 left noenhanced front tc rgb '#c8500a'
set label '-184.1 MPa' at screen 0.403226,0.289116 right noenhanced front tc rgb '#c8500a'
set label '85.1 %' at screen 0.493548,0.289116 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.260204 right noenhanced front tc rgb '#202020'
set label 'bottom flange' at screen 0.0612903,0.260204 left noenhanced front tc rgb '#202020'
set label '-176.0 MPa' at screen 0.403226,0.260204 right noenhanced front tc rgb '#202020'
set label '81.5 %' at screen 0.493548,0.260204 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.231293 right noenhanced front tc rgb '#202020'
set label 'corner +y +z' at screen 0.0612903,0.231293 left noenhanced front tc rgb '#202020'
set label '159.4 MPa' at screen 0.403226,0.231293 right noenhanced front tc rgb '#202020'
set label '73.6 %' at screen 0.493548,0.231293 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.202381 right noenhanced front tc rgb '#202020'
set label 'web end -y -z' at screen 0.0612903,0.202381 left noenhanced front tc rgb '#202020'
set label '-157.9 MPa' at screen 0.403226,0.202381 right noenhanced front tc rgb '#202020'
set label '73.3 %' at screen 0.493548,0.202381 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.0483871,0.173469 right noenhanced front tc rgb '#202020'
set label 'right web' at screen 0.0612903,0.173469 left noenhanced front tc rgb '#202020'
set label '-157.9 MPa' at screen 0.403226,0.173469 right noenhanced front tc rgb '#202020'
set label '73.3 %' at screen 0.493548,0.173469 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.0483871,0.144558 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.144558 left noenhanced front tc rgb '#202020'
set label '151.3 MPa' at screen 0.403226,0.144558 right noenhanced front tc rgb '#202020'
set label '69.9 %' at screen 0.493548,0.144558 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.0483871,0.115646 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.115646 left noenhanced front tc rgb '#202020'
set label '-143.7 MPa' at screen 0.403226,0.115646 right noenhanced front tc rgb '#202020'
set label '66.8 %' at screen 0.493548,0.115646 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.0483871,0.0867347 right noenhanced front tc rgb '#202020'
set label 'web end +y +z' at screen 0.0612903,0.0867347 left noenhanced front tc rgb '#202020'
set label '133.1 MPa' at screen 0.403226,0.0867347 right noenhanced front tc rgb '#202020'
set label '61.4 %' at screen 0.493548,0.0867347 right noenhanced front tc rgb '#202020'
set label '9' at screen 0.0483871,0.0578231 right noenhanced front tc rgb '#202020'
set label 'left web' at screen 0.0612903,0.0578231 left noenhanced front tc rgb '#202020'
set label '133.1 MPa' at screen 0.403226,0.0578231 right noenhanced front tc rgb '#202020'
set label '61.4 %' at screen 0.493548,0.0578231 right noenhanced front tc rgb '#202020'
set label '10' at screen 0.0483871,0.0289116 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0289116 left noenhanced front tc rgb '#202020'
set label '119.0 MPa' at screen 0.403226,0.0289116 right noenhanced front tc rgb '#202020'
set label '55.2 %' at screen 0.493548,0.0289116 right noenhanced front tc rgb '#202020'
set label '11' at screen 0.53871,0.289116 right noenhanced front tc rgb '#202020'
set label 'corner +y -z' at screen 0.551613,0.289116 left noenhanced front tc rgb '#202020'
set label '-103.3 MPa' at screen 0.893548,0.289116 right noenhanced front tc rgb '#202020'
set label '48.3 %' at screen 0.983871,0.289116 right noenhanced front tc rgb '#202020'
set label '12' at screen 0.53871,0.260204 right noenhanced front tc rgb '#202020'
set label 'web end +y -z' at screen 0.551613,0.260204 left noenhanced front tc rgb '#202020'
set label '-77.01 MPa' at screen 0.893548,0.260204 right noenhanced front tc rgb '#202020'
set label '38.7 %' at screen 0.983871,0.260204 right noenhanced front tc rgb '#202020'
set label '13' at screen 0.53871,0.231293 right noenhanced front tc rgb '#202020'
set label 'corner -y +z' at screen 0.551613,0.231293 left noenhanced front tc rgb '#202020'
set label '78.56 MPa' at screen 0.893548,0.231293 right noenhanced front tc rgb '#202020'
set label '36.9 %' at screen 0.983871,0.231293 right noenhanced front tc rgb '#202020'
set label '14' at screen 0.53871,0.202381 right noenhanced front tc rgb '#202020'
set label 'fibre -y' at screen 0.551613,0.202381 left noenhanced front tc rgb '#202020'
set label '-52.78 MPa' at screen 0.893548,0.202381 right noenhanced front tc rgb '#202020'
set label '36.2 %' at screen 0.983871,0.202381 right noenhanced front tc rgb '#202020'
set label '15' at screen 0.53871,0.173469 right noenhanced front tc rgb '#202020'
set label 'web end -y +z' at screen 0.551613,0.173469 left noenhanced front tc rgb '#202020'
set label '52.29 MPa' at screen 0.893548,0.173469 right noenhanced front tc rgb '#202020'
set label '32.8 %' at screen 0.983871,0.173469 right noenhanced front tc rgb '#202020'
set label '16' at screen 0.53871,0.144558 right noenhanced front tc rgb '#202020'
set label 'seam -y -z throat' at screen 0.551613,0.144558 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.144558 right noenhanced front tc rgb '#202020'
set label '27.1 %' at screen 0.983871,0.144558 right noenhanced front tc rgb '#202020'
set label '17' at screen 0.53871,0.115646 right noenhanced front tc rgb '#202020'
set label 'seam -y +z throat' at screen 0.551613,0.115646 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.115646 right noenhanced front tc rgb '#202020'
set label '20.6 %' at screen 0.983871,0.115646 right noenhanced front tc rgb '#202020'
set label '18' at screen 0.53871,0.0867347 right noenhanced front tc rgb '#202020'
set label 'fibre +y' at screen 0.551613,0.0867347 left noenhanced front tc rgb '#202020'
set label '28.07 MPa' at screen 0.893548,0.0867347 right noenhanced front tc rgb '#202020'
set label '20.6 %' at screen 0.983871,0.0867347 right noenhanced front tc rgb '#202020'
set label '19' at screen 0.53871,0.0578231 right noenhanced front tc rgb '#202020'
set label 'seam +y -z throat' at screen 0.551613,0.0578231 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0578231 right noenhanced front tc rgb '#202020'
set label '17.4 %' at screen 0.983871,0.0578231 right noenhanced front tc rgb '#202020'
set label '20' at screen 0.53871,0.0289116 right noenhanced front tc rgb '#202020'
set label 'seam +y +z throat' at screen 0.551613,0.0289116 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0289116 right noenhanced front tc rgb '#202020'
set label '11.2 %' at screen 0.983871,0.0289116 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 4.115646259e-01
set tmargin at screen 9.149659864e-01
set xrange [6.271186441e+01:-6.271186441e+01]
set yrange [-6.271186441e+01:6.271186441e+01]
set xtics 5.000000000e+01
set ytics 1.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.940476 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.353741 center noenhanced front tc rgb '#202020'
$loop0 << e
-5.000000000e+01 -5.000000000e+01
5.000000000e+01 -5.000000000e+01
5.000000000e+01 5.000000000e+01
-5.000000000e+01 5.000000000e+01
-5.000000000e+01 -5.000000000e+01
e
$loop1 << e
-4.000000000e+01 4.000000000e+01
4.000000000e+01 4.000000000e+01
4.000000000e+01 -4.000000000e+01
-4.000000000e+01 -4.000000000e+01
-4.000000000e+01 4.000000000e+01
e
$welds << e
5.000000000e+01 4.000000000e+01
5.000000000e+01 -4.000000000e+01
-5.000000000e+01 4.000000000e+01
-5.000000000e+01 -4.000000000e+01
e
$places << e
-4.000000000e+01 -5.000000000e+01
5.000000000e+01 5.000000000e+01
-5.000000000e+01 -4.000000000e+01
4.000000000e+01 5.000000000e+01
0.000000000e+00 -5.000000000e+01
5.000000000e+01 4.000000000e+01
0.000000000e+00 5.000000000e+01
5.000000000e+01 -5.000000000e+01
5.000000000e+01 -4.000000000e+01
-5.000000000e+01 5.000000000e+01
-5.000000000e+01 0.000000000e+00
-5.000000000e+01 4.000000000e+01
5.000000000e+01 0.000000000e+00
e
$governing << e
-5.000000000e+01 -5.000000000e+01
e
set label '1' at screen 0.530645,0.480022 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.492581,0.480022 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.15,0.881383 left noenhanced front tc rgb '#0b5fa5'
set label '4, 5, 16' at screen 0.389613,0.549019 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.469355,0.536264 to screen 0.519355,0.502721 nohead lw 0.6 lc rgb '#0b5fa5'
set label '6' at screen 0.188065,0.881383 left noenhanced front tc rgb '#0b5fa5'
set label '7' at screen 0.340323,0.480022 left noenhanced front tc rgb '#0b5fa5'
set label '8, 9, 20' at screen 0.15,0.841247 left noenhanced front tc rgb '#0b5fa5'
set label '10' at screen 0.340323,0.881383 left noenhanced front tc rgb '#0b5fa5'
set label '11' at screen 0.15,0.480022 left noenhanced front tc rgb '#0b5fa5'
set label '12, 19' at screen 0.18871,0.549019 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.18871,0.536264 to screen 0.13871,0.502721 nohead lw 0.6 lc rgb '#0b5fa5'
set label '13' at screen 0.530645,0.881383 left noenhanced front tc rgb '#0b5fa5'
set label '14' at screen 0.530645,0.680702 left noenhanced front tc rgb '#0b5fa5'
set label '15, 17' at screen 0.443419,0.841247 left noenhanced front tc rgb '#0b5fa5'
set label '18' at screen 0.15,0.680702 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 4.115646259e-01
set tmargin at screen 9.149659864e-01
set xrange [-2.803150107e+02:2.556020703e+02]
set yrange [-6.271186441e+01:6.271186441e+01]
set xtics 2.000000000e+02
set ytics 1.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.940476 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.353741 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
2.899822298e+00 -5.000000000e+01
2.598038433e+00 -4.375000000e+01
2.296254595e+00 -3.750000000e+01
1.994470796e+00 -3.125000000e+01
1.692687062e+00 -2.500000000e+01
1.390903443e+00 -1.875000000e+01
1.089120064e+00 -1.250000000e+01
1.165078136e+01 -6.250000000e+00
2.806867510e+01 0.000000000e+00
4.448656883e+01 6.250000000e+00
6.090446257e+01 1.250000000e+01
7.732235630e+01 1.875000000e+01
9.374025004e+01 2.500000000e+01
1.101581438e+02 3.125000000e+01
1.265760375e+02 3.750000000e+01
1.429939312e+02 4.375000000e+01
1.594118250e+02 5.000000000e+01
-2.458695761e+00 5.000000000e+01
-2.156912994e+00 4.375000000e+01
-1.855130691e+00 3.750000000e+01
-1.553349192e+00 3.125000000e+01
-1.251569274e+00 2.500000000e+01
-3.527934290e+00 1.875000000e+01
-1.994582803e+01 1.250000000e+01
-3.636372176e+01 6.250000000e+00
-5.278161550e+01 0.000000000e+00
-6.919950923e+01 -6.250000000e+00
-8.561740297e+01 -1.250000000e+01
-1.020352967e+02 -1.875000000e+01
-1.184531904e+02 -2.500000000e+01
-1.348710842e+02 -3.125000000e+01
-1.512889779e+02 -3.750000000e+01
-1.677068716e+02 -4.375000000e+01
-1.841247654e+02 -5.000000000e+01
2.899822298e+00 -5.000000000e+01
e
$high << e
2.899822298e+00 -5.000000000e+01
2.598038433e+00 -4.375000000e+01
2.296254595e+00 -3.750000000e+01
1.994470796e+00 -3.125000000e+01
1.692687062e+00 -2.500000000e+01
1.390903443e+00 -1.875000000e+01
1.089120064e+00 -1.250000000e+01
1.165078136e+01 -6.250000000e+00
2.806867510e+01 0.000000000e+00
4.448656883e+01 6.250000000e+00
6.090446257e+01 1.250000000e+01
7.732235630e+01 1.875000000e+01
9.374025004e+01 2.500000000e+01
1.101581438e+02 3.125000000e+01
1.265760375e+02 3.750000000e+01
1.429939312e+02 4.375000000e+01
1.594118250e+02 5.000000000e+01
e
$low << e
-1.841247654e+02 -5.000000000e+01
-1.677068716e+02 -4.375000000e+01
-1.512889779e+02 -3.750000000e+01
-1.348710842e+02 -3.125000000e+01
-1.184531904e+02 -2.500000000e+01
-1.020352967e+02 -1.875000000e+01
-8.561740297e+01 -1.250000000e+01
-6.919950923e+01 -6.250000000e+00
-5.278161550e+01 0.000000000e+00
-3.636372176e+01 6.250000000e+00
-1.994582803e+01 1.250000000e+01
-3.527934290e+00 1.875000000e+01
-1.251569274e+00 2.500000000e+01
-1.553349192e+00 3.125000000e+01
-1.855130691e+00 3.750000000e+01
-2.156912994e+00 4.375000000e+01
-2.458695761e+00 5.000000000e+01
e
set arrow from screen 0.82312,0.411565 to screen 0.82312,0.914966 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.841247654e+02 -5.000000000e+01
e
set label '-184.1 (1)' at screen 0.669103,0.439626 left noenhanced front tc rgb '#c8500a'
set label '2.900' at screen 0.834439,0.478819 left noenhanced front tc rgb '#0b5fa5'
set label '159.4' at screen 0.846543,0.88018 left noenhanced front tc rgb '#0b5fa5'
set label '-2.459' at screen 0.747407,0.88018 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
