# Redraw in the folder above: gnuplot plots/reactions-balance.gp; as PDF: gnuplot -e 'pdf = 1' plots/reactions-balance.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.6298 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'reactions-balance.pdf'
} else {
  set terminal svg size 620,537 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'reactions-balance.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Reactions: what a balance of forces shows' at screen 0.0193548,0.971136 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s, 96 instants' at screen 0.0193548,0.939479 left noenhanced front tc rgb '#5d6b79'
set label 'reference: forces in balance, evaluated in long double' at screen 0.0193548,0.911546 left noenhanced front tc rgb '#5d6b79'
set label 'largest open force or moment of a body, by the largest that act' at screen 0.0193548,0.872439 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.162011 to screen 0.114903,0.162011 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0907097,0.162011 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'dense LU' at screen 0.127806,0.162011 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.128492 to screen 0.114903,0.128492 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.0907097,0.128492 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'static sparse order' at screen 0.127806,0.128492 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0949721 to screen 0.114903,0.0949721 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.0907097,0.0949721 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'orthogonal decomposition' at screen 0.127806,0.0949721 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0614525 to screen 0.114903,0.0614525 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.0907097,0.0614525 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'normal equations' at screen 0.127806,0.0614525 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.027933 to screen 0.114903,0.027933 nohead lw 1.1 dt (14,4) lc rgb '#5a6670'
set label '' at screen 0.0907097,0.027933 point pt 10 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'accelerations by differences' at screen 0.127806,0.027933 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.162011 to screen 0.558065,0.162011 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.533871,0.162011 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam' at screen 0.570968,0.162011 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.128492 to screen 0.558065,0.128492 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.128492 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0949721 to screen 0.558065,0.0949721 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of double: 2.2e-16' at screen 0.570968,0.0949721 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0614525 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0614525 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.998137803e-01
set tmargin at screen 8.398510242e-01
set xrange [6.110394816e+02:2.179891873e+04]
set yrange [1.000000000e-17:1.000000000e-02]
set xtics ('' 700 1, '' 800 1, '' 900 1, '1000' 1000, '2000' 2000, '' 3000 1, '' 4000 1, '5000' 5000, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '2·10^{4}' 20000)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01)
set label 'floating-point operations of the linear' at screen 0.304839,0.236499 center noenhanced front tc rgb '#202020'
set label 'systems per instant' at screen 0.304839,0.208566 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.348289 to screen 0.509677,0.348289 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0points0 << e
9.000000000e+03 7.140433962e-17
e
$p0points1 << e
7.400000000e+02 6.897489810e-17
e
$p0points2 << e
1.800000000e+04 2.004377536e-16
e
$p0points3 << e
5.134000000e+03 1.637597581e-15
e
$p0points4 << e
6.110394816e+02 2.229362670e-16
e
plot $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0points3 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p0points4 using 1:2 with points pt 10 ps 0.55 lw 1 lc rgb '#5a6670' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.998137803e-01
set tmargin at screen 8.398510242e-01
set xrange [5.630705289e-07:2.011872665e-05]
set yrange [1.000000000e-17:1.000000000e-02]
set xtics ('' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '' 2e-06 1, '3 µs' 3e-06, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01)
set label 'time per one instant: positions to' at screen 0.762903,0.236499 center noenhanced front tc rgb '#202020'
set label 'reactions' at screen 0.762903,0.208566 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.348289 to screen 0.967742,0.348289 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1spread0 << e
3.308913978e-06 7.140433962e-17 3.295449597e-06 3.326403562e-06
e
$p1points0 << e
3.308913978e-06 7.140433962e-17
e
$p1spread1 << e
8.540531933e-07 6.897489810e-17 8.499050546e-07 8.574394638e-07
e
$p1points1 << e
8.540531933e-07 6.897489810e-17
e
$p1spread2 << e
1.650453125e-05 2.004377536e-16 1.621768750e-05 1.661123958e-05
e
$p1points2 << e
1.650453125e-05 2.004377536e-16
e
$p1spread3 << e
2.672204594e-06 1.637597581e-15 2.666386752e-06 2.680071848e-06
e
$p1points3 << e
2.672204594e-06 1.637597581e-15
e
$p1points4 << e
5.630705289e-07 2.229362670e-16
e
$p1spread5 << e
6.866472725e-07 6.870274755e-17 6.819636787e-07 6.868717105e-07
e
$p1points5 << e
6.866472725e-07 6.870274755e-17
e
set label 'default' at screen 0.585481,0.369984 left noenhanced front tc rgb '#202020'
$p1default << e
6.866472725e-07 6.870274755e-17
e
plot $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points2 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#4a716a' notitle, $p1points3 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p1points4 using 1:2 with points pt 10 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1spread5 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points5 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
