# Redraw in the folder above: gnuplot plots/peers-positions.gp; as PDF: gnuplot -e 'pdf = 1' plots/peers-positions.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.7935 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'peers-positions.pdf'
} else {
  set terminal svg size 620,648 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'peers-positions.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'The rig in other programs: positions' at screen 0.0193548,0.97608 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s in 96 instants, each from the one before' at screen 0.0193548,0.949846 left noenhanced front tc rgb '#5d6b79'
set label 'reference: circles in closed form, forces body by body, 30 digits' at screen 0.0193548,0.926698 left noenhanced front tc rgb '#5d6b79'
set label 'largest distance of B and E from where they are / length of the beam' at screen 0.0193548,0.89429 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.328704 to screen 0.295065,0.328704 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.270871,0.328704 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, sparse order' at screen 0.307968,0.328704 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.300926 to screen 0.295065,0.300926 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.270871,0.300926 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'boxbeam, dense' at screen 0.307968,0.300926 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.273148 to screen 0.295065,0.273148 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.270871,0.273148 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Simbody, compact tree, predicted' at screen 0.307968,0.273148 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.24537 to screen 0.295065,0.24537 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.270871,0.24537 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Simbody, compact tree, from the last' at screen 0.307968,0.24537 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.217593 to screen 0.295065,0.217593 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.270871,0.217593 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'Simbody, planar joints, predicted' at screen 0.307968,0.217593 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.189815 to screen 0.295065,0.189815 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.270871,0.189815 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'Simbody, planar joints, from the last' at screen 0.307968,0.189815 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.162037 to screen 0.295065,0.162037 nohead lw 1.1 dt (14,4) lc rgb '#5a6670'
set label '' at screen 0.270871,0.162037 point pt 10 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'numpy, plain Newton, 15 unknowns' at screen 0.307968,0.162037 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.134259 to screen 0.295065,0.134259 nohead lw 1.1 dt (2,5) lc rgb '#857650'
set label '' at screen 0.270871,0.134259 point pt 14 ps 0.55 lw 1 lc rgb '#857650'
set label 'scipy fsolve with Jacobian, 15 unknowns' at screen 0.307968,0.134259 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.106481 to screen 0.295065,0.106481 nohead lw 1.1 dt 1 lc rgb '#7a6a8c'
set label '' at screen 0.270871,0.106481 point pt 6 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'scipy root, method lm, 15 unknowns' at screen 0.307968,0.106481 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.0787037 to screen 0.295065,0.0787037 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.307968,0.0787037 left noenhanced front tc rgb '#202020'
set arrow from screen 0.246677,0.0509259 to screen 0.295065,0.0509259 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.307968,0.0509259 left noenhanced front tc rgb '#202020'
set label '' at screen 0.270871,0.0231481 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.307968,0.0231481 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 4.197530864e-01
set tmargin at screen 8.672839506e-01
set xrange [5.833024360e-07:4.199208528e-04]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '' 2e-06 1, '3 µs' 3e-06, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1, '30 µs' 3e-05, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '300 µs' 0.0003, '' 0.0004 1)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'time per instant, positions to reactions' at screen 0.533871,0.367284 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.430699 to screen 0.967742,0.430699 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0spread0 << e
8.481938516e-07 1.404402782e-16 8.297782012e-07 9.089987297e-07
e
$p0points0 << e
8.481938516e-07 1.404402782e-16
e
$p0spread1 << e
2.832317073e-06 1.404402782e-16 2.770008130e-06 2.904882876e-06
e
$p0points1 << e
2.832317073e-06 1.404402782e-16
e
$p0line2_0 << e
4.055129375e-05 3.176002158e-05
5.227098958e-05 2.463657655e-07
5.276873542e-05 3.858545026e-12
5.813313958e-05 2.540937120e-12
6.344137917e-05 1.602347520e-14
e
$p0spread2 << e
4.055129375e-05 3.176002158e-05 3.986216667e-05 4.186013333e-05
5.227098958e-05 2.463657655e-07 5.050297708e-05 5.502371042e-05
5.276873542e-05 3.858545026e-12 5.174305000e-05 5.447892917e-05
5.813313958e-05 2.540937120e-12 5.737268542e-05 6.144195833e-05
6.344137917e-05 1.602347520e-14 6.274081667e-05 6.572253333e-05
e
$p0points2 << e
4.055129375e-05 3.176002158e-05
5.227098958e-05 2.463657655e-07
5.276873542e-05 3.858545026e-12
5.813313958e-05 2.540937120e-12
6.344137917e-05 1.602347520e-14
e
$p0line3_0 << e
5.960525625e-05 2.161393556e-06
6.321580833e-05 8.337890243e-09
6.722296875e-05 2.649095635e-10
7.233034167e-05 2.464363817e-12
7.517763333e-05 4.181349069e-16
e
$p0spread3 << e
5.960525625e-05 2.161393556e-06 5.860662083e-05 6.056048125e-05
6.321580833e-05 8.337890243e-09 6.203176042e-05 6.707072292e-05
6.722296875e-05 2.649095635e-10 6.555557083e-05 6.903699583e-05
7.233034167e-05 2.464363817e-12 7.107005833e-05 7.520476250e-05
7.517763333e-05 4.181349069e-16 7.315652917e-05 7.844158750e-05
e
$p0points3 << e
5.960525625e-05 2.161393556e-06
6.321580833e-05 8.337890243e-09
6.722296875e-05 2.649095635e-10
7.233034167e-05 2.464363817e-12
7.517763333e-05 4.181349069e-16
e
$p0line4_0 << e
1.414451104e-04 3.144426526e-05
1.877102396e-04 5.645118136e-07
1.934415646e-04 3.668663331e-12
1.925743438e-04 3.668663331e-12
2.410049167e-04 2.936503397e-14
e
$p0spread4 << e
1.414451104e-04 3.144426526e-05 1.399866292e-04 1.499692208e-04
1.877102396e-04 5.645118136e-07 1.826448813e-04 1.925490833e-04
1.934415646e-04 3.668663331e-12 1.900239042e-04 1.997173333e-04
1.925743438e-04 3.668663331e-12 1.880252042e-04 2.064382104e-04
2.410049167e-04 2.936503397e-14 2.331402937e-04 2.480020771e-04
e
$p0points4 << e
1.414451104e-04 3.144426526e-05
1.877102396e-04 5.645118136e-07
1.934415646e-04 3.668663331e-12
1.925743438e-04 3.668663331e-12
2.410049167e-04 2.936503397e-14
e
$p0line5_0 << e
2.184321292e-04 3.392895648e-06
2.406329521e-04 7.860759144e-09
2.409119500e-04 4.745906217e-10
2.763708479e-04 7.603348694e-12
2.880656104e-04 4.585126789e-14
e
$p0spread5 << e
2.184321292e-04 3.392895648e-06 2.106935583e-04 2.256182354e-04
2.406329521e-04 7.860759144e-09 2.337599042e-04 2.467589917e-04
2.409119500e-04 4.745906217e-10 2.377937521e-04 2.540145688e-04
2.763708479e-04 7.603348694e-12 2.717144688e-04 2.903723292e-04
2.880656104e-04 4.585126789e-14 2.813442958e-04 2.951883479e-04
e
$p0points5 << e
2.184321292e-04 3.392895648e-06
2.406329521e-04 7.860759144e-09
2.409119500e-04 4.745906217e-10
2.763708479e-04 7.603348694e-12
2.880656104e-04 4.585126789e-14
e
$p0line6_0 << e
4.725868099e-05 1.204911149e-12
4.780036458e-05 1.204911149e-12
6.587673785e-05 3.185377425e-14
6.748554861e-05 1.468050450e-16
6.667829861e-05 1.468050450e-16
8.375860417e-05 1.468050450e-16
e
$p0spread6 << e
4.725868099e-05 1.204911149e-12 4.551849609e-05 5.036241797e-05
4.780036458e-05 1.204911149e-12 4.574895000e-05 5.018915208e-05
6.587673785e-05 3.185377425e-14 6.391157639e-05 6.878822569e-05
6.748554861e-05 1.468050450e-16 6.468386458e-05 6.977952431e-05
6.667829861e-05 1.468050450e-16 6.495338194e-05 6.871769444e-05
8.375860417e-05 1.468050450e-16 8.293700347e-05 8.847467969e-05
e
$p0points6 << e
4.725868099e-05 1.204911149e-12
4.780036458e-05 1.204911149e-12
6.587673785e-05 3.185377425e-14
6.748554861e-05 1.468050450e-16
6.667829861e-05 1.468050450e-16
8.375860417e-05 1.468050450e-16
e
$p0line7_0 << e
8.554907031e-05 1.204911149e-12
8.419743490e-05 1.204911149e-12
9.355632812e-05 1.043055589e-13
9.312963802e-05 1.468050450e-16
9.491763281e-05 1.468050450e-16
1.194511250e-04 1.468050450e-16
e
$p0spread7 << e
8.554907031e-05 1.204911149e-12 8.167189323e-05 8.957034896e-05
8.419743490e-05 1.204911149e-12 8.176357639e-05 9.070821354e-05
9.355632812e-05 1.043055589e-13 8.932021094e-05 1.001402083e-04
9.312963802e-05 1.468050450e-16 9.155665104e-05 9.652543229e-05
9.491763281e-05 1.468050450e-16 9.193547396e-05 1.019500078e-04
1.194511250e-04 1.468050450e-16 1.166493333e-04 1.248329792e-04
e
$p0points7 << e
8.554907031e-05 1.204911149e-12
8.419743490e-05 1.204911149e-12
9.355632812e-05 1.043055589e-13
9.312963802e-05 1.468050450e-16
9.491763281e-05 1.468050450e-16
1.194511250e-04 1.468050450e-16
e
$p0line8_0 << e
9.663763021e-05 1.204911149e-12
9.648563281e-05 1.204911149e-12
1.152572708e-04 1.043055589e-13
1.154948437e-04 1.468050450e-16
1.152738281e-04 1.468050450e-16
1.305903594e-04 1.468050450e-16
e
$p0spread8 << e
9.663763021e-05 1.204911149e-12 9.491603646e-05 1.104144844e-04
9.648563281e-05 1.204911149e-12 9.364851302e-05 1.066959115e-04
1.152572708e-04 1.043055589e-13 1.099293021e-04 1.258010937e-04
1.154948437e-04 1.468050450e-16 1.122372969e-04 1.260379583e-04
1.152738281e-04 1.468050450e-16 1.104755052e-04 1.242391563e-04
1.305903594e-04 1.468050450e-16 1.253000677e-04 1.462213646e-04
e
$p0points8 << e
9.663763021e-05 1.204911149e-12
9.648563281e-05 1.204911149e-12
1.152572708e-04 1.043055589e-13
1.154948437e-04 1.468050450e-16
1.152738281e-04 1.468050450e-16
1.305903594e-04 1.468050450e-16
e
set label 'default' at screen 0.110865,0.448388 left noenhanced front tc rgb '#202020'
$p0default << e
8.481938516e-07 1.404402782e-16
e
plot $p0spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p0points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p0points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0line5_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p0spread5 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#4a716a' notitle, $p0points5 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p0line6_0 using 1:2 with lines lw 1.1 dt (14,4) lc rgb '#5a6670' notitle, $p0spread6 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p0points6 using 1:2 with points pt 10 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line7_0 using 1:2 with lines lw 1.1 dt (2,5) lc rgb '#857650' notitle, $p0spread7 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p0points7 using 1:2 with points pt 14 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line8_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#7a6a8c' notitle, $p0spread8 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p0points8 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
