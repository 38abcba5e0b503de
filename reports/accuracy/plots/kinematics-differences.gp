# Redraw in the folder above: gnuplot plots/kinematics-differences.gp; as PDF: gnuplot -e 'pdf = 1' plots/kinematics-differences.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.6613 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'kinematics-differences.pdf'
} else {
  set terminal svg size 620,540 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'kinematics-differences.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Accelerations by differences of positions' at screen 0.0193548,0.971296 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s' at screen 0.0193548,0.939815 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed-form dyads in long double' at screen 0.0193548,0.912037 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of accelerations, relative' at screen 0.0193548,0.873148 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.194444 to screen 0.243387,0.194444 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.219194,0.194444 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'differences of order 2' at screen 0.25629,0.194444 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.161111 to screen 0.243387,0.161111 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.219194,0.161111 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'differences of order 4' at screen 0.25629,0.161111 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.127778 to screen 0.243387,0.127778 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.219194,0.127778 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, from the equations of motion' at screen 0.25629,0.127778 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.0944444 to screen 0.243387,0.0944444 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.25629,0.0944444 left noenhanced front tc rgb '#202020'
set arrow from screen 0.195,0.0611111 to screen 0.243387,0.0611111 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off, derivatives from the equations: 8.3e-16' at screen 0.25629,0.0611111 left noenhanced front tc rgb '#202020'
set label '' at screen 0.219194,0.0277778 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.25629,0.0277778 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.037037037e-01
set tmargin at screen 8.407407407e-01
set xrange [1.457033861e+01:1.619245827e+05]
set yrange [1.000000000e-16:1.000000000e-01]
set xtics ('' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '3000' 3000, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '' 20000 1, '3·10^{4}' 30000, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '10^{5}' 100000)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'instants per motion' at screen 0.533871,0.240741 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.336628 to screen 0.967742,0.336628 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
2.400000000e+01 1.144442330e-02
4.800000000e+01 2.881760030e-03
9.600000000e+01 7.217383358e-04
1.920000000e+02 1.805158486e-04
3.840000000e+02 4.513407792e-05
7.680000000e+02 1.128414811e-05
1.536000000e+03 2.821399039e-06
3.072000000e+03 7.047174076e-07
6.144000000e+03 1.825935628e-07
1.228800000e+04 9.040293928e-08
2.457600000e+04 5.156668668e-07
4.915200000e+04 2.137737683e-06
9.830400000e+04 7.095191617e-06
e
$p0points0 << e
2.400000000e+01 1.144442330e-02
4.800000000e+01 2.881760030e-03
9.600000000e+01 7.217383358e-04
1.920000000e+02 1.805158486e-04
3.840000000e+02 4.513407792e-05
7.680000000e+02 1.128414811e-05
1.536000000e+03 2.821399039e-06
3.072000000e+03 7.047174076e-07
6.144000000e+03 1.825935628e-07
1.228800000e+04 9.040293928e-08
2.457600000e+04 5.156668668e-07
4.915200000e+04 2.137737683e-06
9.830400000e+04 7.095191617e-06
e
$p0line1_0 << e
2.400000000e+01 4.307225493e-04
4.800000000e+01 2.753893981e-05
9.600000000e+01 1.731104492e-06
1.920000000e+02 1.083528424e-07
3.840000000e+02 6.821037513e-09
7.680000000e+02 8.381673985e-10
1.536000000e+03 2.555626567e-09
3.072000000e+03 9.969327132e-09
6.144000000e+03 5.725497509e-08
1.228800000e+04 1.425166565e-07
2.457600000e+04 6.626670346e-07
4.915200000e+04 2.678427956e-06
9.830400000e+04 8.747676262e-06
e
$p0points1 << e
2.400000000e+01 4.307225493e-04
4.800000000e+01 2.753893981e-05
9.600000000e+01 1.731104492e-06
1.920000000e+02 1.083528424e-07
3.840000000e+02 6.821037513e-09
7.680000000e+02 8.381673985e-10
1.536000000e+03 2.555626567e-09
3.072000000e+03 9.969327132e-09
6.144000000e+03 5.725497509e-08
1.228800000e+04 1.425166565e-07
2.457600000e+04 6.626670346e-07
4.915200000e+04 2.678427956e-06
9.830400000e+04 8.747676262e-06
e
$p0line2_0 << e
2.400000000e+01 2.533307343e-15
9.600000000e+01 8.309989396e-16
e
$p0points2 << e
2.400000000e+01 2.533307343e-15
9.600000000e+01 8.309989396e-16
e
set label 'default' at screen 0.288518,0.356924 left noenhanced front tc rgb '#202020'
$p0default << e
9.600000000e+01 8.309989396e-16
e
set arrow from screen 0.459465,0.681482 to screen 0.533805,0.656663 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.4067,0.652704 left noenhanced front tc rgb '#404040'
set arrow from screen 0.330079,0.610408 to screen 0.397004,0.565722 nohead lw 1 lc rgb '#404040'
set label 'order 4' at screen 0.273606,0.571697 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line2_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
