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
set yrange [0.000000000e+00:1.896759585e+02]
set xtics 1.000000000e+00
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 10.2 % at s = 4.2 m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 165 % at s = 4.2 m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 23.4 % at s = 6.2- m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 137 % at s = 4.2 m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 6.64 % at s = 4.2 m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 1.18 % at s = 4.7- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 7.067320340e-02
1.500000000e+00 6.985308042e+00
1.912522352e+00 7.073835876e+00
2.695048568e+00 6.926631883e+00
3.200000000e+00 6.790142828e+00
3.200000000e+00 6.813282654e+00
4.200000000e+00 1.017924457e+01
4.700000000e+00 7.716650934e+00
4.700000000e+00 5.030127677e+00
5.200000000e+00 3.385880580e+00
5.200000000e+00 7.986739310e+00
6.200000000e+00 9.763462941e-02
e
$u0_1 << e
0.000000000e+00 2.121611532e+00
1.500000000e+00 9.616588383e-01
1.912522352e+00 7.517481532e-01
2.695048568e+00 5.216492891e-01
e
$u0_2 << e
4.200000000e+00 2.301806116e+00
4.700000000e+00 2.321784121e+00
4.700000000e+00 1.545339693e+00
5.200000000e+00 1.578390595e+00
5.200000000e+00 2.705407879e+00
6.200000000e+00 2.774313884e+00
e
$u1_0 << e
0.000000000e+00 5.412210660e-01
1.500000000e+00 1.133272986e+02
1.912522352e+00 1.146652767e+02
2.695048568e+00 1.119934539e+02
3.200000000e+00 1.091892748e+02
3.200000000e+00 1.092653312e+02
4.200000000e+00 1.649356161e+02
4.700000000e+00 1.247340911e+02
4.700000000e+00 8.158812714e+01
5.200000000e+00 5.486796745e+01
5.200000000e+00 1.296067137e+02
6.200000000e+00 7.706493011e-01
e
$u2_0 << e
0.000000000e+00 1.786182289e+01
1.500000000e+00 8.035916302e+00
1.912522352e+00 6.241281131e+00
2.695048568e+00 4.229208297e+00
e
$u2_1 << e
4.200000000e+00 1.931890912e+01
4.700000000e+00 1.950345817e+01
4.700000000e+00 1.299266892e+01
5.200000000e+00 1.328193076e+01
5.200000000e+00 2.275367705e+01
6.200000000e+00 2.335315754e+01
e
$u2_2 << e
0.000000000e+00 1.423768491e+01
1.500000000e+00 2.365850745e+00
1.912522352e+00 7.537072208e-01
2.695048568e+00 6.600782940e-01
3.200000000e+00 1.113428726e+00
3.200000000e+00 6.580706706e+00
4.200000000e+00 1.539913046e+01
4.700000000e+00 1.554623477e+01
4.700000000e+00 1.035647522e+01
5.200000000e+00 1.058704626e+01
e
$single2 << e
3.200000000e+00 3.653858533e+00
e
$u3_0 << e
0.000000000e+00 1.139014793e+01
1.500000000e+00 9.446838118e+01
1.912522352e+00 9.823796606e+01
2.695048568e+00 9.929899683e+01
3.200000000e+00 9.828423974e+01
3.200000000e+00 9.836029614e+01
4.200000000e+00 1.374911719e+02
4.700000000e+00 1.039899013e+02
4.700000000e+00 6.801423690e+01
5.200000000e+00 4.574743735e+01
5.200000000e+00 1.000540060e+02
6.200000000e+00 1.489710397e+01
e
$single3 << e
3.200000000e+00 1.037367573e+02
3.200000000e+00 1.038128136e+02
e
$u4_0 << e
0.000000000e+00 2.179495426e-02
1.500000000e+00 4.563686532e+00
1.912522352e+00 4.617566864e+00
2.695048568e+00 4.509972651e+00
3.200000000e+00 4.397048449e+00
3.200000000e+00 4.400111238e+00
4.200000000e+00 6.641951755e+00
4.700000000e+00 5.023037686e+00
4.700000000e+00 3.285551156e+00
5.200000000e+00 2.209531217e+00
5.200000000e+00 5.219258033e+00
6.200000000e+00 3.103402163e-02
e
$u4_1 << e
0.000000000e+00 1.407752618e+00
1.500000000e+00 6.333386171e-01
1.912522352e+00 4.918971542e-01
2.695048568e+00 3.333186700e-01
e
$u4_2 << e
4.200000000e+00 1.522590670e+00
4.700000000e+00 1.537135625e+00
4.700000000e+00 1.023997595e+00
5.200000000e+00 1.046795330e+00
5.200000000e+00 1.793296721e+00
6.200000000e+00 1.840543871e+00
e
$u5_0 << e
0.000000000e+00 1.084550647e+00
1.500000000e+00 1.878892161e-01
1.912522352e+00 6.560627758e-02
2.695048568e+00 5.781674063e-02
3.200000000e+00 9.445987124e-02
3.200000000e+00 5.190360336e-01
4.200000000e+00 1.173000073e+00
4.700000000e+00 1.184171315e+00
4.700000000e+00 7.888624524e-01
5.200000000e+00 8.063737033e-01
e
set arrow from screen 0.678716,0.697752 to screen 0.678716,0.697581 nohead lw 1 lc rgb '#202020'
set object circle at 4.200000000e+00,1.649356161e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '165 %: fatigue at s = 4.2 m, fibre +z' at screen 0.274587,0.713871 left noenhanced front tc rgb '#c8500a'
set label '137 %' at screen 0.710974,0.664098 left noenhanced front tc rgb '#a04f86'
set arrow from screen 0.710974,0.651299 to screen 0.678716,0.630915 nohead lw 0.6 lc rgb '#a04f86'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single2 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
