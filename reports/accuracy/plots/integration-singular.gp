# Redraw in the folder above: gnuplot plots/integration-singular.gp; as PDF: gnuplot -e 'pdf = 1' plots/integration-singular.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,7.6427 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'integration-singular.pdf'
} else {
  set terminal svg size 620,729 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'integration-singular.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Integration: through singular positions' at screen 0.0193548,0.978738 left noenhanced front tc rgb '#202020'
set label 'on N-four-bar of two loops, 10 s, ten times flat (IFToMM benchmark A02)' at screen 0.0193548,0.955418 left noenhanced front tc rgb '#5d6b79'
set label 'reference: Jacobi'."'".'s elliptic functions, long double' at screen 0.0193548,0.934842 left noenhanced front tc rgb '#5d6b79'
set label 'distance of the crank'."'".'s tip from its place, by its length' at screen 0.0193548,0.906036 left noenhanced front tc rgb '#202020'
set label 'failed: the same at 1e-11 with looks on its way, 800 instants: the step vanishes' at screen 0.0193548,0.180384 left noenhanced front tc rgb '#5d6b79'
set label 'failed: Dormand-Prince 5(4) with projection, tolerance 1e-10 to tolerance 1e-13 (4' at screen 0.0193548,0.159808 left noenhanced front tc rgb '#5d6b79'
set label 'settings): the step vanishes' at screen 0.0193548,0.139232 left noenhanced front tc rgb '#5d6b79'
set label 'failed: generalised alpha (radius 0.8), 128 steps, 2048 steps, 16384 steps: Newton does' at screen 0.0193548,0.118656 left noenhanced front tc rgb '#5d6b79'
set label 'not converge' at screen 0.0193548,0.0980796 left noenhanced front tc rgb '#5d6b79'
set label 'failed: Newmark (average acceleration), 128 steps to 16384 steps (8 settings): Newton' at screen 0.0193548,0.0775034 left noenhanced front tc rgb '#5d6b79'
set label 'does not converge' at screen 0.0193548,0.0569273 left noenhanced front tc rgb '#5d6b79'
set label 'failed: central differences, 128 steps to 16384 steps (8 settings): Newton does not' at screen 0.0193548,0.0363512 left noenhanced front tc rgb '#5d6b79'
set label 'converge' at screen 0.0193548,0.015775 left noenhanced front tc rgb '#5d6b79'
set arrow from screen 0.256355,0.403292 to screen 0.304742,0.403292 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.280548,0.403292 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'Fehlberg 7(8) with projection' at screen 0.317645,0.403292 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.378601 to screen 0.304742,0.378601 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.280548,0.378601 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'the same at 1e-11 with looks on its way' at screen 0.317645,0.378601 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.353909 to screen 0.304742,0.353909 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.280548,0.353909 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Dormand-Prince 5(4) with projection' at screen 0.317645,0.353909 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.329218 to screen 0.304742,0.329218 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.280548,0.329218 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Runge-Kutta 4 with projection' at screen 0.317645,0.329218 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.304527 to screen 0.304742,0.304527 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.280548,0.304527 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'generalised alpha (radius 0.8)' at screen 0.317645,0.304527 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.279835 to screen 0.304742,0.279835 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.280548,0.279835 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'Newmark (average acceleration)' at screen 0.317645,0.279835 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.255144 to screen 0.304742,0.255144 nohead lw 1.1 dt (14,4) lc rgb '#5a6670'
set label '' at screen 0.280548,0.255144 point pt 10 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'central differences' at screen 0.317645,0.255144 left noenhanced front tc rgb '#202020'
set arrow from screen 0.256355,0.230453 to screen 0.304742,0.230453 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.317645,0.230453 left noenhanced front tc rgb '#202020'
set label '' at screen 0.280548,0.205761 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.317645,0.205761 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 4.842249657e-01
set tmargin at screen 8.820301783e-01
set xrange [5.566805030e+00:3.121000270e+05]
set yrange [1.000000000e-11:1.498209405e+01]
set xtics ('' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '' 30 1, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '10^{5}' 100000, '' 200000 1, '' 300000 1)
set ytics ('10^{-11}' 1e-11, '10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '10^{-1}' 0.1, '1' 1, 'failed' 3.87067101)
set label 'evaluations of the equations of motion' at screen 0.304839,0.437586 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.843621 to screen 0.509677,0.843621 nohead lw 0.8 lc rgb '#606060'
$p0line0_0 << e
9.910000000e+02 1.111654909e-02
5.830000000e+02 1.360129226e-02
7.520000000e+02 1.602586858e-03
1.883000000e+03 1.451025357e-04
2.156000000e+03 2.092111429e-05
3.274000000e+03 1.415266110e-06
3.976000000e+03 1.156348029e-07
4.548000000e+03 1.432337468e-08
4.652000000e+03 1.490846036e-08
6.186000000e+03 6.841967261e-11
6.433000000e+03 1.093170826e-08
e
$p0points0 << e
9.910000000e+02 1.111654909e-02
5.830000000e+02 1.360129226e-02
7.520000000e+02 1.602586858e-03
1.883000000e+03 1.451025357e-04
2.156000000e+03 2.092111429e-05
3.274000000e+03 1.415266110e-06
3.976000000e+03 1.156348029e-07
4.548000000e+03 1.432337468e-08
4.652000000e+03 1.490846036e-08
6.186000000e+03 6.841967261e-11
6.433000000e+03 1.093170826e-08
e
$p0line1_0 << e
6.331000000e+03 2.309101835e-09
7.202000000e+03 1.409492410e-08
5.265000000e+03 2.331109587e-07
6.279000000e+03 1.025560974e-08
8.996000000e+03 5.362581840e-09
e
$p0points1 << e
6.331000000e+03 2.309101835e-09
7.202000000e+03 1.409492410e-08
5.265000000e+03 2.331109587e-07
6.279000000e+03 1.025560974e-08
8.996000000e+03 5.362581840e-09
3.452800000e+04 1.008450210e-06
e
$p0failed1 << e
1.162200000e+04 3.870671008e+00
e
$p0line2_0 << e
4.140000000e+02 1.645212660e-01
6.310000000e+02 6.499378191e-03
9.180000000e+02 3.108414324e-04
1.373000000e+03 3.426391932e-05
1.919000000e+03 2.088209420e-06
2.745000000e+03 1.547834127e-07
4.271000000e+03 1.497719112e-08
e
$p0points2 << e
4.140000000e+02 1.645212660e-01
6.310000000e+02 6.499378191e-03
9.180000000e+02 3.108414324e-04
1.373000000e+03 3.426391932e-05
1.919000000e+03 2.088209420e-06
2.745000000e+03 1.547834127e-07
4.271000000e+03 1.497719112e-08
e
$p0failed2 << e
3.856300000e+04 3.870671008e+00
5.420800000e+04 3.870671008e+00
8.946700000e+04 3.870671008e+00
1.737400000e+05 3.870671008e+00
e
$p0line3_0 << e
5.130000000e+02 1.287003160e-02
1.025000000e+03 4.391333036e-04
2.049000000e+03 1.497365821e-05
4.097000000e+03 6.817701698e-07
8.193000000e+03 3.144480397e-07
1.638500000e+04 2.975677507e-07
3.276900000e+04 1.519307973e-06
6.553700000e+04 2.712515392e-05
e
$p0points3 << e
5.130000000e+02 1.287003160e-02
1.025000000e+03 4.391333036e-04
2.049000000e+03 1.497365821e-05
4.097000000e+03 6.817701698e-07
8.193000000e+03 3.144480397e-07
1.638500000e+04 2.975677507e-07
3.276900000e+04 1.519307973e-06
6.553700000e+04 2.712515392e-05
e
$p0line4_0 << e
1.780000000e+03 1.195570873e-01
2.902000000e+03 2.556363821e-02
4.828000000e+03 5.567382453e-03
e
$p0line4_1 << e
1.530200000e+04 3.046259313e-04
2.732800000e+04 7.428770604e-05
e
$p0points4 << e
1.780000000e+03 1.195570873e-01
2.902000000e+03 2.556363821e-02
4.828000000e+03 5.567382453e-03
1.530200000e+04 3.046259313e-04
2.732800000e+04 7.428770604e-05
e
$p0failed4 << e
1.363000000e+03 3.870671008e+00
7.972000000e+03 3.870671008e+00
1.341800000e+04 3.870671008e+00
e
$p0failed5 << e
5.030000000e+02 3.870671008e+00
1.079000000e+03 3.870671008e+00
2.323000000e+03 3.870671008e+00
3.914000000e+03 3.870671008e+00
4.916000000e+03 3.870671008e+00
1.955900000e+04 3.870671008e+00
3.739900000e+04 3.870671008e+00
1.338100000e+04 3.870671008e+00
e
$p0failed6 << e
1.000000000e+01 3.870671008e+00
1.900000000e+01 3.870671008e+00
3.800000000e+01 3.870671008e+00
7.400000000e+01 3.870671008e+00
1.470000000e+02 3.870671008e+00
2.940000000e+02 3.870671008e+00
5.860000000e+02 3.870671008e+00
1.172000000e+03 3.870671008e+00
e
set label 'default' at screen 0.262153,0.572874 left noenhanced front tc rgb '#202020'
$p0default << e
4.652000000e+03 1.490846036e-08
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0failed1 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0failed2 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0line4_1 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0failed4 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#7a6a8c' notitle, $p0failed5 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#4a716a' notitle, $p0failed6 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 4.842249657e-01
set tmargin at screen 8.820301783e-01
set xrange [5.992978909e-04:7.072352628e-02]
set yrange [1.000000000e-11:1.498209405e+01]
set xtics ('' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1)
set ytics ('' 1e-11, '' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1, '' 1)
set label 'time per motion of 10 s' at screen 0.762903,0.437586 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.843621 to screen 0.967742,0.843621 nohead lw 0.8 lc rgb '#606060'
$p1line0_0 << e
2.645950750e-03 1.111654909e-02
1.103311800e-03 1.360129226e-02
1.582110000e-03 1.602586858e-03
3.107638750e-03 1.451025357e-04
3.587510667e-03 2.092111429e-05
4.206002000e-03 1.415266110e-06
5.346353500e-03 1.156348029e-07
6.570576000e-03 1.432337468e-08
6.302744000e-03 1.490846036e-08
6.338187000e-03 6.841967261e-11
5.857851500e-03 1.093170826e-08
e
$p1spread0 << e
2.645950750e-03 1.111654909e-02 2.635254750e-03 2.699236000e-03
1.103311800e-03 1.360129226e-02 1.082570700e-03 1.109428000e-03
1.582110000e-03 1.602586858e-03 1.555058000e-03 1.591408429e-03
3.107638750e-03 1.451025357e-04 3.086950250e-03 3.122992000e-03
3.587510667e-03 2.092111429e-05 3.566496000e-03 3.604783333e-03
4.206002000e-03 1.415266110e-06 4.162854000e-03 4.223909000e-03
5.346353500e-03 1.156348029e-07 5.275196500e-03 5.371997000e-03
6.570576000e-03 1.432337468e-08 6.512368500e-03 6.596370000e-03
6.302744000e-03 1.490846036e-08 6.258808000e-03 6.333414500e-03
6.338187000e-03 6.841967261e-11 6.256164000e-03 6.418207000e-03
5.857851500e-03 1.093170826e-08 5.826875000e-03 5.984832000e-03
e
$p1points0 << e
2.645950750e-03 1.111654909e-02
1.103311800e-03 1.360129226e-02
1.582110000e-03 1.602586858e-03
3.107638750e-03 1.451025357e-04
3.587510667e-03 2.092111429e-05
4.206002000e-03 1.415266110e-06
5.346353500e-03 1.156348029e-07
6.570576000e-03 1.432337468e-08
6.302744000e-03 1.490846036e-08
6.338187000e-03 6.841967261e-11
5.857851500e-03 1.093170826e-08
e
$p1line1_0 << e
8.008018000e-03 2.309101835e-09
8.340782500e-03 1.409492410e-08
5.022743000e-03 2.331109587e-07
7.140195500e-03 1.025560974e-08
9.718205000e-03 5.362581840e-09
e
$p1spread1 << e
8.008018000e-03 2.309101835e-09 7.904297500e-03 8.104468000e-03
8.340782500e-03 1.409492410e-08 8.332480500e-03 8.515504500e-03
5.022743000e-03 2.331109587e-07 4.966884000e-03 5.146869500e-03
7.140195500e-03 1.025560974e-08 7.025589000e-03 7.256295000e-03
9.718205000e-03 5.362581840e-09 9.674879500e-03 1.000900100e-02
3.082062500e-02 1.008450210e-06 3.058044400e-02 3.165048000e-02
e
$p1points1 << e
8.008018000e-03 2.309101835e-09
8.340782500e-03 1.409492410e-08
5.022743000e-03 2.331109587e-07
7.140195500e-03 1.025560974e-08
9.718205000e-03 5.362581840e-09
3.082062500e-02 1.008450210e-06
e
$p1failed1 << e
9.718205000e-03 3.870671008e+00
e
$p1line2_0 << e
7.904097857e-04 1.645212660e-01
9.722662857e-04 6.499378191e-03
1.235163625e-03 3.108414324e-04
1.616370143e-03 3.426391932e-05
2.147056200e-03 2.088209420e-06
3.051126500e-03 1.547834127e-07
4.178925000e-03 1.497719112e-08
e
$p1spread2 << e
7.904097857e-04 1.645212660e-01 7.833749286e-04 8.005127857e-04
9.722662857e-04 6.499378191e-03 9.602068571e-04 9.819164286e-04
1.235163625e-03 3.108414324e-04 1.222345625e-03 1.248474875e-03
1.616370143e-03 3.426391932e-05 1.589721429e-03 1.644520857e-03
2.147056200e-03 2.088209420e-06 2.127018200e-03 2.221051200e-03
3.051126500e-03 1.547834127e-07 2.985828500e-03 3.123557750e-03
4.178925000e-03 1.497719112e-08 4.124236000e-03 4.273530333e-03
e
$p1points2 << e
7.904097857e-04 1.645212660e-01
9.722662857e-04 6.499378191e-03
1.235163625e-03 3.108414324e-04
1.616370143e-03 3.426391932e-05
2.147056200e-03 2.088209420e-06
3.051126500e-03 1.547834127e-07
4.178925000e-03 1.497719112e-08
e
$p1failed2 << e
4.178925000e-03 3.870671008e+00
4.178925000e-03 3.870671008e+00
4.178925000e-03 3.870671008e+00
4.178925000e-03 3.870671008e+00
e
$p1line3_0 << e
7.893145385e-04 1.287003160e-02
1.568014714e-03 4.391333036e-04
2.751431750e-03 1.497365821e-05
4.617042333e-03 6.817701698e-07
8.301323500e-03 3.144480397e-07
1.556935600e-02 2.975677507e-07
2.920289600e-02 1.519307973e-06
5.382257500e-02 2.712515392e-05
e
$p1spread3 << e
7.893145385e-04 1.287003160e-02 7.738174615e-04 8.084510000e-04
1.568014714e-03 4.391333036e-04 1.554163857e-03 1.594355571e-03
2.751431750e-03 1.497365821e-05 2.740858250e-03 2.819156000e-03
4.617042333e-03 6.817701698e-07 4.549607667e-03 4.705565333e-03
8.301323500e-03 3.144480397e-07 8.256676500e-03 8.572345000e-03
1.556935600e-02 2.975677507e-07 1.543674600e-02 1.607680700e-02
2.920289600e-02 1.519307973e-06 2.904348700e-02 2.983275200e-02
5.382257500e-02 2.712515392e-05 5.308958500e-02 5.477320200e-02
e
$p1points3 << e
7.893145385e-04 1.287003160e-02
1.568014714e-03 4.391333036e-04
2.751431750e-03 1.497365821e-05
4.617042333e-03 6.817701698e-07
8.301323500e-03 3.144480397e-07
1.556935600e-02 2.975677507e-07
2.920289600e-02 1.519307973e-06
5.382257500e-02 2.712515392e-05
e
$p1line4_0 << e
1.214839778e-03 1.195570873e-01
2.103941600e-03 2.556363821e-02
3.334276500e-03 5.567382453e-03
e
$p1line4_1 << e
9.549621500e-03 3.046259313e-04
1.672655300e-02 7.428770604e-05
e
$p1spread4 << e
1.214839778e-03 1.195570873e-01 1.204454222e-03 1.241743556e-03
2.103941600e-03 2.556363821e-02 2.062763800e-03 2.119218400e-03
3.334276500e-03 5.567382453e-03 3.270428250e-03 3.381126750e-03
9.549621500e-03 3.046259313e-04 9.166071000e-03 9.623853000e-03
1.672655300e-02 7.428770604e-05 1.636904600e-02 1.682458000e-02
e
$p1points4 << e
1.214839778e-03 1.195570873e-01
2.103941600e-03 2.556363821e-02
3.334276500e-03 5.567382453e-03
9.549621500e-03 3.046259313e-04
1.672655300e-02 7.428770604e-05
e
$p1failed4 << e
1.214839778e-03 3.870671008e+00
3.334276500e-03 3.870671008e+00
1.672655300e-02 3.870671008e+00
e
$p1failed5 << e
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
e
$p1failed6 << e
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
5.992978909e-04 3.870671008e+00
e
set label 'default' at screen 0.782701,0.608763 left noenhanced front tc rgb '#202020'
$p1default << e
6.302744000e-03 1.490846036e-08
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1failed1 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#c8500a' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1failed2 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1line4_1 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1failed4 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#7a6a8c' notitle, $p1failed5 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#4a716a' notitle, $p1failed6 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
