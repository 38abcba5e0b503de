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
set label 's = 3.9 m at t = 4.7902 s' at screen 0.0193548,0.97193 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.150877 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.150877 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.150877 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.119298 right noenhanced front tc rgb '#c8500a'
set label 'fibre -z' at screen 0.0612903,0.119298 left noenhanced front tc rgb '#c8500a'
set label '-32.09 MPa' at screen 0.403226,0.119298 right noenhanced front tc rgb '#c8500a'
set label '89.6 %' at screen 0.493548,0.119298 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0894737 left noenhanced front tc rgb '#202020'
set label '32.23 MPa' at screen 0.403226,0.0894737 right noenhanced front tc rgb '#202020'
set label '89.6 %' at screen 0.493548,0.0894737 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0596491 left noenhanced front tc rgb '#202020'
set label '-29.41 MPa' at screen 0.403226,0.0596491 right noenhanced front tc rgb '#202020'
set label '82.1 %' at screen 0.493548,0.0596491 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0298246 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0298246 left noenhanced front tc rgb '#202020'
set label '29.55 MPa' at screen 0.403226,0.0298246 right noenhanced front tc rgb '#202020'
set label '82.1 %' at screen 0.493548,0.0298246 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.119298 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.119298 left noenhanced front tc rgb '#202020'
set label '0.07103 MPa' at screen 0.893548,0.119298 right noenhanced front tc rgb '#202020'
set label '3.0 %' at screen 0.983871,0.119298 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.0894737 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0894737 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0894737 right noenhanced front tc rgb '#202020'
set label '0.8 %' at screen 0.983871,0.0894737 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0596491 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0596491 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0596491 right noenhanced front tc rgb '#202020'
set label '0.8 %' at screen 0.983871,0.0596491 right noenhanced front tc rgb '#202020'
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
-1.500000000e+02 -3.000000000e+02
1.500000000e+02 -3.000000000e+02
1.500000000e+02 3.000000000e+02
-1.500000000e+02 3.000000000e+02
-1.500000000e+02 -3.000000000e+02
e
$loop1 << e
-1.360000000e+02 2.750000000e+02
1.360000000e+02 2.750000000e+02
1.360000000e+02 -2.750000000e+02
-1.360000000e+02 -2.750000000e+02
-1.360000000e+02 2.750000000e+02
e
$welds << e
1.500000000e+02 2.750000000e+02
1.500000000e+02 -2.750000000e+02
-1.500000000e+02 2.750000000e+02
-1.500000000e+02 -2.750000000e+02
e
$places << e
0.000000000e+00 3.000000000e+02
1.430000000e+02 -2.750000000e+02
1.430000000e+02 2.750000000e+02
1.430000000e+02 0.000000000e+00
e
$governing << e
0.000000000e+00 -3.000000000e+02
e
set label '1' at screen 0.340323,0.280258 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.877637 left noenhanced front tc rgb '#0b5fa5'
set label '3, 6' at screen 0.217312,0.339625 left noenhanced front tc rgb '#0b5fa5'
set label '4, 7' at screen 0.15486,0.854245 left noenhanced front tc rgb '#0b5fa5'
set label '5' at screen 0.217312,0.596935 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.456140351e-01
set tmargin at screen 9.122807018e-01
set xrange [-5.009423055e+01:5.023718480e+01]
set yrange [-3.562500000e+02:3.562500000e+02]
set xtics 5.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.938596 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.185965 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
-1.419507647e+01 -3.000000000e+02
-1.241137041e+01 -2.625000000e+02
-1.062765233e+01 -2.250000000e+02
-8.843915090e+00 -1.875000000e+02
-7.060144556e+00 -1.500000000e+02
-5.276308120e+00 -1.125000000e+02
-3.492309943e+00 -7.500000000e+01
-1.707692987e+00 -3.750000000e+01
1.186175109e-01 0.000000000e+00
4.092840669e+00 3.750000000e+01
8.111670815e+00 7.500000000e+01
1.213104523e+01 1.125000000e+02
1.615056072e+01 1.500000000e+02
2.017013349e+01 1.875000000e+02
2.418973514e+01 2.250000000e+02
2.820935339e+01 2.625000000e+02
3.222898204e+01 3.000000000e+02
1.434311734e+01 3.000000000e+02
1.255940999e+01 2.625000000e+02
1.077568991e+01 2.250000000e+02
8.991949373e+00 1.875000000e+02
7.208172755e+00 1.500000000e+02
5.424323165e+00 1.125000000e+02
3.640287328e+00 7.500000000e+01
1.855465007e+00 3.750000000e+01
-1.202778203e-01 0.000000000e+00
-3.950072724e+00 -3.750000000e+01
-7.968760641e+00 -7.500000000e+01
-1.198810891e+01 -1.125000000e+02
-1.600761527e+01 -1.500000000e+02
-2.002718381e+01 -1.875000000e+02
-2.404678317e+01 -2.250000000e+02
-2.806640003e+01 -2.625000000e+02
-3.208602779e+01 -3.000000000e+02
-1.419507647e+01 -3.000000000e+02
e
$high << e
-1.419507647e+01 -3.000000000e+02
-1.241137041e+01 -2.625000000e+02
-1.062765233e+01 -2.250000000e+02
-8.843915090e+00 -1.875000000e+02
-7.060144556e+00 -1.500000000e+02
-5.276308120e+00 -1.125000000e+02
-3.492309943e+00 -7.500000000e+01
-1.707692987e+00 -3.750000000e+01
1.186175109e-01 0.000000000e+00
4.092840669e+00 3.750000000e+01
8.111670815e+00 7.500000000e+01
1.213104523e+01 1.125000000e+02
1.615056072e+01 1.500000000e+02
2.017013349e+01 1.875000000e+02
2.418973514e+01 2.250000000e+02
2.820935339e+01 2.625000000e+02
3.222898204e+01 3.000000000e+02
e
$low << e
-3.208602779e+01 -3.000000000e+02
-2.806640003e+01 -2.625000000e+02
-2.404678317e+01 -2.250000000e+02
-2.002718381e+01 -1.875000000e+02
-1.600761527e+01 -1.500000000e+02
-1.198810891e+01 -1.125000000e+02
-7.968760641e+00 -7.500000000e+01
-3.950072724e+00 -3.750000000e+01
-1.202778203e-01 0.000000000e+00
1.855465007e+00 3.750000000e+01
3.640287328e+00 7.500000000e+01
5.424323165e+00 1.125000000e+02
7.208172755e+00 1.500000000e+02
8.991949373e+00 1.875000000e+02
1.077568991e+01 2.250000000e+02
1.255940999e+01 2.625000000e+02
1.434311734e+01 3.000000000e+02
e
set arrow from screen 0.815913,0.245614 to screen 0.815913,0.912281 nohead lw 0.9 lc rgb '#505050'
$point << e
-3.208602779e+01 -3.000000000e+02
e
set label '-32.09 (1)' at screen 0.669103,0.274561 left noenhanced front tc rgb '#c8500a'
set label '-14.20' at screen 0.821399,0.344765 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.821399,0.331607 to screen 0.773012,0.298246 nohead lw 0.6 lc rgb '#0b5fa5'
set label '32.23' at screen 0.846543,0.876396 left noenhanced front tc rgb '#0b5fa5'
set label '14.34' at screen 0.907648,0.813129 left noenhanced front tc rgb '#00785a'
set arrow from screen 0.907648,0.826287 to screen 0.859261,0.859649 nohead lw 0.6 lc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
