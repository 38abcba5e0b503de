# Redraw with: gnuplot mechanism.gp
set terminal svg size 1118,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
set output 'mechanism.svg'
set encoding utf8
set border 3 lc rgb '#505050'
set tics out nomirror
set grid lc rgb '#e2e2e2' lw 0.7 lt 1
set key noenhanced samplen 2.5 spacing 1.2
set multiplot layout 1,2 title 'Mechanism at its critical instants, forces on the beam; grey: t = 0.0000 s' noenhanced
set size ratio -1
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
set xrange [-2.638092434e+00:2.436400000e+00]
set yrange [-3.993600000e+00:3.793600000e+00]
$rest1_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
-1.181000000e+00 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest1_0 << e
-1.012409546e-16 0.000000000e+00
8.245606528e-17 3.000000000e+00
e
$rest1_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest1_2 << e
5.000000000e-01 3.000000000e+00
e
$rest1_3 << e
9.434795343e-17 0.000000000e+00
-4.934825102e-16 -3.200000000e+00
e
$rest1_4 << e
-3.885780586e-16 -3.200000000e+00
-6.850000000e-01 -3.200000000e+00
e
$rest1_5 << e
-6.850000000e-01 -3.200000000e+00
e
$rest1_grounds << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 0.000000000e+00
e
$at1_guides << e
2.540000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
-1.447692434e+00 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at1_0 << e
-4.163336342e-17 0.000000000e+00
2.501090878e-01 2.989556061e+00
e
$at1_1 << e
2.501090878e-01 2.989556061e+00
7.500000000e-01 3.000000000e+00
e
$at1_2 << e
7.500000000e-01 3.000000000e+00
e
$at1_3 << e
-5.273559367e-16 2.220446049e-16
-2.667830269e-01 -3.188859799e+00
e
$at1_4 << e
-2.667830269e-01 -3.188859799e+00
-9.516924340e-01 -3.200000000e+00
e
$at1_5 << e
-9.516924340e-01 -3.200000000e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 7.481051033e-01,2.987200152e+00 to 2.501090878e-01,2.989556061e+00 lw 2 lc rgb '#202020' front
set label 1 'B  102.7 kN' at 7.481051033e-01,2.987200152e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 1.993855940e-01,-3.188552998e+00 to -2.667830269e-01,-3.188859799e+00 lw 2 lc rgb '#202020' front
set label 2 'C  96.16 kN' at 1.993855940e-01,-3.188552998e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -9.641646365e-01,-2.333464242e-01 to -5.273559367e-16,2.220446049e-16 lw 2 lc rgb '#202020' front
set label 3 'O  204.6 kN' at -9.641646365e-01,-2.333464242e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3573 s\nmost negative M"
plot $rest1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_4 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_5 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_4 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_5 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
-1.181000000e+00 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest2_0 << e
-1.012409546e-16 0.000000000e+00
8.245606528e-17 3.000000000e+00
e
$rest2_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest2_2 << e
5.000000000e-01 3.000000000e+00
e
$rest2_3 << e
9.434795343e-17 0.000000000e+00
-4.934825102e-16 -3.200000000e+00
e
$rest2_4 << e
-3.885780586e-16 -3.200000000e+00
-6.850000000e-01 -3.200000000e+00
e
$rest2_5 << e
-6.850000000e-01 -3.200000000e+00
e
$rest2_grounds << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 0.000000000e+00
e
$at2_guides << e
-2.460000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
-9.143590109e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at2_0 << e
9.714451465e-17 0.000000000e+00
-2.498912924e-01 2.989574274e+00
e
$at2_1 << e
-2.498912924e-01 2.989574274e+00
2.500000000e-01 3.000000000e+00
e
$at2_2 << e
2.500000000e-01 3.000000000e+00
e
$at2_3 << e
-3.747002708e-16 2.220446049e-16
2.665507119e-01 -3.188879226e+00
e
$at2_4 << e
2.665507119e-01 -3.188879226e+00
-4.183590109e-01 -3.200000000e+00
e
$at2_5 << e
-4.183590109e-01 -3.200000000e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -7.477891667e-01,2.987228634e+00 to -2.498912924e-01,2.989574274e+00 lw 2 lc rgb '#202020' front
set label 1 'B  102.7 kN' at -7.477891667e-01,2.987228634e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -1.996306896e-01,-3.188573763e+00 to 2.665507119e-01,-3.188879226e+00 lw 2 lc rgb '#202020' front
set label 2 'C  96.16 kN' at -1.996306896e-01,-3.188573763e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 9.640792758e-01,-2.333553562e-01 to -3.747002708e-16,2.220446049e-16 lw 2 lc rgb '#202020' front
set label 3 'O  204.6 kN' at 9.640792758e-01,-2.333553562e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0720 s\nlargest M"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_5 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_5 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
