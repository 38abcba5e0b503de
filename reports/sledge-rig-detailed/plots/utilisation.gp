# Redraw in the folder above: gnuplot plots/utilisation.gp; as PDF: gnuplot -e 'pdf = 1' plots/utilisation.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.3323 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'utilisation.pdf'
} else {
  set terminal svg size 620,604 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
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
set bmargin at screen 8.079470199e-01
set tmargin at screen 9.337748344e-01
set xrange [-1.240000000e-01:6.324000000e+00]
set yrange [-8.500000000e+02:8.500000000e+02]
set xtics 1.000000000e+00
set ytics 1.000000000e+03
set label 'beam, z [mm]' at screen 0.0193548,0.958609 left enhanced front tc rgb '#202020'
set ytics 5.000000000e+02
set object ellipse center 3.2,0 size 0.145,145 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,0 size 0.145,145 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,-0 size 0.145,145 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,-0 size 0.145,145 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,100 size 0.018000000000000002,18.000000000000004 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,100 size 0.018000000000000002,18.000000000000004 front fs empty border lc rgb '#303030'
set object ellipse center 3.2,-100 size 0.018000000000000002,18.000000000000004 front fs solid noborder fc rgb '#ffffff'
set object ellipse center 3.2,-100 size 0.018000000000000002,18.000000000000004 front fs empty border lc rgb '#303030'
set arrow from screen 0.107196,0.915271 to screen 0.107196,0.826451 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'C' at screen 0.110422,0.926392 left noenhanced front tc rgb '#202020'
set arrow from screen 0.54264,0.915271 to screen 0.54264,0.826451 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'O' at screen 0.545866,0.926392 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.915271 to screen 0.950868,0.826451 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'B' at screen 0.954094,0.926392 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.178807947e-01
set tmargin at screen 7.649006623e-01
set xrange [-1.240000000e-01:6.324000000e+00]
set yrange [0.000000000e+00:1.417002979e+02]
set xtics 1.000000000e+00
set ytics 2.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.789735 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.226821 to screen 0.264387,0.226821 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 13.5 % at s = 4.2 m' at screen 0.27729,0.226821 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.19702 to screen 0.264387,0.19702 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 123 % at s = 5.2+ m' at screen 0.27729,0.19702 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.167219 to screen 0.264387,0.167219 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 17.5 % at s = 4.7- m' at screen 0.27729,0.167219 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.137417 to screen 0.264387,0.137417 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 119 % at s = 3.2+ m' at screen 0.27729,0.137417 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.107616 to screen 0.264387,0.107616 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 7.97 % at s = 4.2 m' at screen 0.27729,0.107616 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0778146 to screen 0.264387,0.0778146 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 2.61 % at s = 4.7- m' at screen 0.27729,0.0778146 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0480132 to screen 0.264387,0.0480132 nohead lw 1.6 dt (9,4) lc rgb '#0b5fa5'
set label 'deflection: 7.99 % at s = 3.2292 m' at screen 0.27729,0.0480132 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0182119 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0182119 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.261589 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 1.125380974e-01
1.500000000e+00 9.228419244e+00
1.912522352e+00 9.342279051e+00
2.695048568e+00 9.142068741e+00
3.200000000e+00 8.954787259e+00
3.200000000e+00 9.000993113e+00
4.200000000e+00 1.346277787e+01
4.700000000e+00 1.021161060e+01
4.700000000e+00 6.655650309e+00
5.200000000e+00 4.486541631e+00
5.200000000e+00 1.058126336e+01
6.200000000e+00 1.590432773e-01
e
$u0_1 << e
0.000000000e+00 2.805572324e+00
1.500000000e+00 1.270676629e+00
1.912522352e+00 9.922331906e-01
2.695048568e+00 6.849093828e-01
e
$u0_2 << e
4.200000000e+00 3.043975053e+00
4.700000000e+00 3.070764503e+00
4.700000000e+00 2.043726547e+00
5.200000000e+00 2.087624781e+00
5.200000000e+00 3.578660782e+00
6.200000000e+00 3.669914854e+00
e
$u1_0 << e
0.000000000e+00 2.922593756e-01
1.500000000e+00 4.913715023e+01
1.912522352e+00 4.972409341e+01
2.695048568e+00 4.859262137e+01
3.200000000e+00 4.744439954e+01
3.200000000e+00 4.682158630e+01
4.200000000e+00 7.086542599e+01
4.700000000e+00 5.355955479e+01
4.700000000e+00 3.506405766e+01
e
$u1_1 << e
0.000000000e+00 3.653242195e-01
1.500000000e+00 6.376615729e+01
1.912522352e+00 6.631062709e+01
2.695048568e+00 6.702682286e+01
e
$u1_2 << e
4.200000000e+00 9.280654103e+01
4.700000000e+00 7.019318336e+01
4.700000000e+00 4.590960991e+01
5.200000000e+00 3.087952021e+01
5.200000000e+00 6.753645404e+01
e
$single1 << e
3.200000000e+00 1.184676104e+02
3.200000000e+00 1.185592855e+02
5.200000000e+00 5.216320849e+01
5.200000000e+00 1.232176503e+02
6.200000000e+00 2.496903736e-01
e
$u2_0 << e
0.000000000e+00 1.205673045e+01
1.500000000e+00 5.424243504e+00
1.912522352e+00 4.212864763e+00
2.695048568e+00 2.854715600e+00
e
$u2_1 << e
4.200000000e+00 1.304026366e+01
4.700000000e+00 1.316483427e+01
4.700000000e+00 8.770051520e+00
5.200000000e+00 8.965303264e+00
5.200000000e+00 1.535873201e+01
6.200000000e+00 1.576338134e+01
e
$u2_2 << e
0.000000000e+00 1.601739553e+01
1.500000000e+00 2.661582088e+00
1.912522352e+00 8.479206234e-01
2.695048568e+00 7.425880808e-01
3.200000000e+00 1.252607317e+00
3.200000000e+00 7.403295044e+00
4.200000000e+00 1.732402177e+01
4.700000000e+00 1.748951412e+01
4.700000000e+00 1.165103463e+01
5.200000000e+00 1.191042704e+01
e
$single2 << e
3.200000000e+00 2.466354510e+00
e
$u3_0 << e
0.000000000e+00 7.688349853e+00
1.500000000e+00 6.376615729e+01
1.912522352e+00 6.631062709e+01
2.695048568e+00 6.702682286e+01
e
$u3_1 << e
4.200000000e+00 9.280654103e+01
4.700000000e+00 7.019318336e+01
4.700000000e+00 4.590960991e+01
5.200000000e+00 3.087952021e+01
5.200000000e+00 6.753645404e+01
e
$single3 << e
3.200000000e+00 1.184676104e+02
3.200000000e+00 1.185592855e+02
6.200000000e+00 1.005554518e+01
e
$u4_0 << e
0.000000000e+00 3.231766895e-02
1.500000000e+00 5.472157176e+00
1.912522352e+00 5.536432043e+00
2.695048568e+00 5.407092183e+00
3.200000000e+00 5.271976287e+00
3.200000000e+00 5.277517385e+00
4.200000000e+00 7.965398950e+00
4.700000000e+00 6.025475097e+00
4.700000000e+00 3.940554225e+00
5.200000000e+00 2.651121391e+00
5.200000000e+00 6.261735953e+00
6.200000000e+00 4.670278719e-02
e
$u4_1 << e
0.000000000e+00 1.686766861e+00
1.500000000e+00 7.590017866e-01
1.912522352e+00 5.895198977e-01
2.695048568e+00 3.994886541e-01
e
$u4_2 << e
4.200000000e+00 1.824479950e+00
4.700000000e+00 1.841953200e+00
4.700000000e+00 1.227058703e+00
5.200000000e+00 1.254448952e+00
5.200000000e+00 2.149034418e+00
6.200000000e+00 2.205804239e+00
e
$u4_3 << e
0.000000000e+00 1.792699079e+00
1.500000000e+00 2.985284573e-01
1.912522352e+00 9.542011296e-02
2.695048568e+00 8.336698640e-02
3.200000000e+00 1.405090779e-01
3.200000000e+00 8.297011562e-01
4.200000000e+00 1.939060816e+00
4.700000000e+00 1.957631420e+00
4.700000000e+00 1.304120361e+00
5.200000000e+00 1.333230771e+00
e
$u5_0 << e
0.000000000e+00 2.390156190e+00
1.500000000e+00 4.131551501e-01
1.912522352e+00 1.438289283e-01
2.695048568e+00 1.258561906e-01
3.200000000e+00 2.055316762e-01
3.200000000e+00 1.142534201e+00
4.200000000e+00 2.585207307e+00
4.700000000e+00 2.609835939e+00
4.700000000e+00 1.738601123e+00
5.200000000e+00 1.777213412e+00
e
$single6 << e
3.229166667e+00 7.988623487e+00
e
set arrow from screen 0.814792,0.706759 to screen 0.814792,0.706594 nohead lw 1 lc rgb '#202020'
set object circle at 5.200000000e+00,1.232176503e+02 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '123 %: fatigue at s = 5.2+ m, fibre +z' at screen 0.398276,0.722398 left noenhanced front tc rgb '#c8500a'
set label '119 %' at screen 0.552317,0.676094 left noenhanced front tc rgb '#a04f86'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_1 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u1_2 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_1 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u2_2 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single2 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u3_1 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_2 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_3 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_3 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle, $single6 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#0b5fa5' notitle
unset label
unset arrow
unset object
unset multiplot
