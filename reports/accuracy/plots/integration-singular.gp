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
set ytics ('10^{-11}' 1e-11, '10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '0.1' 0.1, '1' 1, 'failed' 3.87067101)
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
set xrange [5.939197757e-04:7.018996207e-02]
set yrange [1.000000000e-11:1.498209405e+01]
set xtics ('' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1)
set ytics ('' 1e-11, '' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1, '' 1)
set label 'time per motion of 10 s' at screen 0.762903,0.437586 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.843621 to screen 0.967742,0.843621 nohead lw 0.8 lc rgb '#606060'
$p1line0_0 << e
2.583034000e-03 1.111654909e-02
1.058778000e-03 1.360129226e-02
1.534066571e-03 1.602586858e-03
2.994466500e-03 1.451025357e-04
3.497655667e-03 2.092111429e-05
4.077406000e-03 1.415266110e-06
5.184656000e-03 1.156348029e-07
6.377891500e-03 1.432337468e-08
6.133164000e-03 1.490846036e-08
6.205843500e-03 6.841967261e-11
5.707566000e-03 1.093170826e-08
e
$p1spread0 << e
2.583034000e-03 1.111654909e-02 2.566131250e-03 2.591058500e-03
1.058778000e-03 1.360129226e-02 1.055737400e-03 1.066991300e-03
1.534066571e-03 1.602586858e-03 1.517886571e-03 1.542407571e-03
2.994466500e-03 1.451025357e-04 2.983234750e-03 3.018157250e-03
3.497655667e-03 2.092111429e-05 3.458420000e-03 3.506933333e-03
4.077406000e-03 1.415266110e-06 4.050268333e-03 4.123505000e-03
5.184656000e-03 1.156348029e-07 5.134811000e-03 5.193204000e-03
6.377891500e-03 1.432337468e-08 6.312333500e-03 6.384672000e-03
6.133164000e-03 1.490846036e-08 6.057120500e-03 6.204867000e-03
6.205843500e-03 6.841967261e-11 6.158152000e-03 6.244311000e-03
5.707566000e-03 1.093170826e-08 5.598892500e-03 5.783860500e-03
e
$p1points0 << e
2.583034000e-03 1.111654909e-02
1.058778000e-03 1.360129226e-02
1.534066571e-03 1.602586858e-03
2.994466500e-03 1.451025357e-04
3.497655667e-03 2.092111429e-05
4.077406000e-03 1.415266110e-06
5.184656000e-03 1.156348029e-07
6.377891500e-03 1.432337468e-08
6.133164000e-03 1.490846036e-08
6.205843500e-03 6.841967261e-11
5.707566000e-03 1.093170826e-08
e
$p1line1_0 << e
7.770521500e-03 2.309101835e-09
8.295109000e-03 1.409492410e-08
4.966834000e-03 2.331109587e-07
7.047672000e-03 1.025560974e-08
9.702671500e-03 5.362581840e-09
e
$p1spread1 << e
7.770521500e-03 2.309101835e-09 7.667612500e-03 7.931648500e-03
8.295109000e-03 1.409492410e-08 8.238383500e-03 8.367272500e-03
4.966834000e-03 2.331109587e-07 4.825532000e-03 5.003704000e-03
7.047672000e-03 1.025560974e-08 6.940756500e-03 7.111642500e-03
9.702671500e-03 5.362581840e-09 9.350678000e-03 9.722411000e-03
3.058511100e-02 1.008450210e-06 3.050850600e-02 3.087129000e-02
e
$p1points1 << e
7.770521500e-03 2.309101835e-09
8.295109000e-03 1.409492410e-08
4.966834000e-03 2.331109587e-07
7.047672000e-03 1.025560974e-08
9.702671500e-03 5.362581840e-09
3.058511100e-02 1.008450210e-06
e
$p1failed1 << e
9.702671500e-03 3.870671008e+00
e
$p1line2_0 << e
7.783309286e-04 1.645212660e-01
9.459131818e-04 6.499378191e-03
1.206132333e-03 3.108414324e-04
1.587887286e-03 3.426391932e-05
2.120734600e-03 2.088209420e-06
2.988024250e-03 1.547834127e-07
4.128068667e-03 1.497719112e-08
e
$p1spread2 << e
7.783309286e-04 1.645212660e-01 7.673180000e-04 7.843349286e-04
9.459131818e-04 6.499378191e-03 9.416459091e-04 9.588517273e-04
1.206132333e-03 3.108414324e-04 1.201824778e-03 1.213596889e-03
1.587887286e-03 3.426391932e-05 1.576331286e-03 1.594867857e-03
2.120734600e-03 2.088209420e-06 2.091394800e-03 2.135538800e-03
2.988024250e-03 1.547834127e-07 2.929539000e-03 3.011329250e-03
4.128068667e-03 1.497719112e-08 4.061709000e-03 4.173987333e-03
e
$p1points2 << e
7.783309286e-04 1.645212660e-01
9.459131818e-04 6.499378191e-03
1.206132333e-03 3.108414324e-04
1.587887286e-03 3.426391932e-05
2.120734600e-03 2.088209420e-06
2.988024250e-03 1.547834127e-07
4.128068667e-03 1.497719112e-08
e
$p1failed2 << e
4.128068667e-03 3.870671008e+00
4.128068667e-03 3.870671008e+00
4.128068667e-03 3.870671008e+00
4.128068667e-03 3.870671008e+00
e
$p1line3_0 << e
7.732047143e-04 1.287003160e-02
1.541098571e-03 4.391333036e-04
2.744038250e-03 1.497365821e-05
4.603943000e-03 6.817701698e-07
8.311002500e-03 3.144480397e-07
1.554224500e-02 2.975677507e-07
2.937407400e-02 1.519307973e-06
5.396113200e-02 2.712515392e-05
e
$p1spread3 << e
7.732047143e-04 1.287003160e-02 7.669324286e-04 7.845424286e-04
1.541098571e-03 4.391333036e-04 1.533879143e-03 1.556863714e-03
2.744038250e-03 1.497365821e-05 2.696299000e-03 2.768199250e-03
4.603943000e-03 6.817701698e-07 4.524019333e-03 4.747762000e-03
8.311002500e-03 3.144480397e-07 8.284232500e-03 8.349665500e-03
1.554224500e-02 2.975677507e-07 1.543768900e-02 1.569651600e-02
2.937407400e-02 1.519307973e-06 2.921242000e-02 2.952667200e-02
5.396113200e-02 2.712515392e-05 5.287976900e-02 5.435577500e-02
e
$p1points3 << e
7.732047143e-04 1.287003160e-02
1.541098571e-03 4.391333036e-04
2.744038250e-03 1.497365821e-05
4.603943000e-03 6.817701698e-07
8.311002500e-03 3.144480397e-07
1.554224500e-02 2.975677507e-07
2.937407400e-02 1.519307973e-06
5.396113200e-02 2.712515392e-05
e
$p1line4_0 << e
1.193372000e-03 1.195570873e-01
2.048127800e-03 2.556363821e-02
3.261945500e-03 5.567382453e-03
e
$p1line4_1 << e
9.332461000e-03 3.046259313e-04
1.609613600e-02 7.428770604e-05
e
$p1spread4 << e
1.193372000e-03 1.195570873e-01 1.172452889e-03 1.204121556e-03
2.048127800e-03 2.556363821e-02 2.007080200e-03 2.064853000e-03
3.261945500e-03 5.567382453e-03 3.185185250e-03 3.269962500e-03
9.332461000e-03 3.046259313e-04 9.076306000e-03 9.354819500e-03
1.609613600e-02 7.428770604e-05 1.583692800e-02 1.630182500e-02
e
$p1points4 << e
1.193372000e-03 1.195570873e-01
2.048127800e-03 2.556363821e-02
3.261945500e-03 5.567382453e-03
9.332461000e-03 3.046259313e-04
1.609613600e-02 7.428770604e-05
e
$p1failed4 << e
1.193372000e-03 3.870671008e+00
3.261945500e-03 3.870671008e+00
1.609613600e-02 3.870671008e+00
e
$p1failed5 << e
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
e
$p1failed6 << e
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
5.939197757e-04 3.870671008e+00
e
set label 'default' at screen 0.781073,0.608763 left noenhanced front tc rgb '#202020'
$p1default << e
6.133164000e-03 1.490846036e-08
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1failed1 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#c8500a' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1failed2 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1line4_1 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1failed4 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#7a6a8c' notitle, $p1failed5 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#4a716a' notitle, $p1failed6 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
