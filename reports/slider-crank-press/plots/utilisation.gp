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
set yrange [0.000000000e+00:2.234328516e+02]
set xtics 2.000000000e-01
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 33.4 % at s = 0.8 m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 194 % at s = 0.8 m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 2.12 % at s = 1.35- m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 98.6 % at s = 1.35+ m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 15.5 % at s = 0.8 m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 0.461 % at s = 1.35- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 1.021216499e+01
2.500000000e-01 1.023228153e+01
2.500000000e-01 1.023228153e+01
6.988704486e-01 1.091932379e+01
7.800000000e-01 1.105191782e+01
8.000000000e-01 1.183964842e+01
8.200000000e-01 1.111832274e+01
1.350000000e+00 1.206929713e+01
1.350000000e+00 1.206929713e+01
1.600000000e+00 1.207507993e+01
e
$u0_1 << e
0.000000000e+00 1.021217398e+01
2.500000000e-01 1.022524140e+01
2.500000000e-01 1.022524188e+01
6.988704486e-01 1.090571223e+01
7.800000000e-01 1.103799663e+01
e
$u0_2 << e
8.200000000e-01 1.110435199e+01
1.350000000e+00 1.206150861e+01
1.350000000e+00 1.206150916e+01
1.600000000e+00 1.207508526e+01
e
$u0_3 << e
0.000000000e+00 1.021216934e+01
2.500000000e-01 1.023094149e+01
2.500000000e-01 1.023902450e+01
6.988704486e-01 1.092593835e+01
7.800000000e-01 1.105870381e+01
8.000000000e-01 1.184859030e+01
8.200000000e-01 1.112521915e+01
1.350000000e+00 1.207966760e+01
1.350000000e+00 1.206735136e+01
1.600000000e+00 1.207508310e+01
e
$single0 << e
8.000000000e-01 3.344257585e+01
e
$u1_0 << e
6.988704486e-01 6.353547914e+01
7.800000000e-01 6.428252922e+01
8.000000000e-01 6.885261707e+01
8.200000000e-01 6.465616711e+01
e
$single1 << e
0.000000000e+00 5.956276812e+01
2.500000000e-01 8.400154663e+01
2.500000000e-01 8.400154664e+01
8.000000000e-01 1.942894362e+02
1.350000000e+00 9.855620288e+01
1.350000000e+00 9.855620290e+01
1.600000000e+00 6.988825341e+01
e
$u2_0 << e
0.000000000e+00 2.608234715e-01
2.500000000e-01 1.526886883e-01
2.500000000e-01 1.637167992e-01
6.988704486e-01 2.267964235e-02
7.800000000e-01 3.648176484e-03
e
$u2_1 << e
8.200000000e-01 1.407924776e-02
1.350000000e+00 1.570581630e-01
1.350000000e+00 1.708158915e-01
1.600000000e+00 2.034406571e-01
e
$u2_2 << e
0.000000000e+00 2.266035788e-01
2.500000000e-01 1.326560183e-01
2.500000000e-01 1.565778326e+00
6.988704486e-01 1.694996051e+00
7.800000000e-01 1.726974626e+00
8.000000000e-01 1.975490970e+00
8.200000000e-01 1.743806803e+00
1.350000000e+00 2.115367013e+00
1.350000000e+00 1.646636242e-01
1.600000000e+00 1.961133453e-01
e
$u3_0 << e
6.988704486e-01 6.353547914e+01
7.800000000e-01 6.428252922e+01
8.000000000e-01 6.885261707e+01
8.200000000e-01 6.465616711e+01
e
$single3 << e
0.000000000e+00 5.956276812e+01
2.500000000e-01 8.400154663e+01
2.500000000e-01 8.400154664e+01
1.350000000e+00 9.855620288e+01
1.350000000e+00 9.855620290e+01
1.600000000e+00 6.988825341e+01
e
$u4_0 << e
0.000000000e+00 4.760713896e+00
2.500000000e-01 4.766974630e+00
2.500000000e-01 4.766974631e+00
6.988704486e-01 5.078243472e+00
7.800000000e-01 5.137953453e+00
8.000000000e-01 5.503229974e+00
8.200000000e-01 5.167817462e+00
1.350000000e+00 5.592931769e+00
1.350000000e+00 5.592931770e+00
1.600000000e+00 5.586005984e+00
e
$single4 << e
8.000000000e-01 1.552910397e+01
e
$u5_0 << e
0.000000000e+00 2.634508100e-02
2.500000000e-01 1.542267588e-02
2.500000000e-01 3.359390518e-01
6.988704486e-01 3.758992964e-01
7.800000000e-01 3.840097234e-01
8.000000000e-01 4.395286991e-01
8.200000000e-01 3.881464368e-01
1.350000000e+00 4.608658570e-01
1.350000000e+00 1.914390118e-02
1.600000000e+00 2.280026641e-02
e
set arrow from screen 0.529032,0.697752 to screen 0.529032,0.697581 nohead lw 1 lc rgb '#202020'
set object circle at 8.000000000e-01,1.942894362e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '194 %: fatigue at s = 0.8 m, hole oil edge' at screen 0.53871,0.713871 left noenhanced front tc rgb '#c8500a'
set label '98.6 %' at screen 0.828722,0.516455 left noenhanced front tc rgb '#a04f86'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single0 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $single4 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
