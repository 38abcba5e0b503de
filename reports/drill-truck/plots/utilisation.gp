# Redraw in the folder above: gnuplot plots/utilisation.gp; as PDF: gnuplot -e 'pdf = 1' plots/utilisation.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.9548 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'utilisation.pdf'
} else {
  set terminal svg size 620,568 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
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
set bmargin at screen 7.957746479e-01
set tmargin at screen 9.295774648e-01
set xrange [-8.400000000e-02:4.284000000e+00]
set yrange [-2.550000000e+02:2.550000000e+02]
set xtics 5.000000000e-01
set ytics 2.000000000e+02
set label 'beam, z [mm]' at screen 0.0193548,0.955986 left enhanced front tc rgb '#202020'
set ytics 2.000000000e+02
set arrow from screen 0.408508,0.909901 to screen 0.408508,0.815452 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'lift' at screen 0.411733,0.921727 left noenhanced front tc rgb '#202020'
set arrow from screen 0.629469,0.909901 to screen 0.629469,0.815452 nohead lw 0.8 dt (2,3) lc rgb '#707070' front
set label 'sleeve' at screen 0.632695,0.921727 left noenhanced front tc rgb '#202020'
plot $outline_z using 1:2 with filledcurves closed fc rgb '#e3eaf2' notitle, $inner_outline_z using 1:2:3:4 with vectors nohead lw 0.7 lc rgb '#8090a0' notitle, $outline_z using 1:2 with lines lc rgb '#303030' lw 1.3 notitle, $supports_outline_z using 1:2 with points pt 9 ps 1 lc rgb '#303030' notitle
unset label
unset arrow
unset object
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.746478873e-01
set tmargin at screen 7.500000000e-01
set xrange [-8.400000000e-02:4.284000000e+00]
set yrange [0.000000000e+00:1.150000000e+02]
set xtics 5.000000000e-01
set ytics 1.000000000e+01
set label 'utilisation [%], lines through the worst places of one kind' at screen 0.0193548,0.776408 left enhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.177817 to screen 0.308516,0.177817 nohead lw 1.6 dt 1 lc rgb '#0b5fa5'
set label 'yield: 22.3 % at s = 1.5+ m' at screen 0.321419,0.177817 left noenhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.146127 to screen 0.308516,0.146127 nohead lw 1.6 dt (9,4) lc rgb '#c8500a'
set label 'fatigue: 12.1 % at s = 1.5+ m' at screen 0.321419,0.146127 left noenhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.114437 to screen 0.308516,0.114437 nohead lw 1.6 dt (3,3) lc rgb '#00785a'
set label 'shear fatigue: 2.16 % at s = 1.5+ m' at screen 0.321419,0.114437 left noenhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.0827465 to screen 0.308516,0.0827465 nohead lw 1.6 dt (9,3,2,3) lc rgb '#a04f86'
set label 'combined fatigue: 11.5 % at s = 1.5+ m' at screen 0.321419,0.0827465 left noenhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.0510563 to screen 0.308516,0.0510563 nohead lw 1.6 dt (14,4) lc rgb '#8a6d00'
set label 'stress range: 0.701 % at s = 1.5+ m' at screen 0.321419,0.0510563 left noenhanced front tc rgb '#202020'
set arrow from screen 0.260129,0.0193662 to screen 0.308516,0.0193662 nohead lw 1.6 dt (2,5) lc rgb '#4a4a4a'
set label 'weld: 1.77 % at s = 1.5- m' at screen 0.321419,0.0193662 left noenhanced front tc rgb '#202020'
set format x '%g'
set label 's [m], from the start of the beam' at screen 0.529032,0.214789 center noenhanced front tc rgb '#202020'
$u0_0 << e
0.000000000e+00 1.482197856e+00
1.500000000e+00 1.860261773e+01
1.500000000e+00 2.225568151e+01
2.600000000e+00 1.783466341e+01
2.600000000e+00 1.735794322e+01
e
$u0_1 << e
0.000000000e+00 3.507018004e+00
1.500000000e+00 3.667826749e+00
1.500000000e+00 1.611608553e+00
2.600000000e+00 1.473323773e+00
2.600000000e+00 3.128182876e+00
4.200000000e+00 3.095883526e+00
e
$u1_0 << e
0.000000000e+00 3.373674898e-01
1.500000000e+00 4.640668776e+00
1.500000000e+00 1.205111118e+01
2.600000000e+00 9.066545288e+00
2.600000000e+00 6.028799950e+00
e
$u2_0 << e
0.000000000e+00 3.989736844e-01
1.500000000e+00 5.120750097e-01
1.500000000e+00 2.161675162e+00
2.600000000e+00 1.780755865e+00
2.600000000e+00 8.361892766e-02
4.200000000e+00 1.103990411e+00
e
$u3_0 << e
0.000000000e+00 3.373674898e-01
1.500000000e+00 4.355667328e+00
1.500000000e+00 1.145060671e+01
2.600000000e+00 8.666247031e+00
2.600000000e+00 5.628501693e+00
e
$u4_0 << e
0.000000000e+00 1.963566839e-02
1.500000000e+00 2.700990343e-01
1.500000000e+00 7.014061225e-01
2.600000000e+00 5.276965982e-01
2.600000000e+00 3.508918914e-01
e
$u4_1 << e
0.000000000e+00 4.544708219e-02
1.500000000e+00 5.833045127e-02
1.500000000e+00 2.462363625e-01
2.600000000e+00 2.028458551e-01
2.600000000e+00 9.525029914e-03
4.200000000e+00 1.257555196e-01
e
$u5_0 << e
0.000000000e+00 1.683571133e+00
1.500000000e+00 1.771614323e+00
1.500000000e+00 6.978966167e-01
2.600000000e+00 6.132330284e-01
2.600000000e+00 1.646439323e+00
4.200000000e+00 1.629487693e+00
e
set arrow from screen 0.408508,0.366818 to screen 0.408508,0.366642 nohead lw 1 lc rgb '#202020'
set object circle at 1.500000000e+00,2.225568151e+01 size screen 0.008 front fs empty border lc rgb '#202020' lw 1.4
set label '22.3 %: yield at s = 1.5+ m, fibre -z' at screen 0.418185,0.383448 left noenhanced front tc rgb '#0b5fa5'
plot 100 with lines lw 1.3 dt (6,3) lc rgb '#202020' notitle, $u0_0 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $u0_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#0b5fa5' notitle, $u1_0 using 1:2 with lines lw 1.6 dt (9,4) lc rgb '#c8500a' notitle, $u1_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#c8500a' notitle, $u2_0 using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $u2_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#00785a' notitle, $u3_0 using 1:2 with lines lw 1.6 dt (9,3,2,3) lc rgb '#a04f86' notitle, $u3_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#a04f86' notitle, $u4_0 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with lines lw 1.6 dt (14,4) lc rgb '#8a6d00' notitle, $u4_1 using 1:2 with points pt 7 ps 0.3 lc rgb '#8a6d00' notitle, $u5_0 using 1:2 with lines lw 1.6 dt (2,5) lc rgb '#4a4a4a' notitle, $u5_0 using 1:2 with points pt 7 ps 0.3 lc rgb '#4a4a4a' notitle
unset label
unset arrow
unset object
unset multiplot
