# Redraw in the folder above: gnuplot plots/peers-harmonic.gp; as PDF: gnuplot -e 'pdf = 1' plots/peers-harmonic.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.3532 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'peers-harmonic.pdf'
} else {
  set terminal svg size 620,606 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'peers-harmonic.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'A harmonic reaction by modes, in other programs' at screen 0.0193548,0.974422 left noenhanced front tc rgb '#202020'
set label 'on tapered bar, clamped and propped, 64 elements, force at its middle at 1.461 Hz, half' at screen 0.0193548,0.94637 left noenhanced front tc rgb '#5d6b79'
set label 'its lowest frequency' at screen 0.0193548,0.921617 left noenhanced front tc rgb '#5d6b79'
set label 'reference: Timoshenko'."'".'s beam by spectral elements, long double' at screen 0.0193548,0.896865 left noenhanced front tc rgb '#5d6b79'
set label 'relative error of the prop'."'".'s force' at screen 0.0193548,0.862211 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.232673 to screen 0.201581,0.232673 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.177387,0.232673 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, all elements, whole process' at screen 0.214484,0.232673 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.20297 to screen 0.201581,0.20297 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.177387,0.20297 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'boxbeam, all elements, call of the library' at screen 0.214484,0.20297 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.173267 to screen 0.201581,0.173267 nohead lw 1.7 dt (3,3) lc rgb '#00785a'
set label '' at screen 0.177387,0.173267 point pt 9 ps 0.55 lc rgb '#00785a'
set label 'boxbeam, modes with static correction, call of the library' at screen 0.214484,0.173267 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.143564 to screen 0.201581,0.143564 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.177387,0.143564 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'boxbeam, modes alone, call of the library' at screen 0.214484,0.143564 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.113861 to screen 0.201581,0.113861 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.177387,0.113861 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'CalculiX B32R, steady state dynamics, whole process' at screen 0.214484,0.113861 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.0841584 to screen 0.201581,0.0841584 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.214484,0.0841584 left noenhanced front tc rgb '#202020'
set arrow from screen 0.153194,0.0544554 to screen 0.201581,0.0544554 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'models: shear over 5/6 or all of the section: 2.9e-05' at screen 0.214484,0.0544554 left noenhanced front tc rgb '#202020'
set label '' at screen 0.177387,0.0247525 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.214484,0.0247525 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 3.547854785e-01
set tmargin at screen 8.333333333e-01
set xrange [8.467453124e-01:1.889588258e+01]
set yrange [1.000000000e-10:1.000000000e+00]
set xtics ('' 0.9 1, '1' 1, '2' 2, '' 3 1, '' 4 1, '5' 5, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10)
set ytics ('10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '0.1' 0.1, '1' 1)
set label 'modes' at screen 0.304839,0.29868 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.616445 to screen 0.509677,0.616445 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line2_0 << e
1.000000000e+00 1.153304003e-02
2.000000000e+00 1.233005338e-03
3.000000000e+00 5.716393232e-04
4.000000000e+00 2.922307051e-05
6.000000000e+00 8.038015699e-06
8.000000000e+00 5.606419512e-06
1.200000000e+01 1.593235856e-06
1.600000000e+01 4.642522271e-07
e
$p0points2 << e
1.000000000e+00 1.153304003e-02
2.000000000e+00 1.233005338e-03
3.000000000e+00 5.716393232e-04
4.000000000e+00 2.922307051e-05
6.000000000e+00 8.038015699e-06
8.000000000e+00 5.606419512e-06
1.200000000e+01 1.593235856e-06
1.600000000e+01 4.642522271e-07
e
$p0line3_0 << e
1.000000000e+00 4.434219822e-01
2.000000000e+00 6.006967558e-02
3.000000000e+00 2.233279637e-01
4.000000000e+00 2.241404368e-02
6.000000000e+00 5.104778701e-02
8.000000000e+00 6.180985784e-02
1.200000000e+01 6.156241817e-02
1.600000000e+01 4.827768187e-02
e
$p0points3 << e
1.000000000e+00 4.434219822e-01
2.000000000e+00 6.006967558e-02
3.000000000e+00 2.233279637e-01
4.000000000e+00 2.241404368e-02
6.000000000e+00 5.104778701e-02
8.000000000e+00 6.180985784e-02
1.200000000e+01 6.156241817e-02
1.600000000e+01 4.827768187e-02
e
$p0line4_0 << e
1.000000000e+00 4.433967493e-01
2.000000000e+00 6.001238952e-02
3.000000000e+00 2.233575719e-01
4.000000000e+00 2.244260467e-02
6.000000000e+00 5.115750452e-02
8.000000000e+00 6.187058599e-02
1.200000000e+01 3.144088185e-02
1.600000000e+01 3.113939738e-03
e
$p0points4 << e
1.000000000e+00 4.433967493e-01
2.000000000e+00 6.001238952e-02
3.000000000e+00 2.233575719e-01
4.000000000e+00 2.244260467e-02
6.000000000e+00 5.115750452e-02
8.000000000e+00 6.187058599e-02
1.200000000e+01 3.144088185e-02
1.600000000e+01 3.113939738e-03
e
plot $p0line2_0 using 1:2 with lines lw 1.7 dt (3,3) lc rgb '#00785a' notitle, $p0points2 using 1:2 with points pt 9 ps 0.55 lc rgb '#00785a' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points3 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points4 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.547854785e-01
set tmargin at screen 8.333333333e-01
set xrange [1.269501117e-05:1.896734418e-01]
set yrange [1.000000000e-10:1.000000000e+00]
set xtics ('' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '100 ms' 0.1)
set ytics ('' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1, '' 1)
set label 'time per harmonic response, modes' at screen 0.762903,0.29868 center noenhanced front tc rgb '#202020'
set label 'included' at screen 0.762903,0.273927 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.616445 to screen 0.967742,0.616445 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1spread0 << e
5.611000000e-03 2.931286325e-10 5.530000000e-03 5.892000000e-03
e
$p1points0 << e
5.611000000e-03 2.931286325e-10
e
$p1spread1 << e
2.182940411e-05 2.931280774e-10 2.124517123e-05 2.296397945e-05
e
$p1points1 << e
2.182940411e-05 2.931280774e-10
e
$p1line2_0 << e
1.366487556e-04 1.153304003e-02
1.416157742e-04 1.233005338e-03
1.454296719e-04 5.716393232e-04
1.483350000e-04 2.922307051e-05
1.570247966e-04 8.038015699e-06
1.645262000e-04 5.606419512e-06
2.771705152e-04 1.593235856e-06
2.874546129e-04 4.642522271e-07
e
$p1spread2 << e
1.366487556e-04 1.153304003e-02 1.344019333e-04 1.715786000e-04
1.416157742e-04 1.233005338e-03 1.384650484e-04 1.698739677e-04
1.454296719e-04 5.716393232e-04 1.429598594e-04 1.759116562e-04
1.483350000e-04 2.922307051e-05 1.460615873e-04 1.871141429e-04
1.570247966e-04 8.038015699e-06 1.549442203e-04 1.719382203e-04
1.645262000e-04 5.606419512e-06 1.617605818e-04 1.696327455e-04
2.771705152e-04 1.593235856e-06 2.727220303e-04 3.112489394e-04
2.874546129e-04 4.642522271e-07 2.825369032e-04 2.910710000e-04
e
$p1points2 << e
1.366487556e-04 1.153304003e-02
1.416157742e-04 1.233005338e-03
1.454296719e-04 5.716393232e-04
1.483350000e-04 2.922307051e-05
1.570247966e-04 8.038015699e-06
1.645262000e-04 5.606419512e-06
2.771705152e-04 1.593235856e-06
2.874546129e-04 4.642522271e-07
e
$p1line3_0 << e
1.267854143e-04 4.434219822e-01
1.314551286e-04 6.006967558e-02
1.346182000e-04 2.233279637e-01
1.389142909e-04 2.241404368e-02
1.478324844e-04 5.104778701e-02
1.559011020e-04 6.180985784e-02
2.670104412e-04 6.156241817e-02
2.752716471e-04 4.827768187e-02
e
$p1spread3 << e
1.267854143e-04 4.434219822e-01 1.258331286e-04 1.290225000e-04
1.314551286e-04 6.006967558e-02 1.307340714e-04 1.342378857e-04
1.346182000e-04 2.233279637e-01 1.334003667e-04 1.462605000e-04
1.389142909e-04 2.241404368e-02 1.374763091e-04 1.481374182e-04
1.478324844e-04 5.104778701e-02 1.456362344e-04 1.492841875e-04
1.559011020e-04 6.180985784e-02 1.533552449e-04 1.594255918e-04
2.670104412e-04 6.156241817e-02 2.631855882e-04 2.820279412e-04
2.752716471e-04 4.827768187e-02 2.713746471e-04 2.778467059e-04
e
$p1points3 << e
1.267854143e-04 4.434219822e-01
1.314551286e-04 6.006967558e-02
1.346182000e-04 2.233279637e-01
1.389142909e-04 2.241404368e-02
1.478324844e-04 5.104778701e-02
1.559011020e-04 6.180985784e-02
2.670104412e-04 6.156241817e-02
2.752716471e-04 4.827768187e-02
e
$p1line4_0 << e
6.052200000e-02 4.433967493e-01
6.338000000e-02 6.001238952e-02
6.505800000e-02 2.233575719e-01
6.698900000e-02 2.244260467e-02
7.293900000e-02 5.115750452e-02
7.686100000e-02 6.187058599e-02
8.858700000e-02 3.144088185e-02
1.009780000e-01 3.113939738e-03
e
$p1spread4 << e
6.052200000e-02 4.433967493e-01 5.821200000e-02 7.031700000e-02
6.338000000e-02 6.001238952e-02 5.965100000e-02 7.013900000e-02
6.505800000e-02 2.233575719e-01 6.287500000e-02 7.261600000e-02
6.698900000e-02 2.244260467e-02 6.506700000e-02 7.899800000e-02
7.293900000e-02 5.115750452e-02 6.877400000e-02 8.533700000e-02
7.686100000e-02 6.187058599e-02 7.346400000e-02 8.903800000e-02
8.858700000e-02 3.144088185e-02 8.531400000e-02 1.020610000e-01
1.009780000e-01 3.113939738e-03 9.668500000e-02 1.133390000e-01
e
$p1points4 << e
6.052200000e-02 4.433967493e-01
6.338000000e-02 6.001238952e-02
6.505800000e-02 2.233575719e-01
6.698900000e-02 2.244260467e-02
7.293900000e-02 5.115750452e-02
7.686100000e-02 6.187058599e-02
8.858700000e-02 3.144088185e-02
1.009780000e-01 3.113939738e-03
e
set label 'default' at screen 0.830591,0.395222 left noenhanced front tc rgb '#202020'
$p1default << e
5.611000000e-03 2.931286325e-10
e
plot $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1line2_0 using 1:2 with lines lw 1.7 dt (3,3) lc rgb '#00785a' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#00785a' notitle, $p1points2 using 1:2 with points pt 9 ps 0.55 lc rgb '#00785a' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points3 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line4_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points4 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
