# Redraw in the folder above: gnuplot plots/kinematics-predictor.gp; as PDF: gnuplot -e 'pdf = 1' plots/kinematics-predictor.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.0952 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'kinematics-predictor.pdf'
} else {
  set terminal svg size 620,486 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'kinematics-predictor.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Kinematics: where Newton'."'".'s method starts' at screen 0.0193548,0.968107 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s' at screen 0.0193548,0.933128 left noenhanced front tc rgb '#5d6b79'
set label 'reference: the converged positions' at screen 0.0193548,0.902263 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of the predicted positions, relative' at screen 0.0193548,0.859053 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.104938 to screen 0.114903,0.104938 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0907097,0.104938 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Taylor series of order 0' at screen 0.127806,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0679012 to screen 0.114903,0.0679012 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.0907097,0.0679012 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Taylor series of order 1' at screen 0.127806,0.0679012 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0308642 to screen 0.114903,0.0308642 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0907097,0.0308642 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'Taylor series of order 2' at screen 0.127806,0.0308642 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.104938 to screen 0.558065,0.104938 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.533871,0.104938 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'boxbeam, order 2' at screen 0.570968,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0679012 to screen 0.558065,0.0679012 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.0679012 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0308642 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0308642 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.263374486e-01
set tmargin at screen 8.230452675e-01
set xrange [1.869994991e+01:1.971342179e+03]
set yrange [1.000000000e-10:1.000000000e-01]
set xtics ('' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000)
set ytics ('10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '0.1' 0.1)
set label 'instants per motion' at screen 0.304839,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 1e-05 to graph 1, first 0.0001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
2.400000000e+01 1.303966778e-02
4.800000000e+01 6.575669872e-03
9.600000000e+01 3.294838106e-03
1.920000000e+02 1.648295281e-03
3.840000000e+02 8.242572005e-04
7.680000000e+02 4.121422966e-04
1.536000000e+03 2.060728604e-04
e
$p0points0 << e
2.400000000e+01 1.303966778e-02
4.800000000e+01 6.575669872e-03
9.600000000e+01 3.294838106e-03
1.920000000e+02 1.648295281e-03
3.840000000e+02 8.242572005e-04
7.680000000e+02 4.121422966e-04
1.536000000e+03 2.060728604e-04
e
$p0line1_0 << e
2.400000000e+01 1.725216375e-03
4.800000000e+01 4.332234731e-04
9.600000000e+01 1.084261887e-04
1.920000000e+02 2.711407285e-05
3.840000000e+02 6.778988656e-06
7.680000000e+02 1.694776568e-06
1.536000000e+03 4.236959798e-07
e
$p0points1 << e
2.400000000e+01 1.725216375e-03
4.800000000e+01 4.332234731e-04
9.600000000e+01 1.084261887e-04
1.920000000e+02 2.711407285e-05
3.840000000e+02 6.778988656e-06
7.680000000e+02 1.694776568e-06
1.536000000e+03 4.236959798e-07
e
$p0line2_0 << e
2.400000000e+01 1.503156282e-04
4.800000000e+01 1.882722815e-05
9.600000000e+01 2.357310040e-06
1.920000000e+02 2.947927782e-07
3.840000000e+02 3.685127110e-08
7.680000000e+02 4.606518013e-09
1.536000000e+03 5.758166412e-10
e
$p0points2 << e
2.400000000e+01 1.503156282e-04
4.800000000e+01 1.882722815e-05
9.600000000e+01 2.357310040e-06
1.920000000e+02 2.947927782e-07
3.840000000e+02 3.685127110e-08
7.680000000e+02 4.606518013e-09
1.536000000e+03 5.758166412e-10
e
$p0points3 << e
9.600000000e+01 2.357310041e-06
e
set label 'default' at screen 0.256778,0.538784 left noenhanced front tc rgb '#202020'
$p0default << e
9.600000000e+01 2.357310041e-06
e
set arrow from screen 0.293416,0.685208 to screen 0.368405,0.660657 nohead lw 1 lc rgb '#404040'
set label 'order 1' at screen 0.240975,0.654746 left noenhanced front tc rgb '#404040'
set arrow from screen 0.308983,0.609291 to screen 0.377861,0.564193 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.351487,0.604929 left noenhanced front tc rgb '#404040'
set arrow from screen 0.293825,0.438623 to screen 0.35517,0.378373 nohead lw 1 lc rgb '#404040'
set label 'order 3' at screen 0.234562,0.390311 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line2_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0points3 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.263374486e-01
set tmargin at screen 8.230452675e-01
set xrange [2.646350814e-07:3.175620977e-06]
set yrange [1.000000000e-10:1.000000000e-01]
set xtics ('' 3e-07 1, '' 4e-07 1, '500 ns' 5e-07, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '2 µs' 2e-06, '' 3e-06 1)
set ytics ('' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1)
set label 'time per one instant, to round-off' at screen 0.762903,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 1e-05 to graph 1, first 0.0001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
1.197032143e-06 1.303966778e-02
1.194458095e-06 6.575669872e-03
1.195690777e-06 3.294838106e-03
1.198670336e-06 1.648295281e-03
1.141001359e-06 8.242572005e-04
1.058649139e-06 4.121422966e-04
9.689849330e-07 2.060728604e-04
e
$p1spread0 << e
1.197032143e-06 1.303966778e-02 1.195078095e-06 1.212120357e-06
1.194458095e-06 6.575669872e-03 1.187057738e-06 1.195504881e-06
1.195690777e-06 3.294838106e-03 1.189546231e-06 1.215237945e-06
1.198670336e-06 1.648295281e-03 1.191040601e-06 1.207993134e-06
1.141001359e-06 8.242572005e-04 1.136682065e-06 1.141420969e-06
1.058649139e-06 4.121422966e-04 1.047262821e-06 1.060324219e-06
9.689849330e-07 2.060728604e-04 9.628214286e-07 9.745139509e-07
e
$p1points0 << e
1.197032143e-06 1.303966778e-02
1.194458095e-06 6.575669872e-03
1.195690777e-06 3.294838106e-03
1.198670336e-06 1.648295281e-03
1.141001359e-06 8.242572005e-04
1.058649139e-06 4.121422966e-04
9.689849330e-07 2.060728604e-04
e
$p1line1_0 << e
1.176300978e-06 1.725216375e-03
1.085433248e-06 4.332234731e-04
9.710473050e-07 1.084261887e-04
9.593156250e-07 2.711407285e-05
9.619161086e-07 6.778988656e-06
1.039724459e-06 1.694776568e-06
9.212385254e-07 4.236959798e-07
e
$p1spread1 << e
1.176300978e-06 1.725216375e-03 1.174101373e-06 1.183917132e-06
1.085433248e-06 4.332234731e-04 1.080660927e-06 1.094843537e-06
9.710473050e-07 1.084261887e-04 9.677597477e-07 9.727021216e-07
9.593156250e-07 2.711407285e-05 9.568508523e-07 9.628360795e-07
9.619161086e-07 6.778988656e-06 9.552989211e-07 9.653438430e-07
1.039724459e-06 1.694776568e-06 1.037107372e-06 1.043473057e-06
9.212385254e-07 4.236959798e-07 9.179841309e-07 9.244790853e-07
e
$p1points1 << e
1.176300978e-06 1.725216375e-03
1.085433248e-06 4.332234731e-04
9.710473050e-07 1.084261887e-04
9.593156250e-07 2.711407285e-05
9.619161086e-07 6.778988656e-06
1.039724459e-06 1.694776568e-06
9.212385254e-07 4.236959798e-07
e
$p1line2_0 << e
1.023169614e-06 1.503156282e-04
9.913304521e-07 1.882722815e-05
1.128084774e-06 2.357310040e-06
9.072775682e-07 2.947927782e-07
7.582428571e-07 3.685127110e-08
7.639916088e-07 4.606518013e-09
7.547741609e-07 5.758166412e-10
e
$p1spread2 << e
1.023169614e-06 1.503156282e-04 1.021426220e-06 1.030304370e-06
9.913304521e-07 1.882722815e-05 9.852063387e-07 9.922548759e-07
1.128084774e-06 2.357310040e-06 1.124080674e-06 1.128712988e-06
9.072775682e-07 2.947927782e-07 9.042431753e-07 9.075545079e-07
7.582428571e-07 3.685127110e-08 7.534894345e-07 7.633456845e-07
7.639916088e-07 4.606518013e-09 7.566701389e-07 7.648653067e-07
7.547741609e-07 5.758166412e-10 7.527711227e-07 7.580937500e-07
e
$p1points2 << e
1.023169614e-06 1.503156282e-04
9.913304521e-07 1.882722815e-05
1.128084774e-06 2.357310040e-06
9.072775682e-07 2.947927782e-07
7.582428571e-07 3.685127110e-08
7.639916088e-07 4.606518013e-09
7.547741609e-07 5.758166412e-10
e
$p1spread3 << e
7.001207919e-07 2.357310041e-06 6.915359409e-07 7.031607340e-07
e
$p1points3 << e
7.001207919e-07 2.357310041e-06
e
set label 'default' at screen 0.628528,0.538784 left noenhanced front tc rgb '#202020'
$p1default << e
7.001207919e-07 2.357310041e-06
e
plot $p1line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line2_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points3 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
