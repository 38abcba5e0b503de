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
0.000000000e+00 1.500000000e+02
1.200000000e+00 2.400000000e+02
1.200000000e+00 2.400000000e+02
3.000000000e+00 4.000000000e+01
3.000000000e+00 -4.000000000e+01
1.200000000e+00 -2.400000000e+02
1.200000000e+00 -2.400000000e+02
0.000000000e+00 -1.500000000e+02
0.000000000e+00 1.500000000e+02
e
$inner_outline_z << e
0.000000000e+00 1.380000000e+02 1.200000000e+00 9.000000000e+01
0.000000000e+00 -1.380000000e+02 1.200000000e+00 -9.000000000e+01
1.200000000e+00 2.280000000e+02 1.800000000e+00 -2.000000000e+02
1.200000000e+00 -2.280000000e+02 1.800000000e+00 2.000000000e+02
e
$supports_outline_z << e
1.200000000e+00 -3.216000000e+02
0.000000000e+00 -3.216000000e+02
3.000000000e+00 -3.216000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-6.000000000e-02:3.060000000e+00]
set yrange [-4.080000000e+02:4.080000000e+02]
set xtics 5.000000000e-01
set ytics 5.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 2.000000000e+02
set arrow from screen 0.107196,0.912668 to screen 0.107196,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'C' at screen 0.110422,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.444665,0.912668 to screen 0.444665,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'B' at screen 0.447891,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.912668 to screen 0.950868,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'D' at screen 0.954094,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-6.000000000e-02:3.060000000e+00]
set yrange [0.000000000e+00:1.264850154e+02]
set xtics 5.000000000e-01
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 9.09 % at s = 2.6822 m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 110 % at s = 2.6614 m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 15.5 % at s = 3- m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 110 % at s = 2.6614 m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 6.83 % at s = 2.6614 m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 1.89 % at s = 3- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
1.100000000e+00 7.069409507e+00
1.100000000e+00 7.069409507e+00
1.200000000e+00 7.315556788e+00
1.200000000e+00 7.071593545e+00
1.300000000e+00 7.196090664e+00
1.300000000e+00 7.196090664e+00
e
$u0_1 << e
0.000000000e+00 6.455451146e-01
1.100000000e+00 7.062700167e+00
1.100000000e+00 7.062700167e+00
1.200000000e+00 7.310403495e+00
1.200000000e+00 7.070442776e+00
1.300000000e+00 7.194894097e+00
1.300000000e+00 7.194894097e+00
2.661423535e+00 9.091918321e+00
2.682165617e+00 9.093775483e+00
3.000000000e+00 7.650060588e+00
e
$u0_2 << e
0.000000000e+00 2.835090741e+00
1.100000000e+00 1.358775580e+00
1.100000000e+00 1.358775580e+00
1.200000000e+00 1.296190876e+00
1.200000000e+00 3.370288289e-01
1.300000000e+00 3.479402579e-01
1.300000000e+00 3.479402579e-01
2.661423535e+00 9.880562168e-01
2.682165617e+00 1.030792526e+00
3.000000000e+00 3.061099116e+00
e
$single0 << e
3.000000000e+00 7.859755234e+00
e
$u1_0 << e
1.100000000e+00 9.362246029e+01
1.100000000e+00 9.362246029e+01
1.200000000e+00 9.729961245e+01
1.200000000e+00 9.716781387e+01
1.300000000e+00 9.887278930e+01
1.300000000e+00 9.887278930e+01
e
$u1_1 << e
2.661423535e+00 1.099869699e+02
2.682165617e+00 1.099593921e+02
3.000000000e+00 9.083694940e+01
e
$single1 << e
0.000000000e+00 3.822354556e+00
e
$u2_0 << e
0.000000000e+00 1.411058004e+01
1.100000000e+00 6.600901148e+00
1.100000000e+00 6.600901148e+00
1.200000000e+00 6.287760935e+00
1.200000000e+00 1.500747633e+00
1.300000000e+00 1.555544530e+00
1.300000000e+00 1.555544530e+00
2.661423535e+00 4.835277685e+00
2.682165617e+00 5.056795954e+00
3.000000000e+00 1.551916565e+01
e
$u3_0 << e
1.100000000e+00 9.362246029e+01
1.100000000e+00 9.362246029e+01
1.200000000e+00 9.729961245e+01
1.200000000e+00 9.716781387e+01
1.300000000e+00 9.887278930e+01
1.300000000e+00 9.887278930e+01
e
$u3_1 << e
2.661423535e+00 1.099869699e+02
2.682165617e+00 1.099593921e+02
3.000000000e+00 9.083694940e+01
e
$single3 << e
0.000000000e+00 1.411058036e+01
e
$u4_0 << e
0.000000000e+00 2.140235219e-01
1.100000000e+00 5.163288000e+00
1.100000000e+00 5.163288000e+00
1.200000000e+00 5.366083307e+00
1.200000000e+00 5.358814603e+00
1.300000000e+00 5.452844167e+00
1.300000000e+00 5.452844167e+00
2.661423535e+00 6.834695588e+00
2.682165617e+00 6.832981877e+00
3.000000000e+00 5.644694983e+00
e
$u4_1 << e
0.000000000e+00 2.145122575e+00
1.100000000e+00 1.003484054e+00
1.100000000e+00 1.003484054e+00
1.200000000e+00 9.558797646e-01
1.200000000e+00 2.281470795e-01
1.300000000e+00 2.364774288e-01
1.300000000e+00 2.364774288e-01
2.661423535e+00 7.350699467e-01
2.682165617e+00 7.687456593e-01
3.000000000e+00 2.359258974e+00
e
$u5_0 << e
0.000000000e+00 1.311413566e+00
1.100000000e+00 3.322974238e-01
1.100000000e+00 3.322974238e-01
1.200000000e+00 2.975540932e-01
1.200000000e+00 1.275305286e-01
1.300000000e+00 1.311831350e-01
1.300000000e+00 1.311831350e-01
2.661423535e+00 1.475679835e-01
2.682165617e+00 1.783397927e-01
3.000000000e+00 1.889835076e+00
e
set arrow from screen 0.855653,0.697752 to screen 0.855653,0.697581 nohead lw 1 lc rgb '#202020'
set object circle at 2.661423535e+00,1.099869699e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '110 %: combined fatigue at s = 2.6614 m, bottom flange' at screen 0.246749,0.713871 left noenhanced front tc rgb '#a04f86'
set label '110 %' at screen 0.86533,0.713871 left noenhanced front tc rgb '#c8500a'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single0 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_1 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
