# Redraw in the folder above: gnuplot plots/rfem-reactions.gp; as PDF: gnuplot -e 'pdf = 1' plots/rfem-reactions.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,4.9065 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'rfem-reactions.pdf'
} else {
  set terminal svg size 620,468 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'rfem-reactions.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Rigid finite elements: forces of the joints' at screen 0.0193548,0.96688 left noenhanced front tc rgb '#202020'
set label 'on drill-truck, loads of 25 Hz' at screen 0.0193548,0.930556 left noenhanced front tc rgb '#5d6b79'
set label 'reference: corrected elements, 512 parts per link' at screen 0.0193548,0.898504 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of a joint'."'".'s force over the largest of them' at screen 0.0193548,0.853632 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0705128 to screen 0.114903,0.0705128 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0907097,0.0705128 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'classical' at screen 0.127806,0.0705128 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0320513 to screen 0.114903,0.0320513 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.0907097,0.0320513 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'corrected' at screen 0.127806,0.0320513 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0705128 to screen 0.558065,0.0705128 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.0705128 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0320513 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0320513 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 1.965811966e-01
set tmargin at screen 8.162393162e-01
set xrange [1.537106700e+01:8.034575608e+02]
set yrange [1.000000000e-07:1.000000000e-01]
set xtics ('' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1)
set ytics ('10^{-7}' 1e-07, '' 2e-07 1, '' 3e-07 1, '' 4e-07 1, '' 5e-07 1, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '10^{-6}' 1e-06, '' 2e-06 1, '' 3e-06 1, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10^{-5}' 1e-05, '' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '10^{-4}' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '10^{-3}' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10^{-2}' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '0.1' 0.1)
set label 'rigid elements' at screen 0.304839,0.123932 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.900000000e+01 2.995185547e-02
3.100000000e+01 9.172638384e-03
5.100000000e+01 2.765559360e-03
9.000000000e+01 1.010624989e-03
1.700000000e+02 3.025643418e-04
3.310000000e+02 8.268708510e-05
6.500000000e+02 2.027577532e-05
e
$p0points0 << e
1.900000000e+01 2.995185547e-02
3.100000000e+01 9.172638384e-03
5.100000000e+01 2.765559360e-03
9.000000000e+01 1.010624989e-03
1.700000000e+02 3.025643418e-04
3.310000000e+02 8.268708510e-05
6.500000000e+02 2.027577532e-05
e
$p0line1_0 << e
1.900000000e+01 1.345519930e-02
3.100000000e+01 1.495616297e-03
5.100000000e+01 2.906282324e-04
9.000000000e+01 8.081147537e-05
1.700000000e+02 9.600522080e-06
3.310000000e+02 1.450755099e-06
6.500000000e+02 3.840996304e-07
e
$p0points1 << e
1.900000000e+01 1.345519930e-02
3.100000000e+01 1.495616297e-03
5.100000000e+01 2.906282324e-04
9.000000000e+01 8.081147537e-05
1.700000000e+02 9.600522080e-06
3.310000000e+02 1.450755099e-06
6.500000000e+02 3.840996304e-07
e
set label 'default' at screen 0.193066,0.473435 left noenhanced front tc rgb '#202020'
$p0default << e
9.000000000e+01 8.081147537e-05
e
set arrow from screen 0.341246,0.53537 to screen 0.406041,0.479237 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.391385,0.535255 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.965811966e-01
set tmargin at screen 8.162393162e-01
set xrange [3.388877811e-05:4.066653373e-04]
set yrange [1.000000000e-07:1.000000000e-01]
set xtics ('' 4e-05 1, '50 µs' 5e-05, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '200 µs' 0.0002, '' 0.0003 1, '' 0.0004 1)
set ytics ('' 1e-07, '' 2e-07 1, '' 3e-07 1, '' 4e-07 1, '' 5e-07 1, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '' 1e-06, '' 2e-06 1, '' 3e-06 1, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '' 1e-05, '' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.1)
set label 'time per response of the mechanism' at screen 0.762903,0.123932 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
5.734457143e-05 2.995185547e-02
5.956558333e-05 9.172638384e-03
6.500105844e-05 2.765559360e-03
7.599540909e-05 1.010624989e-03
1.017326800e-04 3.025643418e-04
1.495548824e-04 8.268708510e-05
2.430409286e-04 2.027577532e-05
e
$p1spread0 << e
5.734457143e-05 2.995185547e-02 5.700200571e-05 5.761738857e-05
5.956558333e-05 9.172638384e-03 5.944152976e-05 6.014436905e-05
6.500105844e-05 2.765559360e-03 6.480634416e-05 6.568168831e-05
7.599540909e-05 1.010624989e-03 7.590421970e-05 7.670170455e-05
1.017326800e-04 3.025643418e-04 1.007172500e-04 1.020717900e-04
1.495548824e-04 8.268708510e-05 1.488776912e-04 1.498142500e-04
2.430409286e-04 2.027577532e-05 2.410109762e-04 2.459541190e-04
e
$p1points0 << e
5.734457143e-05 2.995185547e-02
5.956558333e-05 9.172638384e-03
6.500105844e-05 2.765559360e-03
7.599540909e-05 1.010624989e-03
1.017326800e-04 3.025643418e-04
1.495548824e-04 8.268708510e-05
2.430409286e-04 2.027577532e-05
e
$p1line1_0 << e
5.638072222e-05 1.345519930e-02
5.773045087e-05 1.495616297e-03
6.166690184e-05 2.906282324e-04
6.879732653e-05 8.081147537e-05
8.603578632e-05 9.600522080e-06
1.190325714e-04 1.450755099e-06
1.814233636e-04 3.840996304e-07
e
$p1spread1 << e
5.638072222e-05 1.345519930e-02 5.603236667e-05 5.657346111e-05
5.773045087e-05 1.495616297e-03 5.755099422e-05 5.889590173e-05
6.166690184e-05 2.906282324e-04 6.118224540e-05 6.209546012e-05
6.879732653e-05 8.081147537e-05 6.825999320e-05 6.905983673e-05
8.603578632e-05 9.600522080e-06 8.552364957e-05 8.633786325e-05
1.190325714e-04 1.450755099e-06 1.181899881e-04 1.212689048e-04
1.814233636e-04 3.840996304e-07 1.801532727e-04 1.822657091e-04
e
$p1points1 << e
5.638072222e-05 1.345519930e-02
5.773045087e-05 1.495616297e-03
6.166690184e-05 2.906282324e-04
6.879732653e-05 8.081147537e-05
8.603578632e-05 9.600522080e-06
1.190325714e-04 1.450755099e-06
1.814233636e-04 3.840996304e-07
e
set label 'default' at screen 0.584868,0.520273 left noenhanced front tc rgb '#202020'
$p1default << e
6.879732653e-05 8.081147537e-05
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
