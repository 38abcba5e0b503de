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
set xrange [-5.641151739e+00:5.270024792e+00]
set yrange [-5.104553495e+00:1.997155174e+00]
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
0.000000000e+00 1.387778781e-17
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
-1.886879803e+00 -2.086109326e+00
-1.273759606e+00 -1.572218653e+00
e
$at1_1 << e
-1.886879803e+00 -2.086109326e+00
-2.459142537e+00 4.501310729e-01
e
$at1_2_axis << e
-2.459142537e+00 4.501310729e-01 5.508479283e+00 -1.008293603e+00
e
$at1_2 << e
-2.459142537e+00 4.501310729e-01
-2.775557562e-17 0.000000000e+00
3.049336746e+00 -5.581625304e-01
e
$at1_3 << e
3.049336746e+00 -5.581625304e-01
3.344433850e+00 -6.121782592e-01
e
$at1_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.521622162e+00,7.373500839e-01 to -2.459142537e+00,4.501310729e-01 lw 2 lc rgb '#202020' front
set label 1 'T  54.58 kN' at -2.521622162e+00,7.373500839e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 3.517640906e-02,-5.541693451e-01 to -2.775557562e-17,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 2 'S  103.1 kN' at 3.517640906e-02,-5.541693451e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.076706795e+00,-3.628912231e-01 to 3.049336746e+00,-5.581625304e-01 lw 2 lc rgb '#202020' front
set label 3 'H  36.61 kN' at 3.076706795e+00,-3.628912231e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 2.7077 s\nleast negative stress"
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
0.000000000e+00 1.387778781e-17
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
-3.109487781e+00 -2.081806364e+00
-3.718975563e+00 -1.563612728e+00
e
$at2_1 << e
-3.109487781e+00 -2.081806364e+00
-2.461653394e+00 4.361909765e-01
e
$at2_2_axis << e
-2.461653394e+00 4.361909765e-01 5.514103602e+00 -9.770677875e-01
e
$at2_2 << e
-2.461653394e+00 4.361909765e-01
0.000000000e+00 0.000000000e+00
3.052450209e+00 -5.408768109e-01
e
$at2_3 << e
3.052450209e+00 -5.408768109e-01
3.347848616e+00 -5.932197281e-01
e
$at2_grounds << e
-2.500000000e+00 -2.600000000e+00
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.311089692e+00,1.031220736e+00 to -2.461653394e+00,4.361909765e-01 lw 2 lc rgb '#202020' front
set label 1 'T  114.0 kN' at -2.311089692e+00,1.031220736e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -2.208435679e-01,-1.108914884e+00 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 2 'S  210.0 kN' at -2.208435679e-01,-1.108914884e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.122788728e+00,-9.864413551e-02 to 3.052450209e+00,-5.408768109e-01 lw 2 lc rgb '#202020' front
set label 3 'H  83.15 kN' at 3.122788728e+00,-9.864413551e-02 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 4.7839 s\nlargest M, most negative stress"
plot $rest2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
