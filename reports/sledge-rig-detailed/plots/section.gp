# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.7976 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,553 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 5.2+ m at t = 0.3571 s, normal running' at screen 0.0193548,0.971067 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.124774 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.124774 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.124774 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.0922242 right noenhanced front tc rgb '#c8500a'
set label 'fibre +z' at screen 0.0612903,0.0922242 left noenhanced front tc rgb '#c8500a'
set label '-13.38 MPa' at screen 0.403226,0.0922242 right noenhanced front tc rgb '#c8500a'
set label '123 %' at screen 0.493548,0.0922242 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.0614828 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0614828 left noenhanced front tc rgb '#202020'
set label '12.90 MPa' at screen 0.403226,0.0614828 right noenhanced front tc rgb '#202020'
set label '123 %' at screen 0.493548,0.0614828 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0307414 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0307414 left noenhanced front tc rgb '#202020'
set label '-10.37 MPa' at screen 0.403226,0.0307414 right noenhanced front tc rgb '#202020'
set label '67.5 %' at screen 0.493548,0.0307414 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.53871,0.0922242 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.551613,0.0922242 left noenhanced front tc rgb '#202020'
set label '9.895 MPa' at screen 0.893548,0.0922242 right noenhanced front tc rgb '#202020'
set label '67.1 %' at screen 0.983871,0.0922242 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.0614828 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0614828 left noenhanced front tc rgb '#202020'
set label '-0.2398 MPa' at screen 0.893548,0.0614828 right noenhanced front tc rgb '#202020'
set label '15.4 %' at screen 0.983871,0.0614828 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.224231465e-01
set tmargin at screen 9.095840868e-01
set xrange [2.266250000e+02:-2.266250000e+02]
set yrange [-2.909375000e+02:2.909375000e+02]
set xtics 1.000000000e+02
set ytics 5.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.936709 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.16094 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.450000000e+02 -2.450000000e+02
1.450000000e+02 -2.450000000e+02
1.450000000e+02 2.450000000e+02
-1.450000000e+02 2.450000000e+02
-1.450000000e+02 -2.450000000e+02
e
$loop1 << e
-8.900000000e+01 1.890000000e+02
8.900000000e+01 1.890000000e+02
8.900000000e+01 -1.890000000e+02
-8.900000000e+01 -1.890000000e+02
-8.900000000e+01 1.890000000e+02
e
$places << e
0.000000000e+00 -2.450000000e+02
1.170000000e+02 1.890000000e+02
1.170000000e+02 -1.890000000e+02
1.170000000e+02 0.000000000e+00
e
$governing << e
0.000000000e+00 2.450000000e+02
e
set label '1' at screen 0.340323,0.873875 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.295213 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.217084,0.807742 left noenhanced front tc rgb '#0b5fa5'
set label '4' at screen 0.217084,0.361346 left noenhanced front tc rgb '#0b5fa5'
set label '5' at screen 0.217084,0.584544 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.224231465e-01
set tmargin at screen 9.095840868e-01
set xrange [-2.495703292e+01:2.432032850e+01]
set yrange [-2.909375000e+02:2.909375000e+02]
set xtics 2.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.936709 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.16094 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.547567389e+01 -2.450000000e+02
1.350142063e+01 -2.143750000e+02
1.152716737e+01 -1.837500000e+02
9.552914103e+00 -1.531250000e+02
7.578660841e+00 -1.225000000e+02
5.604407579e+00 -9.187500000e+01
3.630154317e+00 -6.125000000e+01
1.655901055e+00 -3.062500000e+01
-8.028286749e-02 0.000000000e+00
1.737551076e+00 3.062500000e+01
3.682593046e+00 6.125000000e+01
5.627635015e+00 9.187500000e+01
7.572676984e+00 1.225000000e+02
9.517718953e+00 1.531250000e+02
1.146276092e+01 1.837500000e+02
1.340780289e+01 2.143750000e+02
1.535284486e+01 2.450000000e+02
-1.611237830e+01 2.450000000e+02
-1.413812504e+01 2.143750000e+02
-1.216387178e+01 1.837500000e+02
-1.018961852e+01 1.531250000e+02
-8.215365255e+00 1.225000000e+02
-6.241111993e+00 9.187500000e+01
-4.266858731e+00 6.125000000e+01
-2.292605469e+00 3.062500000e+01
-3.183522071e-01 0.000000000e+00
-2.152532862e+00 -3.062500000e+01
-4.097574831e+00 -6.125000000e+01
-6.042616800e+00 -9.187500000e+01
-7.987658770e+00 -1.225000000e+02
-9.932700739e+00 -1.531250000e+02
-1.187774271e+01 -1.837500000e+02
-1.382278468e+01 -2.143750000e+02
-1.576782665e+01 -2.450000000e+02
1.547567389e+01 -2.450000000e+02
e
$high << e
1.547567389e+01 -2.450000000e+02
1.350142063e+01 -2.143750000e+02
1.152716737e+01 -1.837500000e+02
9.552914103e+00 -1.531250000e+02
7.578660841e+00 -1.225000000e+02
5.604407579e+00 -9.187500000e+01
3.630154317e+00 -6.125000000e+01
1.655901055e+00 -3.062500000e+01
-8.028286749e-02 0.000000000e+00
1.737551076e+00 3.062500000e+01
3.682593046e+00 6.125000000e+01
5.627635015e+00 9.187500000e+01
7.572676984e+00 1.225000000e+02
9.517718953e+00 1.531250000e+02
1.146276092e+01 1.837500000e+02
1.340780289e+01 2.143750000e+02
1.535284486e+01 2.450000000e+02
e
$low << e
-1.576782665e+01 -2.450000000e+02
-1.382278468e+01 -2.143750000e+02
-1.187774271e+01 -1.837500000e+02
-9.932700739e+00 -1.531250000e+02
-7.987658770e+00 -1.225000000e+02
-6.042616800e+00 -9.187500000e+01
-4.097574831e+00 -6.125000000e+01
-2.152532862e+00 -3.062500000e+01
-3.183522071e-01 0.000000000e+00
-2.292605469e+00 3.062500000e+01
-4.266858731e+00 6.125000000e+01
-6.241111993e+00 9.187500000e+01
-8.215365255e+00 1.225000000e+02
-1.018961852e+01 1.531250000e+02
-1.216387178e+01 1.837500000e+02
-1.413812504e+01 2.143750000e+02
-1.611237830e+01 2.450000000e+02
e
set arrow from screen 0.818088,0.222423 to screen 0.818088,0.909584 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.337778835e+01 2.450000000e+02
e
set label '-13.38 (1)' at screen 0.68593,0.879747 left noenhanced front tc rgb '#c8500a'
set label '15.48' at screen 0.846543,0.259411 left noenhanced front tc rgb '#0b5fa5'
set label '-15.77' at screen 0.730739,0.259411 left noenhanced front tc rgb '#00785a'
set label '15.35' at screen 0.845787,0.872596 left noenhanced front tc rgb '#0b5fa5'
set label '-16.11' at screen 0.728619,0.838073 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
