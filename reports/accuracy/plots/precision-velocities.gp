# Redraw in the folder above: gnuplot plots/precision-velocities.gp; as PDF: gnuplot -e 'pdf = 1' plots/precision-velocities.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.2524 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'precision-velocities.pdf'
} else {
  set terminal svg size 620,501 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'precision-velocities.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Precision of the arithmetic: velocities' at screen 0.0193548,0.969062 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s, 96 instants' at screen 0.0193548,0.93513 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed-form dyads in long double' at screen 0.0193548,0.90519 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of velocities, relative' at screen 0.0193548,0.863273 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.101796 to screen 0.114903,0.101796 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0907097,0.101796 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Newton, dense LU' at screen 0.127806,0.101796 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0658683 to screen 0.114903,0.0658683 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.0907097,0.0658683 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Newton, static sparse order' at screen 0.127806,0.0658683 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0299401 to screen 0.114903,0.0299401 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0907097,0.0299401 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam' at screen 0.127806,0.0299401 left noenhanced front tc rgb '#202020'
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
set xrange [9.411947152e+00:1.129433658e+02]
set yrange [1.000000000e-19:1.000000000e-02]
set xtics ('10' 10, '20' 20, '' 30 1, '' 40 1, '50' 50, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100)
set ytics ('10^{-18}' 1e-18, '10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'bits of the numbers'."'".' significand' at screen 0.304839,0.181637 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.660964047e+01 2.817245873e-04
2.400000000e+01 2.707406025e-07
5.300000000e+01 6.941933314e-16
6.400000000e+01 4.622039332e-19
e
$p0points0 << e
1.660964047e+01 2.817245873e-04
2.400000000e+01 2.707406025e-07
5.300000000e+01 6.941933314e-16
6.400000000e+01 4.622039332e-19
e
$p0line1_0 << e
1.660964047e+01 2.789962169e-04
2.400000000e+01 2.910685465e-07
5.300000000e+01 6.458652881e-16
6.400000000e+01 4.622039332e-19
e
$p0points1 << e
1.660964047e+01 2.789962169e-04
2.400000000e+01 2.910685465e-07
5.300000000e+01 6.458652881e-16
6.400000000e+01 4.622039332e-19
e
$p0points2 << e
5.300000000e+01 7.130142755e-16
e
set label 'default' at screen 0.397844,0.402574 left noenhanced front tc rgb '#202020'
$p0default << e
5.300000000e+01 7.130142755e-16
e
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.495009980e-01
set tmargin at screen 8.283433134e-01
set xrange [4.468839052e-07:4.833779880e-05]
set yrange [1.000000000e-19:1.000000000e-02]
set xtics ('' 5e-07 1, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '' 2e-06 1, '' 3e-06 1, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1, '' 3e-05 1, '' 4e-05 1)
set ytics ('' 1e-18, '' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01)
set label 'time per one instant: positions to' at screen 0.762903,0.181637 center noenhanced front tc rgb '#202020'
set label 'reactions' at screen 0.762903,0.151697 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
3.743430208e-05 2.817245873e-04
2.385936316e-06 2.707406025e-07
4.227465000e-06 6.941933314e-16
2.695980990e-05 4.622039332e-19
e
$p1spread0 << e
3.743430208e-05 2.817245873e-04 3.729019792e-05 3.761123958e-05
2.385936316e-06 2.707406025e-07 2.381334280e-06 2.394023674e-06
4.227465000e-06 6.941933314e-16 4.215355417e-06 4.251505417e-06
2.695980990e-05 4.622039332e-19 2.691351563e-05 2.702013542e-05
e
$p1points0 << e
3.743430208e-05 2.817245873e-04
2.385936316e-06 2.707406025e-07
4.227465000e-06 6.941933314e-16
2.695980990e-05 4.622039332e-19
e
$p1line1_0 << e
1.629876042e-05 2.789962169e-04
5.774474016e-07 2.910685465e-07
1.032532067e-06 6.458652881e-16
5.855668981e-06 4.622039332e-19
e
$p1spread1 << e
1.629876042e-05 2.789962169e-04 1.625106994e-05 1.636642262e-05
5.774474016e-07 2.910685465e-07 5.743332189e-07 5.782184066e-07
1.032532067e-06 6.458652881e-16 1.029978145e-06 1.034225694e-06
5.855668981e-06 4.622039332e-19 5.853101273e-06 5.870140625e-06
e
$p1points1 << e
1.629876042e-05 2.789962169e-04
5.774474016e-07 2.910685465e-07
1.032532067e-06 6.458652881e-16
5.855668981e-06 4.622039332e-19
e
$p1spread2 << e
6.945834019e-07 7.130142755e-16 6.903974095e-07 6.960322780e-07
e
$p1points2 << e
6.945834019e-07 7.130142755e-16
e
set label 'default' at screen 0.558124,0.349759 left noenhanced front tc rgb '#202020'
$p1default << e
6.945834019e-07 7.130142755e-16
e
plot $p1line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points2 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
