# Redraw with: gnuplot mechanism.gp
set terminal svg size 946,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-1.729066743e+00:2.414066532e+00]
set yrange [-3.993600000e+00:3.793600000e+00]
$rest1_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest1_0_axis << e
-1.933437190e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest1_0 << e
-1.933437190e-16 -3.200000000e+00
2.599768912e-18 0.000000000e+00
1.862967888e-16 3.000000000e+00
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
4.400000000e-02 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.463331984e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at1_0_axis << e
-4.266674253e-02 -3.199715542e+00 8.266681364e-02 6.199448862e+00
e
$at1_0 << e
-4.266674253e-02 -3.199715542e+00
3.035766083e-18 0.000000000e+00
4.000007112e-02 2.999733321e+00
e
$at1_1 << e
4.000007112e-02 2.999733321e+00
5.400000000e-01 3.000000000e+00
e
$at1_2 << e
5.400000000e-01 3.000000000e+00
e
$at1_3 << e
-4.266674253e-02 -3.199715542e+00
6.423331984e-01 -3.200000000e+00
e
$at1_4 << e
6.423331984e-01 -3.200000000e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -8.815048791e-01,-4.549869757e-01 to 3.035766083e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  14.80 kN' at -8.815048791e-01,-4.549869757e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 5.019933916e-01,3.039181671e+00 to 4.000007112e-02,2.999733321e+00 lw 2 lc rgb '#202020' front
set label 2 'B  6.916 kN' at 5.019933916e-01,3.039181671e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.752779624e-01,-3.149613667e+00 to -4.266674253e-02,-3.199715542e+00 lw 2 lc rgb '#202020' front
set label 3 'C  6.278 kN' at 3.752779624e-01,-3.149613667e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.2778 s\nmost negative M, most negative stress"
plot $rest1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest2_0_axis << e
-1.933437190e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest2_0 << e
-1.933437190e-16 -3.200000000e+00
2.599768912e-18 0.000000000e+00
1.862967888e-16 3.000000000e+00
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
-3.600000000e-02 3.000000000e+00 9.920000000e-01 0.000000000e+00
2.316665317e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at2_0_axis << e
4.266659081e-02 -3.199715544e+00 -8.266651969e-02 6.199448866e+00
e
$at2_0 << e
4.266659081e-02 -3.199715544e+00
-3.252606517e-19 0.000000000e+00
-3.999992888e-02 2.999733322e+00
e
$at2_1 << e
-3.999992888e-02 2.999733322e+00
4.600000000e-01 3.000000000e+00
e
$at2_2 << e
4.600000000e-01 3.000000000e+00
e
$at2_3 << e
4.266659081e-02 -3.199715544e+00
7.276665317e-01 -3.200000000e+00
e
$at2_4 << e
7.276665317e-01 -3.200000000e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 8.815015275e-01,-4.548294395e-01 to -3.252606517e-19,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  14.79 kN' at 8.815015275e-01,-4.548294395e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -5.019858550e-01,3.038683417e+00 to -3.999992888e-02,2.999733322e+00 lw 2 lc rgb '#202020' front
set label 2 'B  6.915 kN' at -5.019858550e-01,3.038683417e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -3.752818751e-01,-3.149272946e+00 to 4.266659081e-02,-3.199715544e+00 lw 2 lc rgb '#202020' front
set label 3 'C  6.279 kN' at -3.752818751e-01,-3.149272946e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.8333 s\nlargest M, largest stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
