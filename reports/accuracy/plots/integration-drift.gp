# Redraw in the folder above: gnuplot plots/integration-drift.gp; as PDF: gnuplot -e 'pdf = 1' plots/integration-drift.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.8500 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'integration-drift.pdf'
} else {
  set terminal svg size 620,558 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'integration-drift.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Integration: constraints drift unless they are projected' at screen 0.0193548,0.972222 left noenhanced front tc rgb '#202020'
set label 'on simple pendulum from the horizontal (IFToMM benchmark A01)' at screen 0.0193548,0.941756 left noenhanced front tc rgb '#5d6b79'
set label 'reference: the closed pin: zero' at screen 0.0193548,0.914875 left noenhanced front tc rgb '#5d6b79'
set label 'largest distance of the pin'."'".'s two halves, by the length' at screen 0.0193548,0.87724 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.22043 to screen 0.262452,0.22043 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.238258,0.22043 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'Fehlberg 7(8) at 1e-11, projected' at screen 0.275355,0.22043 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.188172 to screen 0.262452,0.188172 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.238258,0.188172 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Fehlberg 7(8) at 1e-11, not projected' at screen 0.275355,0.188172 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.155914 to screen 0.262452,0.155914 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.238258,0.155914 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Fehlberg 7(8) at 1e-08, not projected' at screen 0.275355,0.155914 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.123656 to screen 0.262452,0.123656 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.238258,0.123656 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'Runge-Kutta 4, 200 steps a swing, not projected' at screen 0.275355,0.123656 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.0913978 to screen 0.262452,0.0913978 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.275355,0.0913978 left noenhanced front tc rgb '#202020'
set arrow from screen 0.214065,0.0591398 to screen 0.262452,0.0591398 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off of a coordinate: 2.0e-16' at screen 0.275355,0.0591398 left noenhanced front tc rgb '#202020'
set label '' at screen 0.238258,0.0268817 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.275355,0.0268817 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.261648746e-01
set tmargin at screen 8.458781362e-01
set xrange [6.606934480e-01:1.513561248e+03]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 0.7 1, '' 0.8 1, '' 0.9 1, '1' 1, '2' 2, '' 3 1, '' 4 1, '5' 5, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '20' 20, '' 30 1, '' 40 1, '50' 50, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '200' 200, '' 300 1, '' 400 1, '500' 500, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'swings' at screen 0.533871,0.265233 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.335943 to screen 0.967742,0.335943 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0line0_0 << e
1.000000000e+00 2.001483021e-16
3.000000000e+00 2.001483021e-16
1.000000000e+01 2.482534153e-16
3.000000000e+01 2.482534153e-16
1.000000000e+02 2.482534153e-16
3.000000000e+02 2.482534153e-16
1.000000000e+03 2.482534153e-16
e
$p0points0 << e
1.000000000e+00 2.001483021e-16
3.000000000e+00 2.001483021e-16
1.000000000e+01 2.482534153e-16
3.000000000e+01 2.482534153e-16
1.000000000e+02 2.482534153e-16
3.000000000e+02 2.482534153e-16
1.000000000e+03 2.482534153e-16
e
$p0line1_0 << e
1.000000000e+00 1.230958851e-10
3.000000000e+00 1.155217240e-09
1.000000000e+01 1.305616899e-08
3.000000000e+01 1.181006100e-07
1.000000000e+02 1.314577833e-06
3.000000000e+02 1.183727997e-05
1.000000000e+03 1.315493167e-04
e
$p0points1 << e
1.000000000e+00 1.230958851e-10
3.000000000e+00 1.155217240e-09
1.000000000e+01 1.305616899e-08
3.000000000e+01 1.181006100e-07
1.000000000e+02 1.314577833e-06
3.000000000e+02 1.183727997e-05
1.000000000e+03 1.315493167e-04
e
$p0line2_0 << e
1.000000000e+00 5.441567161e-08
3.000000000e+00 5.514267719e-07
1.000000000e+01 6.408490321e-06
3.000000000e+01 5.843005862e-05
1.000000000e+02 6.522031259e-04
3.000000000e+02 5.878879318e-03
1.000000000e+03 6.553118178e-02
e
$p0points2 << e
1.000000000e+00 5.441567161e-08
3.000000000e+00 5.514267719e-07
1.000000000e+01 6.408490321e-06
3.000000000e+01 5.843005862e-05
1.000000000e+02 6.522031259e-04
3.000000000e+02 5.878879318e-03
1.000000000e+03 6.553118178e-02
e
$p0line3_0 << e
1.000000000e+00 4.127332482e-07
3.000000000e+00 3.711348414e-06
1.000000000e+01 4.122597050e-05
3.000000000e+01 3.710060413e-04
1.000000000e+02 4.122182445e-03
3.000000000e+02 3.709935278e-02
1.000000000e+03 4.122133038e-01
e
$p0points3 << e
1.000000000e+00 4.127332482e-07
3.000000000e+00 3.711348414e-06
1.000000000e+01 4.122597050e-05
3.000000000e+01 3.710060413e-04
1.000000000e+02 4.122182445e-03
3.000000000e+02 3.709935278e-02
1.000000000e+03 4.122133038e-01
e
set label 'default' at screen 0.83132,0.358634 left noenhanced front tc rgb '#202020'
$p0default << e
1.000000000e+03 2.482534153e-16
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points3 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
