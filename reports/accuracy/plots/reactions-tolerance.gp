# Redraw in the folder above: gnuplot plots/reactions-tolerance.gp; as PDF: gnuplot -e 'pdf = 1' plots/reactions-tolerance.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.6298 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'reactions-tolerance.pdf'
} else {
  set terminal svg size 620,537 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'reactions-tolerance.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Reactions: what a tolerance of positions costs' at screen 0.0193548,0.971136 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s, 96 instants' at screen 0.0193548,0.939479 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed-form dyads in long double, reactions by orthogonal decomposition' at screen 0.0193548,0.911546 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of the reactions, by the largest reaction' at screen 0.0193548,0.872439 left noenhanced front tc rgb '#202020'
set arrow from screen 0.197903,0.162011 to screen 0.24629,0.162011 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.222097,0.162011 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Newton, static sparse order, from the last instant' at screen 0.259194,0.162011 left noenhanced front tc rgb '#202020'
set arrow from screen 0.197903,0.128492 to screen 0.24629,0.128492 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.222097,0.128492 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam' at screen 0.259194,0.128492 left noenhanced front tc rgb '#202020'
set arrow from screen 0.197903,0.0949721 to screen 0.24629,0.0949721 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.259194,0.0949721 left noenhanced front tc rgb '#202020'
set arrow from screen 0.197903,0.0614525 to screen 0.24629,0.0614525 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.259194,0.0614525 left noenhanced front tc rgb '#202020'
set label '' at screen 0.222097,0.027933 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.259194,0.027933 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.998137803e-01
set tmargin at screen 8.398510242e-01
set xrange [2.263557517e+02:2.716269020e+03]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 300 1, '' 400 1, '500' 500, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '2000' 2000)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'floating-point operations of the linear' at screen 0.304839,0.236499 center noenhanced front tc rgb '#202020'
set label 'systems per instant' at screen 0.304839,0.208566 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.313177 to screen 0.509677,0.313177 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
5.640000000e+02 1.913349731e-05
7.066526316e+02 3.832712082e-06
7.400000000e+02 3.718536928e-11
8.678315789e+02 3.351086556e-12
9.011789474e+02 2.222138340e-14
9.085894737e+02 7.872249271e-16
9.160000000e+02 7.300465729e-16
9.160000000e+02 7.300465729e-16
1.017894737e+03 7.300465729e-16
1.054947368e+03 7.300465729e-16
1.069768421e+03 7.300465729e-16
1.077178947e+03 5.947974473e-16
1.084589474e+03 7.369201952e-16
1.090147368e+03 7.369201952e-16
e
$p0points0 << e
5.640000000e+02 1.913349731e-05
7.066526316e+02 3.832712082e-06
7.400000000e+02 3.718536928e-11
8.678315789e+02 3.351086556e-12
9.011789474e+02 2.222138340e-14
9.085894737e+02 7.872249271e-16
9.160000000e+02 7.300465729e-16
9.160000000e+02 7.300465729e-16
1.017894737e+03 7.300465729e-16
1.054947368e+03 7.300465729e-16
1.069768421e+03 7.300465729e-16
1.077178947e+03 5.947974473e-16
1.084589474e+03 7.369201952e-16
1.090147368e+03 7.369201952e-16
e
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.998137803e-01
set tmargin at screen 8.398510242e-01
set xrange [2.577064886e-07:3.092477864e-06]
set yrange [1.000000000e-16:1.000000000e-02]
set xtics ('' 3e-07 1, '' 4e-07 1, '500 ns' 5e-07, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '2 µs' 2e-06, '' 3e-06 1)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01)
set label 'time per one instant: positions to' at screen 0.762903,0.236499 center noenhanced front tc rgb '#202020'
set label 'reactions' at screen 0.762903,0.208566 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.313177 to screen 0.967742,0.313177 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1line0_0 << e
6.217020958e-07 1.913349731e-05
8.031429850e-07 3.832712082e-06
8.393701332e-07 3.718536928e-11
9.948654848e-07 3.351086556e-12
1.037754375e-06 2.222138340e-14
1.039121979e-06 7.872249271e-16
1.063083870e-06 7.300465729e-16
1.059555697e-06 7.300465729e-16
1.192031250e-06 7.300465729e-16
1.239724398e-06 7.300465729e-16
1.255792175e-06 7.300465729e-16
1.265658410e-06 5.947974473e-16
1.279258511e-06 7.369201952e-16
1.282623200e-06 7.369201952e-16
e
$p1spread0 << e
6.217020958e-07 1.913349731e-05 6.185092939e-07 6.238023328e-07
8.031429850e-07 3.832712082e-06 8.005438639e-07 8.059181315e-07
8.393701332e-07 3.718536928e-11 8.371981728e-07 8.412257514e-07
9.948654848e-07 3.351086556e-12 9.913435497e-07 9.974363982e-07
1.037754375e-06 2.222138340e-14 1.024977812e-06 1.038530521e-06
1.039121979e-06 7.872249271e-16 1.037034479e-06 1.044740833e-06
1.063083870e-06 7.300465729e-16 1.054992805e-06 1.063948561e-06
1.059555697e-06 7.300465729e-16 1.051075680e-06 1.061218431e-06
1.192031250e-06 7.300465729e-16 1.189230257e-06 1.198447069e-06
1.239724398e-06 7.300465729e-16 1.236846135e-06 1.243208584e-06
1.255792175e-06 7.300465729e-16 1.252408028e-06 1.265545097e-06
1.265658410e-06 5.947974473e-16 1.262607597e-06 1.272062754e-06
1.279258511e-06 7.369201952e-16 1.272963542e-06 1.284568852e-06
1.282623200e-06 7.369201952e-16 1.278903678e-06 1.288503858e-06
e
$p1points0 << e
6.217020958e-07 1.913349731e-05
8.031429850e-07 3.832712082e-06
8.393701332e-07 3.718536928e-11
9.948654848e-07 3.351086556e-12
1.037754375e-06 2.222138340e-14
1.039121979e-06 7.872249271e-16
1.063083870e-06 7.300465729e-16
1.059555697e-06 7.300465729e-16
1.192031250e-06 7.300465729e-16
1.239724398e-06 7.300465729e-16
1.255792175e-06 7.300465729e-16
1.265658410e-06 5.947974473e-16
1.279258511e-06 7.369201952e-16
1.282623200e-06 7.369201952e-16
e
$p1spread1 << e
6.866472725e-07 6.521964362e-16 6.819636787e-07 6.868717105e-07
e
$p1points1 << e
6.866472725e-07 6.521964362e-16
e
set label 'default' at screen 0.629698,0.351637 left noenhanced front tc rgb '#202020'
$p1default << e
6.866472725e-07 6.521964362e-16
e
plot $p1line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points1 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
