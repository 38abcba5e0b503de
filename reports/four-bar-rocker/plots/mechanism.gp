# Redraw with: gnuplot mechanism.gp
set terminal svg size 1460,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-1.044281944e+00:2.922876310e+00]
set yrange [-1.575742095e+00:2.111227216e+00]
$rest1_0 << e
0.000000000e+00 0.000000000e+00
2.500000000e-01 0.000000000e+00
e
$rest1_1 << e
2.500000000e-01 0.000000000e+00
1.749769743e+00 -2.628151778e-02
e
$rest1_2_axis << e
1.500000000e+00 -1.200000000e+00 6.244243573e-01 2.934296206e+00
e
$rest1_2 << e
1.500000000e+00 -1.200000000e+00
1.749769743e+00 -2.628151778e-02
2.124424357e+00 1.734296206e+00
e
$rest1_3 << e
2.124424357e+00 1.734296206e+00
e
$rest1_grounds << e
0.000000000e+00 0.000000000e+00
1.500000000e+00 -1.200000000e+00
e
$at1_0 << e
0.000000000e+00 0.000000000e+00
-2.458299911e-01 4.547103990e-02
e
$at1_1 << e
-2.458299911e-01 4.547103990e-02
1.252475582e+00 -2.580595194e-02
e
$at1_2_axis << e
1.500000000e+00 -1.200000000e+00 -6.188110450e-01 2.935485120e+00
e
$at1_2 << e
1.500000000e+00 -1.200000000e+00
1.252475582e+00 -2.580595194e-02
8.811889550e-01 1.735485120e+00
e
$at1_3 << e
8.811889550e-01 1.735485120e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
1.500000000e+00 -1.200000000e+00
e
set arrow 1 from 8.973856826e-01,-3.747220152e-03 to 1.252475582e+00,-2.580595194e-02 lw 2 lc rgb '#202020' front
set label 1 'B  29.19 kN' at 8.973856826e-01,-3.747220152e-03 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 1.731120248e+00,-1.333688068e+00 to 1.500000000e+00,-1.200000000e+00 lw 2 lc rgb '#202020' front
set label 2 'C  21.90 kN' at 1.731120248e+00,-1.333688068e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 9.809663251e-01,1.811041161e+00 to 8.811889550e-01,1.735485120e+00 lw 2 lc rgb '#202020' front
set label 3 'D  10.27 kN' at 9.809663251e-01,1.811041161e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.5232 s\nmost negative M, largest stress"
plot $rest1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_3 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_3 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_0 << e
0.000000000e+00 0.000000000e+00
2.500000000e-01 0.000000000e+00
e
$rest2_1 << e
2.500000000e-01 0.000000000e+00
1.749769743e+00 -2.628151778e-02
e
$rest2_2_axis << e
1.500000000e+00 -1.200000000e+00 6.244243573e-01 2.934296206e+00
e
$rest2_2 << e
1.500000000e+00 -1.200000000e+00
1.749769743e+00 -2.628151778e-02
2.124424357e+00 1.734296206e+00
e
$rest2_3 << e
2.124424357e+00 1.734296206e+00
e
$rest2_grounds << e
0.000000000e+00 0.000000000e+00
1.500000000e+00 -1.200000000e+00
e
$at2_0 << e
0.000000000e+00 0.000000000e+00
2.493074634e-01 -1.859539432e-02
e
$at2_1 << e
2.493074634e-01 -1.859539432e-02
1.749288292e+00 -2.617916724e-02
e
$at2_2_axis << e
1.500000000e+00 -1.200000000e+00 6.232207302e-01 2.934552082e+00
e
$at2_2 << e
1.500000000e+00 -1.200000000e+00
1.749288292e+00 -2.617916724e-02
2.123220730e+00 1.734552082e+00
e
$at2_3 << e
2.123220730e+00 1.734552082e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
1.500000000e+00 -1.200000000e+00
e
set arrow 1 from 2.218955515e+00,-2.305419820e-02 to 1.749288292e+00,-2.617916724e-02 lw 2 lc rgb '#202020' front
set label 1 'B  38.53 kN' at 2.218955515e+00,-2.305419820e-02 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 1.200962195e+00,-1.325307617e+00 to 1.500000000e+00,-1.200000000e+00 lw 2 lc rgb '#202020' front
set label 2 'C  26.60 kN' at 1.200962195e+00,-1.325307617e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.985889098e+00,1.818601989e+00 to 2.123220730e+00,1.734552082e+00 lw 2 lc rgb '#202020' front
set label 3 'D  13.21 kN' at 1.985889098e+00,1.818601989e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0979 s\nlargest M, most negative stress"
plot $rest2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_3 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
