# Redraw in the folder above: gnuplot plots/precision-turning-points.gp; as PDF: gnuplot -e 'pdf = 1' plots/precision-turning-points.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.2524 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'precision-turning-points.pdf'
} else {
  set terminal svg size 620,501 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'precision-turning-points.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Precision of the arithmetic: velocities next to turning points' at screen 0.0193548,0.969062 left noenhanced front tc rgb '#202020'
set label 'on sledge-rig, one period of 1.4286 s, instants to three digits next to quarters of the' at screen 0.0193548,0.93513 left noenhanced front tc rgb '#5d6b79'
set label 'period' at screen 0.0193548,0.90519 left noenhanced front tc rgb '#5d6b79'
set label 'reference: Newton'."'".'s method in long double, the driver'."'".'s phase too' at screen 0.0193548,0.87525 left noenhanced front tc rgb '#5d6b79'
set label 'largest error of velocities, by the largest at the same instant' at screen 0.0193548,0.833333 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.101796 to screen 0.114903,0.101796 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0907097,0.101796 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label '5 digits, the driver'."'".'s phase to 3' at screen 0.127806,0.101796 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0658683 to screen 0.114903,0.0658683 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.0907097,0.0658683 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label '5 digits' at screen 0.127806,0.0658683 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0665161,0.0299401 to screen 0.114903,0.0299401 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.0907097,0.0299401 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'float' at screen 0.127806,0.0299401 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.101796 to screen 0.558065,0.101796 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.533871,0.101796 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam, double' at screen 0.570968,0.101796 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0658683 to screen 0.558065,0.0658683 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.0658683 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0299401 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0299401 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.195608782e-01
set tmargin at screen 7.984031936e-01
set xrange [6.425266623e-01:2.477019065e+03]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 0.7 1, '' 0.8 1, '' 0.9 1, '1' 1, '' 2 1, '3' 3, '' 4 1, '' 5 1, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'largest rate of the driver over its rate at the instant' at screen 0.533871,0.151697 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
1.000000790e+00 5.033991541e-05
1.000019740e+00 4.364831647e-04
1.000078962e+00 8.953398536e-04
5.305478942e+01 1.501707047e-01
1.591559903e+02 6.197627574e-01
1.591549536e+03 2.674303375e-01
e
$p0points0 << e
1.000000790e+00 5.033991541e-05
1.000019740e+00 4.364831647e-04
1.000078962e+00 8.953398536e-04
5.305478942e+01 1.501707047e-01
1.591559903e+02 6.197627574e-01
1.591549536e+03 2.674303375e-01
e
$p0line1_0 << e
1.000000790e+00 5.033991541e-05
1.000019740e+00 1.634972585e-04
1.000078962e+00 2.950512888e-04
5.305478942e+01 1.608615165e-03
1.591559903e+02 9.962042887e-04
1.591549536e+03 5.088513082e-02
e
$p0points1 << e
1.000000790e+00 5.033991541e-05
1.000019740e+00 1.634972585e-04
1.000078962e+00 2.950512888e-04
5.305478942e+01 1.608615165e-03
1.591559903e+02 9.962042887e-04
1.591549536e+03 5.088513082e-02
e
$p0line2_0 << e
1.000000790e+00 1.291304298e-07
1.000019740e+00 2.841920005e-07
1.000078962e+00 2.385836250e-07
5.305478942e+01 1.716386621e-05
1.591559903e+02 1.362323423e-05
1.591549536e+03 1.735426534e-04
e
$p0points2 << e
1.000000790e+00 1.291304298e-07
1.000019740e+00 2.841920005e-07
1.000078962e+00 2.385836250e-07
5.305478942e+01 1.716386621e-05
1.591559903e+02 1.362323423e-05
1.591549536e+03 1.735426534e-04
e
$p0line3_0 << e
1.000000790e+00 4.502794248e-16
1.000019740e+00 3.722042350e-16
1.000078962e+00 4.041828088e-16
5.305478942e+01 2.321983265e-14
1.591559903e+02 1.859347629e-14
1.591549536e+03 1.086539744e-13
e
$p0points3 << e
1.000000790e+00 4.502794248e-16
1.000019740e+00 3.722042350e-16
1.000078962e+00 4.041828088e-16
5.305478942e+01 2.321983265e-14
1.591559903e+02 1.859347629e-14
1.591549536e+03 1.086539744e-13
e
set label 'default' at screen 0.83132,0.351274 left noenhanced front tc rgb '#202020'
$p0default << e
1.591549536e+03 1.086539744e-13
e
plot $p0line0_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points0 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points1 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points2 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0line3_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points3 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
