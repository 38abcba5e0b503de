# Redraw with: gnuplot mechanism.gp
set terminal svg size 2060,860 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
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
set xrange [-7.393391280e-01:7.393391272e-01]
set yrange [-2.048356052e+00:4.551326017e-01]
$rest1_guides << e
-9.548925482e-17 -1.559457876e+00 1.952795775e-17 3.189157521e-01
e
$rest1_0 << e
0.000000000e+00 0.000000000e+00
1.224646799e-17 2.000000000e-01
e
$rest1_1_axis << e
8.927509176e-17 2.000000000e-01 -2.572996239e-16 -1.600000000e+00
e
$rest1_1 << e
8.927509176e-17 2.000000000e-01
-1.680245322e-16 -1.400000000e+00
e
$rest1_2 << e
-8.572527594e-17 -1.400000000e+00
e
$rest1_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_guides << e
-1.090373083e-16 -1.780714381e+00 1.952795775e-17 3.189157521e-01
e
$at1_0 << e
0.000000000e+00 0.000000000e+00
-1.971823494e-01 -3.345326699e-02
e
$at1_1_axis << e
-1.971823494e-01 -3.345326699e-02 1.971823494e-01 -1.587803238e+00
e
$at1_1 << e
-1.971823494e-01 -3.345326699e-02
-4.163336342e-17 -1.621256505e+00
e
$at1_2 << e
-9.927332944e-17 -1.621256505e+00
e
$at1_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -1.963482084e-01,-4.345293818e-02 to -1.971823494e-01,-3.345326699e-02 lw 2 lc rgb '#202020' front
set label 1 'A  30.30 kN' at -1.963482084e-01,-4.345293818e-02 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from -1.277777688e-03,-1.612911059e+00 to -4.163336342e-17,-1.621256505e+00 lw 2 lc rgb '#202020' front
set label 2 'P  25.50 kN' at -1.277777688e-03,-1.612911059e+00 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.3321 s\nmost negative M"
plot $rest1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_guides << e
-9.548925482e-17 -1.559457876e+00 1.952795775e-17 3.189157521e-01
e
$rest2_0 << e
0.000000000e+00 0.000000000e+00
1.224646799e-17 2.000000000e-01
e
$rest2_1_axis << e
8.927509176e-17 2.000000000e-01 -2.572996239e-16 -1.600000000e+00
e
$rest2_1 << e
8.927509176e-17 2.000000000e-01
-1.680245322e-16 -1.400000000e+00
e
$rest2_2 << e
-8.572527594e-17 -1.400000000e+00
e
$rest2_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_guides << e
-1.195592296e-16 -1.952550396e+00 1.952795775e-17 3.189157521e-01
e
$at2_0 << e
0.000000000e+00 0.000000000e+00
-4.921692414e-02 -1.938496695e-01
e
$at2_1_axis << e
-4.921692414e-02 -1.938496695e-01 4.921692414e-02 -1.599242850e+00
e
$at2_1 << e
-4.921692414e-02 -1.938496695e-01
-7.285838599e-17 -1.793092520e+00
e
$at2_2 << e
-1.097952508e-16 -1.793092520e+00
e
$at2_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -5.906534217e-02,1.224681282e-01 to -4.921692414e-02,-1.938496695e-01 lw 2 lc rgb '#202020' front
set label 1 'A  955.7 kN' at -5.906534217e-02,1.224681282e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 9.737685844e-03,-2.111859573e+00 to -7.285838599e-17,-1.793092520e+00 lw 2 lc rgb '#202020' front
set label 2 'P  963.1 kN' at 9.737685844e-03,-2.111859573e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.5525 s\nmost negative stress"
plot $rest2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c8551b', $at2_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest3_guides << e
-9.548925482e-17 -1.559457876e+00 1.952795775e-17 3.189157521e-01
e
$rest3_0 << e
0.000000000e+00 0.000000000e+00
1.224646799e-17 2.000000000e-01
e
$rest3_1_axis << e
8.927509176e-17 2.000000000e-01 -2.572996239e-16 -1.600000000e+00
e
$rest3_1 << e
8.927509176e-17 2.000000000e-01
-1.680245322e-16 -1.400000000e+00
e
$rest3_2 << e
-8.572527594e-17 -1.400000000e+00
e
$rest3_grounds << e
0.000000000e+00 0.000000000e+00
e
$at3_guides << e
-1.195672468e-16 -1.952681327e+00 1.952795775e-17 3.189157521e-01
e
$at3_0 << e
0.000000000e+00 0.000000000e+00
4.875468702e-02 -1.939664417e-01
e
$at3_1_axis << e
4.875468702e-02 -1.939664417e-01 -4.875468702e-02 -1.599257009e+00
e
$at3_1 << e
4.875468702e-02 -1.939664417e-01
-4.857225733e-17 -1.793223451e+00
e
$at3_2 << e
-1.098032679e-16 -1.793223451e+00
e
$at3_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 4.839459844e-02,-2.094727544e-01 to 4.875468702e-02,-1.939664417e-01 lw 2 lc rgb '#202020' front
set label 1 'A  46.84 kN' at 4.839459844e-02,-2.094727544e-01 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 4.697807766e-04,-1.780167020e+00 to -4.857225733e-17,-1.793223451e+00 lw 2 lc rgb '#202020' front
set label 2 'P  39.45 kN' at 4.697807766e-04,-1.780167020e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.6470 s\nlargest stress"
plot $rest3_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest3_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest3_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest3_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest3_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest3_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at3_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#3f8f4f', $at3_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#3f8f4f', $at3_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#3f8f4f', $at3_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#3f8f4f', $at3_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#3f8f4f', $at3_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest4_guides << e
-9.548925482e-17 -1.559457876e+00 1.952795775e-17 3.189157521e-01
e
$rest4_0 << e
0.000000000e+00 0.000000000e+00
1.224646799e-17 2.000000000e-01
e
$rest4_1_axis << e
8.927509176e-17 2.000000000e-01 -2.572996239e-16 -1.600000000e+00
e
$rest4_1 << e
8.927509176e-17 2.000000000e-01
-1.680245322e-16 -1.400000000e+00
e
$rest4_2 << e
-8.572527594e-17 -1.400000000e+00
e
$rest4_grounds << e
0.000000000e+00 0.000000000e+00
e
$at4_guides << e
-1.090373086e-16 -1.780714385e+00 1.952795775e-17 3.189157521e-01
e
$at4_0 << e
0.000000000e+00 0.000000000e+00
1.971823487e-01 -3.345327142e-02
e
$at4_1_axis << e
1.971823487e-01 -3.345327142e-02 -1.971823487e-01 -1.587803238e+00
e
$at4_1 << e
1.971823487e-01 -3.345327142e-02
-5.551115123e-17 -1.621256509e+00
e
$at4_2 << e
-9.927332972e-17 -1.621256509e+00
e
$at4_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.963487824e-01,-4.344831422e-02 to 1.971823487e-01,-3.345327142e-02 lw 2 lc rgb '#202020' front
set label 1 'A  30.29 kN' at 1.963487824e-01,-4.344831422e-02 right offset -0.3,0.9 tc rgb '#202020' front noenhanced
set arrow 2 from 1.277202903e-03,-1.612915692e+00 to -5.551115123e-17,-1.621256509e+00 lw 2 lc rgb '#202020' front
set label 2 'P  25.48 kN' at 1.277202903e-03,-1.612915692e+00 left offset 0.3,0.9 tc rgb '#202020' front noenhanced
set title "t = 0.8679 s\nlargest M"
plot $rest4_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest4_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#c4c4c4', $rest4_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest4_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest4_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest4_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at4_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#7a4fa0', $at4_0 using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#7a4fa0', $at4_1_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#7a4fa0', $at4_1 using 1:2 with points pt 7 ps 0.6 lc rgb '#7a4fa0', $at4_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#7a4fa0', $at4_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
