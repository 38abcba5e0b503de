# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.1540 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,587 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 0.8 m at t = 0.5500 s' at screen 0.0193548,0.972743 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.175468 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.175468 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.175468 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.144804 right noenhanced front tc rgb '#c8500a'
set label 'hole oil edge' at screen 0.0612903,0.144804 left noenhanced front tc rgb '#c8500a'
set label '-76.92 MPa' at screen 0.403226,0.144804 right noenhanced front tc rgb '#c8500a'
set label '194 %' at screen 0.493548,0.144804 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.115843 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.115843 left noenhanced front tc rgb '#202020'
set label '-27.23 MPa' at screen 0.403226,0.115843 right noenhanced front tc rgb '#202020'
set label '68.9 %' at screen 0.493548,0.115843 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0868825 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0868825 left noenhanced front tc rgb '#202020'
set label '-27.23 MPa' at screen 0.403226,0.0868825 right noenhanced front tc rgb '#202020'
set label '68.9 %' at screen 0.493548,0.0868825 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0579216 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0579216 left noenhanced front tc rgb '#202020'
set label '-27.22 MPa' at screen 0.403226,0.0579216 right noenhanced front tc rgb '#202020'
set label '68.8 %' at screen 0.493548,0.0579216 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.0483871,0.0289608 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0289608 left noenhanced front tc rgb '#202020'
set label '-27.17 MPa' at screen 0.403226,0.0289608 right noenhanced front tc rgb '#202020'
set label '68.6 %' at screen 0.493548,0.0289608 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.144804 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.551613,0.144804 left noenhanced front tc rgb '#202020'
set label '-27.17 MPa' at screen 0.893548,0.144804 right noenhanced front tc rgb '#202020'
set label '68.5 %' at screen 0.983871,0.144804 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.115843 right noenhanced front tc rgb '#202020'
set label 'beside hole oil +z' at screen 0.551613,0.115843 left noenhanced front tc rgb '#202020'
set label '-27.20 MPa' at screen 0.893548,0.115843 right noenhanced front tc rgb '#202020'
set label '11.8 %' at screen 0.983871,0.115843 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0868825 right noenhanced front tc rgb '#202020'
set label 'beside hole oil -z' at screen 0.551613,0.0868825 left noenhanced front tc rgb '#202020'
set label '-27.20 MPa' at screen 0.893548,0.0868825 right noenhanced front tc rgb '#202020'
set label '11.8 %' at screen 0.983871,0.0868825 right noenhanced front tc rgb '#202020'
set label '9' at screen 0.53871,0.0579216 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0579216 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0579216 right noenhanced front tc rgb '#202020'
set label '2.0 %' at screen 0.983871,0.0579216 right noenhanced front tc rgb '#202020'
set label '10' at screen 0.53871,0.0289608 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0289608 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0289608 right noenhanced front tc rgb '#202020'
set label '2.0 %' at screen 0.983871,0.0289608 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.674616695e-01
set tmargin at screen 9.148211244e-01
set xrange [1.711250000e+02:-1.711250000e+02]
set yrange [-2.196875000e+02:2.196875000e+02]
set xtics 1.000000000e+02
set ytics 5.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.940375 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.20954 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.300000000e+02 -1.850000000e+02
1.300000000e+02 -1.850000000e+02
1.300000000e+02 1.850000000e+02
-1.300000000e+02 1.850000000e+02
-1.300000000e+02 -1.850000000e+02
e
$loop1 << e
-1.000000000e+02 1.450000000e+02
1.000000000e+02 1.450000000e+02
1.000000000e+02 -1.450000000e+02
-1.000000000e+02 -1.450000000e+02
-1.000000000e+02 1.450000000e+02
e
set object rectangle center -115,0 size 30,40 front fs solid border lc rgb '#303030' fc rgb '#ffffff'
set object rectangle center 115,0 size 30,40 front fs solid border lc rgb '#303030' fc rgb '#ffffff'
$welds << e
1.300000000e+02 1.450000000e+02
1.300000000e+02 -1.450000000e+02
-1.300000000e+02 1.450000000e+02
-1.300000000e+02 -1.450000000e+02
e
$places << e
1.000000000e+02 1.850000000e+02
0.000000000e+00 1.850000000e+02
1.150000000e+02 1.450000000e+02
1.150000000e+02 -1.450000000e+02
0.000000000e+00 -1.850000000e+02
1.150000000e+02 -2.000000000e+01
e
$governing << e
1.150000000e+02 1.999999973e+01
e
set label '1, 7' at screen 0.148678,0.645311 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.200828,0.88118 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.88118 left noenhanced front tc rgb '#0b5fa5'
set label '4, 9' at screen 0.179904,0.822246 left noenhanced front tc rgb '#0b5fa5'
set label '5, 10' at screen 0.179904,0.360037 left noenhanced front tc rgb '#0b5fa5'
set label '6' at screen 0.340323,0.336036 left noenhanced front tc rgb '#0b5fa5'
set label '8' at screen 0.16242,0.586376 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.674616695e-01
set tmargin at screen 9.148211244e-01
set xrange [-9.880438916e+01:2.313448907e+01]
set yrange [-2.196875000e+02:2.196875000e+02]
set xtics 5.000000000e+01
set ytics 5.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.940375 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.20954 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.183802348e+00 -1.850000000e+02
1.187816185e+00 -1.618750000e+02
1.191830023e+00 -1.387500000e+02
1.195843860e+00 -1.156250000e+02
1.199857697e+00 -9.250000000e+01
1.203871534e+00 -6.937500000e+01
1.207885372e+00 -4.625000000e+01
1.211899209e+00 -2.312500000e+01
1.215913046e+00 0.000000000e+00
1.219926883e+00 2.312500000e+01
1.223940721e+00 4.625000000e+01
1.227954558e+00 6.937500000e+01
1.231968395e+00 9.250000000e+01
1.235982232e+00 1.156250000e+02
1.239996070e+00 1.387500000e+02
1.244009907e+00 1.618750000e+02
1.248023744e+00 1.850000000e+02
-2.723119137e+01 1.850000000e+02
-2.722717754e+01 1.618750000e+02
-2.722316370e+01 1.387500000e+02
-2.721914986e+01 1.156250000e+02
-2.721513602e+01 9.250000000e+01
-2.721112219e+01 6.937500000e+01
-2.720710835e+01 4.625000000e+01
-2.720309451e+01 2.312500000e+01
-2.719908067e+01 0.000000000e+00
-2.719506684e+01 -2.312500000e+01
-2.719105300e+01 -4.625000000e+01
-2.718703916e+01 -6.937500000e+01
-2.718302533e+01 -9.250000000e+01
-2.717901149e+01 -1.156250000e+02
-2.717499765e+01 -1.387500000e+02
-2.717098381e+01 -1.618750000e+02
-2.716696998e+01 -1.850000000e+02
1.183802348e+00 -1.850000000e+02
e
$high << e
1.183802348e+00 -1.850000000e+02
1.187816185e+00 -1.618750000e+02
1.191830023e+00 -1.387500000e+02
1.195843860e+00 -1.156250000e+02
1.199857697e+00 -9.250000000e+01
1.203871534e+00 -6.937500000e+01
1.207885372e+00 -4.625000000e+01
1.211899209e+00 -2.312500000e+01
1.215913046e+00 0.000000000e+00
1.219926883e+00 2.312500000e+01
1.223940721e+00 4.625000000e+01
1.227954558e+00 6.937500000e+01
1.231968395e+00 9.250000000e+01
1.235982232e+00 1.156250000e+02
1.239996070e+00 1.387500000e+02
1.244009907e+00 1.618750000e+02
1.248023744e+00 1.850000000e+02
e
$low << e
-2.716696998e+01 -1.850000000e+02
-2.717098381e+01 -1.618750000e+02
-2.717499765e+01 -1.387500000e+02
-2.717901149e+01 -1.156250000e+02
-2.718302533e+01 -9.250000000e+01
-2.718703916e+01 -6.937500000e+01
-2.719105300e+01 -4.625000000e+01
-2.719506684e+01 -2.312500000e+01
-2.719908067e+01 0.000000000e+00
-2.720309451e+01 2.312500000e+01
-2.720710835e+01 4.625000000e+01
-2.721112219e+01 6.937500000e+01
-2.721513602e+01 9.250000000e+01
-2.721914986e+01 1.156250000e+02
-2.722316370e+01 1.387500000e+02
-2.722717754e+01 1.618750000e+02
-2.723119137e+01 1.850000000e+02
e
set arrow from screen 0.910213,0.267462 to screen 0.910213,0.914821 nohead lw 0.9 lc rgb '#505050'
$point << e
-7.691792383e+01 1.999999973e+01
e
set label '-76.92 (1)' at screen 0.728619,0.636871 left noenhanced front tc rgb '#c8500a'
set label '1.184' at screen 0.846383,0.334831 left noenhanced front tc rgb '#0b5fa5'
set label '-27.17' at screen 0.768335,0.334831 left noenhanced front tc rgb '#00785a'
set label '1.248' at screen 0.846543,0.879976 left noenhanced front tc rgb '#0b5fa5'
set label '-27.23' at screen 0.768175,0.879976 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
