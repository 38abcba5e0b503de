# Redraw in the folder above: gnuplot plots/peers-reactions.gp; as PDF: gnuplot -e 'pdf = 1' plots/peers-reactions.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.6048 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'peers-reactions.pdf'
} else {
  set terminal svg size 620,630 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'peers-reactions.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'The rig in other programs: reactions' at screen 0.0193548,0.975397 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s in 96 instants, each from the one before' at screen 0.0193548,0.948413 left noenhanced front tc rgb '#5d6b79'
set label 'reference: circles in closed form, forces body by body, 30 digits' at screen 0.0193548,0.924603 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of a pin'."'".'s force / its largest force' at screen 0.0193548,0.89127 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.309524 to screen 0.295065,0.309524 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.270871,0.309524 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, sparse order' at screen 0.307968,0.309524 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.280952 to screen 0.295065,0.280952 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.270871,0.280952 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'boxbeam, dense' at screen 0.307968,0.280952 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.252381 to screen 0.295065,0.252381 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.270871,0.252381 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Simbody, compact tree, predicted' at screen 0.307968,0.252381 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.22381 to screen 0.295065,0.22381 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.270871,0.22381 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Simbody, compact tree, from the last' at screen 0.307968,0.22381 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.195238 to screen 0.295065,0.195238 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.270871,0.195238 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'Simbody, planar joints, predicted' at screen 0.307968,0.195238 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.166667 to screen 0.295065,0.166667 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.270871,0.166667 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'Simbody, planar joints, from the last' at screen 0.307968,0.166667 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.138095 to screen 0.295065,0.138095 nohead lw 1.1 dt (14,4) lc rgb '#5a6670'
set label '' at screen 0.270871,0.138095 point pt 10 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'numpy, plain Newton, 15 unknowns' at screen 0.307968,0.138095 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.109524 to screen 0.295065,0.109524 nohead lw 1.1 dt (2,5) lc rgb '#857650'
set label '' at screen 0.270871,0.109524 point pt 14 ps 0.55 lw 1 lc rgb '#857650'
set label 'scipy fsolve with Jacobian, 15 unknowns' at screen 0.307968,0.109524 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.0809524 to screen 0.295065,0.0809524 nohead lw 1.1 dt 1 lc rgb '#7a6a8c'
set label '' at screen 0.270871,0.0809524 point pt 6 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'scipy root, method lm, 15 unknowns' at screen 0.307968,0.0809524 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.052381 to screen 0.295065,0.052381 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.307968,0.052381 left noenhanced front tc rgb '#202020'
set label '' at screen 0.270871,0.0238095 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.307968,0.0238095 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 4.031746032e-01
set tmargin at screen 8.634920635e-01
set xrange [5.833024360e-07:4.199208528e-04]
set yrange [1.000000000e-15:1.000000000e-02]
set xtics ('' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '' 2e-06 1, '3 µs' 3e-06, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1, '30 µs' 3e-05, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '300 µs' 0.0003, '' 0.0004 1)
set ytics ('10^{-15}' 1e-15, '10^{-14}' 1e-14, '10^{-13}' 1e-13, '10^{-12}' 1e-12, '10^{-11}' 1e-11, '10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01)
set label 'time per instant, positions to reactions' at screen 0.533871,0.349206 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0spread0 << e
8.481938516e-07 1.186082761e-15 8.297782012e-07 9.089987297e-07
e
$p0points0 << e
8.481938516e-07 1.186082761e-15
e
$p0spread1 << e
2.832317073e-06 1.186082761e-15 2.770008130e-06 2.904882876e-06
e
$p0points1 << e
2.832317073e-06 1.186082761e-15
e
$p0line2_0 << e
4.055129375e-05 6.781326689e-05
5.227098958e-05 1.034018199e-06
5.276873542e-05 1.974083809e-11
5.813313958e-05 1.862447162e-11
6.344137917e-05 1.182547227e-13
e
$p0spread2 << e
4.055129375e-05 6.781326689e-05 3.986216667e-05 4.186013333e-05
5.227098958e-05 1.034018199e-06 5.050297708e-05 5.502371042e-05
5.276873542e-05 1.974083809e-11 5.174305000e-05 5.447892917e-05
5.813313958e-05 1.862447162e-11 5.737268542e-05 6.144195833e-05
6.344137917e-05 1.182547227e-13 6.274081667e-05 6.572253333e-05
e
$p0points2 << e
4.055129375e-05 6.781326689e-05
5.227098958e-05 1.034018199e-06
5.276873542e-05 1.974083809e-11
5.813313958e-05 1.862447162e-11
6.344137917e-05 1.182547227e-13
e
$p0line3_0 << e
5.960525625e-05 2.292768569e-05
6.321580833e-05 1.025794892e-07
6.722296875e-05 6.228401486e-11
7.233034167e-05 2.756722510e-12
7.517763333e-05 1.208588462e-14
e
$p0spread3 << e
5.960525625e-05 2.292768569e-05 5.860662083e-05 6.056048125e-05
6.321580833e-05 1.025794892e-07 6.203176042e-05 6.707072292e-05
6.722296875e-05 6.228401486e-11 6.555557083e-05 6.903699583e-05
7.233034167e-05 2.756722510e-12 7.107005833e-05 7.520476250e-05
7.517763333e-05 1.208588462e-14 7.315652917e-05 7.844158750e-05
e
$p0points3 << e
5.960525625e-05 2.292768569e-05
6.321580833e-05 1.025794892e-07
6.722296875e-05 6.228401486e-11
7.233034167e-05 2.756722510e-12
7.517763333e-05 1.208588462e-14
e
$p0line4_0 << e
1.414451104e-04 7.989620943e-05
1.877102396e-04 2.080786620e-06
1.934415646e-04 1.923650194e-11
1.925743438e-04 1.923650194e-11
2.410049167e-04 3.589863240e-13
e
$p0spread4 << e
1.414451104e-04 7.989620943e-05 1.399866292e-04 1.499692208e-04
1.877102396e-04 2.080786620e-06 1.826448813e-04 1.925490833e-04
1.934415646e-04 1.923650194e-11 1.900239042e-04 1.997173333e-04
1.925743438e-04 1.923650194e-11 1.880252042e-04 2.064382104e-04
2.410049167e-04 3.589863240e-13 2.331402937e-04 2.480020771e-04
e
$p0points4 << e
1.414451104e-04 7.989620943e-05
1.877102396e-04 2.080786620e-06
1.934415646e-04 1.923650194e-11
1.925743438e-04 1.923650194e-11
2.410049167e-04 3.589863240e-13
e
$p0line5_0 << e
2.184321292e-04 3.198528821e-05
2.406329521e-04 1.033957396e-07
2.409119500e-04 7.079246244e-11
2.763708479e-04 6.372752448e-12
2.880656104e-04 2.577590436e-13
e
$p0spread5 << e
2.184321292e-04 3.198528821e-05 2.106935583e-04 2.256182354e-04
2.406329521e-04 1.033957396e-07 2.337599042e-04 2.467589917e-04
2.409119500e-04 7.079246244e-11 2.377937521e-04 2.540145688e-04
2.763708479e-04 6.372752448e-12 2.717144688e-04 2.903723292e-04
2.880656104e-04 2.577590436e-13 2.813442958e-04 2.951883479e-04
e
$p0points5 << e
2.184321292e-04 3.198528821e-05
2.406329521e-04 1.033957396e-07
2.409119500e-04 7.079246244e-11
2.763708479e-04 6.372752448e-12
2.880656104e-04 2.577590436e-13
e
$p0line6_0 << e
4.725868099e-05 1.896070530e-11
4.780036458e-05 1.896070530e-11
6.587673785e-05 2.998345361e-13
6.748554861e-05 1.857021935e-15
6.667829861e-05 1.857021935e-15
8.375860417e-05 1.696756763e-15
e
$p0spread6 << e
4.725868099e-05 1.896070530e-11 4.551849609e-05 5.036241797e-05
4.780036458e-05 1.896070530e-11 4.574895000e-05 5.018915208e-05
6.587673785e-05 2.998345361e-13 6.391157639e-05 6.878822569e-05
6.748554861e-05 1.857021935e-15 6.468386458e-05 6.977952431e-05
6.667829861e-05 1.857021935e-15 6.495338194e-05 6.871769444e-05
8.375860417e-05 1.696756763e-15 8.293700347e-05 8.847467969e-05
e
$p0points6 << e
4.725868099e-05 1.896070530e-11
4.780036458e-05 1.896070530e-11
6.587673785e-05 2.998345361e-13
6.748554861e-05 1.857021935e-15
6.667829861e-05 1.857021935e-15
8.375860417e-05 1.696756763e-15
e
$p0line7_0 << e
8.554907031e-05 1.896070530e-11
8.419743490e-05 1.896070530e-11
9.355632812e-05 1.163683343e-12
9.312963802e-05 1.623375106e-15
9.491763281e-05 1.623375106e-15
1.194511250e-04 1.650029079e-15
e
$p0spread7 << e
8.554907031e-05 1.896070530e-11 8.167189323e-05 8.957034896e-05
8.419743490e-05 1.896070530e-11 8.176357639e-05 9.070821354e-05
9.355632812e-05 1.163683343e-12 8.932021094e-05 1.001402083e-04
9.312963802e-05 1.623375106e-15 9.155665104e-05 9.652543229e-05
9.491763281e-05 1.623375106e-15 9.193547396e-05 1.019500078e-04
1.194511250e-04 1.650029079e-15 1.166493333e-04 1.248329792e-04
e
$p0points7 << e
8.554907031e-05 1.896070530e-11
8.419743490e-05 1.896070530e-11
9.355632812e-05 1.163683343e-12
9.312963802e-05 1.623375106e-15
9.491763281e-05 1.623375106e-15
1.194511250e-04 1.650029079e-15
e
$p0line8_0 << e
9.663763021e-05 1.896070530e-11
9.648563281e-05 1.896070530e-11
1.152572708e-04 1.164396768e-12
1.154948437e-04 1.857021935e-15
1.152738281e-04 1.857021935e-15
1.305903594e-04 1.889452588e-15
e
$p0spread8 << e
9.663763021e-05 1.896070530e-11 9.491603646e-05 1.104144844e-04
9.648563281e-05 1.896070530e-11 9.364851302e-05 1.066959115e-04
1.152572708e-04 1.164396768e-12 1.099293021e-04 1.258010937e-04
1.154948437e-04 1.857021935e-15 1.122372969e-04 1.260379583e-04
1.152738281e-04 1.857021935e-15 1.104755052e-04 1.242391563e-04
1.305903594e-04 1.889452588e-15 1.253000677e-04 1.462213646e-04
e
$p0points8 << e
9.663763021e-05 1.896070530e-11
9.648563281e-05 1.896070530e-11
1.152572708e-04 1.164396768e-12
1.154948437e-04 1.857021935e-15
1.152738281e-04 1.857021935e-15
1.305903594e-04 1.889452588e-15
e
set label 'default' at screen 0.162285,0.423196 left noenhanced front tc rgb '#202020'
$p0default << e
8.481938516e-07 1.186082761e-15
e
plot $p0spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p0points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p0points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0line5_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p0spread5 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#4a716a' notitle, $p0points5 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p0line6_0 using 1:2 with lines lw 1.1 dt (14,4) lc rgb '#5a6670' notitle, $p0spread6 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p0points6 using 1:2 with points pt 10 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line7_0 using 1:2 with lines lw 1.1 dt (2,5) lc rgb '#857650' notitle, $p0spread7 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p0points7 using 1:2 with points pt 14 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line8_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#7a6a8c' notitle, $p0spread8 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p0points8 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
