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
4.200000000e+00 1.500000000e+02
4.200000000e+00 -1.500000000e+02
0.000000000e+00 -1.500000000e+02
0.000000000e+00 1.500000000e+02
e
$inner_outline_z << e
0.000000000e+00 1.400000000e+02 4.200000000e+00 0.000000000e+00
0.000000000e+00 -1.400000000e+02 4.200000000e+00 0.000000000e+00
e
$supports_outline_z << e
0.000000000e+00 -2.010000000e+02
1.500000000e+00 -2.010000000e+02
2.600000000e+00 -2.010000000e+02
4.200000000e+00 -2.010000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-8.400000000e-02:4.284000000e+00]
set yrange [-2.550000000e+02:2.550000000e+02]
set xtics 5.000000000e-01
set ytics 2.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 2.000000000e+02
set arrow from screen 0.408508,0.912668 to screen 0.408508,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'lift' at screen 0.411733,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.629469,0.912668 to screen 0.629469,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'sleeve' at screen 0.632695,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-8.400000000e-02:4.284000000e+00]
set yrange [0.000000000e+00:1.150000000e+02]
set xtics 5.000000000e-01
set ytics 1.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 23.7 % at s = 1.5+ m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 13.7 % at s = 1.5+ m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 2.31 % at s = 1.5+ m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 13.7 % at s = 1.5+ m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 1.98 % at s = 1.5+ m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 1.88 % at s = 1.5- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
1.500000000e+00 2.372562852e+01
1.866666667e+00 2.185524578e+01
2.233333333e+00 2.010236054e+01
2.600000000e+00 1.864456851e+01
2.600000000e+00 1.831357743e+01
3.000000000e+00 1.379728818e+01
3.400000000e+00 9.308815506e+00
3.800000000e+00 4.925612714e+00
e
$u0_1 << e
0.000000000e+00 3.781363863e+00
5.000000000e-01 3.824525009e+00
1.000000000e+00 3.873013821e+00
1.500000000e+00 3.934916483e+00
1.500000000e+00 1.920544014e+00
1.866666667e+00 1.859633189e+00
2.233333333e+00 1.794330770e+00
2.600000000e+00 1.726514522e+00
2.600000000e+00 3.284622119e+00
3.000000000e+00 3.264493493e+00
3.400000000e+00 3.259733760e+00
3.800000000e+00 3.266838940e+00
4.200000000e+00 3.277560681e+00
e
$u0_2 << e
5.000000000e-01 7.873763147e+00
1.000000000e+00 1.380670882e+01
1.500000000e+00 1.991296590e+01
e
$u1_0 << e
0.000000000e+00 1.876330591e+00
5.000000000e-01 3.546728534e+00
1.000000000e+00 5.396536288e+00
1.500000000e+00 7.317458105e+00
1.500000000e+00 1.371935255e+01
1.866666667e+00 7.755518899e+00
2.233333333e+00 6.569194581e+00
2.600000000e+00 1.025126548e+01
2.600000000e+00 6.925272585e+00
3.000000000e+00 6.342253944e+00
3.400000000e+00 4.966636092e+00
3.800000000e+00 2.874781536e+00
e
$u2_0 << e
0.000000000e+00 7.740106580e-01
5.000000000e-01 7.410047062e-01
1.000000000e+00 7.361651188e-01
1.500000000e+00 7.569847678e-01
1.500000000e+00 2.313780225e+00
1.866666667e+00 2.215655773e+00
2.233333333e+00 2.082475865e+00
2.600000000e+00 1.913468146e+00
2.600000000e+00 4.352923861e-01
3.000000000e+00 5.281117900e-01
3.400000000e+00 6.650073501e-01
3.800000000e+00 9.182703484e-01
4.200000000e+00 1.222984401e+00
e
$u3_0 << e
1.500000000e+00 1.371935255e+01
1.866666667e+00 7.755518899e+00
e
$u3_1 << e
2.600000000e+00 6.925272585e+00
3.000000000e+00 6.342253944e+00
3.400000000e+00 4.966636092e+00
3.800000000e+00 2.874781536e+00
e
$u3_2 << e
5.000000000e-01 3.546728534e+00
1.000000000e+00 5.396536288e+00
1.500000000e+00 7.317458105e+00
e
$u3_3 << e
2.233333333e+00 6.569194581e+00
2.600000000e+00 1.025126548e+01
e
$u3_4 << e
0.000000000e+00 1.876330591e+00
5.000000000e-01 3.421386490e+00
1.000000000e+00 5.132797137e+00
1.500000000e+00 6.909741475e+00
1.500000000e+00 1.299898874e+01
1.866666667e+00 7.472061815e+00
2.233333333e+00 6.251577861e+00
2.600000000e+00 9.780739671e+00
2.600000000e+00 6.465450635e+00
3.000000000e+00 5.920833701e+00
3.400000000e+00 4.636421043e+00
3.800000000e+00 2.683552637e+00
e
$single3 << e
0.000000000e+00 1.879841959e+00
e
$u4_0 << e
0.000000000e+00 3.093723815e-01
5.000000000e-01 6.020998517e-01
1.000000000e+00 9.529720057e-01
1.500000000e+00 1.325414344e+00
1.500000000e+00 1.978481369e+00
1.866666667e+00 1.420365331e+00
2.233333333e+00 1.151190119e+00
2.600000000e+00 1.379864193e+00
2.600000000e+00 1.066298091e+00
3.000000000e+00 8.916905585e-01
3.400000000e+00 6.573133528e-01
3.800000000e+00 3.605380280e-01
e
$u4_1 << e
0.000000000e+00 2.278397768e-01
5.000000000e-01 2.193975140e-01
1.000000000e+00 2.197764578e-01
1.500000000e+00 2.280994931e-01
1.500000000e+00 5.081654899e-01
1.866666667e+00 4.860795777e-01
2.233333333e+00 4.604268643e-01
2.600000000e+00 4.281828328e-01
2.600000000e+00 1.312081932e-01
3.000000000e+00 1.525482201e-01
3.400000000e+00 1.901599705e-01
3.800000000e+00 2.353061271e-01
4.200000000e+00 2.817653822e-01
e
$u5_0 << e
0.000000000e+00 1.794413844e+00
5.000000000e-01 1.817695926e+00
1.000000000e+00 1.845509447e+00
1.500000000e+00 1.877865725e+00
1.500000000e+00 8.499851102e-01
1.866666667e+00 8.139131902e-01
2.233333333e+00 7.783904201e-01
2.600000000e+00 7.395434205e-01
2.600000000e+00 1.728791509e+00
3.000000000e+00 1.718214653e+00
3.400000000e+00 1.715719157e+00
3.800000000e+00 1.719466142e+00
4.200000000e+00 1.725111668e+00
e
set arrow from screen 0.408508,0.392156 to screen 0.408508,0.391986 nohead lw 1 lc rgb '#202020'
set object circle at 1.500000000e+00,2.372562852e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '23.7 %: yield at s = 1.5+ m, bottom flange' at screen 0.418185,0.408276 left noenhanced front tc rgb '#0b5fa5'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_2 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_3 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_4 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_4 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
