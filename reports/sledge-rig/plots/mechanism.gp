# Redraw with: gnuplot mechanism.gp
set terminal svg size 1028,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-1.953183027e+00:2.637860435e+00]
set yrange [-3.993600000e+00:3.793600000e+00]
$rest1_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest1_0_axis << e
-1.924565389e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest1_0 << e
-1.924565389e-16 -3.200000000e+00
3.486948934e-18 0.000000000e+00
1.871839688e-16 3.000000000e+00
e
$rest1_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest1_2 << e
5.000000000e-01 3.000000000e+00
e
$rest1_3 << e
0.000000000e+00 -3.200000000e+00
6.850000000e-01 -3.200000000e+00
e
$rest1_4 << e
6.850000000e-01 -3.200000000e+00
e
$rest1_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_guides << e
2.540000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
-7.787361985e-02 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at1_0_axis << e
-2.667830269e-01 -3.188859799e+00 5.168921147e-01 6.178415860e+00
e
$at1_0 << e
-2.667830269e-01 -3.188859799e+00
2.602085214e-18 0.000000000e+00
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
-2.667830269e-01 -3.188859799e+00
4.181263802e-01 -3.200000000e+00
e
$at1_4 << e
4.181263802e-01 -3.200000000e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -9.642250911e-01,-2.330964900e-01 to 2.602085214e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  215.4 kN' at -9.642250911e-01,-2.330964900e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 7.643337249e-01,3.003091269e+00 to 2.501090878e-01,2.989556061e+00 lw 2 lc rgb '#202020' front
set label 2 'B  111.7 kN' at 7.643337249e-01,3.003091269e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.808446407e-01,-3.192753888e+00 to -2.667830269e-01,-3.188859799e+00 lw 2 lc rgb '#202020' front
set label 3 'C  97.18 kN' at 1.808446407e-01,-3.192753888e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3571 s\nmost negative M, most negative stress"
plot $rest1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest2_0_axis << e
-1.924565389e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest2_0 << e
-1.924565389e-16 -3.200000000e+00
3.486948934e-18 0.000000000e+00
1.871839688e-16 3.000000000e+00
e
$rest2_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest2_2 << e
5.000000000e-01 3.000000000e+00
e
$rest2_3 << e
0.000000000e+00 -3.200000000e+00
6.850000000e-01 -3.200000000e+00
e
$rest2_4 << e
6.850000000e-01 -3.200000000e+00
e
$rest2_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_guides << e
-2.460000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
4.554604347e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at2_0_axis << e
2.665507119e-01 -3.188879226e+00 -5.164420044e-01 6.178453500e+00
e
$at2_0 << e
2.665507119e-01 -3.188879226e+00
-4.336808690e-18 0.000000000e+00
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
2.665507119e-01 -3.188879226e+00
9.514604347e-01 -3.200000000e+00
e
$at2_4 << e
9.514604347e-01 -3.200000000e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 9.552986758e-01,-2.261472187e-01 to -4.336808690e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  213.1 kN' at 9.552986758e-01,-2.261472187e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -7.579636361e-01,2.981714069e+00 to -2.498912924e-01,2.989574274e+00 lw 2 lc rgb '#202020' front
set label 2 'B  110.3 kN' at -7.579636361e-01,2.981714069e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -1.783111033e-01,-3.178328039e+00 to 2.665507119e-01,-3.188879226e+00 lw 2 lc rgb '#202020' front
set label 3 'C  96.60 kN' at -1.783111033e-01,-3.178328039e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0714 s\nlargest M, largest stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
