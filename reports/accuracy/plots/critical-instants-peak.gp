# Redraw in the folder above: gnuplot plots/critical-instants-peak.gp; as PDF: gnuplot -e 'pdf = 1' plots/critical-instants-peak.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.8500 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'critical-instants-peak.pdf'
} else {
  set terminal svg size 620,558 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'critical-instants-peak.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Peak over time: bending moment' at screen 0.0193548,0.972222 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, M at s = 3.2 m, 1.429 s' at screen 0.0193548,0.941756 left noenhanced front tc rgb '#5d6b79'
set label 'reference: Brent'."'".'s method on exact solves about every peak of four times the instants' at screen 0.0193548,0.914875 left noenhanced front tc rgb '#5d6b79'
set label 'error of the largest M, relative, worst of 8 places between the instants' at screen 0.0193548,0.87724 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.22043 to screen 0.276677,0.22043 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.252484,0.22043 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'interpolated through 9 solves, then searched' at screen 0.289581,0.22043 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.188172 to screen 0.276677,0.188172 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.252484,0.188172 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Brent'."'".'s method, every value a solve' at screen 0.289581,0.188172 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.155914 to screen 0.276677,0.155914 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.252484,0.155914 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'instants and a parabola' at screen 0.289581,0.155914 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.123656 to screen 0.276677,0.123656 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.252484,0.123656 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'instants alone' at screen 0.289581,0.123656 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.0913978 to screen 0.276677,0.0913978 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.289581,0.0913978 left noenhanced front tc rgb '#202020'
set arrow from screen 0.22829,0.0591398 to screen 0.276677,0.0591398 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.289581,0.0591398 left noenhanced front tc rgb '#202020'
set label '' at screen 0.252484,0.0268817 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.289581,0.0268817 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 3.261648746e-01
set tmargin at screen 8.458781362e-01
set xrange [4.658699101e+00:5.241806666e+02]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 5 1, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'instants solved' at screen 0.304839,0.265233 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.337418 to screen 0.509677,0.337418 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
1.200000000e+01 7.346490277e-06
1.800000000e+01 1.820159331e-08
3.000000000e+01 2.343156117e-11
5.400000000e+01 2.458085259e-14
1.020000000e+02 7.283215583e-16
1.980000000e+02 3.641607792e-16
3.900000000e+02 5.462411688e-16
e
$p0points0 << e
1.200000000e+01 7.346490277e-06
1.800000000e+01 1.820159331e-08
3.000000000e+01 2.343156117e-11
5.400000000e+01 2.458085259e-14
1.020000000e+02 7.283215583e-16
1.980000000e+02 3.641607792e-16
3.900000000e+02 5.462411688e-16
e
$p0line1_0 << e
1.400000000e+01 7.283215583e-16
1.800000000e+01 1.110223025e-16
3.000000000e+01 1.110223025e-16
5.400000000e+01 1.110223025e-16
1.170000000e+02 1.110223025e-16
2.140000000e+02 1.110223025e-16
4.070000000e+02 1.110223025e-16
e
$p0points1 << e
1.400000000e+01 7.283215583e-16
1.800000000e+01 1.110223025e-16
3.000000000e+01 1.110223025e-16
5.400000000e+01 1.110223025e-16
1.170000000e+02 1.110223025e-16
2.140000000e+02 1.110223025e-16
4.070000000e+02 1.110223025e-16
e
$p0line2_0 << e
6.000000000e+00 2.846076766e-02
1.200000000e+01 2.224017352e-03
2.400000000e+01 1.510823787e-04
4.800000000e+01 9.663052019e-06
9.600000000e+01 6.075246115e-07
1.920000000e+02 3.802685135e-08
3.840000000e+02 2.377563849e-09
e
$p0points2 << e
6.000000000e+00 2.846076766e-02
1.200000000e+01 2.224017352e-03
2.400000000e+01 1.510823787e-04
4.800000000e+01 9.663052019e-06
9.600000000e+01 6.075246115e-07
1.920000000e+02 3.802685135e-08
3.840000000e+02 2.377563849e-09
e
$p0line3_0 << e
6.000000000e+00 1.364095713e-01
1.200000000e+01 3.488457377e-02
2.400000000e+01 8.772278199e-03
4.800000000e+01 2.196303270e-03
9.600000000e+01 5.492785267e-04
1.920000000e+02 1.373323104e-04
3.840000000e+02 3.433387018e-05
e
$p0points3 << e
6.000000000e+00 1.364095713e-01
1.200000000e+01 3.488457377e-02
2.400000000e+01 8.772278199e-03
4.800000000e+01 2.196303270e-03
9.600000000e+01 5.492785267e-04
1.920000000e+02 1.373323104e-04
3.840000000e+02 3.433387018e-05
e
set label 'default' at screen 0.380601,0.373817 left noenhanced front tc rgb '#202020'
$p0default << e
1.020000000e+02 7.283215583e-16
e
set arrow from screen 0.290008,0.668189 to screen 0.356818,0.624726 nohead lw 1 lc rgb '#404040'
set label 'order 4' at screen 0.233478,0.630618 left noenhanced front tc rgb '#404040'
set arrow from screen 0.290242,0.74292 to screen 0.364543,0.718752 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.327948,0.697682 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points3 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.261648746e-01
set tmargin at screen 8.458781362e-01
set xrange [4.022345047e-06:8.187915643e-04]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per period at one station' at screen 0.762903,0.265233 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.337418 to screen 0.967742,0.337418 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1line0_0 << e
1.602242036e-05 7.346490277e-06
2.198037273e-05 1.820159331e-08
4.745217225e-05 2.343156117e-11
8.299192373e-05 2.458085259e-14
1.575849206e-04 7.283215583e-16
3.042906061e-04 3.641607792e-16
5.945834706e-04 5.462411688e-16
e
$p1spread0 << e
1.602242036e-05 7.346490277e-06 1.598214614e-05 1.614912972e-05
2.198037273e-05 1.820159331e-08 2.194397955e-05 2.214491591e-05
4.745217225e-05 2.343156117e-11 4.674555981e-05 4.748222010e-05
8.299192373e-05 2.458085259e-14 8.272644068e-05 8.385966949e-05
1.575849206e-04 7.283215583e-16 1.554930476e-04 1.591855556e-04
3.042906061e-04 3.641607792e-16 3.009847273e-04 3.058559697e-04
5.945834706e-04 5.462411688e-16 5.918535294e-04 6.052341765e-04
e
$p1points0 << e
1.602242036e-05 7.346490277e-06
2.198037273e-05 1.820159331e-08
4.745217225e-05 2.343156117e-11
8.299192373e-05 2.458085259e-14
1.575849206e-04 7.283215583e-16
3.042906061e-04 3.641607792e-16
5.945834706e-04 5.462411688e-16
e
$p1line1_0 << e
1.795300544e-05 7.283215583e-16
2.416190120e-05 1.110223025e-16
5.036744724e-05 1.110223025e-16
8.545494068e-05 1.110223025e-16
1.581986825e-04 1.110223025e-16
3.069594545e-04 1.110223025e-16
6.108013529e-04 1.110223025e-16
e
$p1spread1 << e
1.795300544e-05 7.283215583e-16 1.768988748e-05 1.800128131e-05
2.416190120e-05 1.110223025e-16 2.396647229e-05 2.427136627e-05
5.036744724e-05 1.110223025e-16 4.967973367e-05 5.049044724e-05
8.545494068e-05 1.110223025e-16 8.465577119e-05 8.617331356e-05
1.581986825e-04 1.110223025e-16 1.576478571e-04 1.586829206e-04
3.069594545e-04 1.110223025e-16 3.049039697e-04 3.088841515e-04
6.108013529e-04 1.110223025e-16 6.088955294e-04 6.158760588e-04
e
$p1points1 << e
1.795300544e-05 7.283215583e-16
2.416190120e-05 1.110223025e-16
5.036744724e-05 1.110223025e-16
8.545494068e-05 1.110223025e-16
1.581986825e-04 1.110223025e-16
3.069594545e-04 1.110223025e-16
6.108013529e-04 1.110223025e-16
e
$p1line2_0 << e
5.379669381e-06 2.846076766e-02
1.155475291e-05 2.224017352e-03
3.671402952e-05 1.510823787e-04
7.319544118e-05 9.663052019e-06
1.461875072e-04 6.075246115e-07
2.919487143e-04 3.802685135e-08
5.844788333e-04 2.377563849e-09
e
$p1spread2 << e
5.379669381e-06 2.846076766e-02 5.359949511e-06 5.420001629e-06
1.155475291e-05 2.224017352e-03 1.148854662e-05 1.156364802e-05
3.671402952e-05 1.510823787e-04 3.664695203e-05 3.691761993e-05
7.319544118e-05 9.663052019e-06 7.271132353e-05 7.334772794e-05
1.461875072e-04 6.075246115e-07 1.457423478e-04 1.471102029e-04
2.919487143e-04 3.802685135e-08 2.892189143e-04 2.930661143e-04
5.844788333e-04 2.377563849e-09 5.811048333e-04 5.845572778e-04
e
$p1points2 << e
5.379669381e-06 2.846076766e-02
1.155475291e-05 2.224017352e-03
3.671402952e-05 1.510823787e-04
7.319544118e-05 9.663052019e-06
1.461875072e-04 6.075246115e-07
2.919487143e-04 3.802685135e-08
5.844788333e-04 2.377563849e-09
e
$p1line3_0 << e
5.396688913e-06 1.364095713e-01
1.157431389e-05 3.488457377e-02
3.690834317e-05 8.772278199e-03
7.341200735e-05 2.196303270e-03
1.457231884e-04 5.492785267e-04
2.918926286e-04 1.373323104e-04
5.858820556e-04 3.433387018e-05
e
$p1spread3 << e
5.396688913e-06 1.364095713e-01 5.347605490e-06 5.413468784e-06
1.157431389e-05 3.488457377e-02 1.152514936e-05 1.161129988e-05
3.690834317e-05 8.772278199e-03 3.675098524e-05 3.710616605e-05
7.341200735e-05 2.196303270e-03 7.298283824e-05 7.402838235e-05
1.457231884e-04 5.492785267e-04 1.450100870e-04 1.470669420e-04
2.918926286e-04 1.373323104e-04 2.895665714e-04 2.936627143e-04
5.858820556e-04 3.433387018e-05 5.804500000e-04 5.904244444e-04
e
$p1points3 << e
5.396688913e-06 1.364095713e-01
1.157431389e-05 3.488457377e-02
3.690834317e-05 8.772278199e-03
7.341200735e-05 2.196303270e-03
1.457231884e-04 5.492785267e-04
2.918926286e-04 1.373323104e-04
5.858820556e-04 3.433387018e-05
e
set label 'default' at screen 0.853652,0.373817 left noenhanced front tc rgb '#202020'
$p1default << e
1.575849206e-04 7.283215583e-16
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points3 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
