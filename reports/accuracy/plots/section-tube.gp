# Redraw in the folder above: gnuplot plots/section-tube.gp; as PDF: gnuplot -e 'pdf = 1' plots/section-tube.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.0952 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section-tube.pdf'
} else {
  set terminal svg size 620,486 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section-tube.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Section: a round tube as a polygon' at screen 0.0193548,0.968107 left noenhanced front tc rgb '#202020'
set label 'on round tube 200 x 10 mm' at screen 0.0193548,0.933128 left noenhanced front tc rgb '#5d6b79'
set label 'reference: closed form, long double' at screen 0.0193548,0.902263 left noenhanced front tc rgb '#5d6b79'
set label 'relative error of I_y' at screen 0.0193548,0.859053 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0192903,0.104938 to screen 0.0676774,0.104938 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.0434839,0.104938 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'exact arcs' at screen 0.0805806,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0192903,0.0679012 to screen 0.0676774,0.0679012 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.0434839,0.0679012 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'polygon with its corners on the circle' at screen 0.0805806,0.0679012 left noenhanced front tc rgb '#202020'
set arrow from screen 0.0192903,0.0308642 to screen 0.0676774,0.0308642 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.0434839,0.0308642 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'polygon of the same area' at screen 0.0805806,0.0308642 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.104938 to screen 0.558065,0.104938 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.570968,0.104938 left noenhanced front tc rgb '#202020'
set arrow from screen 0.509677,0.0679012 to screen 0.558065,0.0679012 nohead lw 1.2 dt (6,4) lc rgb '#606060'
set label 'round-off: 2.2e-16' at screen 0.570968,0.0679012 left noenhanced front tc rgb '#202020'
set label '' at screen 0.533871,0.0308642 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.570968,0.0308642 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 2.263374486e-01
set tmargin at screen 8.230452675e-01
set xrange [5.502167273e+00:5.955471431e+03]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 6 1, '' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '' 30 1, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1)
set ytics ('10^{-16}' 1e-16, '10^{-14}' 1e-14, '10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1)
set label 'pieces of the border' at screen 0.304839,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.239258 to screen 0.509677,0.239258 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p0points0 << e
8.000000000e+00 9.635846808e-16
e
$p0line1_0 << e
1.600000000e+01 1.875825318e-01
3.200000000e+01 5.023098901e-02
6.400000000e+01 1.277697977e-02
1.280000000e+02 3.208120928e-03
2.560000000e+02 8.029002217e-04
5.120000000e+02 2.007794727e-04
1.024000000e+03 5.019826993e-05
2.048000000e+03 1.254978009e-05
4.096000000e+03 3.137458317e-06
e
$p0points1 << e
1.600000000e+01 1.875825318e-01
3.200000000e+01 5.023098901e-02
6.400000000e+01 1.277697977e-02
1.280000000e+02 3.208120928e-03
2.560000000e+02 8.029002217e-04
5.120000000e+02 2.007794727e-04
1.024000000e+03 5.019826993e-05
2.048000000e+03 1.254978009e-05
4.096000000e+03 3.137458317e-06
e
$p0line2_0 << e
1.600000000e+01 2.279877492e-03
3.200000000e+01 1.345849742e-04
6.400000000e+01 8.295523968e-06
1.280000000e+02 5.166847059e-07
2.560000000e+02 3.226500102e-08
5.120000000e+02 2.016129690e-09
1.024000000e+03 1.260035253e-10
2.048000000e+03 7.874826550e-12
4.096000000e+03 4.841153520e-13
e
$p0points2 << e
1.600000000e+01 2.279877492e-03
3.200000000e+01 1.345849742e-04
6.400000000e+01 8.295523968e-06
1.280000000e+02 5.166847059e-07
2.560000000e+02 3.226500102e-08
5.120000000e+02 2.016129690e-09
1.024000000e+03 1.260035253e-10
2.048000000e+03 7.874826550e-12
4.096000000e+03 4.841153520e-13
e
set label 'default' at screen 0.13485,0.285582 left noenhanced front tc rgb '#202020'
$p0default << e
8.000000000e+00 9.635846808e-16
e
set arrow from screen 0.302909,0.695237 to screen 0.373953,0.655988 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.248495,0.657426 left noenhanced front tc rgb '#404040'
set arrow from screen 0.304605,0.536431 to screen 0.363126,0.47177 nohead lw 1 lc rgb '#404040'
set label 'order 4' at screen 0.24393,0.485914 left noenhanced front tc rgb '#404040'
plot $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.263374486e-01
set tmargin at screen 8.230452675e-01
set xrange [3.790918483e-07:1.183898117e-04]
set yrange [1.000000000e-16:1.000000000e+00]
set xtics ('' 4e-07 1, '' 5e-07 1, '' 6e-07 1, '' 7e-07 1, '' 8e-07 1, '' 9e-07 1, '1 µs' 1e-06, '' 2e-06 1, '' 3e-06 1, '' 4e-06 1, '' 5e-06 1, '' 6e-06 1, '' 7e-06 1, '' 8e-06 1, '' 9e-06 1, '10 µs' 1e-05, '' 2e-05 1, '' 3e-05 1, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001)
set ytics ('' 1e-16, '' 1e-14, '' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per all properties of one section' at screen 0.762903,0.156379 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.239258 to screen 0.967742,0.239258 nohead lw 1.2 dt (6,4) lc rgb '#606060'
$p1spread0 << e
1.937243131e-06 9.635846808e-16 1.919646011e-06 1.946781884e-06
e
$p1points0 << e
1.937243131e-06 9.635846808e-16
e
$p1line1_0 << e
5.173536466e-07 1.875825318e-01
9.120046365e-07 5.023098901e-02
1.626563361e-06 1.277697977e-02
2.967623845e-06 3.208120928e-03
5.703064535e-06 8.029002217e-04
1.100972425e-05 2.007794727e-04
2.155952484e-05 5.019826993e-05
4.244583761e-05 1.254978009e-05
8.671063866e-05 3.137458317e-06
e
$p1spread1 << e
5.173536466e-07 1.875825318e-01 5.156821729e-07 5.305450457e-07
9.120046365e-07 5.023098901e-02 9.068477823e-07 9.252491471e-07
1.626563361e-06 1.277697977e-02 1.618089768e-06 1.649929580e-06
2.967623845e-06 3.208120928e-03 2.934644486e-06 2.991501232e-06
5.703064535e-06 8.029002217e-04 5.633411194e-06 5.716649343e-06
1.100972425e-05 2.007794727e-04 1.094031672e-05 1.107013511e-05
2.155952484e-05 5.019826993e-05 2.150218359e-05 2.160010583e-05
4.244583761e-05 1.254978009e-05 4.225486752e-05 4.290999573e-05
8.671063866e-05 3.137458317e-06 8.605839496e-05 8.703153782e-05
e
$p1points1 << e
5.173536466e-07 1.875825318e-01
9.120046365e-07 5.023098901e-02
1.626563361e-06 1.277697977e-02
2.967623845e-06 3.208120928e-03
5.703064535e-06 8.029002217e-04
1.100972425e-05 2.007794727e-04
2.155952484e-05 5.019826993e-05
4.244583761e-05 1.254978009e-05
8.671063866e-05 3.137458317e-06
e
$p1line2_0 << e
5.191277540e-07 2.279877492e-03
9.106965326e-07 1.345849742e-04
1.638152066e-06 8.295523968e-06
2.994085942e-06 5.166847059e-07
5.753381594e-06 3.226500102e-08
1.106213392e-05 2.016129690e-09
2.158464859e-05 1.260035253e-10
4.260355172e-05 7.874826550e-12
8.576555556e-05 4.841153520e-13
e
$p1spread2 << e
5.191277540e-07 2.279877492e-03 5.183702570e-07 5.244473174e-07
9.106965326e-07 1.345849742e-04 9.078359466e-07 9.158372906e-07
1.638152066e-06 8.295523968e-06 1.626828163e-06 1.641341263e-06
2.994085942e-06 5.166847059e-07 2.958290904e-06 2.999155641e-06
5.753381594e-06 3.226500102e-08 5.674975870e-06 5.785079686e-06
1.106213392e-05 2.016129690e-09 1.102822942e-05 1.115347859e-05
2.158464859e-05 1.260035253e-10 2.155499566e-05 2.166498698e-05
4.260355172e-05 7.874826550e-12 4.246278017e-05 4.265932328e-05
8.576555556e-05 4.841153520e-13 8.556602564e-05 8.599255556e-05
e
$p1points2 << e
5.191277540e-07 2.279877492e-03
9.106965326e-07 1.345849742e-04
1.638152066e-06 8.295523968e-06
2.994085942e-06 5.166847059e-07
5.753381594e-06 3.226500102e-08
1.106213392e-05 2.016129690e-09
2.158464859e-05 1.260035253e-10
4.260355172e-05 7.874826550e-12
8.576555556e-05 4.841153520e-13
e
set label 'default' at screen 0.687313,0.285582 left noenhanced front tc rgb '#202020'
$p1default << e
1.937243131e-06 9.635846808e-16
e
plot $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
