# Redraw in the folder above: gnuplot plots/cut-forces-peak.gp; as PDF: gnuplot -e 'pdf = 1' plots/cut-forces-peak.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.6613 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'cut-forces-peak.pdf'
} else {
  set terminal svg size 620,540 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'cut-forces-peak.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Bending moment: a peak between stations' at screen 0.0193548,0.971296 left noenhanced front tc rgb '#202020'
set label 'on connecting rod of a crank at 300 rpm, r/l = 0.3, tapered in width and height' at screen 0.0193548,0.939815 left noenhanced front tc rgb '#5d6b79'
set label 'reference: roots of V by halving, over the period by Brent'."'".'s method on exact solves' at screen 0.0193548,0.912037 left noenhanced front tc rgb '#5d6b79'
set label 'error of the largest M over the rod and the period, relative' at screen 0.0193548,0.873148 left noenhanced front tc rgb '#202020'
set arrow from screen 0.237387,0.194444 to screen 0.285774,0.194444 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.261581,0.194444 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'maxima along the beam, searched for' at screen 0.298677,0.194444 left noenhanced front tc rgb '#202020'
set arrow from screen 0.237387,0.161111 to screen 0.285774,0.161111 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.261581,0.161111 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'equal stations and a parabola' at screen 0.298677,0.161111 left noenhanced front tc rgb '#202020'
set arrow from screen 0.237387,0.127778 to screen 0.285774,0.127778 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.261581,0.127778 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'equal stations' at screen 0.298677,0.127778 left noenhanced front tc rgb '#202020'
set arrow from screen 0.237387,0.0944444 to screen 0.285774,0.0944444 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.298677,0.0944444 left noenhanced front tc rgb '#202020'
set label 'round-off: 2.2e-16, below all that is shown' at screen 0.298677,0.0611111 left noenhanced front tc rgb '#202020'
set label '' at screen 0.261581,0.0277778 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.298677,0.0277778 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 3.037037037e-01
set tmargin at screen 8.407407407e-01
set xrange [2.989698497e+00:6.850189081e+02]
set yrange [1.000000000e-09:1.000000000e-01]
set xtics ('3' 3, '' 4 1, '' 5 1, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1)
set ytics ('10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '10^{-1}' 0.1)
set label 'stations verified' at screen 0.304839,0.240741 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0points0 << e
5.000000000e+00 6.241505925e-07
e
$p0line1_0 << e
4.000000000e+00 1.555989230e-02
8.000000000e+00 2.049204288e-03
1.600000000e+01 2.626116129e-04
3.200000000e+01 3.322869662e-05
6.400000000e+01 4.178678905e-06
1.280000000e+02 5.239015895e-07
2.560000000e+02 6.558557067e-08
5.120000000e+02 8.204311788e-09
e
$p0points1 << e
4.000000000e+00 1.555989230e-02
8.000000000e+00 2.049204288e-03
1.600000000e+01 2.626116129e-04
3.200000000e+01 3.322869662e-05
6.400000000e+01 4.178678905e-06
1.280000000e+02 5.239015895e-07
2.560000000e+02 6.558557067e-08
5.120000000e+02 8.204311788e-09
e
$p0line2_0 << e
4.000000000e+00 6.349396895e-02
8.000000000e+00 1.655932696e-02
1.600000000e+01 4.227532765e-03
3.200000000e+01 1.067969365e-03
6.400000000e+01 2.683858345e-04
1.280000000e+02 6.727112343e-05
2.560000000e+02 1.683964148e-05
5.120000000e+02 4.212643483e-06
e
$p0points2 << e
4.000000000e+00 6.349396895e-02
8.000000000e+00 1.655932696e-02
1.600000000e+01 4.227532765e-03
3.200000000e+01 1.067969365e-03
6.400000000e+01 2.683858345e-04
1.280000000e+02 6.727112343e-05
2.560000000e+02 1.683964148e-05
5.120000000e+02 4.212643483e-06
e
set label 'default' at screen 0.151673,0.511647 left noenhanced front tc rgb '#202020'
$p0default << e
5.000000000e+00 6.241505925e-07
e
set arrow from screen 0.264999,0.594268 to screen 0.319457,0.531088 nohead lw 1 lc rgb '#404040'
set label 'order 3' at screen 0.202293,0.54631 left noenhanced front tc rgb '#404040'
set arrow from screen 0.262822,0.696203 to screen 0.327031,0.646541 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.312668,0.695597 left noenhanced front tc rgb '#404040'
plot $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.037037037e-01
set tmargin at screen 8.407407407e-01
set xrange [1.090315120e-05:2.600184090e-03]
set yrange [1.000000000e-09:1.000000000e-01]
set xtics ('' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1)
set ytics ('' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1)
set label 'time per beam over one period' at screen 0.762903,0.240741 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1spread0 << e
1.765491754e-04 6.241505925e-07 1.752440526e-04 1.776480175e-04
e
$p1points0 << e
1.765491754e-04 6.241505925e-07
e
$p1line1_0 << e
1.471713166e-05 1.555989230e-02
3.048219149e-05 2.049204288e-03
6.072259146e-05 2.626116129e-04
1.203450119e-04 3.322869662e-05
2.418002619e-04 4.178678905e-06
4.819313810e-04 5.239015895e-07
9.574314545e-04 6.558557067e-08
1.912378333e-03 8.204311788e-09
e
$p1spread1 << e
1.471713166e-05 1.555989230e-02 1.471299852e-05 1.489264497e-05
3.048219149e-05 2.049204288e-03 3.027778116e-05 3.081463222e-05
6.072259146e-05 2.626116129e-04 6.024382317e-05 6.130035366e-05
1.203450119e-04 3.322869662e-05 1.199719524e-04 1.207465714e-04
2.418002619e-04 4.178678905e-06 2.415090952e-04 2.424855952e-04
4.819313810e-04 5.239015895e-07 4.787465714e-04 4.842686667e-04
9.574314545e-04 6.558557067e-08 9.542156364e-04 9.634568182e-04
1.912378333e-03 8.204311788e-09 1.902557000e-03 1.920225167e-03
e
$p1points1 << e
1.471713166e-05 1.555989230e-02
3.048219149e-05 2.049204288e-03
6.072259146e-05 2.626116129e-04
1.203450119e-04 3.322869662e-05
2.418002619e-04 4.178678905e-06
4.819313810e-04 5.239015895e-07
9.574314545e-04 6.558557067e-08
1.912378333e-03 8.204311788e-09
e
$p1line2_0 << e
1.464110965e-05 6.349396895e-02
3.027519520e-05 1.655932696e-02
6.057203571e-05 4.227532765e-03
1.215418072e-04 1.067969365e-03
2.418901667e-04 2.683858345e-04
4.857266190e-04 6.727112343e-05
9.609849091e-04 1.683964148e-05
1.935985500e-03 4.212643483e-06
e
$p1spread2 << e
1.464110965e-05 6.349396895e-02 1.461892836e-05 1.479034064e-05
3.027519520e-05 1.655932696e-02 3.009624625e-05 3.060030931e-05
6.057203571e-05 4.227532765e-03 5.987372619e-05 6.120197024e-05
1.215418072e-04 1.067969365e-03 1.199640120e-04 1.219663012e-04
2.418901667e-04 2.683858345e-04 2.405739048e-04 2.443660000e-04
4.857266190e-04 6.727112343e-05 4.780622381e-04 4.865392381e-04
9.609849091e-04 1.683964148e-05 9.596984545e-04 9.680172727e-04
1.935985500e-03 4.212643483e-06 1.914162667e-03 1.939280333e-03
e
$p1points2 << e
1.464110965e-05 6.349396895e-02
3.027519520e-05 1.655932696e-02
6.057203571e-05 4.227532765e-03
1.215418072e-04 1.067969365e-03
2.418901667e-04 2.683858345e-04
4.857266190e-04 6.727112343e-05
9.609849091e-04 1.683964148e-05
1.935985500e-03 4.212643483e-06
e
set label 'default' at screen 0.676515,0.511647 left noenhanced front tc rgb '#202020'
$p1default << e
1.765491754e-04 6.241505925e-07
e
plot $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
