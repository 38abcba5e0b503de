# Redraw in the folder above: gnuplot plots/utilisation.gp; as PDF: gnuplot -e 'pdf = 1' plots/utilisation.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.1435 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'utilisation.pdf'
} else {
  set terminal svg size 620,586 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'utilisation.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set format x ''
$outline_z << e
0.000000000e+00 2.100000000e+02
2.500000000e-01 2.100000000e+02
2.500000000e-01 2.100000000e+02
1.350000000e+00 1.600000000e+02
1.350000000e+00 1.600000000e+02
1.600000000e+00 1.600000000e+02
1.600000000e+00 -1.600000000e+02
1.350000000e+00 -1.600000000e+02
1.350000000e+00 -1.600000000e+02
2.500000000e-01 -2.100000000e+02
2.500000000e-01 -2.100000000e+02
0.000000000e+00 -2.100000000e+02
0.000000000e+00 2.100000000e+02
e
$inner_outline_z << e
0.000000000e+00 1.700000000e+02 2.500000000e-01 0.000000000e+00
0.000000000e+00 -1.700000000e+02 2.500000000e-01 0.000000000e+00
2.500000000e-01 1.700000000e+02 1.100000000e+00 -5.000000000e+01
2.500000000e-01 -1.700000000e+02 1.100000000e+00 5.000000000e+01
1.350000000e+00 1.200000000e+02 2.500000000e-01 0.000000000e+00
1.350000000e+00 -1.200000000e+02 2.500000000e-01 0.000000000e+00
e
$supports_outline_z << e
0.000000000e+00 -2.814000000e+02
1.600000000e+00 -2.814000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-3.200000000e-02:1.632000000e+00]
set yrange [-3.570000000e+02:3.570000000e+02]
set xtics 2.000000000e-01
set ytics 5.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 2.000000000e+02
set object ellipse center 0.8,0 size 0.04,40 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 0.8,0 size 0.04,40 front fs empty border lc rgb '#303030'
set object ellipse center 0.8,-0 size 0.04,40 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 0.8,-0 size 0.04,40 front fs empty border lc rgb '#303030'
set arrow from screen 0.107196,0.912668 to screen 0.107196,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'A' at screen 0.110422,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.912668 to screen 0.950868,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'P' at screen 0.954094,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-3.200000000e-02:1.632000000e+00]
set yrange [0.000000000e+00:2.238842513e+02]
set xtics 2.000000000e-01
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 33.5 % at s = 0.8 m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 195 % at s = 0.8 m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 1.98 % at s = 0.8 m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 98.7 % at s = 1.35 m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 15.6 % at s = 0.8 m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 0.440 % at s = 0.8 m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 1.023189898e+01
2.500000000e-01 1.025169456e+01
6.989777918e-01 1.093990193e+01
8.000000000e-01 1.186181068e+01
1.350000000e+00 1.209220483e+01
1.600000000e+00 1.209838861e+01
e
$u0_1 << e
0.000000000e+00 1.023190710e+01
2.500000000e-01 1.024499603e+01
6.989777918e-01 1.092694705e+01
e
$u0_2 << e
1.350000000e+00 1.208479368e+01
1.600000000e+00 1.209839343e+01
e
$u0_3 << e
0.000000000e+00 1.023190290e+01
2.500000000e-01 1.025850584e+01
6.989777918e-01 1.094667050e+01
8.000000000e-01 1.187092070e+01
1.350000000e+00 1.209035286e+01
1.600000000e+00 1.209839148e+01
e
$single0 << e
8.000000000e-01 3.350700382e+01
e
$u1_0 << e
6.989777918e-01 6.365734932e+01
8.000000000e-01 6.898407498e+01
e
$single1 << e
0.000000000e+00 5.968374287e+01
2.500000000e-01 8.416610444e+01
8.000000000e-01 1.946819576e+02
1.350000000e+00 9.874959449e+01
1.600000000e+00 7.003004220e+01
e
$u2_0 << e
0.000000000e+00 2.608234715e-01
2.500000000e-01 1.637167991e-01
6.989777918e-01 2.264823111e-02
e
$u2_1 << e
1.350000000e+00 1.708158915e-01
1.600000000e+00 2.034406571e-01
e
$u2_2 << e
0.000000000e+00 2.266035788e-01
2.500000000e-01 1.567561244e+00
6.989777918e-01 1.698033358e+00
8.000000000e-01 1.979423888e+00
1.350000000e+00 1.646636242e-01
1.600000000e+00 1.961133453e-01
e
$u3_0 << e
6.989777918e-01 6.362700095e+01
8.000000000e-01 6.895218120e+01
e
$single3 << e
0.000000000e+00 5.968374287e+01
2.500000000e-01 8.414617650e+01
1.350000000e+00 9.872064622e+01
1.600000000e+00 7.003004220e+01
e
$u4_0 << e
0.000000000e+00 4.770383127e+00
2.500000000e-01 4.776313064e+00
6.989777918e-01 5.087984274e+00
8.000000000e-01 5.513737100e+00
1.350000000e+00 5.603906482e+00
1.600000000e+00 5.597338833e+00
e
$single4 << e
8.000000000e-01 1.556047730e+01
e
$u5_0 << e
0.000000000e+00 2.634508100e-02
2.500000000e-01 3.363536492e-01
6.989777918e-01 3.765812489e-01
8.000000000e-01 4.403692168e-01
1.350000000e+00 1.914390118e-02
1.600000000e+00 2.280026641e-02
e
set arrow from screen 0.529032,0.697752 to screen 0.529032,0.697581 nohead lw 1 lc rgb '#202020'
set object circle at 8.000000000e-01,1.946819576e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '195 %: fatigue at s = 0.8 m, hole oil edge' at screen 0.53871,0.713871 left noenhanced front tc rgb '#c8500a'
set label '98.7 %' at screen 0.828722,0.516384 left noenhanced front tc rgb '#a04f86'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single0 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $single4 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
