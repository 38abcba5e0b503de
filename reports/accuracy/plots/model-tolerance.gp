# Redraw in the folder above: gnuplot plots/model-tolerance.gp; as PDF: gnuplot -e 'pdf = 1' plots/model-tolerance.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.0952 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'model-tolerance.pdf'
} else {
  set terminal svg size 620,486 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'model-tolerance.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Models of the elasticity: error asked and found' at screen 0.0193548,0.968107 left noenhanced front tc rgb '#202020'
set label 'on drill-truck, 25 Hz' at screen 0.0193548,0.933128 left noenhanced front tc rgb '#5d6b79'
set label 'reference: all elements, 256 parts per link' at screen 0.0193548,0.902263 left noenhanced front tc rgb '#5d6b79'
set label 'relative error of the governing stress' at screen 0.0193548,0.859053 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0200645,0.104938 to screen 0.0684516,0.104938 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0442581,0.104938 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'error of the model chosen' at screen 0.0813548,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0200645,0.0679012 to screen 0.0684516,0.0679012 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.0442581,0.0679012 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'as boxbeam finds it, by a finer model' at screen 0.0813548,0.0679012 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0200645,0.0308642 to screen 0.0684516,0.0308642 nohead lw 1.7 dt (3,3) lc rgb '#00785a'
set label '' at screen 0.0442581,0.0308642 point pt 9 ps 0.55 lc rgb '#00785a'
set label 'as it is estimated before' at screen 0.0813548,0.0308642 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.104938 to screen 0.558065,0.104938 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.533871,0.104938 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'tolerance' at screen 0.570968,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0679012 to screen 0.558065,0.0679012 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.0679012 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0308642 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0308642 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.263374486e-01
set tmargin at screen 8.230452675e-01
set xrange [6.606934480e-05:1.513561248e-01]
set yrange [1.000000000e-05:1.000000000e-01]
set xtics ('' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '10^{-4}' 0.0001, '2·10^{-4}' 0.0002, '' 0.0003 1, '' 0.0004 1, '5·10^{-4}' 0.0005, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '10^{-3}' 0.001, '2·10^{-3}' 0.002, '' 0.003 1, '' 0.004 1, '5·10^{-3}' 0.005, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10^{-2}' 0.01, '2·10^{-2}' 0.02, '' 0.03 1, '' 0.04 1, '5·10^{-2}' 0.05, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '0.1' 0.1)
set ytics ('10^{-5}' 1e-05, '' 2e-05 1, '3·10^{-5}' 3e-05, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '10^{-4}' 0.0001, '' 0.0002 1, '3·10^{-4}' 0.0003, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '10^{-3}' 0.001, '' 0.002 1, '3·10^{-3}' 0.003, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10^{-2}' 0.01, '' 0.02 1, '3·10^{-2}' 0.03, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '0.1' 0.1)
set label 'tolerance that is asked for' at screen 0.533871,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.001 to graph 1, first 0.01 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.000000000e-01 7.697907735e-02
5.000000000e-02 2.823929919e-02
2.000000000e-02 1.884310207e-02
1.000000000e-02 7.943265187e-03
5.000000000e-03 1.627794828e-03
2.000000000e-03 1.627794828e-03
1.000000000e-03 9.091356736e-04
5.000000000e-04 1.844834380e-04
2.000000000e-04 8.987082358e-05
1.000000000e-04 4.408179713e-05
e
$p0points0 << e
1.000000000e-01 7.697907735e-02
5.000000000e-02 2.823929919e-02
2.000000000e-02 1.884310207e-02
1.000000000e-02 7.943265187e-03
5.000000000e-03 1.627794828e-03
2.000000000e-03 1.627794828e-03
1.000000000e-03 9.091356736e-04
5.000000000e-04 1.844834380e-04
2.000000000e-04 8.987082358e-05
1.000000000e-04 4.408179713e-05
e
$p0line1_0 << e
1.000000000e-01 7.700527878e-02
5.000000000e-02 2.826576961e-02
2.000000000e-02 1.886103731e-02
1.000000000e-02 7.958809724e-03
5.000000000e-03 1.647241788e-03
2.000000000e-03 1.647241788e-03
1.000000000e-03 9.312013141e-04
5.000000000e-04 2.029211331e-04
2.000000000e-04 1.098343702e-04
1.000000000e-04 6.404559645e-05
e
$p0points1 << e
1.000000000e-01 7.700527878e-02
5.000000000e-02 2.826576961e-02
2.000000000e-02 1.886103731e-02
1.000000000e-02 7.958809724e-03
5.000000000e-03 1.647241788e-03
2.000000000e-03 1.647241788e-03
1.000000000e-03 9.312013141e-04
5.000000000e-04 2.029211331e-04
2.000000000e-04 1.098343702e-04
1.000000000e-04 6.404559645e-05
e
$p0line2_0 << e
1.000000000e-01 3.312446694e-02
5.000000000e-02 2.756330584e-02
2.000000000e-02 2.947187307e-02
1.000000000e-02 1.410396824e-02
5.000000000e-03 3.211632318e-03
2.000000000e-03 3.211632318e-03
1.000000000e-03 1.063466135e-03
5.000000000e-04 1.688585975e-04
2.000000000e-04 7.504826555e-05
1.000000000e-04 4.221464937e-05
e
$p0points2 << e
1.000000000e-01 3.312446694e-02
5.000000000e-02 2.756330584e-02
2.000000000e-02 2.947187307e-02
1.000000000e-02 1.410396824e-02
5.000000000e-03 3.211632318e-03
2.000000000e-03 3.211632318e-03
1.000000000e-03 1.063466135e-03
5.000000000e-04 1.688585975e-04
2.000000000e-04 7.504826555e-05
1.000000000e-04 4.221464937e-05
e
$p0line3_0 << e
1.000000000e-01 1.000000000e-01
5.000000000e-02 5.000000000e-02
2.000000000e-02 2.000000000e-02
1.000000000e-02 1.000000000e-02
5.000000000e-03 5.000000000e-03
2.000000000e-03 2.000000000e-03
1.000000000e-03 1.000000000e-03
5.000000000e-04 5.000000000e-04
2.000000000e-04 2.000000000e-04
1.000000000e-04 1.000000000e-04
e
$p0points3 << e
1.000000000e-01 1.000000000e-01
5.000000000e-02 5.000000000e-02
2.000000000e-02 2.000000000e-02
1.000000000e-02 1.000000000e-02
5.000000000e-03 5.000000000e-03
2.000000000e-03 2.000000000e-03
1.000000000e-03 1.000000000e-03
5.000000000e-04 5.000000000e-04
2.000000000e-04 2.000000000e-04
1.000000000e-04 1.000000000e-04
e
set label 'default' at screen 0.675902,0.636399 left noenhanced front tc rgb '#202020'
$p0default << e
1.000000000e-02 7.943265187e-03
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.7 dt (3,3) lc rgb '#00785a' notitle, $p0points2 using 1:2 with points pt 9 ps 0.55 lc rgb '#00785a' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points3 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
