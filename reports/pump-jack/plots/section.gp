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
set label 's = 2.5- m at t = 4.8605 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'top flange' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '37.64 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '119 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '37.64 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '119 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '35.30 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '112 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '-37.03 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '110 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '-34.70 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '102 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label '0.3003 MPa' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '8.5 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '6.3 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0298246 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0298246 right noenhanced front tc rgb '#202020'
set label '6.3 %' at screen 0.983871,0.0298246 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [3.700000000e+02:-3.700000000e+02]
set yrange [-4.750000000e+02:4.750000000e+02]
set xtics 2.000000000e+02
set ytics 1.000000000e+02
set label 'z [mm], seen along the beam' at screen 0.0193548,0.938596 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.185965 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.500000000e+02 -4.000000000e+02
1.500000000e+02 -4.000000000e+02
1.500000000e+02 4.000000000e+02
-1.500000000e+02 4.000000000e+02
-1.500000000e+02 -4.000000000e+02
e
$loop1 << e
-1.360000000e+02 3.750000000e+02
1.360000000e+02 3.750000000e+02
1.360000000e+02 -3.750000000e+02
-1.360000000e+02 -3.750000000e+02
-1.360000000e+02 3.750000000e+02
e
$welds << e
1.500000000e+02 3.750000000e+02
1.500000000e+02 -3.750000000e+02
-1.500000000e+02 3.750000000e+02
-1.500000000e+02 -3.750000000e+02
e
$places << e
0.000000000e+00 4.000000000e+02
1.430000000e+02 3.750000000e+02
0.000000000e+00 -4.000000000e+02
1.430000000e+02 -3.750000000e+02
1.430000000e+02 0.000000000e+00
e
$governing << e
1.360000000e+02 4.000000000e+02
e
set label '1' at screen 0.252581,0.877637 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '3, 7' at screen 0.185613,0.860093 left noenhanced front tc rgb '#0b5fa5'
set label '4' at screen 0.340323,0.280258 left noenhanced front tc rgb '#0b5fa5'
set label '5, 8' at screen 0.248065,0.333777 left noenhanced front tc rgb '#0b5fa5'
set label '6' at screen 0.248065,0.596935 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-5.818174380e+01:5.859540110e+01]
set yrange [-4.750000000e+02:4.750000000e+02]
set xtics 5.000000000e+01
set ytics 1.000000000e+02
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
-1.768694661e+01 -4.000000000e+02
-1.555417799e+01 -3.500000000e+02
-1.342137981e+01 -3.000000000e+02
-1.128853427e+01 -2.500000000e+02
-9.155605614e+00 -2.000000000e+02
-7.022509947e+00 -1.500000000e+02
-4.888992547e+00 -1.000000000e+02
-2.292015652e+00 -5.000000000e+01
1.657809530e+00 0.000000000e+00
5.845130321e+00 5.000000000e+01
1.004231106e+01 1.000000000e+02
1.435746457e+01 1.500000000e+02
1.899407606e+01 2.000000000e+02
2.364633070e+01 2.500000000e+02
2.830587209e+01 3.000000000e+02
3.296941688e+01 3.500000000e+02
3.763540073e+01 4.000000000e+02
1.643470548e+01 4.000000000e+02
1.430193752e+01 3.500000000e+02
1.216914036e+01 3.000000000e+02
1.003629651e+01 2.500000000e+02
7.903370976e+00 2.000000000e+02
5.770282140e+00 1.500000000e+02
3.636784827e+00 1.000000000e+02
1.501641314e+00 5.000000000e+01
-7.451779264e-01 0.000000000e+00
-4.749572870e+00 -5.000000000e+01
-9.299269278e+00 -1.000000000e+02
-1.392370580e+01 -1.500000000e+02
-1.857082647e+01 -2.000000000e+02
-2.322774379e+01 -2.500000000e+02
-2.788977194e+01 -3.000000000e+02
-3.255480154e+01 -3.500000000e+02
-3.722174344e+01 -4.000000000e+02
-1.768694661e+01 -4.000000000e+02
e
$high << e
-1.768694661e+01 -4.000000000e+02
-1.555417799e+01 -3.500000000e+02
-1.342137981e+01 -3.000000000e+02
-1.128853427e+01 -2.500000000e+02
-9.155605614e+00 -2.000000000e+02
-7.022509947e+00 -1.500000000e+02
-4.888992547e+00 -1.000000000e+02
-2.292015652e+00 -5.000000000e+01
1.657809530e+00 0.000000000e+00
5.845130321e+00 5.000000000e+01
1.004231106e+01 1.000000000e+02
1.435746457e+01 1.500000000e+02
1.899407606e+01 2.000000000e+02
2.364633070e+01 2.500000000e+02
2.830587209e+01 3.000000000e+02
3.296941688e+01 3.500000000e+02
3.763540073e+01 4.000000000e+02
e
$low << e
-3.722174344e+01 -4.000000000e+02
-3.255480154e+01 -3.500000000e+02
-2.788977194e+01 -3.000000000e+02
-2.322774379e+01 -2.500000000e+02
-1.857082647e+01 -2.000000000e+02
-1.392370580e+01 -1.500000000e+02
-9.299269278e+00 -1.000000000e+02
-4.749572870e+00 -5.000000000e+01
-7.451779264e-01 0.000000000e+00
1.501641314e+00 5.000000000e+01
3.636784827e+00 1.000000000e+02
5.770282140e+00 1.500000000e+02
7.903370976e+00 2.000000000e+02
1.003629651e+01 2.500000000e+02
1.216914036e+01 3.000000000e+02
1.430193752e+01 3.500000000e+02
1.643470548e+01 4.000000000e+02
e
set arrow from screen 0.815592,0.245614 to screen 0.815592,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
3.763540073e+01 4.000000000e+02
e
set label '37.64 (1)' at screen 0.867252,0.883333 left noenhanced front tc rgb '#c8500a'
set label '-17.69' at screen 0.695343,0.281499 left noenhanced front tc rgb '#0b5fa5'
set label '-37.22' at screen 0.686619,0.32193 left noenhanced front tc rgb '#00785a'
set label '16.43' at screen 0.906654,0.813129 left noenhanced front tc rgb '#00785a'
set arrow from screen 0.906654,0.826287 to screen 0.858267,0.859649 nohead lw 0.6 lc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
