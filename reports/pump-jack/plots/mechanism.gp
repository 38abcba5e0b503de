# Redraw with: gnuplot mechanism.gp
set terminal svg size 900,1346 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
set output 'mechanism.svg'
set encoding utf8
set border 3 lc rgb '#505050'
set tics out nomirror
set grid lc rgb '#e2e2e2' lw 0.7 lt 1
set key noenhanced samplen 2.5 spacing 1.2
set multiplot layout 2,1 title 'Mechanism at its critical instants, forces on the beam; grey: t = 0.0000 s' noenhanced
set size ratio -1
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
set xrange [-5.641151719e+00:5.270024785e+00]
set yrange [-5.104553493e+00:1.997155171e+00]
$rest1_0 << e
-2.500000000e+00 -2.600000000e+00
-2.500000000e+00 -3.400000000e+00
-2.500000000e+00 -4.200000000e+00
e
$rest1_1 << e
-2.500000000e+00 -3.400000000e+00
-2.367398321e+00 -8.033835873e-01
e
$rest1_2_axis << e
-2.367398321e+00 -8.033835873e-01 5.302972240e+00 1.799579236e+00
e
$rest1_2 << e
-2.367398321e+00 -8.033835873e-01
0.000000000e+00 0.000000000e+00
2.935573918e+00 9.961956482e-01
e
$rest1_3 << e
2.935573918e+00 9.961956482e-01
3.219661717e+00 1.092601679e+00
e
$rest1_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
$at1_0 << e
-2.500000000e+00 -2.600000000e+00
-1.886918059e+00 -2.086063688e+00
-1.273836117e+00 -1.572127375e+00
e
$at1_1 << e
-1.886918059e+00 -2.086063688e+00
-2.459132175e+00 4.501876812e-01
e
$at1_2_axis << e
-2.459132175e+00 4.501876812e-01 5.508456071e+00 -1.008420406e+00
e
$at1_2 << e
-2.459132175e+00 4.501876812e-01
2.775557562e-17 0.000000000e+00
3.049323896e+00 -5.582327246e-01
e
$at1_3 << e
3.049323896e+00 -5.582327246e-01
3.344419757e+00 -6.122552464e-01
e
$at1_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.521606729e+00,7.374087551e-01 to -2.459132175e+00,4.501876812e-01 lw 2 lc rgb '#202020' front
set label 1 'T  54.58 kN' at -2.521606729e+00,7.374087551e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 3.516760843e-02,-5.541711175e-01 to 2.775557562e-17,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 2 'S  103.1 kN' at 3.516760843e-02,-5.541711175e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.076697651e+00,-3.629617575e-01 to 3.049323896e+00,-5.582327246e-01 lw 2 lc rgb '#202020' front
set label 3 'H  36.61 kN' at 3.076697651e+00,-3.629617575e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 2.7078 s\nleast negative stress"
plot $rest1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_0 << e
-2.500000000e+00 -2.600000000e+00
-2.500000000e+00 -3.400000000e+00
-2.500000000e+00 -4.200000000e+00
e
$rest2_1 << e
-2.500000000e+00 -3.400000000e+00
-2.367398321e+00 -8.033835873e-01
e
$rest2_2_axis << e
-2.367398321e+00 -8.033835873e-01 5.302972240e+00 1.799579236e+00
e
$rest2_2 << e
-2.367398321e+00 -8.033835873e-01
0.000000000e+00 0.000000000e+00
2.935573918e+00 9.961956482e-01
e
$rest2_3 << e
2.935573918e+00 9.961956482e-01
3.219661717e+00 1.092601679e+00
e
$rest2_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
$at2_0 << e
-2.500000000e+00 -2.600000000e+00
-3.109487774e+00 -2.081806355e+00
-3.718975547e+00 -1.563612710e+00
e
$at2_1 << e
-3.109487774e+00 -2.081806355e+00
-2.461653392e+00 4.361909871e-01
e
$at2_2_axis << e
-2.461653392e+00 4.361909871e-01 5.514103598e+00 -9.770678111e-01
e
$at2_2 << e
-2.461653392e+00 4.361909871e-01
-2.775557562e-17 0.000000000e+00
3.052450206e+00 -5.408768240e-01
e
$at2_3 << e
3.052450206e+00 -5.408768240e-01
3.347848613e+00 -5.932197425e-01
e
$at2_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.311089692e+00,1.031220745e+00 to -2.461653392e+00,4.361909871e-01 lw 2 lc rgb '#202020' front
set label 1 'T  114.0 kN' at -2.311089692e+00,1.031220745e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -2.208435676e-01,-1.108914881e+00 to -2.775557562e-17,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 2 'S  210.0 kN' at -2.208435676e-01,-1.108914881e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.122788727e+00,-9.864414996e-02 to 3.052450206e+00,-5.408768240e-01 lw 2 lc rgb '#202020' front
set label 3 'H  83.15 kN' at 3.122788727e+00,-9.864414996e-02 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 4.7839 s\nlargest M, most negative stress"
plot $rest2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
