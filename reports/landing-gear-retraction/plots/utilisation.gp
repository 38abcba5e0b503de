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
0.000000000e+00 7.000000000e+01
1.100000000e+00 5.000000000e+01
1.100000000e+00 -5.000000000e+01
0.000000000e+00 -7.000000000e+01
0.000000000e+00 7.000000000e+01
e
$inner_outline_z << e
0.000000000e+00 6.000000000e+01 1.100000000e+00 -2.000000000e+01
0.000000000e+00 -6.000000000e+01 1.100000000e+00 2.000000000e+01
e
$supports_outline_z << e
0.000000000e+00 -9.380000000e+01
1.100000000e+00 -9.380000000e+01
e
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 8.020477816e-01
set tmargin at screen 9.317406143e-01
set xrange [-2.200000000e-02:1.122000000e+00]
set yrange [-1.190000000e+02:1.190000000e+02]
set xtics 2.000000000e-01
set ytics 1.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.957338 left enhanced front tc rgb '#202020'
set ytics 1.000000000e+02
set arrow from screen 0.107196,0.912668 to screen 0.107196,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'B' at screen 0.110422,0.924131 left noenhanced front tc rgb '#202020'
set arrow from screen 0.950868,0.912668 to screen 0.950868,0.82112 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'foot' at screen 0.902933,0.924131 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.969283276e-01
set tmargin at screen 7.576791809e-01
set xrange [-2.200000000e-02:1.122000000e+00]
set yrange [0.000000000e+00:1.150000000e+02]
set xtics 2.000000000e-01
set ytics 1.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.783276 left enhanced front tc rgb '#202020'
set arrow from screen 0.216,0.203072 to screen 0.264387,0.203072 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 80.3 % at s = 1.1- m' at screen 0.27729,0.203072 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.172355 to screen 0.264387,0.172355 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 85.1 % at s = 1.1- m' at screen 0.27729,0.172355 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.141638 to screen 0.264387,0.141638 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 27.1 % at s = 1.1- m' at screen 0.27729,0.141638 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.110922 to screen 0.264387,0.110922 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 81.5 % at s = 1.1- m' at screen 0.27729,0.110922 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0802048 to screen 0.264387,0.0802048 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 35.1 % at s = 1.1- m' at screen 0.27729,0.0802048 left noenhanced front tc rgb '#202020'
set arrow from screen 0.216,0.0494881 to screen 0.264387,0.0494881 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 22.5 % at s = 1.1- m' at screen 0.27729,0.0494881 left noenhanced front tc rgb '#202020'
set label '' at screen 0.240194,0.0187713 point pt 6 ps 0.7 lw 1.3 lc rgb '#202020'
set label 'holes, single welds and other places of no line' at screen 0.27729,0.0187713 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.238908 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 5.502976005e+01
1.100000000e+00 8.027018461e+01
e
$u0_1 << e
0.000000000e+00 6.115054550e+01
1.100000000e+00 7.334962656e+01
e
$single1 << e
0.000000000e+00 4.709552929e+01
1.100000000e+00 8.506763683e+01
e
$u2_0 << e
0.000000000e+00 1.542688439e+01
1.100000000e+00 2.709923868e+01
e
$single3 << e
0.000000000e+00 4.580358311e+01
1.100000000e+00 8.145661634e+01
e
$u4_0 << e
0.000000000e+00 2.736752211e+01
1.100000000e+00 3.509768828e+01
e
$u5_0 << e
0.000000000e+00 1.288914650e+01
1.100000000e+00 2.254366121e+01
e
set arrow from screen 0.950868,0.637925 to screen 0.950868,0.637754 nohead lw 1 lc rgb '#202020'
set object circle at 1.100000000e+00,8.506763683e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '85.1 %: fatigue at s = 1.1- m, corner -y -z' at screen 0.491772,0.654044 left noenhanced front tc rgb '#c8500a'
set label '81.5 %' at screen 0.915159,0.559293 left noenhanced front tc rgb '#a04f86'
set arrow from screen 0.950868,0.572092 to screen 0.950868,0.623287 nohead lw 0.6 lc rgb '#a04f86'
set label '80.3 %' at screen 0.915159,0.682526 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.950868,0.669728 to screen 0.950868,0.618533 nohead lw 0.6 lc rgb '#0b5fa5'
set label '35.1 %' at screen 0.869772,0.453838 left noenhanced front tc rgb '#8a6d00'
set label '27.1 %' at screen 0.869772,0.421792 left noenhanced front tc rgb '#00785a'
set label '22.5 %' at screen 0.915159,0.364213 left noenhanced front tc rgb '#4a4a4a'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $single1 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $single3 using 1:2 with points pt 6 ps 0.7 lw 1.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
