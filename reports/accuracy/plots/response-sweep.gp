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
set xrange [1.428031783e-03:1.713638140e-02]
set yrange [1.000000000e-13:1.000000000e+01]
set xtics ('2 ms' 0.002, '' 0.003 1, '' 0.004 1, '5 ms' 0.005, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01)
set ytics ('' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per 100 frequencies, modes' at screen 0.762903,0.181637 center noenhanced front tc rgb '#202020'
set label 'included' at screen 0.762903,0.151697 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
2.807493250e-03 2.417596907e+00
2.759789250e-03 2.235506222e+00
2.791489250e-03 2.223268986e+00
2.800946250e-03 1.889253463e+00
2.842769000e-03 1.388884875e+00
2.911093750e-03 3.239603155e-02
3.085230000e-03 3.944071597e-03
3.334220333e-03 2.032751274e-04
3.986205667e-03 4.978272137e-05
4.916228000e-03 2.911260782e-05
8.190812000e-03 2.410110542e-08
e
$p1spread0 << e
2.807493250e-03 2.417596907e+00 2.785457750e-03 2.847308000e-03
2.759789250e-03 2.235506222e+00 2.758747500e-03 2.831171500e-03
2.791489250e-03 2.223268986e+00 2.762836500e-03 2.859596500e-03
2.800946250e-03 1.889253463e+00 2.777415750e-03 2.870878500e-03
2.842769000e-03 1.388884875e+00 2.827250500e-03 2.878890500e-03
2.911093750e-03 3.239603155e-02 2.883908250e-03 2.949791750e-03
3.085230000e-03 3.944071597e-03 3.069071000e-03 3.099366500e-03
3.334220333e-03 2.032751274e-04 3.288047667e-03 3.365050333e-03
3.986205667e-03 4.978272137e-05 3.940093333e-03 4.304603667e-03
4.916228000e-03 2.911260782e-05 4.887540000e-03 5.174295500e-03
8.190812000e-03 2.410110542e-08 8.039350000e-03 8.655414500e-03
e
$p1points0 << e
2.807493250e-03 2.417596907e+00
2.759789250e-03 2.235506222e+00
2.791489250e-03 2.223268986e+00
2.800946250e-03 1.889253463e+00
2.842769000e-03 1.388884875e+00
2.911093750e-03 3.239603155e-02
3.085230000e-03 3.944071597e-03
3.334220333e-03 2.032751274e-04
3.986205667e-03 4.978272137e-05
4.916228000e-03 2.911260782e-05
8.190812000e-03 2.410110542e-08
e
$p1line1_0 << e
2.967601250e-03 1.115269759e+00
2.931687250e-03 1.158076640e+00
2.961281500e-03 1.131469263e+00
2.974040750e-03 1.074121251e+00
3.045315250e-03 1.000369782e+00
3.145746000e-03 2.300767713e-01
3.297716500e-03 1.344257253e-01
3.542426333e-03 2.130494986e-02
4.259646000e-03 1.689463193e-02
5.264350500e-03 1.762174556e-02
8.620647500e-03 5.556152657e-05
e
$p1spread1 << e
2.967601250e-03 1.115269759e+00 2.867556000e-03 3.055941250e-03
2.931687250e-03 1.158076640e+00 2.877180500e-03 2.980042250e-03
2.961281500e-03 1.131469263e+00 2.898868000e-03 3.008550000e-03
2.974040750e-03 1.074121251e+00 2.886865000e-03 3.029804500e-03
3.045315250e-03 1.000369782e+00 2.980913500e-03 3.125360250e-03
3.145746000e-03 2.300767713e-01 3.041624750e-03 3.184261250e-03
3.297716500e-03 1.344257253e-01 3.241817750e-03 3.365936500e-03
3.542426333e-03 2.130494986e-02 3.509877333e-03 3.649116333e-03
4.259646000e-03 1.689463193e-02 4.212909333e-03 4.360824667e-03
5.264350500e-03 1.762174556e-02 5.216123000e-03 5.357615500e-03
8.620647500e-03 5.556152657e-05 8.536366000e-03 8.870437500e-03
e
$p1points1 << e
2.967601250e-03 1.115269759e+00
2.931687250e-03 1.158076640e+00
2.961281500e-03 1.131469263e+00
2.974040750e-03 1.074121251e+00
3.045315250e-03 1.000369782e+00
3.145746000e-03 2.300767713e-01
3.297716500e-03 1.344257253e-01
3.542426333e-03 2.130494986e-02
4.259646000e-03 1.689463193e-02
5.264350500e-03 1.762174556e-02
8.620647500e-03 5.556152657e-05
e
$p1spread2 << e
3.150851250e-03 4.268266783e-13 3.136634750e-03 3.190333000e-03
e
$p1points2 << e
3.150851250e-03 4.268266783e-13
e
set label 'default' at screen 0.74021,0.630966 left noenhanced front tc rgb '#202020'
$p1default << e
3.986205667e-03 4.978272137e-05
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points2 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
