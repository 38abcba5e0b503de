# Redraw with: gnuplot mechanism.gp
set terminal svg size 988,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-1.846415025e+00:2.531373297e+00]
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
1.540000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
2.897327741e-02 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at1_0_axis << e
-1.600150246e-01 -3.195996745e+00 3.100291102e-01 6.192243693e+00
e
$at1_0 << e
-1.600150246e-01 -3.195996745e+00
2.168404345e-18 0.000000000e+00
1.500140856e-01 2.996246948e+00
e
$at1_1 << e
1.500140856e-01 2.996246948e+00
6.500000000e-01 3.000000000e+00
e
$at1_2 << e
6.500000000e-01 3.000000000e+00
e
$at1_3 << e
-1.600150246e-01 -3.195996745e+00
5.249732774e-01 -3.200000000e+00
e
$at1_4 << e
5.249732774e-01 -3.200000000e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -9.825476455e-01,-1.366167058e-01 to 2.168404345e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  49.66 kN' at -9.825476455e-01,-1.366167058e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 6.651784170e-01,3.012013634e+00 to 1.500140856e-01,2.996246948e+00 lw 2 lc rgb '#202020' front
set label 2 'B  25.80 kN' at 6.651784170e-01,3.012013634e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 3.056517633e-01,-3.183954542e+00 to -1.600150246e-01,-3.195996745e+00 lw 2 lc rgb '#202020' front
set label 3 'C  23.32 kN' at 3.056517633e-01,-3.183954542e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
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
-1.460000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
3.489732975e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at2_0_axis << e
1.599849866e-01 -3.195998248e+00 -3.099709116e-01 6.192246606e+00
e
$at2_0 << e
1.599849866e-01 -3.195998248e+00
-3.035766083e-18 0.000000000e+00
-1.499859250e-01 2.996248358e+00
e
$at2_1 << e
-1.499859250e-01 2.996248358e+00
3.500000000e-01 3.000000000e+00
e
$at2_2 << e
3.500000000e-01 3.000000000e+00
e
$at2_3 << e
1.599849866e-01 -3.195998248e+00
8.449732975e-01 -3.200000000e+00
e
$at2_4 << e
8.449732975e-01 -3.200000000e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 9.823555082e-01,-1.341435902e-01 to -3.035766083e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  49.63 kN' at 9.823555082e-01,-1.341435902e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -6.647175467e-01,3.004200004e+00 to -1.499859250e-01,2.996248358e+00 lw 2 lc rgb '#202020' front
set label 2 'B  25.77 kN' at -6.647175467e-01,3.004200004e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -3.059057184e-01,-3.178613299e+00 to 1.599849866e-01,-3.195998248e+00 lw 2 lc rgb '#202020' front
set label 3 'C  23.34 kN' at -3.059057184e-01,-3.178613299e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.8333 s\nlargest M, largest stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
