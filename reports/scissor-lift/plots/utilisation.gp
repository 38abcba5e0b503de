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
0.000000000e+00 5.000000000e+01
9.000000000e-01 8.500000000e+01
9.000000000e-01 8.500000000e+01
1.500000000e+00 8.500000000e+01
1.500000000e+00 8.500000000e+01
2.400000000e+00 5.000000000e+01
2.400000000e+00 -5.000000000e+01
1.500000000e+00 -8.500000000e+01
1.500000000e+00 -8.500000000e+01
9.000000000e-01 -8.500000000e+01
9.000000000e-01 -8.500000000e+01
0.000000000e+00 -5.000000000e+01
0.000000000e+00 5.000000000e+01
e
$inner_outline_z << e
0.000000000e+00 4.200000000e+01 9.000000000e-01 3.500000000e+01
0.000000000e+00 -4.200000000e+01 9.000000000e-01 -3.500000000e+01
9.000000000e-01 7.700000000e+01 6.000000000e-01 0.000000000e+00
9.000000000e-01 -7.700000000e+01 6.000000000e-01 0.000000000e+00
1.500000000e+00 7.700000000e+01 9.000000000e-01 -3.500000000e+01
1.500000000e+00 -7.700000000e+01 9.000000000e-01 3.500000000e+01
e
$supports_outline_z << e
0.000000000e+00 -1.139000000e+02
1.200000000e+00 -1.139000000e+02
2.400000000e+00 -1.139000000e+02
1.050000000e+00 -1.139000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-4.800000000e-02:2.448000000e+00]
set yrange [-1.445000000e+02:1.445000000e+02]
set xtics 5.000000000e-01
set ytics 1.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 1.000000000e+02
set object ellipse center 1.2,0 size 0.05,50 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 1.2,0 size 0.05,50 front fs empty border lc rgb '#303030'
set object ellipse center 1.2,-0 size 0.05,50 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 1.2,-0 size 0.05,50 front fs empty border lc rgb '#303030'
set arrow from screen 0.107196,0.912668 to screen 0.107196,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'A' at screen 0.110422,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.476303,0.912668 to screen 0.476303,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'P' at screen 0.479529,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.529032,0.912668 to screen 0.529032,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'M' at screen 0.532258,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.912668 to screen 0.950868,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'C' at screen 0.954094,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-4.800000000e-02:2.448000000e+00]
set yrange [0.000000000e+00:1.150000000e+02]
set xtics 5.000000000e-01
set ytics 1.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 40.9 % at s = 1.05+ m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 84.9 % at s = 1.05+ m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 8.14 % at s = 1.05+ m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 77.0 % at s = 1.05+ m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 14.2 % at s = 1.05+ m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 4.99 % at s = 0+ m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 2.194005875e+00
9.000000000e-01 3.042235648e+01
9.500000000e-01 3.203835965e+01
1.050000000e+00 3.527552819e+01
1.050000000e+00 4.085043960e+01
1.150000000e+00 3.500713598e+01
1.200000000e+00 3.338210838e+01
1.200000000e+00 3.264858527e+01
1.500000000e+00 2.424252053e+01
2.400000000e+00 1.383358051e+00
e
$u0_1 << e
0.000000000e+00 8.167086789e+00
9.000000000e-01 5.057303120e+00
9.500000000e-01 5.062291784e+00
1.050000000e+00 5.072270223e+00
1.050000000e+00 8.859843983e+00
1.150000000e+00 8.849586573e+00
e
$u0_2 << e
1.500000000e+00 2.586366431e+00
2.400000000e+00 6.489168305e+00
e
$single0 << e
1.200000000e+00 3.605551553e+01
e
$u1_0 << e
9.500000000e-01 6.888020080e+01
1.050000000e+00 7.575517192e+01
1.050000000e+00 8.490012414e+01
1.150000000e+00 7.269534262e+01
e
$u1_1 << e
0.000000000e+00 3.186010204e+00
9.000000000e-01 4.072082321e+01
e
$u1_2 << e
1.200000000e+00 4.362446750e+01
1.200000000e+00 4.272045954e+01
1.500000000e+00 3.186130303e+01
2.400000000e+00 2.124680653e+00
e
$single1 << e
1.200000000e+00 4.581752293e+01
e
$u2_0 << e
0.000000000e+00 7.451232122e+00
9.000000000e-01 4.484666776e+00
9.500000000e-01 4.485939575e+00
1.050000000e+00 4.488486196e+00
1.050000000e+00 8.139873869e+00
1.150000000e+00 8.137324086e+00
e
$u2_1 << e
1.500000000e+00 2.180621344e+00
2.400000000e+00 5.911386910e+00
e
$u2_2 << e
0.000000000e+00 6.956982186e+00
9.000000000e-01 3.324483573e+00
9.500000000e-01 3.325427100e+00
1.050000000e+00 3.327314909e+00
1.050000000e+00 6.034088666e+00
1.150000000e+00 6.032198512e+00
1.200000000e+00 6.094435875e+00
1.200000000e+00 2.673124087e+00
1.500000000e+00 1.126954809e+00
2.400000000e+00 5.499890366e+00
e
$single2 << e
1.200000000e+00 7.868593875e+00
1.200000000e+00 3.451300210e+00
e
$u3_0 << e
9.500000000e-01 6.274727094e+01
1.050000000e+00 6.897488112e+01
1.050000000e+00 7.698958930e+01
1.150000000e+00 6.603281811e+01
e
$u3_1 << e
0.000000000e+00 5.774112762e+00
9.000000000e-01 3.710609350e+01
e
$u3_2 << e
1.200000000e+00 3.978721758e+01
1.200000000e+00 3.888320962e+01
1.500000000e+00 2.901032854e+01
2.400000000e+00 4.498951642e+00
e
$u4_0 << e
0.000000000e+00 8.593490962e-01
9.000000000e-01 1.098345592e+01
9.500000000e-01 1.156012112e+01
1.050000000e+00 1.271394323e+01
1.050000000e+00 1.424873485e+01
1.150000000e+00 1.220041399e+01
1.200000000e+00 1.176664364e+01
1.200000000e+00 1.152280939e+01
1.500000000e+00 8.593814899e+00
2.400000000e+00 5.730811524e-01
e
$u4_1 << e
0.000000000e+00 2.845347667e+00
9.000000000e-01 1.712526994e+00
9.500000000e-01 1.713013029e+00
1.050000000e+00 1.713985488e+00
1.050000000e+00 3.108314269e+00
1.150000000e+00 3.107340602e+00
e
$u4_2 << e
1.500000000e+00 8.326979689e-01
2.400000000e+00 2.257338207e+00
e
$single4 << e
1.200000000e+00 1.235816724e+01
e
$u5_0 << e
0.000000000e+00 4.987316987e+00
9.000000000e-01 2.415604684e+00
9.500000000e-01 2.418178544e+00
1.050000000e+00 2.423326435e+00
1.050000000e+00 4.446508587e+00
1.150000000e+00 4.441360678e+00
1.200000000e+00 4.485286854e+00
1.200000000e+00 1.991357273e+00
1.500000000e+00 8.454143551e-01
2.400000000e+00 4.006981948e+00
e
set arrow from screen 0.476303,0.637254 to screen 0.476303,0.637083 nohead lw 1 lc rgb '#202020'
set object circle at 1.050000000e+00,8.490012414e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '84.9 %: fatigue at s = 1.05+ m, fibre -z' at screen 0.48598,0.653373 left noenhanced front tc rgb '#c8500a'
set label '77.0 %' at screen 0.395206,0.621679 left noenhanced front tc rgb '#a04f86'
set label '40.9 %' at screen 0.395206,0.476887 left noenhanced front tc rgb '#0b5fa5'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single0 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_1 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_2 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single2 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_2 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $single4 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
