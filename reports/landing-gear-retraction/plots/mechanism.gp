# Redraw with: gnuplot mechanism.gp
set terminal svg size 1120,1275 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
set output 'mechanism.svg'
set encoding utf8
set border 3 lc rgb '#505050'
set tics out nomirror
set grid lc rgb '#e2e2e2' lw 0.7 lt 1
set key noenhanced samplen 2.5 spacing 1.2
set multiplot layout 3,3 margins 0.068,0.985,4.862745098e-02,9.333333333e-01 spacing 0.065,6.901960784e-02 title 'Bodies from the beam''s joint on at the critical instants; forces on the beam, the longest arrow of each row its largest; grey: t = 0.0000 s, retraction' noenhanced
set size ratio -1
unset key
set xtics autofreq
$rest1_02_guides << e
0.000000000e+00 -2.049685012e-02 0.000000000e+00 4.099370024e-02
-5.553105143e-01 -1.094504582e+00 4.106210286e-01 0.000000000e+00
e
$rest1_02_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 -1.094504582e+00
e
$rest1_02_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.094504582e+00
e
$rest1_02_1_lines << e
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 0.000000000e+00
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 -3.283513745e-01
e
$rest1_02_1 << e
0.000000000e+00 -1.094504582e+00
-3.500000000e-01 -1.094504582e+00
-3.500000000e-01 -1.422855956e+00
e
$rest1_02_2 << e
-3.500000000e-01 -1.094504582e+00
e
$rest1_02_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_02_guides << e
1.258793362e-01 -1.619235236e-02 -2.517586724e-01 3.238470473e-02
-8.689914546e-01 4.852057696e-01 0.000000000e+00 -4.085696339e-01
e
$at1_02_0_axis << e
0.000000000e+00 0.000000000e+00 -8.689914546e-01 -6.733050515e-02
e
$at1_02_0 << e
0.000000000e+00 0.000000000e+00
-8.689914546e-01 -6.733050515e-02
e
$at1_02_1_lines << e
-8.689914546e-01 -6.733050515e-02 0.000000000e+00 3.482514578e-01
-8.689914546e-01 -6.733050515e-02 -2.606974364e-01 3.280523063e-01
e
$at1_02_1 << e
-8.689914546e-01 -6.733050515e-02
-8.689914546e-01 2.809209527e-01
-1.129688891e+00 2.607218012e-01
e
$at1_02_2 << e
-8.689914546e-01 2.809209527e-01
e
$at1_02_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.867966492e-03,-4.645274749e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.867966492e-03,-4.645274749e-01 center offset 1.286779527e-02,-8.999927235e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -8.700809362e-01,2.449678647e-01 to -8.689914546e-01,-6.733050515e-02 lw 2 lc rgb '#202020' front
set label 2 'foot' at -8.700809362e-01,2.449678647e-01 center offset -1.116342593e-02,8.999945234e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-2.045931543e+00:8.968524957e-01]
set label 1000 't = 6.0000 s   most negative M_y (retraction)   hinge 1.323 kN, foot 0.8290 kN' at graph 0,1.13 left noenhanced
set title 'seen along y' offset 0,-0.6
plot $rest1_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest1_12_guides << e
-2.042848169e-01 -2.049685012e-02 4.085696339e-01 4.099370024e-02
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
e
$rest1_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.098167583e-01 -1.094504582e+00
e
$rest1_12_0 << e
0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00
e
$rest1_12_1_lines << e
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00 3.294502749e-02 -3.283513745e-01
e
$rest1_12_1 << e
1.098167583e-01 -1.094504582e+00
1.098167583e-01 -1.094504582e+00
1.427617858e-01 -1.422855956e+00
e
$rest1_12_2 << e
1.098167583e-01 -1.094504582e+00
e
$rest1_12_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_12_guides << e
-1.613834184e-01 -1.619235236e-02 3.227668368e-01 3.238470473e-02
-7.264977496e-01 4.852057696e-01 4.099370024e-02 -4.085696339e-01
e
$at1_12_0_axis << e
0.000000000e+00 0.000000000e+00 -6.710592037e-01 -6.733050515e-02
e
$at1_12_0 << e
0.000000000e+00 0.000000000e+00
-6.710592037e-01 -6.733050515e-02
e
$at1_12_1_lines << e
-6.710592037e-01 -6.733050515e-02 -3.494169583e-02 3.482514578e-01
-6.710592037e-01 -6.733050515e-02 -2.362594569e-01 3.280523063e-01
e
$at1_12_1 << e
-6.710592037e-01 -6.733050515e-02
-7.060008995e-01 2.809209527e-01
-9.073186606e-01 2.607218012e-01
e
$at1_12_2 << e
-7.060008995e-01 2.809209527e-01
e
$at1_12_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.183192189e-01,-4.645274749e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -2.183192189e-01,-4.645274749e-01 center offset -1.361111250e+00,-8.145272002e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -5.938926042e-01,2.449678647e-01 to -6.710592037e-01,-6.733050515e-02 lw 2 lc rgb '#202020' front
set label 2 'foot' at -5.938926042e-01,2.449678647e-01 center offset 7.676101897e-01,8.737226962e-01 tc rgb '#202020' front noenhanced
set xlabel 'y [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-1.853670457e+00:1.089113582e+00]
set yrange [-2.045931543e+00:8.968524957e-01]
set title 'seen along x' offset 0,-0.6
plot $rest1_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest1_01_guides << e
0.000000000e+00 -2.042848169e-01 0.000000000e+00 4.085696339e-01
-5.553105143e-01 1.098167583e-01 4.106210286e-01 0.000000000e+00
e
$rest1_01_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 1.098167583e-01
e
$rest1_01_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 1.098167583e-01
e
$rest1_01_1_lines << e
0.000000000e+00 1.098167583e-01 -3.500000000e-01 0.000000000e+00
0.000000000e+00 1.098167583e-01 -3.500000000e-01 3.294502749e-02
e
$rest1_01_1 << e
0.000000000e+00 1.098167583e-01
-3.500000000e-01 1.098167583e-01
-3.500000000e-01 1.427617858e-01
e
$rest1_01_2 << e
-3.500000000e-01 1.098167583e-01
e
$rest1_01_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_01_guides << e
1.258793362e-01 -1.613834184e-01 -2.517586724e-01 3.227668368e-01
-8.689914546e-01 -7.264977496e-01 0.000000000e+00 4.099370024e-02
e
$at1_01_0_axis << e
0.000000000e+00 0.000000000e+00 -8.689914546e-01 -6.710592037e-01
e
$at1_01_0 << e
0.000000000e+00 0.000000000e+00
-8.689914546e-01 -6.710592037e-01
e
$at1_01_1_lines << e
-8.689914546e-01 -6.710592037e-01 0.000000000e+00 -3.494169583e-02
-8.689914546e-01 -6.710592037e-01 -2.606974364e-01 -2.362594569e-01
e
$at1_01_1 << e
-8.689914546e-01 -6.710592037e-01
-8.689914546e-01 -7.060008995e-01
-1.129688891e+00 -9.073186606e-01
e
$at1_01_2 << e
-8.689914546e-01 -7.060008995e-01
e
$at1_01_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.867966492e-03,-2.183192189e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.867966492e-03,-2.183192189e-01 center offset 2.737859735e-02,-8.999670585e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -8.700809362e-01,-5.938926042e-01 to -8.689914546e-01,-6.710592037e-01 lw 2 lc rgb '#202020' front
set label 2 'foot' at -8.700809362e-01,-5.938926042e-01 center offset -4.517490129e-02,8.999103132e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'y [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-1.853670457e+00:1.089113582e+00]
set title 'seen along z' offset 0,-0.6
plot $rest1_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_02_guides << e
0.000000000e+00 -2.049685012e-02 0.000000000e+00 4.099370024e-02
-5.553105143e-01 -1.094504582e+00 4.106210286e-01 0.000000000e+00
e
$rest2_02_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 -1.094504582e+00
e
$rest2_02_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.094504582e+00
e
$rest2_02_1_lines << e
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 0.000000000e+00
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 -3.283513745e-01
e
$rest2_02_1 << e
0.000000000e+00 -1.094504582e+00
-3.500000000e-01 -1.094504582e+00
-3.500000000e-01 -1.422855956e+00
e
$rest2_02_2 << e
-3.500000000e-01 -1.094504582e+00
e
$rest2_02_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_02_guides << e
8.500516161e-02 -1.865750871e-02 -1.700103232e-01 3.731501743e-02
-6.620170274e-01 -1.019793821e+00 3.687680125e-01 -4.989104444e-02
e
$at2_02_0_axis << e
0.000000000e+00 0.000000000e+00 -1.633071699e-01 -1.087264846e+00
e
$at2_02_0 << e
0.000000000e+00 0.000000000e+00
-1.633071699e-01 -1.087264846e+00
e
$at2_02_1_lines << e
-1.633071699e-01 -1.087264846e+00 -3.143258513e-01 4.252550244e-02
-1.633071699e-01 -1.087264846e+00 -3.633180022e-01 -2.836539512e-01
e
$at2_02_1 << e
-1.633071699e-01 -1.087264846e+00
-4.776330212e-01 -1.044739343e+00
-5.266251722e-01 -1.370918797e+00
e
$at2_02_2 << e
-4.776330212e-01 -1.044739343e+00
e
$at2_02_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.083412837e-02,-4.658616525e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.083412837e-02,-4.658616525e-01 left offset 7.439942532e-02,-8.997567178e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -1.716586812e-01,-7.726548746e-01 to -1.633071699e-01,-1.087264846e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at -1.716586812e-01,-7.726548746e-01 right offset -8.491601495e-02,8.996830664e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-2.045931543e+00:8.968524957e-01]
set label 1000 't = 4.4956 s   largest stress (extension)   hinge 1.339 kN, foot 0.8443 kN' at graph 0,1.13 left noenhanced
set title 'seen along y' offset 0,-0.6
plot $rest2_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_12_guides << e
-2.042848169e-01 -2.049685012e-02 4.085696339e-01 4.099370024e-02
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
e
$rest2_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.098167583e-01 -1.094504582e+00
e
$rest2_12_0 << e
0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00
e
$rest2_12_1_lines << e
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00 3.294502749e-02 -3.283513745e-01
e
$rest2_12_1 << e
1.098167583e-01 -1.094504582e+00
1.098167583e-01 -1.094504582e+00
1.427617858e-01 -1.422855956e+00
e
$rest2_12_2 << e
1.098167583e-01 -1.094504582e+00
e
$rest2_12_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_12_guides << e
-1.859527552e-01 -1.865750871e-02 3.719055104e-01 3.731501743e-02
-2.003092252e-01 -1.019793821e+00 1.735818706e-01 -4.989104444e-02
e
$at2_12_0_axis << e
0.000000000e+00 0.000000000e+00 3.443724699e-02 -1.087264846e+00
e
$at2_12_0 << e
0.000000000e+00 0.000000000e+00
3.443724699e-02 -1.087264846e+00
e
$at2_12_1_lines << e
3.443724699e-02 -1.087264846e+00 -1.479555368e-01 4.252550244e-02
3.443724699e-02 -1.087264846e+00 -1.376243627e-01 -2.836539512e-01
e
$at2_12_1 << e
3.443724699e-02 -1.087264846e+00
-1.135182898e-01 -1.044739343e+00
-1.031871157e-01 -1.370918797e+00
e
$at2_12_2 << e
-1.135182898e-01 -1.044739343e+00
e
$at2_12_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -2.151931411e-01,-4.658616525e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -2.151931411e-01,-4.658616525e-01 right offset -1.341911802e+00,-8.170432413e-01 tc rgb '#202020' front noenhanced
set arrow 2 from 1.101195038e-01,-7.726548746e-01 to 3.443724699e-02,-1.087264846e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at 1.101195038e-01,-7.726548746e-01 left offset 7.484377783e-01,8.750374502e-01 tc rgb '#202020' front noenhanced
set xlabel 'y [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-1.853670457e+00:1.089113582e+00]
set yrange [-2.045931543e+00:8.968524957e-01]
set title 'seen along x' offset 0,-0.6
plot $rest2_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_01_guides << e
0.000000000e+00 -2.042848169e-01 0.000000000e+00 4.085696339e-01
-5.553105143e-01 1.098167583e-01 4.106210286e-01 0.000000000e+00
e
$rest2_01_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 1.098167583e-01
e
$rest2_01_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 1.098167583e-01
e
$rest2_01_1_lines << e
0.000000000e+00 1.098167583e-01 -3.500000000e-01 0.000000000e+00
0.000000000e+00 1.098167583e-01 -3.500000000e-01 3.294502749e-02
e
$rest2_01_1 << e
0.000000000e+00 1.098167583e-01
-3.500000000e-01 1.098167583e-01
-3.500000000e-01 1.427617858e-01
e
$rest2_01_2 << e
-3.500000000e-01 1.098167583e-01
e
$rest2_01_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_01_guides << e
8.500516161e-02 -1.859527552e-01 -1.700103232e-01 3.719055104e-01
-6.620170274e-01 -2.003092252e-01 3.687680125e-01 1.735818706e-01
e
$at2_01_0_axis << e
0.000000000e+00 0.000000000e+00 -1.633071699e-01 3.443724699e-02
e
$at2_01_0 << e
0.000000000e+00 0.000000000e+00
-1.633071699e-01 3.443724699e-02
e
$at2_01_1_lines << e
-1.633071699e-01 3.443724699e-02 -3.143258513e-01 -1.479555368e-01
-1.633071699e-01 3.443724699e-02 -3.633180022e-01 -1.376243627e-01
e
$at2_01_1 << e
-1.633071699e-01 3.443724699e-02
-4.776330212e-01 -1.135182898e-01
-5.266251722e-01 -1.031871157e-01
e
$at2_01_2 << e
-4.776330212e-01 -1.135182898e-01
e
$at2_01_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.083412837e-02,-2.151931411e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.083412837e-02,-2.151931411e-01 center offset 1.609036212e-01,-8.988615369e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -1.716586812e-01,1.101195038e-01 to -1.633071699e-01,3.443724699e-02 lw 2 lc rgb '#202020' front
set label 2 'foot' at -1.716586812e-01,1.101195038e-01 center offset -3.509883762e-01,8.945698709e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'y [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-1.853670457e+00:1.089113582e+00]
set title 'seen along z' offset 0,-0.6
plot $rest2_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest3_02_guides << e
0.000000000e+00 -2.049685012e-02 0.000000000e+00 4.099370024e-02
-5.553105143e-01 -1.094504582e+00 4.106210286e-01 0.000000000e+00
e
$rest3_02_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 -1.094504582e+00
e
$rest3_02_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.094504582e+00
e
$rest3_02_1_lines << e
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 0.000000000e+00
0.000000000e+00 -1.094504582e+00 -3.500000000e-01 -3.283513745e-01
e
$rest3_02_1 << e
0.000000000e+00 -1.094504582e+00
-3.500000000e-01 -1.094504582e+00
-3.500000000e-01 -1.422855956e+00
e
$rest3_02_2 << e
-3.500000000e-01 -1.094504582e+00
e
$rest3_02_grounds << e
0.000000000e+00 0.000000000e+00
e
$at3_02_guides << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 0.000000000e+00
-5.553105143e-01 -1.100000000e+00 4.106210286e-01 0.000000000e+00
e
$at3_02_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 -1.100000000e+00
e
$at3_02_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.100000000e+00
e
$at3_02_1_lines << e
0.000000000e+00 -1.100000000e+00 -3.500000000e-01 0.000000000e+00
0.000000000e+00 -1.100000000e+00 -3.500000000e-01 -3.300000000e-01
e
$at3_02_1 << e
0.000000000e+00 -1.100000000e+00
-3.500000000e-01 -1.100000000e+00
-3.500000000e-01 -1.430000000e+00
e
$at3_02_2 << e
-3.500000000e-01 -1.100000000e+00
e
$at3_02_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 8.829061503e-02,4.840469039e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 8.829061503e-02,4.840469039e-01 center offset 5.742091932e-01,8.853919661e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -8.829061503e-02,-1.587973400e+00 to 0.000000000e+00,-1.100000000e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at -8.829061503e-02,-1.587973400e+00 center offset -5.697358348e-01,-8.856205272e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-2.045931543e+00:8.968524957e-01]
set label 1000 't = 0.1000 s   largest M_y, most negative M_z, most negative stress (landing)   hinge 46.24 kN, foot 46.51 kN' at graph 0,1.13 left noenhanced
set title 'seen along y' offset 0,-0.6
plot $rest3_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest3_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest3_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest3_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest3_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at3_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#3f8f4f', $at3_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#3f8f4f', $at3_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#3f8f4f', $at3_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#3f8f4f', $at3_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest3_12_guides << e
-2.042848169e-01 -2.049685012e-02 4.085696339e-01 4.099370024e-02
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
e
$rest3_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.098167583e-01 -1.094504582e+00
e
$rest3_12_0 << e
0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00
e
$rest3_12_1_lines << e
1.098167583e-01 -1.094504582e+00 0.000000000e+00 0.000000000e+00
1.098167583e-01 -1.094504582e+00 3.294502749e-02 -3.283513745e-01
e
$rest3_12_1 << e
1.098167583e-01 -1.094504582e+00
1.098167583e-01 -1.094504582e+00
1.427617858e-01 -1.422855956e+00
e
$rest3_12_2 << e
1.098167583e-01 -1.094504582e+00
e
$rest3_12_grounds << e
0.000000000e+00 0.000000000e+00
e
$at3_12_guides << e
-2.053105143e-01 0.000000000e+00 4.106210286e-01 0.000000000e+00
0.000000000e+00 -1.100000000e+00 0.000000000e+00 0.000000000e+00
e
$at3_12_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 -1.100000000e+00
e
$at3_12_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.100000000e+00
e
$at3_12_1_lines << e
0.000000000e+00 -1.100000000e+00 0.000000000e+00 0.000000000e+00
0.000000000e+00 -1.100000000e+00 0.000000000e+00 -3.300000000e-01
e
$at3_12_1 << e
0.000000000e+00 -1.100000000e+00
0.000000000e+00 -1.100000000e+00
0.000000000e+00 -1.430000000e+00
e
$at3_12_2 << e
0.000000000e+00 -1.100000000e+00
e
$at3_12_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -1.354709124e-01,4.840469039e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -1.354709124e-01,4.840469039e-01 center offset -8.624484379e-01,8.666965378e-01 tc rgb '#202020' front noenhanced
set arrow 2 from 1.324359225e-01,-1.587973400e+00 to 0.000000000e+00,-1.100000000e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at 1.324359225e-01,-1.587973400e+00 center offset 8.381594956e-01,-8.685794468e-01 tc rgb '#202020' front noenhanced
set xlabel 'y [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-1.853670457e+00:1.089113582e+00]
set yrange [-2.045931543e+00:8.968524957e-01]
set title 'seen along x' offset 0,-0.6
plot $rest3_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest3_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest3_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest3_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest3_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at3_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#3f8f4f', $at3_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#3f8f4f', $at3_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#3f8f4f', $at3_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#3f8f4f', $at3_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest3_01_guides << e
0.000000000e+00 -2.042848169e-01 0.000000000e+00 4.085696339e-01
-5.553105143e-01 1.098167583e-01 4.106210286e-01 0.000000000e+00
e
$rest3_01_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 1.098167583e-01
e
$rest3_01_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 1.098167583e-01
e
$rest3_01_1_lines << e
0.000000000e+00 1.098167583e-01 -3.500000000e-01 0.000000000e+00
0.000000000e+00 1.098167583e-01 -3.500000000e-01 3.294502749e-02
e
$rest3_01_1 << e
0.000000000e+00 1.098167583e-01
-3.500000000e-01 1.098167583e-01
-3.500000000e-01 1.427617858e-01
e
$rest3_01_2 << e
-3.500000000e-01 1.098167583e-01
e
$rest3_01_grounds << e
0.000000000e+00 0.000000000e+00
e
$at3_01_guides << e
0.000000000e+00 -2.053105143e-01 0.000000000e+00 4.106210286e-01
-5.553105143e-01 0.000000000e+00 4.106210286e-01 0.000000000e+00
e
$at3_01_0_axis << e
0.000000000e+00 0.000000000e+00 0.000000000e+00 0.000000000e+00
e
$at3_01_0 << e
0.000000000e+00 0.000000000e+00
0.000000000e+00 0.000000000e+00
e
$at3_01_1_lines << e
0.000000000e+00 0.000000000e+00 -3.500000000e-01 0.000000000e+00
0.000000000e+00 0.000000000e+00 -3.500000000e-01 0.000000000e+00
e
$at3_01_1 << e
0.000000000e+00 0.000000000e+00
-3.500000000e-01 0.000000000e+00
-3.500000000e-01 0.000000000e+00
e
$at3_01_2 << e
-3.500000000e-01 0.000000000e+00
e
$at3_01_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 8.829061503e-02,-1.354709124e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 8.829061503e-02,-1.354709124e-01 left offset 1.747224043e+00,-7.540022507e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -8.829061503e-02,1.324359225e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at -8.829061503e-02,1.324359225e-01 right offset -1.775040628e+00,7.488452649e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'y [m]' offset 0.8,0
set xrange [-2.036236465e+00:9.065475738e-01]
set yrange [-1.853670457e+00:1.089113582e+00]
set title 'seen along z' offset 0,-0.6
plot $rest3_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest3_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest3_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest3_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest3_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at3_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#3f8f4f', $at3_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#3f8f4f', $at3_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#3f8f4f', $at3_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#3f8f4f', $at3_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
