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
0.000000000e+00 3.000000000e+02
1.500000000e+00 3.000000000e+02
1.500000000e+00 3.000000000e+02
3.200000000e+00 5.000000000e+02
3.200000000e+00 5.000000000e+02
4.200000000e+00 3.000000000e+02
4.200000000e+00 3.000000000e+02
4.700000000e+00 3.000000000e+02
4.700000000e+00 3.000000000e+02
5.200000000e+00 3.000000000e+02
5.200000000e+00 2.450000000e+02
6.200000000e+00 2.450000000e+02
6.200000000e+00 -2.450000000e+02
5.200000000e+00 -2.450000000e+02
5.200000000e+00 -3.000000000e+02
4.700000000e+00 -3.000000000e+02
4.700000000e+00 -3.000000000e+02
4.200000000e+00 -3.000000000e+02
4.200000000e+00 -3.000000000e+02
3.200000000e+00 -5.000000000e+02
3.200000000e+00 -5.000000000e+02
1.500000000e+00 -3.000000000e+02
1.500000000e+00 -3.000000000e+02
0.000000000e+00 -3.000000000e+02
0.000000000e+00 3.000000000e+02
e
$inner_outline_z << e
0.000000000e+00 2.500000000e+02 1.500000000e+00 0.000000000e+00
0.000000000e+00 -2.500000000e+02 1.500000000e+00 0.000000000e+00
1.500000000e+00 2.500000000e+02 1.700000000e+00 2.000000000e+02
1.500000000e+00 -2.500000000e+02 1.700000000e+00 -2.000000000e+02
3.200000000e+00 4.500000000e+02 1.000000000e+00 -2.000000000e+02
3.200000000e+00 -4.500000000e+02 1.000000000e+00 2.000000000e+02
4.200000000e+00 2.500000000e+02 5.000000000e-01 0.000000000e+00
4.200000000e+00 -2.500000000e+02 5.000000000e-01 0.000000000e+00
4.700000000e+00 2.500000000e+02 5.000000000e-01 0.000000000e+00
4.700000000e+00 -2.500000000e+02 5.000000000e-01 0.000000000e+00
4.700000000e+00 -2.450000000e+02 5.000000000e-01 0.000000000e+00
4.700000000e+00 2.450000000e+02 5.000000000e-01 0.000000000e+00
5.200000000e+00 1.890000000e+02 1.000000000e+00 0.000000000e+00
5.200000000e+00 -1.890000000e+02 1.000000000e+00 0.000000000e+00
e
$supports_outline_z << e
3.200000000e+00 -6.700000000e+02
6.200000000e+00 -6.700000000e+02
0.000000000e+00 -6.700000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-1.240000000e-01:6.324000000e+00]
set yrange [-8.500000000e+02:8.500000000e+02]
set xtics 1.000000000e+00
set ytics 1.000000000e+03
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 5.000000000e+02
set object ellipse center 3.2,0 size 0.145,145 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,0 size 0.145,145 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,-0 size 0.145,145 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,-0 size 0.145,145 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,100 size 0.018000000000000002,18.000000000000004 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,100 size 0.018000000000000002,18.000000000000004 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,-100 size 0.018000000000000002,18.000000000000004 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,-100 size 0.018000000000000002,18.000000000000004 front fs empty border lc rgb '#303030'
set arrow from screen 0.107196,0.912668 to screen 0.107196,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'C' at screen 0.110422,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.54264,0.912668 to screen 0.54264,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'O' at screen 0.545866,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.912668 to screen 0.950868,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'B' at screen 0.954094,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-1.240000000e-01:6.324000000e+00]
set yrange [0.000000000e+00:2.064338831e+02]
set xtics 1.000000000e+00
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 11.1 % at s = 4.2 m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 180 % at s = 4.2 m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 25.4 % at s = 6.2- m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 150 % at s = 4.2 m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 7.23 % at s = 4.2 m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 1.29 % at s = 4.7- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 7.660987151e-02
1.500000000e+00 7.613974154e+00
1.906190524e+00 7.707098867e+00
2.695026968e+00 7.541512017e+00
3.200000000e+00 7.388497800e+00
3.200000000e+00 7.413734486e+00
4.200000000e+00 1.107395053e+01
4.700000000e+00 8.389289713e+00
4.700000000e+00 5.469485704e+00
5.200000000e+00 3.679962366e+00
5.200000000e+00 8.680846298e+00
6.200000000e+00 1.055213733e-01
e
$u0_1 << e
0.000000000e+00 2.318399852e+00
1.500000000e+00 1.045415164e+00
1.906190524e+00 8.187511505e-01
2.695026968e+00 5.638561612e-01
e
$u0_2 << e
4.200000000e+00 2.511490752e+00
4.700000000e+00 2.531534329e+00
4.700000000e+00 1.685079049e+00
5.200000000e+00 1.718134930e+00
5.200000000e+00 2.944839595e+00
6.200000000e+00 3.013699867e+00
e
$u1_0 << e
0.000000000e+00 5.914030185e-01
1.500000000e+00 1.235757390e+02
1.906190524e+00 1.249960589e+02
2.695026968e+00 1.220286826e+02
3.200000000e+00 1.189514799e+02
3.200000000e+00 1.190337395e+02
4.200000000e+00 1.795077244e+02
4.700000000e+00 1.356676501e+02
4.700000000e+00 8.873981380e+01
5.200000000e+00 5.963931398e+01
5.200000000e+00 1.408774367e+02
6.200000000e+00 8.371313122e-01
e
$u2_0 << e
0.000000000e+00 1.950895710e+01
1.500000000e+00 8.738158176e+00
1.906190524e+00 6.805013457e+00
2.695026968e+00 4.591470067e+00
e
$u2_1 << e
4.200000000e+00 2.107549588e+01
4.700000000e+00 2.125980556e+01
4.700000000e+00 1.416269938e+01
5.200000000e+00 1.445158864e+01
5.200000000e+00 2.475745331e+01
6.200000000e+00 2.535617040e+01
e
$u2_2 << e
0.000000000e+00 1.555061797e+01
1.500000000e+00 2.560246540e+00
1.906190524e+00 8.245703287e-01
2.695026968e+00 7.301128395e-01
3.200000000e+00 1.219349676e+00
3.200000000e+00 7.149618489e+00
4.200000000e+00 1.679930831e+01
4.700000000e+00 1.694622182e+01
4.700000000e+00 1.128910820e+01
5.200000000e+00 1.151938225e+01
e
$single2 << e
3.200000000e+00 3.970315740e+00
e
$u3_0 << e
0.000000000e+00 1.244049438e+01
1.500000000e+00 1.030112608e+02
1.906190524e+00 1.070503345e+02
2.695026968e+00 1.081966101e+02
3.200000000e+00 1.070714296e+02
3.200000000e+00 1.071536895e+02
4.200000000e+00 1.496384028e+02
4.700000000e+00 1.131050085e+02
4.700000000e+00 7.397602564e+01
5.200000000e+00 4.972560983e+01
5.200000000e+00 1.087546545e+02
6.200000000e+00 1.617483658e+01
e
$single3 << e
3.200000000e+00 1.130114548e+02
3.200000000e+00 1.130937145e+02
e
$u4_0 << e
0.000000000e+00 2.381577981e-02
1.500000000e+00 4.976390884e+00
1.906190524e+00 5.033587117e+00
2.695026968e+00 4.914090973e+00
3.200000000e+00 4.790172125e+00
3.200000000e+00 4.793484717e+00
4.200000000e+00 7.228770069e+00
4.700000000e+00 5.463331741e+00
4.700000000e+00 3.573549339e+00
5.200000000e+00 2.401673183e+00
5.200000000e+00 5.673129674e+00
6.200000000e+00 3.371124999e-02
e
$u4_1 << e
0.000000000e+00 1.537569014e+00
1.500000000e+00 6.886847507e-01
1.906190524e+00 5.363268668e-01
2.695026968e+00 3.618697848e-01
e
$u4_2 << e
4.200000000e+00 1.661033405e+00
4.700000000e+00 1.675559494e+00
4.700000000e+00 1.116211780e+00
5.200000000e+00 1.138980151e+00
5.200000000e+00 1.951221324e+00
6.200000000e+00 1.998408308e+00
e
$u5_0 << e
0.000000000e+00 1.185153372e+00
1.500000000e+00 2.030087413e-01
1.906190524e+00 7.122922428e-02
2.695026968e+00 6.327789844e-02
3.200000000e+00 1.026378590e-01
3.200000000e+00 5.630420393e-01
4.200000000e+00 1.280287799e+00
4.700000000e+00 1.291444636e+00
4.700000000e+00 8.603249963e-01
5.200000000e+00 8.778137978e-01
e
set arrow from screen 0.678716,0.697752 to screen 0.678716,0.697581 nohead lw 1 lc rgb '#202020'
set object circle at 4.200000000e+00,1.795077244e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '180 %: fatigue at s = 4.2 m, fibre +z' at screen 0.274587,0.713871 left noenhanced front tc rgb '#c8500a'
set label '150 %' at screen 0.710974,0.664097 left noenhanced front tc rgb '#a04f86'
set arrow from screen 0.710974,0.651299 to screen 0.678716,0.630914 nohead lw 0.6 lc rgb '#a04f86'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single2 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
