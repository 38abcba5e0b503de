# Redraw in the folder above: gnuplot plots/utilisation.gp; as PDF: gnuplot -e 'pdf = 1' plots/utilisation.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.3887 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'utilisation.pdf'
} else {
  set terminal svg size 620,514 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
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
0.000000000e+00 2.250000000e+02
2.100000000e+00 4.000000000e+02
2.100000000e+00 4.000000000e+02
2.900000000e+00 4.000000000e+02
2.900000000e+00 4.000000000e+02
4.900000000e+00 2.000000000e+02
4.900000000e+00 2.000000000e+02
5.600000000e+00 2.000000000e+02
5.600000000e+00 -2.000000000e+02
4.900000000e+00 -2.000000000e+02
4.900000000e+00 -2.000000000e+02
2.900000000e+00 -4.000000000e+02
2.900000000e+00 -4.000000000e+02
2.100000000e+00 -4.000000000e+02
2.100000000e+00 -4.000000000e+02
0.000000000e+00 -2.250000000e+02
0.000000000e+00 2.250000000e+02
e
$inner_outline_z << e
0.000000000e+00 2.000000000e+02 2.100000000e+00 1.750000000e+02
0.000000000e+00 -2.000000000e+02 2.100000000e+00 -1.750000000e+02
2.100000000e+00 3.750000000e+02 8.000000000e-01 0.000000000e+00
2.100000000e+00 -3.750000000e+02 8.000000000e-01 0.000000000e+00
2.900000000e+00 3.750000000e+02 2.000000000e+00 -2.000000000e+02
2.900000000e+00 -3.750000000e+02 2.000000000e+00 2.000000000e+02
4.900000000e+00 1.750000000e+02 7.000000000e-01 0.000000000e+00
4.900000000e+00 -1.750000000e+02 7.000000000e-01 0.000000000e+00
e
$supports_outline_z << e
0.000000000e+00 -5.360000000e+02
2.500000000e+00 -5.360000000e+02
5.600000000e+00 -5.360000000e+02
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 7.743190661e-01
set tmargin at screen 9.221789883e-01
set xrange [-1.120000000e-01:5.712000000e+00]
set yrange [-6.800000000e+02:6.800000000e+02]
set xtics 1.000000000e+00
set ytics 5.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.951362 left enhanced front tc rgb '#202020'
set ytics 5.000000000e+02
set arrow from screen 0.107196,0.900435 to screen 0.107196,0.796063 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'T' at screen 0.110422,0.913504 left noenhanced front tc rgb '#202020'
set arrow from screen 0.483836,0.900435 to screen 0.483836,0.796063 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'S' at screen 0.487061,0.913504 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.900435 to screen 0.950868,0.796063 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'H' at screen 0.954094,0.913504 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.984435798e-01
set tmargin at screen 7.237354086e-01
set xrange [-1.120000000e-01:5.712000000e+00]
set yrange [0.000000000e+00:1.150000000e+02]
set xtics 1.000000000e+00
set ytics 1.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.752918 left enhanced front tc rgb '#202020'
set arrow from screen 0.0229677,0.0914397 to screen 0.0713548,0.0914397 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 25.1 % at s = 2.5- m' at screen 0.0842581,0.0914397 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0229677,0.0564202 to screen 0.0713548,0.0564202 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 89.6 % at s = 3.9 m' at screen 0.0842581,0.0564202 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0229677,0.0214008 to screen 0.0713548,0.0214008 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 14.6 % at s = 0+ m' at screen 0.0842581,0.0214008 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0914397 to screen 0.558065,0.0914397 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 82.1 % at s = 3.9 m' at screen 0.570968,0.0914397 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0564202 to screen 0.558065,0.0564202 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 6.28 % at s = 2.5- m' at screen 0.570968,0.0564202 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0214008 to screen 0.558065,0.0214008 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 5.65 % at s = 0+ m' at screen 0.570968,0.0214008 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.132296 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 1.490191504e+00
2.100000000e+00 2.102194920e+01
2.200000000e+00 2.203533885e+01
2.500000000e+00 2.509026715e+01
2.500000000e+00 2.497498360e+01
2.800000000e+00 2.266447480e+01
2.900000000e+00 2.189898488e+01
3.072493476e+00 2.191116992e+01
3.408140986e+00 2.185497709e+01
3.900000000e+00 2.148598803e+01
4.000000000e+00 2.135058001e+01
4.900000000e+00 1.825174537e+01
5.600000000e+00 5.196540990e+00
e
$u0_1 << e
0.000000000e+00 1.168409310e+01
2.100000000e+00 7.049048583e+00
2.200000000e+00 7.065193559e+00
2.500000000e+00 7.113750304e+00
2.500000000e+00 5.367809135e+00
2.800000000e+00 5.319005834e+00
2.900000000e+00 1.765560994e+00
3.072493476e+00 1.867024505e+00
3.408140986e+00 2.109013800e+00
3.900000000e+00 2.620628947e+00
4.000000000e+00 2.757809226e+00
4.900000000e+00 9.746164023e+00
5.600000000e+00 9.589078114e+00
e
$u1_0 << e
0.000000000e+00 8.952413328e+00
2.100000000e+00 5.035699256e+01
e
$u1_1 << e
2.900000000e+00 5.029458799e+01
3.072493476e+00 5.046335762e+01
3.408140986e+00 5.061070939e+01
e
$u1_2 << e
4.900000000e+00 4.357145589e+01
5.600000000e+00 1.309685274e+01
e
$u1_3 << e
3.900000000e+00 8.959457267e+01
4.000000000e+00 8.918869794e+01
e
$u1_4 << e
2.200000000e+00 7.412755108e+01
2.500000000e+00 8.373905392e+01
2.500000000e+00 8.028011835e+01
2.800000000e+00 7.319810086e+01
e
$u2_0 << e
0.000000000e+00 1.460513876e+01
2.100000000e+00 8.450802369e+00
2.200000000e+00 8.450855508e+00
2.500000000e+00 8.450988684e+00
2.500000000e+00 6.212632748e+00
2.800000000e+00 6.212588958e+00
2.900000000e+00 1.867820434e+00
3.072493476e+00 2.003058627e+00
3.408140986e+00 2.321729091e+00
3.900000000e+00 2.984147848e+00
4.000000000e+00 3.160081763e+00
4.900000000e+00 1.205352993e+01
5.600000000e+00 1.205446604e+01
e
$u3_0 << e
0.000000000e+00 1.094093244e+01
2.100000000e+00 4.737596074e+01
e
$u3_1 << e
2.900000000e+00 4.715177065e+01
3.072493476e+00 4.716788077e+01
3.408140986e+00 4.698791884e+01
e
$u3_2 << e
4.900000000e+00 3.812656791e+01
5.600000000e+00 1.146245306e+01
e
$u3_3 << e
3.900000000e+00 8.212984087e+01
4.000000000e+00 8.150156791e+01
e
$u3_4 << e
2.200000000e+00 6.972752267e+01
2.500000000e+00 7.873520870e+01
2.500000000e+00 7.526348406e+01
2.800000000e+00 6.862406524e+01
e
$u4_0 << e
0.000000000e+00 9.458669541e-01
2.100000000e+00 5.320466496e+00
2.200000000e+00 5.560680327e+00
2.500000000e+00 6.281687483e+00
2.500000000e+00 6.022215334e+00
2.800000000e+00 5.490957593e+00
2.900000000e+00 5.313873142e+00
3.072493476e+00 5.331704493e+00
3.408140986e+00 5.347272940e+00
3.900000000e+00 5.301022615e+00
4.000000000e+00 5.277008313e+00
4.900000000e+00 4.603540828e+00
5.600000000e+00 1.383747573e+00
e
$u4_1 << e
0.000000000e+00 2.891542408e+00
2.100000000e+00 1.673099710e+00
2.200000000e+00 1.673110231e+00
2.500000000e+00 1.673136597e+00
2.500000000e+00 1.229984278e+00
2.800000000e+00 1.229975608e+00
2.900000000e+00 3.697932681e-01
3.072493476e+00 3.965678833e-01
3.408140986e+00 4.596586335e-01
3.900000000e+00 5.908050717e-01
4.000000000e+00 6.256366734e-01
4.900000000e+00 2.386371915e+00
5.600000000e+00 2.386557248e+00
e
$u5_0 << e
0.000000000e+00 5.654310768e+00
2.100000000e+00 2.742649915e+00
2.200000000e+00 2.748939135e+00
2.500000000e+00 2.767854384e+00
2.500000000e+00 2.088823527e+00
2.800000000e+00 2.069839898e+00
2.900000000e+00 6.822312395e-02
3.072493476e+00 8.787307659e-02
3.408140986e+00 1.824114444e-01
3.900000000e+00 4.360690349e-01
4.000000000e+00 5.084492918e-01
4.900000000e+00 4.875517494e+00
5.600000000e+00 4.796948677e+00
e
set arrow from screen 0.694754,0.607884 to screen 0.694754,0.60769 nohead lw 1 lc rgb '#202020'
set object circle at 3.900000000e+00,8.959457267e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '89.6 %: fatigue at s = 3.9 m, fibre -z' at screen 0.287915,0.626261 left noenhanced front tc rgb '#c8500a'
set label '82.1 %' at screen 0.613657,0.592164 left noenhanced front tc rgb '#a04f86'
set label '25.1 %' at screen 0.493513,0.331621 left noenhanced front tc rgb '#0b5fa5'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_1 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_2 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_3 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_4 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_4 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_2 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_3 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_4 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_4 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
