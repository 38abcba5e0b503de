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
set ytics ('10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '0.1' 0.1)
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
set xrange [1.060515878e-05:2.492512570e-03]
set yrange [1.000000000e-09:1.000000000e-01]
set xtics ('' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '' 0.0003 1, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1)
set ytics ('' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1)
set label 'time per beam over one period' at screen 0.762903,0.240741 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1spread0 << e
1.724817288e-04 6.241505925e-07 1.708382542e-04 1.726966271e-04
e
$p1points0 << e
1.724817288e-04 6.241505925e-07
e
$p1line1_0 << e
1.429292482e-05 1.555989230e-02
2.945910787e-05 2.049204288e-03
5.881485549e-05 2.626116129e-04
1.172028721e-04 3.322869662e-05
2.353294419e-04 4.178678905e-06
4.688540909e-04 5.239015895e-07
9.303534545e-04 6.558557067e-08
1.856202333e-03 8.204311788e-09
e
$p1spread1 << e
1.429292482e-05 1.555989230e-02 1.427580851e-05 1.434730496e-05
2.945910787e-05 2.049204288e-03 2.945688921e-05 2.949695044e-05
5.881485549e-05 2.626116129e-04 5.869328324e-05 5.901006358e-05
1.172028721e-04 3.322869662e-05 1.167811977e-04 1.174327442e-04
2.353294419e-04 4.178678905e-06 2.351876047e-04 2.356089535e-04
4.688540909e-04 5.239015895e-07 4.663134545e-04 4.696420909e-04
9.303534545e-04 6.558557067e-08 9.272807273e-04 9.307795455e-04
1.856202333e-03 8.204311788e-09 1.847015333e-03 1.860428833e-03
e
$p1points1 << e
1.429292482e-05 1.555989230e-02
2.945910787e-05 2.049204288e-03
5.881485549e-05 2.626116129e-04
1.172028721e-04 3.322869662e-05
2.353294419e-04 4.178678905e-06
4.688540909e-04 5.239015895e-07
9.303534545e-04 6.558557067e-08
1.856202333e-03 8.204311788e-09
e
$p1line2_0 << e
1.428846942e-05 6.349396895e-02
2.943164809e-05 1.655932696e-02
5.867788953e-05 4.227532765e-03
1.166558736e-04 1.067969365e-03
2.350488140e-04 2.683858345e-04
4.659410455e-04 6.727112343e-05
9.299747273e-04 1.683964148e-05
1.851123000e-03 4.212643483e-06
e
$p1spread2 << e
1.428846942e-05 6.349396895e-02 1.420827881e-05 1.433420057e-05
2.943164809e-05 1.655932696e-02 2.936821114e-05 2.956331085e-05
5.867788953e-05 4.227532765e-03 5.837184884e-05 5.886491279e-05
1.166558736e-04 1.067969365e-03 1.164578736e-04 1.170385172e-04
2.350488140e-04 2.683858345e-04 2.334068140e-04 2.354426512e-04
4.659410455e-04 6.727112343e-05 4.637013636e-04 4.686187273e-04
9.299747273e-04 1.683964148e-05 9.218407273e-04 9.304418182e-04
1.851123000e-03 4.212643483e-06 1.835384500e-03 1.853600167e-03
e
$p1points2 << e
1.428846942e-05 6.349396895e-02
2.943164809e-05 1.655932696e-02
5.867788953e-05 4.227532765e-03
1.166558736e-04 1.067969365e-03
2.350488140e-04 2.683858345e-04
4.659410455e-04 6.727112343e-05
9.299747273e-04 1.683964148e-05
1.851123000e-03 4.212643483e-06
e
set label 'default' at screen 0.677402,0.511647 left noenhanced front tc rgb '#202020'
$p1default << e
1.724817288e-04 6.241505925e-07
e
plot $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
