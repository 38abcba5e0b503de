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
set label 'yield: 41.0 % at s = 1.05+ m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 84.9 % at s = 1.05+ m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 8.14 % at s = 1.05+ m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 84.9 % at s = 1.05+ m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 14.2 % at s = 1.05+ m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 4.99 % at s = 0+ m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
1.050000000e+00 4.098616069e+01
1.150000000e+00 3.514271166e+01
1.150000000e+00 3.514271166e+01
1.175000000e+00 3.383200785e+01
e
$u0_1 << e
1.200000000e+00 3.268144025e+01
1.225000000e+00 3.145639797e+01
1.500000000e+00 2.428578899e+01
1.500000000e+00 2.424924791e+01
e
$u0_2 << e
0.000000000e+00 2.194005671e+00
9.000000000e-01 3.042235731e+01
9.000000000e-01 3.042235731e+01
9.500000000e-01 3.203836055e+01
9.500000000e-01 3.203836055e+01
1.050000000e+00 3.527552921e+01
1.050000000e+00 4.085043398e+01
1.150000000e+00 3.500713561e+01
1.150000000e+00 3.500713561e+01
1.175000000e+00 3.372389985e+01
1.200000000e+00 3.338122262e+01
1.200000000e+00 3.264771317e+01
1.225000000e+00 3.142211466e+01
1.500000000e+00 2.424187087e+01
1.500000000e+00 2.424187087e+01
2.400000000e+00 1.383320714e+00
e
$u0_3 << e
0.000000000e+00 8.167086975e+00
9.000000000e-01 3.358323086e+00
9.000000000e-01 5.057301938e+00
9.500000000e-01 5.062290621e+00
9.500000000e-01 5.062290621e+00
1.050000000e+00 5.072269101e+00
1.050000000e+00 8.859841500e+00
1.150000000e+00 8.849584143e+00
1.150000000e+00 8.849584143e+00
1.175000000e+00 8.847019747e+00
e
$u0_4 << e
1.225000000e+00 4.018938565e+00
1.500000000e+00 3.996091442e+00
1.500000000e+00 2.586298062e+00
2.400000000e+00 6.488992861e+00
e
$u0_5 << e
9.000000000e-01 3.043127839e+01
9.000000000e-01 3.047628809e+01
9.500000000e-01 3.208968466e+01
9.500000000e-01 3.208968466e+01
1.050000000e+00 3.532234855e+01
e
$single0 << e
1.200000000e+00 3.605818514e+01
e
$u1_0 << e
9.500000000e-01 6.888020491e+01
9.500000000e-01 6.888020491e+01
1.050000000e+00 7.575517651e+01
1.050000000e+00 8.490009939e+01
1.150000000e+00 7.269533217e+01
1.150000000e+00 7.269533217e+01
e
$u1_1 << e
0.000000000e+00 3.186008967e+00
9.000000000e-01 4.072082562e+01
9.000000000e-01 4.072082562e+01
e
$u1_2 << e
1.175000000e+00 4.368851358e+01
1.200000000e+00 4.362159087e+01
1.200000000e+00 4.271762541e+01
1.225000000e+00 4.108335600e+01
1.500000000e+00 3.185919410e+01
1.500000000e+00 3.185919410e+01
2.400000000e+00 2.124598235e+00
e
$single1 << e
1.200000000e+00 4.584746959e+01
e
$u2_0 << e
0.000000000e+00 7.452143428e+00
9.000000000e-01 2.745483020e+00
e
$u2_1 << e
0.000000000e+00 7.451231790e+00
9.000000000e-01 2.745172138e+00
9.000000000e-01 4.484667065e+00
9.500000000e-01 4.485939867e+00
9.500000000e-01 4.485939867e+00
1.050000000e+00 4.488486492e+00
1.050000000e+00 8.139872674e+00
1.150000000e+00 8.137322925e+00
1.150000000e+00 8.137322925e+00
1.175000000e+00 8.136685349e+00
e
$u2_2 << e
1.225000000e+00 3.567982341e+00
1.500000000e+00 3.561089663e+00
1.500000000e+00 2.180620564e+00
2.400000000e+00 5.911386698e+00
e
$u2_3 << e
0.000000000e+00 6.956982569e+00
9.000000000e-01 1.447476451e+00
9.000000000e-01 3.324483787e+00
9.500000000e-01 3.325427316e+00
9.500000000e-01 3.325427316e+00
1.050000000e+00 3.327315129e+00
1.050000000e+00 6.034087781e+00
1.150000000e+00 6.032197652e+00
1.150000000e+00 6.032197652e+00
1.175000000e+00 6.031725017e+00
1.200000000e+00 6.094435021e+00
1.200000000e+00 2.673123516e+00
1.225000000e+00 2.644945383e+00
1.500000000e+00 2.639835840e+00
1.500000000e+00 1.126916490e+00
2.400000000e+00 5.499521164e+00
e
$single2 << e
1.200000000e+00 7.868592772e+00
1.200000000e+00 3.451299473e+00
e
$u3_0 << e
1.050000000e+00 8.490009939e+01
1.150000000e+00 7.269533217e+01
1.150000000e+00 7.269533217e+01
e
$u3_1 << e
1.175000000e+00 4.368851358e+01
1.200000000e+00 4.362159087e+01
1.200000000e+00 4.271762541e+01
1.225000000e+00 4.108335600e+01
1.500000000e+00 3.185919410e+01
1.500000000e+00 3.185919410e+01
e
$u3_2 << e
9.500000000e-01 6.888020491e+01
9.500000000e-01 6.888020491e+01
1.050000000e+00 7.575517651e+01
e
$u3_3 << e
0.000000000e+00 5.774112803e+00
9.000000000e-01 3.710609567e+01
9.000000000e-01 3.710609567e+01
e
$u3_4 << e
1.175000000e+00 3.977384357e+01
1.200000000e+00 3.978460067e+01
1.200000000e+00 3.888063520e+01
1.225000000e+00 3.736493561e+01
1.500000000e+00 2.900841242e+01
1.500000000e+00 2.900841242e+01
2.400000000e+00 4.498658044e+00
e
$single3 << e
0.000000000e+00 7.568583959e+00
9.000000000e-01 4.072082562e+01
9.000000000e-01 4.072082562e+01
2.400000000e+00 5.966290524e+00
e
$u4_0 << e
0.000000000e+00 8.593487626e-01
9.000000000e-01 1.098345657e+01
9.000000000e-01 1.098345657e+01
9.500000000e-01 1.156012181e+01
9.500000000e-01 1.156012181e+01
1.050000000e+00 1.271394400e+01
1.050000000e+00 1.424873070e+01
1.150000000e+00 1.220041223e+01
1.150000000e+00 1.220041223e+01
1.175000000e+00 1.178391853e+01
1.200000000e+00 1.176586774e+01
1.200000000e+00 1.152204495e+01
1.225000000e+00 1.108124036e+01
1.500000000e+00 8.593246067e+00
1.500000000e+00 8.593246067e+00
2.400000000e+00 5.730589219e-01
e
$u4_1 << e
0.000000000e+00 2.845347541e+00
9.000000000e-01 1.048278864e+00
9.000000000e-01 1.712527105e+00
9.500000000e-01 1.713013140e+00
9.500000000e-01 1.713013140e+00
1.050000000e+00 1.713985601e+00
1.050000000e+00 3.108313813e+00
1.150000000e+00 3.107340159e+00
1.150000000e+00 3.107340159e+00
1.175000000e+00 3.107096692e+00
e
$u4_2 << e
1.225000000e+00 1.362479395e+00
1.500000000e+00 1.359847338e+00
1.500000000e+00 8.326976713e-01
2.400000000e+00 2.257338126e+00
e
$single4 << e
0.000000000e+00 2.845695661e+00
1.200000000e+00 1.236624462e+01
e
$u5_0 << e
0.000000000e+00 4.987317162e+00
9.000000000e-01 1.057601480e+00
9.000000000e-01 2.415604771e+00
9.500000000e-01 2.418178630e+00
9.500000000e-01 2.418178630e+00
1.050000000e+00 2.423326522e+00
1.050000000e+00 4.446508327e+00
1.150000000e+00 4.441360429e+00
1.150000000e+00 4.441360429e+00
1.175000000e+00 4.440073425e+00
1.200000000e+00 4.485286609e+00
1.200000000e+00 1.991357102e+00
1.225000000e+00 1.969427139e+00
1.500000000e+00 1.955292147e+00
1.500000000e+00 8.453921772e-01
2.400000000e+00 4.006873611e+00
e
set arrow from screen 0.476303,0.637254 to screen 0.476303,0.637083 nohead lw 1 lc rgb '#202020'
set object circle at 1.050000000e+00,8.490009939e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '84.9 %: combined fatigue at s = 1.05+ m, bottom flange' at screen 0.179109,0.660121 left noenhanced front tc rgb '#a04f86'
set label '84.9 %' at screen 0.395206,0.620793 left noenhanced front tc rgb '#c8500a'
set label '41.0 %' at screen 0.395206,0.47743 left noenhanced front tc rgb '#0b5fa5'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_4 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_4 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_5 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_5 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single0 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_1 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_2 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_3 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single2 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_2 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_3 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_4 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_4 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $single4 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
