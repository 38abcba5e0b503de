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
set xrange [1.452815058e-03:1.743378070e-02]
set yrange [1.000000000e-13:1.000000000e+01]
set xtics ('2 ms' 0.002, '' 0.003 1, '' 0.004 1, '5 ms' 0.005, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01)
set ytics ('' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per 100 frequencies, modes' at screen 0.762903,0.181637 center noenhanced front tc rgb '#202020'
set label 'included' at screen 0.762903,0.151697 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
2.842881500e-03 2.417596907e+00
2.817418250e-03 2.235506222e+00
2.837941750e-03 2.223268986e+00
2.829892000e-03 1.889253463e+00
2.859226000e-03 1.388884875e+00
3.000808500e-03 3.239603155e-02
3.159491750e-03 3.944071597e-03
3.344549333e-03 2.032751274e-04
3.997474000e-03 4.978272137e-05
4.939433000e-03 2.911260782e-05
8.140066000e-03 2.410110542e-08
e
$p1spread0 << e
2.842881500e-03 2.417596907e+00 2.823845500e-03 2.996184000e-03
2.817418250e-03 2.235506222e+00 2.795693250e-03 3.015285250e-03
2.837941750e-03 2.223268986e+00 2.765207500e-03 2.900690750e-03
2.829892000e-03 1.889253463e+00 2.801937500e-03 2.991634750e-03
2.859226000e-03 1.388884875e+00 2.851624750e-03 3.036096500e-03
3.000808500e-03 3.239603155e-02 2.946857500e-03 3.176106500e-03
3.159491750e-03 3.944071597e-03 3.129399000e-03 3.346732750e-03
3.344549333e-03 2.032751274e-04 3.312604667e-03 3.376821000e-03
3.997474000e-03 4.978272137e-05 3.969993000e-03 4.033603500e-03
4.939433000e-03 2.911260782e-05 4.917871000e-03 4.958111000e-03
8.140066000e-03 2.410110542e-08 8.068278000e-03 8.166536000e-03
e
$p1points0 << e
2.842881500e-03 2.417596907e+00
2.817418250e-03 2.235506222e+00
2.837941750e-03 2.223268986e+00
2.829892000e-03 1.889253463e+00
2.859226000e-03 1.388884875e+00
3.000808500e-03 3.239603155e-02
3.159491750e-03 3.944071597e-03
3.344549333e-03 2.032751274e-04
3.997474000e-03 4.978272137e-05
4.939433000e-03 2.911260782e-05
8.140066000e-03 2.410110542e-08
e
$p1line1_0 << e
2.852761333e-03 1.115269759e+00
2.855442000e-03 1.158076640e+00
2.874297000e-03 1.131469263e+00
2.924383750e-03 1.074121251e+00
2.997370750e-03 1.000369782e+00
3.075280250e-03 2.300767713e-01
3.260403000e-03 1.344257253e-01
3.583524667e-03 2.130494986e-02
4.271921333e-03 1.689463193e-02
5.319303000e-03 1.762174556e-02
8.568915000e-03 5.556152657e-05
e
$p1spread1 << e
2.852761333e-03 1.115269759e+00 2.813085000e-03 2.916373333e-03
2.855442000e-03 1.158076640e+00 2.827673667e-03 2.950104000e-03
2.874297000e-03 1.131469263e+00 2.833706000e-03 3.022369333e-03
2.924383750e-03 1.074121251e+00 2.867338000e-03 3.128745500e-03
2.997370750e-03 1.000369782e+00 2.964606750e-03 3.179454250e-03
3.075280250e-03 2.300767713e-01 3.030410500e-03 3.119994750e-03
3.260403000e-03 1.344257253e-01 3.225403000e-03 3.298097000e-03
3.583524667e-03 2.130494986e-02 3.481041000e-03 3.758113333e-03
4.271921333e-03 1.689463193e-02 4.257316000e-03 4.565408000e-03
5.319303000e-03 1.762174556e-02 5.243169000e-03 5.647711000e-03
8.568915000e-03 5.556152657e-05 8.462765500e-03 9.159551000e-03
e
$p1points1 << e
2.852761333e-03 1.115269759e+00
2.855442000e-03 1.158076640e+00
2.874297000e-03 1.131469263e+00
2.924383750e-03 1.074121251e+00
2.997370750e-03 1.000369782e+00
3.075280250e-03 2.300767713e-01
3.260403000e-03 1.344257253e-01
3.583524667e-03 2.130494986e-02
4.271921333e-03 1.689463193e-02
5.319303000e-03 1.762174556e-02
8.568915000e-03 5.556152657e-05
e
$p1spread2 << e
3.152751500e-03 4.268266783e-13 3.096119000e-03 3.349196250e-03
e
$p1points2 << e
3.152751500e-03 4.268266783e-13
e
set label 'default' at screen 0.737839,0.630966 left noenhanced front tc rgb '#202020'
$p1default << e
3.997474000e-03 4.978272137e-05
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points2 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
