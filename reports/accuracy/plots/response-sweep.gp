# Redraw in the folder above: gnuplot plots/response-sweep.gp; as PDF: gnuplot -e 'pdf = 1' plots/response-sweep.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.2524 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'response-sweep.pdf'
} else {
  set terminal svg size 620,501 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'response-sweep.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Harmonic response: forces of the joints over the frequency' at screen 0.0193548,0.969062 left noenhanced front tc rgb '#202020'
set label 'on drill-truck, loads up to 45 Hz' at screen 0.0193548,0.93513 left noenhanced front tc rgb '#5d6b79'
set label 'reference: all modes of the same elements with static correction' at screen 0.0193548,0.90519 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of a joint'."'".'s force over the largest of them' at screen 0.0193548,0.863273 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.101796 to screen 0.114903,0.101796 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0907097,0.101796 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'modes with static correction' at screen 0.127806,0.101796 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0658683 to screen 0.114903,0.0658683 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0907097,0.0658683 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'modes alone' at screen 0.127806,0.0658683 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0299401 to screen 0.114903,0.0299401 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.0907097,0.0299401 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'direct' at screen 0.127806,0.0299401 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.101796 to screen 0.558065,0.101796 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.101796 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0658683 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0658683 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.495009980e-01
set tmargin at screen 8.283433134e-01
set xrange [7.450406587e-01:1.811981647e+02]
set yrange [1.000000000e-13:1.000000000e+01]
set xtics ('' 0.8 1, '' 0.9 1, '1' 1, '' 2 1, '3' 3, '' 4 1, '' 5 1, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100)
set ytics ('10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'equations of motion' at screen 0.304839,0.181637 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.000000000e+00 2.417596907e+00
2.000000000e+00 2.235506222e+00
3.000000000e+00 2.223268986e+00
4.000000000e+00 1.889253463e+00
6.000000000e+00 1.388884875e+00
8.000000000e+00 3.239603155e-02
1.200000000e+01 3.944071597e-03
1.600000000e+01 2.032751274e-04
2.400000000e+01 4.978272137e-05
3.200000000e+01 2.911260782e-05
4.800000000e+01 2.410110542e-08
e
$p0points0 << e
1.000000000e+00 2.417596907e+00
2.000000000e+00 2.235506222e+00
3.000000000e+00 2.223268986e+00
4.000000000e+00 1.889253463e+00
6.000000000e+00 1.388884875e+00
8.000000000e+00 3.239603155e-02
1.200000000e+01 3.944071597e-03
1.600000000e+01 2.032751274e-04
2.400000000e+01 4.978272137e-05
3.200000000e+01 2.911260782e-05
4.800000000e+01 2.410110542e-08
e
$p0line1_0 << e
1.000000000e+00 1.115269759e+00
2.000000000e+00 1.158076640e+00
3.000000000e+00 1.131469263e+00
4.000000000e+00 1.074121251e+00
6.000000000e+00 1.000369782e+00
8.000000000e+00 2.300767713e-01
1.200000000e+01 1.344257253e-01
1.600000000e+01 2.130494986e-02
2.400000000e+01 1.689463193e-02
3.200000000e+01 1.762174556e-02
4.800000000e+01 5.556152657e-05
e
$p0points1 << e
1.000000000e+00 1.115269759e+00
2.000000000e+00 1.158076640e+00
3.000000000e+00 1.131469263e+00
4.000000000e+00 1.074121251e+00
6.000000000e+00 1.000369782e+00
8.000000000e+00 2.300767713e-01
1.200000000e+01 1.344257253e-01
1.600000000e+01 2.130494986e-02
2.400000000e+01 1.689463193e-02
3.200000000e+01 1.762174556e-02
4.800000000e+01 5.556152657e-05
e
$p0points2 << e
1.350000000e+02 4.268266783e-13
e
set label 'default' at screen 0.268997,0.587213 left noenhanced front tc rgb '#202020'
$p0default << e
2.400000000e+01 4.978272137e-05
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.495009980e-01
set tmargin at screen 8.283433134e-01
set xrange [2.248052902e-04:1.050808687e-02]
set yrange [1.000000000e-13:1.000000000e+01]
set xtics ('300 µs' 0.0003, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1, '3 ms' 0.003, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01)
set ytics ('' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per 100 frequencies, modes' at screen 0.762903,0.181637 center noenhanced front tc rgb '#202020'
set label 'included' at screen 0.762903,0.151697 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
2.770262632e-04 2.417596907e+00
2.948227429e-04 2.235506222e+00
3.201179375e-04 2.223268986e+00
3.400620333e-04 1.889253463e+00
4.001736538e-04 1.388884875e+00
4.641370000e-04 3.239603155e-02
7.244846000e-04 3.944071597e-03
9.188426364e-04 2.032751274e-04
1.718575833e-03 4.978272137e-05
2.953132000e-03 2.911260782e-05
8.033536500e-03 2.410110542e-08
e
$p1spread0 << e
2.770262632e-04 2.417596907e+00 2.762203421e-04 2.795774737e-04
2.948227429e-04 2.235506222e+00 2.933516857e-04 2.972060571e-04
3.201179375e-04 2.223268986e+00 3.170530000e-04 3.237108125e-04
3.400620333e-04 1.889253463e+00 3.383387667e-04 3.451316000e-04
4.001736538e-04 1.388884875e+00 3.955505385e-04 4.020807308e-04
4.641370000e-04 3.239603155e-02 4.609121818e-04 4.651667273e-04
7.244846000e-04 3.944071597e-03 7.151306000e-04 7.304041333e-04
9.188426364e-04 2.032751274e-04 9.151816364e-04 9.247387273e-04
1.718575833e-03 4.978272137e-05 1.708415500e-03 1.734311167e-03
2.953132000e-03 2.911260782e-05 2.927218000e-03 2.971259000e-03
8.033536500e-03 2.410110542e-08 8.014448000e-03 8.074988500e-03
e
$p1points0 << e
2.770262632e-04 2.417596907e+00
2.948227429e-04 2.235506222e+00
3.201179375e-04 2.223268986e+00
3.400620333e-04 1.889253463e+00
4.001736538e-04 1.388884875e+00
4.641370000e-04 3.239603155e-02
7.244846000e-04 3.944071597e-03
9.188426364e-04 2.032751274e-04
1.718575833e-03 4.978272137e-05
2.953132000e-03 2.911260782e-05
8.033536500e-03 2.410110542e-08
e
$p1line1_0 << e
3.255721613e-04 1.115269759e+00
3.512692414e-04 1.158076640e+00
3.872573077e-04 1.131469263e+00
4.163912800e-04 1.074121251e+00
4.929407143e-04 1.000369782e+00
5.719077222e-04 2.300767713e-01
8.715571667e-04 1.344257253e-01
1.098569700e-03 2.130494986e-02
1.958115333e-03 1.689463193e-02
3.281009000e-03 1.762174556e-02
8.493341500e-03 5.556152657e-05
e
$p1spread1 << e
3.255721613e-04 1.115269759e+00 3.230515806e-04 3.282109355e-04
3.512692414e-04 1.158076640e+00 3.482150000e-04 3.537581724e-04
3.872573077e-04 1.131469263e+00 3.832960000e-04 3.888065769e-04
4.163912800e-04 1.074121251e+00 4.140245600e-04 4.227804800e-04
4.929407143e-04 1.000369782e+00 4.901536667e-04 4.952222857e-04
5.719077222e-04 2.300767713e-01 5.707031667e-04 5.744577222e-04
8.715571667e-04 1.344257253e-01 8.659020000e-04 8.721463333e-04
1.098569700e-03 2.130494986e-02 1.091689300e-03 1.104950200e-03
1.958115333e-03 1.689463193e-02 1.951812667e-03 1.967623000e-03
3.281009000e-03 1.762174556e-02 3.228109500e-03 3.295733750e-03
8.493341500e-03 5.556152657e-05 8.465725000e-03 8.552134500e-03
e
$p1points1 << e
3.255721613e-04 1.115269759e+00
3.512692414e-04 1.158076640e+00
3.872573077e-04 1.131469263e+00
4.163912800e-04 1.074121251e+00
4.929407143e-04 1.000369782e+00
5.719077222e-04 2.300767713e-01
8.715571667e-04 1.344257253e-01
1.098569700e-03 2.130494986e-02
1.958115333e-03 1.689463193e-02
3.281009000e-03 1.762174556e-02
8.493341500e-03 5.556152657e-05
e
$p1spread2 << e
3.151690000e-03 4.268266783e-13 3.106912750e-03 3.171872750e-03
e
$p1points2 << e
3.151690000e-03 4.268266783e-13
e
set label 'default' at screen 0.787707,0.630966 left noenhanced front tc rgb '#202020'
$p1default << e
1.718575833e-03 4.978272137e-05
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points2 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
