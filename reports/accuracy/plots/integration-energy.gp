# Redraw in the folder above: gnuplot plots/integration-energy.gp; as PDF: gnuplot -e 'pdf = 1' plots/integration-energy.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.0387 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'integration-energy.pdf'
} else {
  set terminal svg size 620,576 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'integration-energy.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Integration: energy over many swings' at screen 0.0193548,0.97309 left noenhanced front tc rgb '#202020'
set label 'on simple pendulum from the horizontal (IFToMM benchmark A01)' at screen 0.0193548,0.943576 left noenhanced front tc rgb '#5d6b79'
set label 'reference: conservation of energy' at screen 0.0193548,0.917535 left noenhanced front tc rgb '#5d6b79'
set label 'largest change of the energy, by what falling exchanges' at screen 0.0193548,0.881076 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.244792 to screen 0.198774,0.244792 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.174581,0.244792 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'Fehlberg 7(8) at 1e-11, projected' at screen 0.211677,0.244792 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.213542 to screen 0.198774,0.213542 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.174581,0.213542 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'Fehlberg 7(8) at 1e-08, projected' at screen 0.211677,0.213542 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.182292 to screen 0.198774,0.182292 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.174581,0.182292 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Runge-Kutta 4, 200 steps a swing, projected' at screen 0.211677,0.182292 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.151042 to screen 0.198774,0.151042 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.174581,0.151042 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'generalised alpha, radius 0.8, 200 steps a swing' at screen 0.211677,0.151042 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.119792 to screen 0.198774,0.119792 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.174581,0.119792 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'central differences, 200 steps a swing' at screen 0.211677,0.119792 left noenhanced front tc rgb '#202020'
set arrow from screen 0.150387,0.0885417 to screen 0.198774,0.0885417 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.211677,0.0885417 left noenhanced front tc rgb '#202020'
set label 'round-off of a coordinate: 2.0e-16, below all that is shown' at screen 0.211677,0.0572917 left noenhanced front tc rgb '#202020'
set label '' at screen 0.174581,0.0260417 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.211677,0.0260417 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.472222222e-01
set tmargin at screen 8.506944444e-01
set xrange [6.606934480e-01:1.513561248e+03]
set yrange [1.000000000e-11:1.000000000e-02]
set xtics ('' 0.7 1, '' 0.8 1, '' 0.9 1, '1' 1, '2' 2, '' 3 1, '' 4 1, '5' 5, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '20' 20, '' 30 1, '' 40 1, '50' 50, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '200' 200, '' 300 1, '' 400 1, '500' 500, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000)
set ytics ('10^{-11}' 1e-11, '10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01)
set label 'swings' at screen 0.533871,0.288194 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.000000000e+00 1.227804810e-11
3.000000000e+00 3.625470068e-11
1.000000000e+01 1.201709929e-10
3.000000000e+01 3.599284649e-10
1.000000000e+02 1.199070020e-09
3.000000000e+02 3.596671177e-09
1.000000000e+03 1.198825422e-08
e
$p0points0 << e
1.000000000e+00 1.227804810e-11
3.000000000e+00 3.625470068e-11
1.000000000e+01 1.201709929e-10
3.000000000e+01 3.599284649e-10
1.000000000e+02 1.199070020e-09
3.000000000e+02 3.596671177e-09
1.000000000e+03 1.198825422e-08
e
$p0line1_0 << e
1.000000000e+00 1.159789814e-08
3.000000000e+00 3.479369593e-08
1.000000000e+01 1.159791101e-07
3.000000000e+01 3.479407180e-07
1.000000000e+02 1.159934461e-06
3.000000000e+02 3.483333054e-06
1.000000000e+03 1.175424252e-05
e
$p0points1 << e
1.000000000e+00 1.159789814e-08
3.000000000e+00 3.479369593e-08
1.000000000e+01 1.159791101e-07
3.000000000e+01 3.479407180e-07
1.000000000e+02 1.159934461e-06
3.000000000e+02 3.483333054e-06
1.000000000e+03 1.175424252e-05
e
$p0line2_0 << e
1.000000000e+00 5.171233119e-08
3.000000000e+00 5.171233119e-08
1.000000000e+01 6.183126246e-08
3.000000000e+01 1.597778602e-07
1.000000000e+02 5.025909920e-07
3.000000000e+02 1.482057246e-06
1.000000000e+03 4.910189879e-06
e
$p0points2 << e
1.000000000e+00 5.171233119e-08
3.000000000e+00 5.171233119e-08
1.000000000e+01 6.183126246e-08
3.000000000e+01 1.597778602e-07
1.000000000e+02 5.025909920e-07
3.000000000e+02 1.482057246e-06
1.000000000e+03 4.910189879e-06
e
$p0line3_0 << e
1.000000000e+00 1.102909629e-03
3.000000000e+00 1.111255457e-03
1.000000000e+01 1.139202252e-03
3.000000000e+01 1.209079500e-03
1.000000000e+02 1.373834174e-03
3.000000000e+02 2.159324321e-03
1.000000000e+03 5.036858701e-03
e
$p0points3 << e
1.000000000e+00 1.102909629e-03
3.000000000e+00 1.111255457e-03
1.000000000e+01 1.139202252e-03
3.000000000e+01 1.209079500e-03
1.000000000e+02 1.373834174e-03
3.000000000e+02 2.159324321e-03
1.000000000e+03 5.036858701e-03
e
$p0line4_0 << e
1.000000000e+00 5.157571326e-04
3.000000000e+00 5.157571326e-04
1.000000000e+01 5.157571326e-04
3.000000000e+01 5.157571326e-04
1.000000000e+02 5.157571326e-04
3.000000000e+02 5.157571326e-04
1.000000000e+03 5.157572606e-04
e
$p0points4 << e
1.000000000e+00 5.157571326e-04
3.000000000e+00 5.157571326e-04
1.000000000e+01 5.157571326e-04
3.000000000e+01 5.157571326e-04
1.000000000e+02 5.157571326e-04
3.000000000e+02 5.157571326e-04
1.000000000e+03 5.157572606e-04
e
set label 'default' at screen 0.83132,0.53848 left noenhanced front tc rgb '#202020'
$p0default << e
1.000000000e+03 1.198825422e-08
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points4 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
