# Redraw in the folder above: gnuplot plots/critical-instants-nodes.gp; as PDF: gnuplot -e 'pdf = 1' plots/critical-instants-nodes.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.2839 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'critical-instants-nodes.pdf'
} else {
  set terminal svg size 620,504 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'critical-instants-nodes.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Peak over time: solves that it is interpolated through' at screen 0.0193548,0.969246 left noenhanced front tc rgb '#202020'
set label 'on a wave of 8 instants, and slides of slider-cranks at the instants of the program' at screen 0.0193548,0.935516 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed form' at screen 0.0193548,0.905754 left noenhanced front tc rgb '#5d6b79'
set label 'error of the peak, relative, worst of 16 places between the instants' at screen 0.0193548,0.864087 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0599355,0.136905 to screen 0.108323,0.136905 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.084129,0.136905 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'a wave of 8 instants' at screen 0.121226,0.136905 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0599355,0.10119 to screen 0.108323,0.10119 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.084129,0.10119 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'r/l = 0.5' at screen 0.121226,0.10119 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0599355,0.0654762 to screen 0.108323,0.0654762 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.084129,0.0654762 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'r/l = 0.95' at screen 0.121226,0.0654762 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0599355,0.0297619 to screen 0.108323,0.0297619 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.084129,0.0297619 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'r/l = 0.99' at screen 0.121226,0.0297619 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.136905 to screen 0.558065,0.136905 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.533871,0.136905 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'the program, a wave of 8 instants' at screen 0.570968,0.136905 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.10119 to screen 0.558065,0.10119 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.10119 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0654762 to screen 0.558065,0.0654762 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.570968,0.0654762 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0297619 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0297619 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.539682540e-01
set tmargin at screen 8.293650794e-01
set xrange [1.802775638e+00:2.163330765e+01]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('2' 2, '' 3 1, '' 4 1, '5' 5, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '20' 20)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'solves per peak' at screen 0.304839,0.186508 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.268207 to screen 0.509677,0.268207 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
3.000000000e+00 8.470954970e-03
5.000000000e+00 7.493070641e-05
7.000000000e+00 2.145448406e-07
9.000000000e+00 6.261215990e-10
1.100000000e+01 9.285905378e-13
1.300000000e+01 7.216449660e-15
e
$p0points0 << e
3.000000000e+00 8.470954970e-03
5.000000000e+00 7.493070641e-05
7.000000000e+00 2.145448406e-07
9.000000000e+00 6.261215990e-10
1.100000000e+01 9.285905378e-13
1.300000000e+01 7.216449660e-15
e
$p0line1_0 << e
3.000000000e+00 8.359933430e-07
5.000000000e+00 4.620592797e-10
7.000000000e+00 3.833970178e-14
9.000000000e+00 4.440892099e-16
1.100000000e+01 1.480297366e-16
1.300000000e+01 2.960594732e-16
e
$p0points1 << e
3.000000000e+00 8.359933430e-07
5.000000000e+00 4.620592797e-10
7.000000000e+00 3.833970178e-14
9.000000000e+00 4.440892099e-16
1.100000000e+01 1.480297366e-16
1.300000000e+01 2.960594732e-16
e
$p0line2_0 << e
3.000000000e+00 2.080819422e-04
5.000000000e+00 1.040947196e-06
7.000000000e+00 3.505597112e-09
9.000000000e+00 1.224390965e-11
1.100000000e+01 4.325494238e-14
1.300000000e+01 4.601589615e-16
e
$p0points2 << e
3.000000000e+00 2.080819422e-04
5.000000000e+00 1.040947196e-06
7.000000000e+00 3.505597112e-09
9.000000000e+00 1.224390965e-11
1.100000000e+01 4.325494238e-14
1.300000000e+01 4.601589615e-16
e
$p0line3_0 << e
3.000000000e+00 2.083588744e-04
5.000000000e+00 1.352481719e-06
7.000000000e+00 5.391806897e-09
9.000000000e+00 2.957654890e-11
1.100000000e+01 1.337084937e-13
1.300000000e+01 5.113135515e-16
e
$p0points3 << e
3.000000000e+00 2.083588744e-04
5.000000000e+00 1.352481719e-06
7.000000000e+00 5.391806897e-09
9.000000000e+00 2.957654890e-11
1.100000000e+01 1.337084937e-13
1.300000000e+01 5.113135515e-16
e
$p0points4 << e
9.000000000e+00 6.261213770e-10
e
set label 'default' at screen 0.377991,0.555056 left noenhanced front tc rgb '#202020'
$p0default << e
9.000000000e+00 6.261213770e-10
e
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points2 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p0points3 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p0points4 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.539682540e-01
set tmargin at screen 8.293650794e-01
set xrange [3.553266790e-07:5.093320868e-06]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 4e-07 1, '500 ns' 5e-07, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '2 µs' 2e-06, '' 3e-06 1, '' 4e-06 1, '5 µs' 5e-06)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01)
set label 'time per peak' at screen 0.762903,0.186508 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.268207 to screen 0.967742,0.268207 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1line0_0 << e
4.127480521e-07 8.470954970e-03
7.365361414e-07 7.493070641e-05
9.941175804e-07 2.145448406e-07
1.236501261e-06 6.261215990e-10
1.506093124e-06 9.285905378e-13
1.736111884e-06 7.216449660e-15
e
$p1spread0 << e
4.127480521e-07 8.470954970e-03 4.098041784e-07 4.184227245e-07
7.365361414e-07 7.493070641e-05 7.346404905e-07 7.374537284e-07
9.941175804e-07 2.145448406e-07 9.919039571e-07 1.004046991e-06
1.236501261e-06 6.261215990e-10 1.234708628e-06 1.237845232e-06
1.506093124e-06 9.285905378e-13 1.493284767e-06 1.509519581e-06
1.736111884e-06 7.216449660e-15 1.735102070e-06 1.740908637e-06
e
$p1points0 << e
4.127480521e-07 8.470954970e-03
7.365361414e-07 7.493070641e-05
9.941175804e-07 2.145448406e-07
1.236501261e-06 6.261215990e-10
1.506093124e-06 9.285905378e-13
1.736111884e-06 7.216449660e-15
e
$p1line1_0 << e
5.648268704e-07 8.359933430e-07
9.650925871e-07 4.620592797e-10
1.343130595e-06 3.833970178e-14
1.657176401e-06 4.440892099e-16
2.051838155e-06 1.480297366e-16
2.399748532e-06 2.960594732e-16
e
$p1spread1 << e
5.648268704e-07 8.359933430e-07 5.645395650e-07 5.665806753e-07
9.650925871e-07 4.620592797e-10 9.639092883e-07 9.702182410e-07
1.343130595e-06 3.833970178e-14 1.337689956e-06 1.347637964e-06
1.657176401e-06 4.440892099e-16 1.652344700e-06 1.658735145e-06
2.051838155e-06 1.480297366e-16 2.050179665e-06 2.061574004e-06
2.399748532e-06 2.960594732e-16 2.390843444e-06 2.404817515e-06
e
$p1points1 << e
5.648268704e-07 8.359933430e-07
9.650925871e-07 4.620592797e-10
1.343130595e-06 3.833970178e-14
1.657176401e-06 4.440892099e-16
2.051838155e-06 1.480297366e-16
2.399748532e-06 2.960594732e-16
e
$p1line2_0 << e
8.176706905e-07 2.080819422e-04
1.414940610e-06 1.040947196e-06
1.939473882e-06 3.505597112e-09
2.451888281e-06 1.224390965e-11
2.994047344e-06 4.325494238e-14
3.510845552e-06 4.601589615e-16
e
$p1spread2 << e
8.176706905e-07 2.080819422e-04 8.149306095e-07 8.225191626e-07
1.414940610e-06 1.040947196e-06 1.413336209e-06 1.417001582e-06
1.939473882e-06 3.505597112e-09 1.938397705e-06 1.949841512e-06
2.451888281e-06 1.224390965e-11 2.443276188e-06 2.465471510e-06
2.994047344e-06 4.325494238e-14 2.973606980e-06 3.008585129e-06
3.510845552e-06 4.601589615e-16 3.502601779e-06 3.521406050e-06
e
$p1points2 << e
8.176706905e-07 2.080819422e-04
1.414940610e-06 1.040947196e-06
1.939473882e-06 3.505597112e-09
2.451888281e-06 1.224390965e-11
2.994047344e-06 4.325494238e-14
3.510845552e-06 4.601589615e-16
e
$p1line3_0 << e
8.171502604e-07 2.083588744e-04
1.419072445e-06 1.352481719e-06
1.941277832e-06 5.391806897e-09
2.443766026e-06 2.957654890e-11
3.006022547e-06 1.337084937e-13
3.525065574e-06 5.113135515e-16
e
$p1spread3 << e
8.171502604e-07 2.083588744e-04 8.134835377e-07 8.210053754e-07
1.419072445e-06 1.352481719e-06 1.417431825e-06 1.423720894e-06
1.941277832e-06 5.391806897e-09 1.938416650e-06 1.954511879e-06
2.443766026e-06 2.957654890e-11 2.435077170e-06 2.453959073e-06
3.006022547e-06 1.337084937e-13 2.989419257e-06 3.016986594e-06
3.525065574e-06 5.113135515e-16 3.517845331e-06 3.527111190e-06
e
$p1points3 << e
8.171502604e-07 2.083588744e-04
1.419072445e-06 1.352481719e-06
1.941277832e-06 5.391806897e-09
2.443766026e-06 2.957654890e-11
3.006022547e-06 1.337084937e-13
3.525065574e-06 5.113135515e-16
e
$p1spread4 << e
4.385757060e-06 6.261213770e-10 4.361507396e-06 4.416238010e-06
e
$p1points4 << e
4.385757060e-06 6.261213770e-10
e
set label 'default' at screen 0.854794,0.555056 left noenhanced front tc rgb '#202020'
$p1default << e
4.385757060e-06 6.261213770e-10
e
plot $p1line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points2 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#4a716a' notitle, $p1points3 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points4 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
