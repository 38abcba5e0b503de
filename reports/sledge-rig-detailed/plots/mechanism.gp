# Redraw with: gnuplot mechanism.gp
set terminal svg size 2096,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
set output 'mechanism.svg'
set encoding utf8
set border 3 lc rgb '#505050'
set tics out nomirror
set grid lc rgb '#e2e2e2' lw 0.7 lt 1
set key noenhanced samplen 2.5 spacing 1.2
set multiplot layout 1,4 title 'Mechanism at its critical instants, forces on the beam; grey: t = 0.0000 s' noenhanced
set size ratio -1
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
set xrange [-2.006641995e+00:2.690972203e+00]
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
set arrow 1 from -8.072896542e-01,-1.951581498e-01 to 2.602085214e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  215.4 kN' at -8.072896542e-01,-1.951581498e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 6.806395036e-01,3.000888305e+00 to 2.501090878e-01,2.989556061e+00 lw 2 lc rgb '#202020' front
set label 2 'B  111.7 kN' at 6.806395036e-01,3.000888305e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.079896152e-01,-3.192120093e+00 to -2.667830269e-01,-3.188859799e+00 lw 2 lc rgb '#202020' front
set label 3 'C  97.18 kN' at 1.079896152e-01,-3.192120093e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3571 s\nmost negative stress (normal running)"
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
set arrow 1 from 7.998160852e-01,-1.893399287e-01 to -4.336808690e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  213.1 kN' at 7.998160852e-01,-1.893399287e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -6.752707504e-01,2.982993381e+00 to -2.498912924e-01,2.989574274e+00 lw 2 lc rgb '#202020' front
set label 2 'B  110.3 kN' at -6.752707504e-01,2.982993381e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -1.059062427e-01,-3.180045330e+00 to 2.665507119e-01,-3.188879226e+00 lw 2 lc rgb '#202020' front
set label 3 'C  96.60 kN' at -1.059062427e-01,-3.180045330e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0714 s\nlargest stress (normal running)"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest3_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest3_0_axis << e
-1.924565389e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest3_0 << e
-1.924565389e-16 -3.200000000e+00
3.486948934e-18 0.000000000e+00
1.871839688e-16 3.000000000e+00
e
$rest3_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest3_2 << e
5.000000000e-01 3.000000000e+00
e
$rest3_3 << e
0.000000000e+00 -3.200000000e+00
6.850000000e-01 -3.200000000e+00
e
$rest3_4 << e
6.850000000e-01 -3.200000000e+00
e
$rest3_grounds << e
0.000000000e+00 0.000000000e+00
e
$at3_guides << e
3.040000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
-1.314303923e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at3_0_axis << e
-3.202419948e-01 -3.183935468e+00 6.204688649e-01 6.168874969e+00
e
$at3_0 << e
-3.202419948e-01 -3.183935468e+00
4.336808690e-18 0.000000000e+00
3.002268701e-01 2.984939501e+00
e
$at3_1 << e
3.002268701e-01 2.984939501e+00
8.000000000e-01 3.000000000e+00
e
$at3_2 << e
8.000000000e-01 3.000000000e+00
e
$at3_3 << e
-3.202419948e-01 -3.183935468e+00
3.645696077e-01 -3.200000000e+00
e
$at3_4 << e
3.645696077e-01 -3.200000000e+00
e
$at3_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -9.721859818e-01,-1.972775122e-01 to 4.336808690e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  257.2 kN' at -9.721859818e-01,-1.972775122e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 8.192726303e-01,3.002962750e+00 to 3.002268701e-01,2.984939501e+00 lw 2 lc rgb '#202020' front
set label 2 'B  134.7 kN' at 8.192726303e-01,3.002962750e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from 1.305112434e-01,-3.191693522e+00 to -3.202419948e-01,-3.183935468e+00 lw 2 lc rgb '#202020' front
set label 3 'C  116.9 kN' at 1.305112434e-01,-3.191693522e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3571 s\nmost negative M (over-stroke)"
plot $rest3_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest3_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest3_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest3_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at3_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#3f8f4f', $at3_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#3f8f4f', $at3_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#3f8f4f', $at3_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest4_guides << e
4.000000000e-03 3.000000000e+00 9.920000000e-01 0.000000000e+00
1.890000000e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$rest4_0_axis << e
-1.924565389e-16 -3.200000000e+00 3.796405077e-16 6.200000000e+00
e
$rest4_0 << e
-1.924565389e-16 -3.200000000e+00
3.486948934e-18 0.000000000e+00
1.871839688e-16 3.000000000e+00
e
$rest4_1 << e
0.000000000e+00 3.000000000e+00
5.000000000e-01 3.000000000e+00
e
$rest4_2 << e
5.000000000e-01 3.000000000e+00
e
$rest4_3 << e
0.000000000e+00 -3.200000000e+00
6.850000000e-01 -3.200000000e+00
e
$rest4_4 << e
6.850000000e-01 -3.200000000e+00
e
$rest4_grounds << e
0.000000000e+00 0.000000000e+00
e
$at4_guides << e
-2.960000000e-01 3.000000000e+00 9.920000000e-01 0.000000000e+00
5.085722028e-01 -3.200000000e+00 9.920000000e-01 0.000000000e+00
e
$at4_0_axis << e
3.197594644e-01 -3.183983964e+00 -6.195339624e-01 6.168968931e+00
e
$at4_0 << e
3.197594644e-01 -3.183983964e+00
3.469446952e-18 0.000000000e+00
-2.997744979e-01 2.984984967e+00
e
$at4_1 << e
-2.997744979e-01 2.984984967e+00
2.000000000e-01 3.000000000e+00
e
$at4_2 << e
2.000000000e-01 3.000000000e+00
e
$at4_3 << e
3.197594644e-01 -3.183983964e+00
1.004572203e+00 -3.200000000e+00
e
$at4_4 << e
1.004572203e+00 -3.200000000e+00
e
$at4_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 9.566476229e-01,-1.872036686e-01 to 3.469446952e-18,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'O  252.8 kN' at 9.566476229e-01,-1.872036686e-01 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -8.081102419e-01,2.972013884e+00 to -2.997744979e-01,2.984984967e+00 lw 2 lc rgb '#202020' front
set label 2 'B  131.9 kN' at -8.081102419e-01,2.972013884e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 3 from -1.261798245e-01,-3.170823342e+00 to 3.197594644e-01,-3.183983964e+00 lw 2 lc rgb '#202020' front
set label 3 'C  115.7 kN' at -1.261798245e-01,-3.170823342e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 1.0714 s\nlargest M (over-stroke)"
plot $rest4_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest4_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest4_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest4_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest4_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest4_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest4_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest4_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at4_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#7a4fa0', $at4_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#7a4fa0', $at4_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#7a4fa0', $at4_1 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#7a4fa0', $at4_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#7a4fa0', $at4_3 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#7a4fa0', $at4_4 using 1:2 with points pt 5 ps 1.6 lc rgb '#7a4fa0', $at4_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
