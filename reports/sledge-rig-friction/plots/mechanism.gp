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
set xrange [-1.952849492e+00:2.637516964e+00]
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
2.536878566e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
-7.753963204e-02 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at1_0_axis << e
-2.664494921e-01 -3.188887685e+00 5.162458910e-01 6.178469890e+00
e
$at1_0 << e
-2.664494921e-01 -3.188887685e+00
-6.071532166e-18 0.000000000e+00
2.497963989e-01 2.989582205e+00
e
$at1_1 << e
2.497963989e-01 2.989582205e+00
7.496878566e-01 3.000000000e+00
e
$at1_2 << e
7.496878566e-01 3.000000000e+00
e
$at1_3 << e
-2.664494921e-01 -3.188887685e+00
4.184603680e-01 -3.200000000e+00
e
$at1_4 << e
4.184603680e-01 -3.200000000e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -9.683789477e-01,-2.151887860e-01 to -6.071532166e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  233.5 kN' at -9.683789477e-01,-2.151887860e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 7.649163447e-01,3.002891558e+00 to 2.497963989e-01,2.989582205e+00 lw 2 lc rgb '#202020' front
set label 2 'B  121.3 kN' at 7.649163447e-01,3.002891558e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.846240718e-01,-3.193082524e+00 to -2.664494921e-01,-3.188887685e+00 lw 2 lc rgb '#202020' front
set label 3 'C  106.2 kN' at 1.846240718e-01,-3.193082524e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3685 s\nmost negative M, most negative stress"
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
-2.456769984e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
4.551169639e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at2_0_axis << e
2.662067753e-01 -3.188907956e+00 -5.157756271e-01 6.178509165e+00
e
$at2_0 << e
2.662067753e-01 -3.188907956e+00
-6.071532166e-18 0.000000000e+00
-2.495688518e-01 2.989601209e+00
e
$at2_1 << e
-2.495688518e-01 2.989601209e+00
2.503230016e-01 3.000000000e+00
e
$at2_2 << e
2.503230016e-01 3.000000000e+00
e
$at2_3 << e
2.662067753e-01 -3.188907956e+00
9.511169639e-01 -3.200000000e+00
e
$at2_4 << e
9.511169639e-01 -3.200000000e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 9.584828554e-01,-2.083432263e-01 to -6.071532166e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  230.9 kN' at 9.584828554e-01,-2.083432263e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -7.580404734e-01,2.981546994e+00 to -2.495688518e-01,2.989601209e+00 lw 2 lc rgb '#202020' front
set label 2 'B  119.7 kN' at -7.580404734e-01,2.981546994e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -1.816266447e-01,-3.178585603e+00 to 2.662067753e-01,-3.188907956e+00 lw 2 lc rgb '#202020' front
set label 3 'C  105.5 kN' at -1.816266447e-01,-3.178585603e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0830 s\nlargest M, largest stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
