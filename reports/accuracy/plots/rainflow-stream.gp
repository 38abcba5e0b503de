# Redraw in the folder above: gnuplot plots/rainflow-stream.gp; as PDF: gnuplot -e 'pdf = 1' plots/rainflow-stream.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.2839 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'rainflow-stream.pdf'
} else {
  set terminal svg size 620,504 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'rainflow-stream.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Rainflow: a history in chunks' at screen 0.0193548,0.969246 left noenhanced front tc rgb '#202020'
set label 'on wide-band noise, ranges up to 240 MPa, EN 1993-1-9 category 100' at screen 0.0193548,0.935516 left noenhanced front tc rgb '#5d6b79'
set label 'reference: every cycle by itself, plain stack, summed in long double' at screen 0.0193548,0.905754 left noenhanced front tc rgb '#5d6b79'
set label 'relative error of the damage sum' at screen 0.0193548,0.864087 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0206452,0.136905 to screen 0.0690323,0.136905 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0448387,0.136905 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'streamed, residue kept' at screen 0.0819355,0.136905 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0206452,0.10119 to screen 0.0690323,0.10119 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.0448387,0.10119 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'streamed, kernels for every machine' at screen 0.0819355,0.10119 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0206452,0.0654762 to screen 0.0690323,0.0654762 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0448387,0.0654762 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'each chunk by itself' at screen 0.0819355,0.0654762 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0206452,0.0297619 to screen 0.0690323,0.0297619 nohead lw 1.7 dt (3,3) lc rgb '#00785a'
set label '' at screen 0.0448387,0.0297619 point pt 9 ps 0.55 lc rgb '#00785a'
set label 'all in memory' at screen 0.0819355,0.0297619 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.136905 to screen 0.558065,0.136905 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.533871,0.136905 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'plain stack' at screen 0.570968,0.136905 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.10119 to screen 0.558065,0.10119 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.10119 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0654762 to screen 0.558065,0.0654762 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of the sum: 1.0e-14' at screen 0.570968,0.0654762 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0297619 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0297619 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.539682540e-01
set tmargin at screen 8.293650794e-01
set xrange [4.931163522e-01:2.658033939e+05]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 0.5 1, '' 0.6 1, '' 0.7 1, '' 0.8 1, '' 0.9 1, '1' 1, '' 2 1, '' 3 1, '' 4 1, '' 5 1, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '' 30 1, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '10^{5}' 100000, '' 200000 1)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'samples per chunk' at screen 0.304839,0.186508 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.325893 to screen 0.509677,0.325893 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
1.000000000e+00 4.440892099e-16
8.000000000e+00 4.440892099e-16
6.400000000e+01 4.440892099e-16
2.560000000e+02 4.440892099e-16
1.024000000e+03 4.440892099e-16
4.096000000e+03 4.440892099e-16
1.638400000e+04 4.440892099e-16
6.553600000e+04 4.440892099e-16
e
$p0points0 << e
1.000000000e+00 4.440892099e-16
8.000000000e+00 4.440892099e-16
6.400000000e+01 4.440892099e-16
2.560000000e+02 4.440892099e-16
1.024000000e+03 4.440892099e-16
4.096000000e+03 4.440892099e-16
1.638400000e+04 4.440892099e-16
6.553600000e+04 4.440892099e-16
e
$p0line1_0 << e
1.000000000e+00 4.440892099e-16
8.000000000e+00 4.440892099e-16
6.400000000e+01 4.440892099e-16
2.560000000e+02 4.440892099e-16
1.024000000e+03 4.440892099e-16
4.096000000e+03 4.440892099e-16
1.638400000e+04 4.440892099e-16
6.553600000e+04 4.440892099e-16
e
$p0points1 << e
1.000000000e+00 4.440892099e-16
8.000000000e+00 4.440892099e-16
6.400000000e+01 4.440892099e-16
2.560000000e+02 4.440892099e-16
1.024000000e+03 4.440892099e-16
4.096000000e+03 4.440892099e-16
1.638400000e+04 4.440892099e-16
6.553600000e+04 4.440892099e-16
e
$p0line2_0 << e
1.000000000e+00 1.000000000e+00
8.000000000e+00 8.843691151e-01
6.400000000e+01 2.996188414e-01
2.560000000e+02 1.080088236e-01
1.024000000e+03 3.266282667e-02
4.096000000e+03 8.491973777e-03
1.638400000e+04 2.152811699e-03
6.553600000e+04 2.103942508e-04
e
$p0points2 << e
1.000000000e+00 1.000000000e+00
8.000000000e+00 8.843691151e-01
6.400000000e+01 2.996188414e-01
2.560000000e+02 1.080088236e-01
1.024000000e+03 3.266282667e-02
4.096000000e+03 8.491973777e-03
1.638400000e+04 2.152811699e-03
6.553600000e+04 2.103942508e-04
e
$p0points3 << e
1.310720000e+05 4.440892099e-16
e
$p0points4 << e
1.310720000e+05 6.661338148e-16
e
set label 'default' at screen 0.384664,0.308007 left noenhanced front tc rgb '#202020'
$p0default << e
1.638400000e+04 4.440892099e-16
e
set arrow from screen 0.316085,0.763233 to screen 0.387743,0.72718 nohead lw 1 lc rgb '#404040'
set label 'order 1' at screen 0.261979,0.727669 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0points3 using 1:2 with points pt 9 ps 0.55 lc rgb '#00785a' notitle, $p0points4 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.539682540e-01
set tmargin at screen 8.293650794e-01
set xrange [2.090276183e-04:2.508331420e-03]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 0.0003 1, '' 0.0004 1, '500 µs' 0.0005, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '2 ms' 0.002)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per history of 131 072 samples' at screen 0.762903,0.186508 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.325893 to screen 0.967742,0.325893 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1line0_0 << e
1.193613556e-03 4.440892099e-16
8.181285385e-04 4.440892099e-16
6.920466000e-04 4.440892099e-16
6.745857333e-04 4.440892099e-16
6.711872500e-04 4.440892099e-16
6.689715000e-04 4.440892099e-16
6.680356875e-04 4.440892099e-16
6.709100000e-04 4.440892099e-16
e
$p1spread0 << e
1.193613556e-03 4.440892099e-16 1.185650444e-03 1.206337111e-03
8.181285385e-04 4.440892099e-16 8.160947692e-04 8.210800000e-04
6.920466000e-04 4.440892099e-16 6.896470000e-04 6.939207333e-04
6.745857333e-04 4.440892099e-16 6.725520000e-04 6.777792000e-04
6.711872500e-04 4.440892099e-16 6.673158750e-04 6.737329375e-04
6.689715000e-04 4.440892099e-16 6.650180000e-04 6.755901250e-04
6.680356875e-04 4.440892099e-16 6.647063750e-04 6.704618125e-04
6.709100000e-04 4.440892099e-16 6.654311875e-04 6.749453750e-04
e
$p1points0 << e
1.193613556e-03 4.440892099e-16
8.181285385e-04 4.440892099e-16
6.920466000e-04 4.440892099e-16
6.745857333e-04 4.440892099e-16
6.711872500e-04 4.440892099e-16
6.689715000e-04 4.440892099e-16
6.680356875e-04 4.440892099e-16
6.709100000e-04 4.440892099e-16
e
$p1line1_0 << e
1.150764778e-03 4.440892099e-16
8.283470000e-04 4.440892099e-16
7.847000000e-04 4.440892099e-16
7.816284615e-04 4.440892099e-16
7.774506154e-04 4.440892099e-16
7.750909231e-04 4.440892099e-16
7.730358571e-04 4.440892099e-16
7.733170000e-04 4.440892099e-16
e
$p1spread1 << e
1.150764778e-03 4.440892099e-16 1.141825889e-03 1.152171333e-03
8.283470000e-04 4.440892099e-16 8.156671538e-04 8.307043846e-04
7.847000000e-04 4.440892099e-16 7.811469231e-04 7.875565385e-04
7.816284615e-04 4.440892099e-16 7.798943077e-04 7.856983077e-04
7.774506154e-04 4.440892099e-16 7.756486923e-04 7.819789231e-04
7.750909231e-04 4.440892099e-16 7.722196923e-04 7.811161538e-04
7.730358571e-04 4.440892099e-16 7.706837857e-04 7.787608571e-04
7.733170000e-04 4.440892099e-16 7.723920714e-04 7.741346429e-04
e
$p1points1 << e
1.150764778e-03 4.440892099e-16
8.283470000e-04 4.440892099e-16
7.847000000e-04 4.440892099e-16
7.816284615e-04 4.440892099e-16
7.774506154e-04 4.440892099e-16
7.750909231e-04 4.440892099e-16
7.730358571e-04 4.440892099e-16
7.733170000e-04 4.440892099e-16
e
$p1line2_0 << e
1.028983300e-03 1.000000000e+00
1.963900667e-03 8.843691151e-01
1.315312750e-03 2.996188414e-01
1.170813778e-03 1.080088236e-01
1.096202200e-03 3.266282667e-02
6.827693333e-04 8.491973777e-03
6.749796000e-04 2.152811699e-03
6.822719333e-04 2.103942508e-04
e
$p1spread2 << e
1.028983300e-03 1.000000000e+00 1.024955200e-03 1.047637200e-03
1.963900667e-03 8.843691151e-01 1.952640500e-03 1.971373500e-03
1.315312750e-03 2.996188414e-01 1.311913875e-03 1.324882125e-03
1.170813778e-03 1.080088236e-01 1.166655333e-03 1.171706222e-03
1.096202200e-03 3.266282667e-02 1.094909200e-03 1.100856100e-03
6.827693333e-04 8.491973777e-03 6.790650667e-04 6.849359333e-04
6.749796000e-04 2.152811699e-03 6.724124667e-04 6.763750667e-04
6.822719333e-04 2.103942508e-04 6.797648667e-04 6.844378667e-04
e
$p1points2 << e
1.028983300e-03 1.000000000e+00
1.963900667e-03 8.843691151e-01
1.315312750e-03 2.996188414e-01
1.170813778e-03 1.080088236e-01
1.096202200e-03 3.266282667e-02
6.827693333e-04 8.491973777e-03
6.749796000e-04 2.152811699e-03
6.822719333e-04 2.103942508e-04
e
$p1spread3 << e
2.677033158e-04 4.440892099e-16 2.659620526e-04 2.682277895e-04
e
$p1points3 << e
2.677033158e-04 4.440892099e-16
e
$p1spread4 << e
1.268116875e-03 6.661338148e-16 1.260139875e-03 1.272089125e-03
e
$p1points4 << e
1.268116875e-03 6.661338148e-16
e
set label 'default' at screen 0.659683,0.298999 left noenhanced front tc rgb '#202020'
$p1default << e
6.680356875e-04 4.440892099e-16
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#00785a' notitle, $p1points3 using 1:2 with points pt 9 ps 0.55 lc rgb '#00785a' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points4 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
