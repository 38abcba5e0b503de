# Redraw in the folder above: gnuplot plots/critical-instants-bits.gp; as PDF: gnuplot -e 'pdf = 1' plots/critical-instants-bits.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,4.9065 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'critical-instants-bits.pdf'
} else {
  set terminal svg size 620,468 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'critical-instants-bits.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Peak over time: how far it is searched' at screen 0.0193548,0.96688 left noenhanced front tc rgb '#202020'
set label 'on a crest between two of its eight instants' at screen 0.0193548,0.930556 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed form' at screen 0.0193548,0.898504 left noenhanced front tc rgb '#5d6b79'
set label 'error of the peak, relative, worst of 15 places' at screen 0.0193548,0.853632 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0705128 to screen 0.114903,0.0705128 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0907097,0.0705128 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'Brent'."'".'s method' at screen 0.127806,0.0705128 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0320513 to screen 0.114903,0.0320513 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.127806,0.0320513 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0705128 to screen 0.558065,0.0705128 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.570968,0.0705128 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0320513 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0320513 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 1.965811966e-01
set tmargin at screen 8.162393162e-01
set xrange [2.161618050e+00:2.593941660e+01]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 3 1, '' 4 1, '5' 5, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '20' 20)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'values of the interpolation' at screen 0.304839,0.123932 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.211915 to screen 0.509677,0.211915 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
5.533333333e+00 8.532182772e-04
6.200000000e+00 5.974479692e-06
6.400000000e+00 1.035800562e-06
6.733333333e+00 2.864805922e-07
7.266666667e+00 1.924319482e-09
7.866666667e+00 2.480842198e-10
7.933333333e+00 1.071565059e-11
8.066666667e+00 3.735900478e-13
8.266666667e+00 9.026113190e-14
8.400000000e+00 6.994405055e-15
8.733333333e+00 2.220446049e-16
1.013333333e+01 1.110223025e-16
e
$p0points0 << e
5.533333333e+00 8.532182772e-04
6.200000000e+00 5.974479692e-06
6.400000000e+00 1.035800562e-06
6.733333333e+00 2.864805922e-07
7.266666667e+00 1.924319482e-09
7.866666667e+00 2.480842198e-10
7.933333333e+00 1.071565059e-11
8.066666667e+00 3.735900478e-13
8.266666667e+00 9.026113190e-14
8.400000000e+00 6.994405055e-15
8.733333333e+00 2.220446049e-16
1.013333333e+01 1.110223025e-16
e
set label 'default' at screen 0.336689,0.301651 left noenhanced front tc rgb '#202020'
$p0default << e
8.400000000e+00 6.994405055e-15
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.965811966e-01
set tmargin at screen 8.162393162e-01
set xrange [2.304466912e-08:2.765360295e-07]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 3e-08 1, '' 4e-08 1, '50 ns' 5e-08, '' 6e-08 1, '' 7e-08 1, '' 8e-08 1, '' 9e-08 1, '100 ns' 1e-07, '200 ns' 2e-07)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01)
set label 'time per peak' at screen 0.762903,0.123932 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.211915 to screen 0.967742,0.211915 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1line0_0 << e
5.271250949e-08 8.532182772e-04
6.410732419e-08 5.974479692e-06
6.434124669e-08 1.035800562e-06
7.317890842e-08 2.864805922e-07
9.377964215e-08 1.924319482e-09
1.053832477e-07 2.480842198e-10
1.055477493e-07 1.071565059e-11
1.056462600e-07 3.735900478e-13
1.060322564e-07 9.026113190e-14
1.052836058e-07 6.994405055e-15
1.199334798e-07 2.220446049e-16
1.197517541e-07 1.110223025e-16
e
$p1spread0 << e
5.271250949e-08 8.532182772e-04 5.233314007e-08 5.284373419e-08
6.410732419e-08 5.974479692e-06 6.387775722e-08 6.472946133e-08
6.434124669e-08 1.035800562e-06 6.390258429e-08 6.468365378e-08
7.317890842e-08 2.864805922e-07 7.290259341e-08 7.330730403e-08
9.377964215e-08 1.924319482e-09 9.349693688e-08 9.448873425e-08
1.053832477e-07 2.480842198e-10 1.048344780e-07 1.055310420e-07
1.055477493e-07 1.071565059e-11 1.047710612e-07 1.059788016e-07
1.056462600e-07 3.735900478e-13 1.049572933e-07 1.070988882e-07
1.060322564e-07 9.026113190e-14 1.054026186e-07 1.063411515e-07
1.052836058e-07 6.994405055e-15 1.049886219e-07 1.062398937e-07
1.199334798e-07 2.220446049e-16 1.197822004e-07 1.217714299e-07
1.197517541e-07 1.110223025e-16 1.196141098e-07 1.211781180e-07
e
$p1points0 << e
5.271250949e-08 8.532182772e-04
6.410732419e-08 5.974479692e-06
6.434124669e-08 1.035800562e-06
7.317890842e-08 2.864805922e-07
9.377964215e-08 1.924319482e-09
1.053832477e-07 2.480842198e-10
1.055477493e-07 1.071565059e-11
1.056462600e-07 3.735900478e-13
1.060322564e-07 9.026113190e-14
1.052836058e-07 6.994405055e-15
1.199334798e-07 2.220446049e-16
1.197517541e-07 1.110223025e-16
e
set label 'default' at screen 0.821436,0.301651 left noenhanced front tc rgb '#202020'
$p1default << e
1.052836058e-07 6.994405055e-15
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
