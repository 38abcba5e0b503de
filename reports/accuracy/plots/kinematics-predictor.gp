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
set ytics ('10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '10^{-1}' 0.1)
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
set xrange [2.669905480e-07:3.203886577e-06]
set yrange [1.000000000e-10:1.000000000e-01]
set xtics ('' 3e-07 1, '' 4e-07 1, '500 ns' 5e-07, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '2 µs' 2e-06, '' 3e-06 1)
set ytics ('' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1)
set label 'time per one instant, to round-off' at screen 0.762903,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 1e-05 to graph 1, first 0.0001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
1.206970481e-06 1.303966778e-02
1.190925545e-06 6.575669872e-03
1.193321121e-06 3.294838106e-03
1.181881510e-06 1.648295281e-03
1.131006680e-06 8.242572005e-04
1.043619491e-06 4.121422966e-04
9.650904948e-07 2.060728604e-04
e
$p1spread0 << e
1.206970481e-06 1.303966778e-02 1.201645408e-06 1.219131560e-06
1.190925545e-06 6.575669872e-03 1.178336884e-06 1.196994081e-06
1.193321121e-06 3.294838106e-03 1.185896073e-06 1.208041427e-06
1.181881510e-06 1.648295281e-03 1.174146070e-06 1.186878314e-06
1.131006680e-06 8.242572005e-04 1.115257246e-06 1.138491848e-06
1.043619491e-06 4.121422966e-04 1.032496094e-06 1.049715345e-06
9.650904948e-07 2.060728604e-04 9.562631138e-07 9.734903274e-07
e
$p1points0 << e
1.206970481e-06 1.303966778e-02
1.190925545e-06 6.575669872e-03
1.193321121e-06 3.294838106e-03
1.181881510e-06 1.648295281e-03
1.131006680e-06 8.242572005e-04
1.043619491e-06 4.121422966e-04
9.650904948e-07 2.060728604e-04
e
$p1line1_0 << e
1.154472495e-06 1.725216375e-03
1.072810341e-06 4.332234731e-04
9.715101219e-07 1.084261887e-04
9.574718364e-07 2.711407285e-05
9.549168596e-07 6.778988656e-06
1.034723958e-06 1.694776568e-06
9.248393787e-07 4.236959798e-07
e
$p1spread1 << e
1.154472495e-06 1.725216375e-03 1.146542837e-06 1.171909761e-06
1.072810341e-06 4.332234731e-04 1.066595315e-06 1.089638385e-06
9.715101219e-07 1.084261887e-04 9.587216981e-07 9.731535967e-07
9.574718364e-07 2.711407285e-05 9.546976273e-07 9.628000579e-07
9.549168596e-07 6.778988656e-06 9.522905093e-07 9.611008873e-07
1.034723958e-06 1.694776568e-06 1.032817007e-06 1.038006110e-06
9.248393787e-07 4.236959798e-07 9.163556548e-07 9.308034784e-07
e
$p1points1 << e
1.154472495e-06 1.725216375e-03
1.072810341e-06 4.332234731e-04
9.715101219e-07 1.084261887e-04
9.574718364e-07 2.711407285e-05
9.549168596e-07 6.778988656e-06
1.034723958e-06 1.694776568e-06
9.248393787e-07 4.236959798e-07
e
$p1line2_0 << e
1.021355955e-06 1.503156282e-04
9.884687500e-07 1.882722815e-05
1.086865489e-06 2.357310040e-06
9.048997396e-07 2.947927782e-07
7.577970282e-07 3.685127110e-08
7.582182138e-07 4.606518013e-09
7.512127459e-07 5.758166412e-10
e
$p1spread2 << e
1.021355955e-06 1.503156282e-04 1.018262205e-06 1.027935711e-06
9.884687500e-07 1.882722815e-05 9.859946895e-07 1.000994690e-06
1.086865489e-06 2.357310040e-06 1.074078012e-06 1.087972260e-06
9.048997396e-07 2.947927782e-07 8.977302827e-07 9.118269159e-07
7.577970282e-07 3.685127110e-08 7.441437653e-07 7.627378217e-07
7.582182138e-07 4.606518013e-09 7.485575214e-07 7.619661458e-07
7.512127459e-07 5.758166412e-10 7.437855179e-07 7.585494068e-07
e
$p1points2 << e
1.021355955e-06 1.503156282e-04
9.884687500e-07 1.882722815e-05
1.086865489e-06 2.357310040e-06
9.048997396e-07 2.947927782e-07
7.577970282e-07 3.685127110e-08
7.582182138e-07 4.606518013e-09
7.512127459e-07 5.758166412e-10
e
$p1spread3 << e
7.050399061e-07 2.357310041e-06 7.016530957e-07 7.153546802e-07
e
$p1points3 << e
7.050399061e-07 2.357310041e-06
e
set label 'default' at screen 0.628221,0.538784 left noenhanced front tc rgb '#202020'
$p1default << e
7.050399061e-07 2.357310041e-06
e
plot $p1line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line2_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points3 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
