# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.7137 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,545 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 4.2- m at t = 0.2778 s' at screen 0.0193548,0.970642 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.157798 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.157798 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.157798 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.124771 right noenhanced front tc rgb '#c8500a'
set label 'fibre +z' at screen 0.0612903,0.124771 left noenhanced front tc rgb '#c8500a'
set label '-18.87 MPa' at screen 0.403226,0.124771 right noenhanced front tc rgb '#c8500a'
set label '92.0 %' at screen 0.493548,0.124771 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.093578 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.093578 left noenhanced front tc rgb '#202020'
set label '-18.87 MPa' at screen 0.403226,0.093578 right noenhanced front tc rgb '#202020'
set label '92.0 %' at screen 0.493548,0.093578 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0623853 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0623853 left noenhanced front tc rgb '#202020'
set label '18.38 MPa' at screen 0.403226,0.0623853 right noenhanced front tc rgb '#202020'
set label '92.0 %' at screen 0.493548,0.0623853 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0311927 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.0612903,0.0311927 left noenhanced front tc rgb '#202020'
set label '-17.08 MPa' at screen 0.403226,0.0311927 right noenhanced front tc rgb '#202020'
set label '83.2 %' at screen 0.493548,0.0311927 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.124771 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.551613,0.124771 left noenhanced front tc rgb '#202020'
set label '16.59 MPa' at screen 0.893548,0.124771 right noenhanced front tc rgb '#202020'
set label '83.2 %' at screen 0.983871,0.124771 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.093578 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.093578 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.093578 right noenhanced front tc rgb '#202020'
set label '3.1 %' at screen 0.983871,0.093578 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0623853 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0623853 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0623853 right noenhanced front tc rgb '#202020'
set label '3.1 %' at screen 0.983871,0.0623853 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0311927 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.0311927 left noenhanced front tc rgb '#202020'
set label '-0.2417 MPa' at screen 0.893548,0.0311927 right noenhanced front tc rgb '#202020'
set label '0.9 %' at screen 0.983871,0.0311927 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.568807339e-01
set tmargin at screen 9.082568807e-01
set xrange [1.254237288e+02:-1.254237288e+02]
set yrange [-1.504237288e+02:1.504237288e+02]
set xtics 1.000000000e+02
set ytics 2.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.93578 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.194495 center noenhanced front tc rgb '#202020'
$loop0 << e
-1.000000000e+02 -1.250000000e+02
1.000000000e+02 -1.250000000e+02
1.000000000e+02 1.250000000e+02
-1.000000000e+02 1.250000000e+02
-1.000000000e+02 -1.250000000e+02
e
$loop1 << e
-8.800000000e+01 1.130000000e+02
8.800000000e+01 1.130000000e+02
8.800000000e+01 -1.130000000e+02
-8.800000000e+01 -1.130000000e+02
-8.800000000e+01 1.130000000e+02
e
$welds << e
1.000000000e+02 1.130000000e+02
1.000000000e+02 -1.130000000e+02
-1.000000000e+02 1.130000000e+02
-1.000000000e+02 -1.130000000e+02
e
$places << e
8.800000000e+01 1.250000000e+02
0.000000000e+00 -1.250000000e+02
9.400000000e+01 1.130000000e+02
9.400000000e+01 -1.130000000e+02
9.400000000e+01 0.000000000e+00
e
$governing << e
0.000000000e+00 1.250000000e+02
e
set label '1' at screen 0.340323,0.872024 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.172839,0.872024 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.293114 left noenhanced front tc rgb '#0b5fa5'
set label '4, 6' at screen 0.171097,0.800632 left noenhanced front tc rgb '#0b5fa5'
set label '5, 7' at screen 0.171097,0.364506 left noenhanced front tc rgb '#0b5fa5'
set label '8' at screen 0.143935,0.609174 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.568807339e-01
set tmargin at screen 9.082568807e-01
set xrange [-2.929624617e+01:2.881343554e+01]
set yrange [-1.504237288e+02:1.504237288e+02]
set xtics 2.000000000e+01
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.93578 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.194495 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.838283740e+01 -1.250000000e+02
1.605476610e+01 -1.093750000e+02
1.372669481e+01 -9.375000000e+01
1.139862352e+01 -7.812500000e+01
9.070552222e+00 -6.250000000e+01
6.742480928e+00 -4.687500000e+01
4.414409635e+00 -3.125000000e+01
2.086338341e+00 -1.562500000e+01
-2.320769950e-01 0.000000000e+00
2.087061452e+00 1.562500000e+01
4.415123055e+00 3.125000000e+01
6.743184658e+00 4.687500000e+01
9.071246261e+00 6.250000000e+01
1.139930786e+01 7.812500000e+01
1.372736947e+01 9.375000000e+01
1.605543107e+01 1.093750000e+02
1.838349267e+01 1.250000000e+02
-1.886630330e+01 1.250000000e+02
-1.653823201e+01 1.093750000e+02
-1.421016071e+01 9.375000000e+01
-1.188208942e+01 7.812500000e+01
-9.554018127e+00 6.250000000e+01
-7.225946834e+00 4.687500000e+01
-4.897875540e+00 3.125000000e+01
-2.569804246e+00 1.562500000e+01
-2.417329527e-01 0.000000000e+00
-2.569061754e+00 -1.562500000e+01
-4.897123357e+00 -3.125000000e+01
-7.225184959e+00 -4.687500000e+01
-9.553246562e+00 -6.250000000e+01
-1.188130817e+01 -7.812500000e+01
-1.420936977e+01 -9.375000000e+01
-1.653743137e+01 -1.093750000e+02
-1.886549297e+01 -1.250000000e+02
1.838283740e+01 -1.250000000e+02
e
$high << e
1.838283740e+01 -1.250000000e+02
1.605476610e+01 -1.093750000e+02
1.372669481e+01 -9.375000000e+01
1.139862352e+01 -7.812500000e+01
9.070552222e+00 -6.250000000e+01
6.742480928e+00 -4.687500000e+01
4.414409635e+00 -3.125000000e+01
2.086338341e+00 -1.562500000e+01
-2.320769950e-01 0.000000000e+00
2.087061452e+00 1.562500000e+01
4.415123055e+00 3.125000000e+01
6.743184658e+00 4.687500000e+01
9.071246261e+00 6.250000000e+01
1.139930786e+01 7.812500000e+01
1.372736947e+01 9.375000000e+01
1.605543107e+01 1.093750000e+02
1.838349267e+01 1.250000000e+02
e
$low << e
-1.886549297e+01 -1.250000000e+02
-1.653743137e+01 -1.093750000e+02
-1.420936977e+01 -9.375000000e+01
-1.188130817e+01 -7.812500000e+01
-9.553246562e+00 -6.250000000e+01
-7.225184959e+00 -4.687500000e+01
-4.897123357e+00 -3.125000000e+01
-2.569061754e+00 -1.562500000e+01
-2.417329527e-01 0.000000000e+00
-2.569804246e+00 1.562500000e+01
-4.897875540e+00 3.125000000e+01
-7.225946834e+00 4.687500000e+01
-9.554018127e+00 6.250000000e+01
-1.188208942e+01 7.812500000e+01
-1.421016071e+01 9.375000000e+01
-1.653823201e+01 1.093750000e+02
-1.886630330e+01 1.250000000e+02
e
set arrow from screen 0.817389,0.256881 to screen 0.817389,0.908257 nohead lw 0.9 lc rgb '#505050'
$point << e
-1.886630330e+01 1.250000000e+02
e
set label '-18.87 (1)' at screen 0.669103,0.877982 left noenhanced front tc rgb '#c8500a'
set label '18.38' at screen 0.846539,0.294411 left noenhanced front tc rgb '#0b5fa5'
set label '-18.87' at screen 0.728623,0.294411 left noenhanced front tc rgb '#00785a'
set label '18.38' at screen 0.846543,0.870726 left noenhanced front tc rgb '#0b5fa5'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
