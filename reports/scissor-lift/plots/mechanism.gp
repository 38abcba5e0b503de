# Redraw with: gnuplot mechanism.gp
set terminal svg size 900,1454 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-6.800000000e-01:3.180000000e+00]
set yrange [-7.200000000e-01:2.044921176e+00]
$rest1_guides << e
2.101114336e+00 6.818158198e-01 4.000000000e-01 0.000000000e+00
2.101114336e+00 1.110223025e-16 4.000000000e-01 0.000000000e+00
e
$rest1_rods << e
1.040828313e+00 1.832387043e-01 -1.408283130e-01 -5.832387043e-01
e
$rest1_0_axis << e
0.000000000e+00 0.000000000e+00 2.301114336e+00 6.818158198e-01
1.006737522e+00 2.982944212e-01 3.409079099e-02 -1.150557168e-01
e
$rest1_0 << e
0.000000000e+00 0.000000000e+00
1.040828313e+00 1.832387043e-01
1.150557168e+00 3.409079099e-01
2.301114336e+00 6.818158198e-01
e
$rest1_1 << e
2.301114336e+00 1.110223025e-16
1.150557168e+00 3.409079099e-01
0.000000000e+00 6.818158198e-01
e
$rest1_2 << e
0.000000000e+00 6.818158198e-01
2.500000000e+00 6.818158198e-01
1.500000000e+00 8.318158198e-01
e
$rest1_grounds << e
0.000000000e+00 0.000000000e+00
9.000000000e-01 -4.000000000e-01
e
$at1_guides << e
2.100497999e+00 6.838925040e-01 4.000000000e-01 0.000000000e+00
2.100497999e+00 0.000000000e+00 4.000000000e-01 0.000000000e+00
e
$at1_rods << e
1.040662500e+00 1.841780705e-01 -1.406624997e-01 -5.841780705e-01
e
$at1_0_axis << e
2.220446049e-16 -5.551115123e-17 2.300497999e+00 6.838925040e-01
1.006467875e+00 2.992029705e-01 3.419462520e-02 -1.150248999e-01
e
$at1_0 << e
2.220446049e-16 -5.551115123e-17
1.040662500e+00 1.841780705e-01
1.150248999e+00 3.419462520e-01
2.300497999e+00 6.838925040e-01
e
$at1_1 << e
2.300497999e+00 0.000000000e+00
1.150248999e+00 3.419462520e-01
2.220446049e-16 6.838925040e-01
e
$at1_2 << e
0.000000000e+00 6.838925040e-01
2.500000000e+00 6.838925040e-01
1.500000000e+00 8.338925040e-01
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
9.000000000e-01 -4.000000000e-01
e
set arrow 1 from 9.364104932e-02,1.526954884e-01 to 2.220446049e-16,-5.551115123e-17 lw 2 lc rgb '#202020' front
set label 1 'A  15.96 kN' at 9.364104932e-02,1.526954884e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 1.150247651e+00,4.716456508e-01 to 1.150248999e+00,3.419462520e-01 lw 2 lc rgb '#202020' front
set label 2 'M  11.55 kN' at 1.150247651e+00,4.716456508e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 2.300497999e+00,7.845426727e-01 to 2.300497999e+00,6.838925040e-01 lw 2 lc rgb '#202020' front
set label 3 'C  8.966 kN' at 2.300497999e+00,7.845426727e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 4 from 9.128293259e-01,-8.968238821e-02 to 1.006467875e+00,2.992029705e-01 lw 2 lc rgb '#202020' front
set label 4 'P  35.63 kN' at 9.128293259e-01,-8.968238821e-02 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 10.9327 s\nlargest M, most negative stress"
plot $rest1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_rods using 1:2:3:4 with vectors nohead lw 2 dt 2 lc rgb '#c4c4c4', $rest1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_rods using 1:2:3:4 with vectors nohead lw 2 dt 2 lc rgb '#1f5fa8', $at1_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_guides << e
2.101114336e+00 6.818158198e-01 4.000000000e-01 0.000000000e+00
2.101114336e+00 1.110223025e-16 4.000000000e-01 0.000000000e+00
e
$rest2_rods << e
1.040828313e+00 1.832387043e-01 -1.408283130e-01 -5.832387043e-01
e
$rest2_0_axis << e
0.000000000e+00 0.000000000e+00 2.301114336e+00 6.818158198e-01
1.006737522e+00 2.982944212e-01 3.409079099e-02 -1.150557168e-01
e
$rest2_0 << e
0.000000000e+00 0.000000000e+00
1.040828313e+00 1.832387043e-01
1.150557168e+00 3.409079099e-01
2.301114336e+00 6.818158198e-01
e
$rest2_1 << e
2.301114336e+00 1.110223025e-16
1.150557168e+00 3.409079099e-01
0.000000000e+00 6.818158198e-01
e
$rest2_2 << e
0.000000000e+00 6.818158198e-01
2.500000000e+00 6.818158198e-01
1.500000000e+00 8.318158198e-01
e
$rest2_grounds << e
0.000000000e+00 0.000000000e+00
9.000000000e-01 -4.000000000e-01
e
$at2_guides << e
1.610973023e+00 1.574921176e+00 4.000000000e-01 0.000000000e+00
1.610973023e+00 0.000000000e+00 4.000000000e-01 0.000000000e+00
e
$at2_rods << e
8.710467563e-01 5.984793634e-01 2.895324372e-02 -9.984793634e-01
e
$at2_0_axis << e
0.000000000e+00 1.110223025e-16 1.810973023e+00 1.574921176e+00
7.923006975e-01 6.890280145e-01 7.874605880e-02 -9.054865114e-02
e
$at2_0 << e
0.000000000e+00 1.110223025e-16
8.710467563e-01 5.984793634e-01
9.054865114e-01 7.874605880e-01
1.810973023e+00 1.574921176e+00
e
$at2_1 << e
1.810973023e+00 0.000000000e+00
9.054865114e-01 7.874605880e-01
2.220446049e-16 1.574921176e+00
e
$at2_2 << e
0.000000000e+00 1.574921176e+00
2.500000000e+00 1.574921176e+00
1.500000000e+00 1.724921176e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
9.000000000e-01 -4.000000000e-01
e
set arrow 1 from -2.656051131e-03,2.722608459e-02 to 0.000000000e+00,1.110223025e-16 lw 2 lc rgb '#202020' front
set label 1 'A  2.437 kN' at -2.656051131e-03,2.722608459e-02 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 9.054901056e-01,8.202582816e-01 to 9.054865114e-01,7.874605880e-01 lw 2 lc rgb '#202020' front
set label 2 'M  2.922 kN' at 9.054901056e-01,8.202582816e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.810973023e+00,1.600430974e+00 to 1.810973023e+00,1.574921176e+00 lw 2 lc rgb '#202020' front
set label 3 'C  2.272 kN' at 1.810973023e+00,1.600430974e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 4 from 7.949500820e-01,5.976615394e-01 to 7.923006975e-01,6.890280145e-01 lw 2 lc rgb '#202020' front
set label 4 'P  8.142 kN' at 7.949500820e-01,5.976615394e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 36.0099 s\nleast negative stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_rods using 1:2:3:4 with vectors nohead lw 2 dt 2 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_rods using 1:2:3:4 with vectors nohead lw 2 dt 2 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
