# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.5769 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,627.333 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 0+ m at t = 0.5000 s' at screen 0.0193548,0.974495 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.299681 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.299681 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.299681 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.270988 right noenhanced front tc rgb '#c8500a'
set label 'corner +y -z' at screen 0.0612903,0.270988 left noenhanced front tc rgb '#c8500a'
set label '8.671 MPa' at screen 0.403226,0.270988 right noenhanced front tc rgb '#c8500a'
set label '3.7 %' at screen 0.493548,0.270988 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.243889 right noenhanced front tc rgb '#202020'
set label 'corner -y +z' at screen 0.0612903,0.243889 left noenhanced front tc rgb '#202020'
set label '-8.258 MPa' at screen 0.403226,0.243889 right noenhanced front tc rgb '#202020'
set label '3.5 %' at screen 0.493548,0.243889 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.216791 right noenhanced front tc rgb '#202020'
set label 'bottom flange' at screen 0.0612903,0.216791 left noenhanced front tc rgb '#202020'
set label '8.100 MPa' at screen 0.403226,0.216791 right noenhanced front tc rgb '#202020'
set label '3.4 %' at screen 0.493548,0.216791 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.189692 right noenhanced front tc rgb '#202020'
set label 'web end +y -z' at screen 0.0612903,0.189692 left noenhanced front tc rgb '#202020'
set label '7.952 MPa' at screen 0.403226,0.189692 right noenhanced front tc rgb '#202020'
set label '3.4 %' at screen 0.493548,0.189692 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.0483871,0.162593 right noenhanced front tc rgb '#202020'
set label 'left web' at screen 0.0612903,0.162593 left noenhanced front tc rgb '#202020'
set label '7.952 MPa' at screen 0.403226,0.162593 right noenhanced front tc rgb '#202020'
set label '3.4 %' at screen 0.493548,0.162593 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.0483871,0.135494 right noenhanced front tc rgb '#202020'
set label 'top flange' at screen 0.0612903,0.135494 left noenhanced front tc rgb '#202020'
set label '-7.687 MPa' at screen 0.403226,0.135494 right noenhanced front tc rgb '#202020'
set label '3.3 %' at screen 0.493548,0.135494 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.0483871,0.108395 right noenhanced front tc rgb '#202020'
set label 'web end -y +z' at screen 0.0612903,0.108395 left noenhanced front tc rgb '#202020'
set label '-7.539 MPa' at screen 0.403226,0.108395 right noenhanced front tc rgb '#202020'
set label '3.2 %' at screen 0.493548,0.108395 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.0483871,0.0812965 right noenhanced front tc rgb '#202020'
set label 'right web' at screen 0.0612903,0.0812965 left noenhanced front tc rgb '#202020'
set label '-7.539 MPa' at screen 0.403226,0.0812965 right noenhanced front tc rgb '#202020'
set label '3.2 %' at screen 0.493548,0.0812965 right noenhanced front tc rgb '#202020'
set label '9' at screen 0.0483871,0.0541977 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.0541977 left noenhanced front tc rgb '#202020'
set label '5.240 MPa' at screen 0.403226,0.0541977 right noenhanced front tc rgb '#202020'
set label '2.2 %' at screen 0.493548,0.0541977 right noenhanced front tc rgb '#202020'
set label '10' at screen 0.0483871,0.0270988 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0270988 left noenhanced front tc rgb '#202020'
set label '-4.827 MPa' at screen 0.403226,0.0270988 right noenhanced front tc rgb '#202020'
set label '2.1 %' at screen 0.493548,0.0270988 right noenhanced front tc rgb '#202020'
set label '11' at screen 0.53871,0.270988 right noenhanced front tc rgb '#202020'
set label 'fibre +y' at screen 0.551613,0.270988 left noenhanced front tc rgb '#202020'
set label '3.637 MPa' at screen 0.893548,0.270988 right noenhanced front tc rgb '#202020'
set label '1.6 %' at screen 0.983871,0.270988 right noenhanced front tc rgb '#202020'
set label '12' at screen 0.53871,0.243889 right noenhanced front tc rgb '#202020'
set label 'fibre -y' at screen 0.551613,0.243889 left noenhanced front tc rgb '#202020'
set label '-3.224 MPa' at screen 0.893548,0.243889 right noenhanced front tc rgb '#202020'
set label '1.4 %' at screen 0.983871,0.243889 right noenhanced front tc rgb '#202020'
set label '13' at screen 0.53871,0.216791 right noenhanced front tc rgb '#202020'
set label 'corner -y -z' at screen 0.551613,0.216791 left noenhanced front tc rgb '#202020'
set label '1.809 MPa' at screen 0.893548,0.216791 right noenhanced front tc rgb '#202020'
set label '0.8 %' at screen 0.983871,0.216791 right noenhanced front tc rgb '#202020'
set label '14' at screen 0.53871,0.189692 right noenhanced front tc rgb '#202020'
set label 'corner +y +z' at screen 0.551613,0.189692 left noenhanced front tc rgb '#202020'
set label '-1.396 MPa' at screen 0.893548,0.189692 right noenhanced front tc rgb '#202020'
set label '0.6 %' at screen 0.983871,0.189692 right noenhanced front tc rgb '#202020'
set label '15' at screen 0.53871,0.162593 right noenhanced front tc rgb '#202020'
set label 'web end -y -z' at screen 0.551613,0.162593 left noenhanced front tc rgb '#202020'
set label '1.090 MPa' at screen 0.893548,0.162593 right noenhanced front tc rgb '#202020'
set label '0.5 %' at screen 0.983871,0.162593 right noenhanced front tc rgb '#202020'
set label '16' at screen 0.53871,0.135494 right noenhanced front tc rgb '#202020'
set label 'web end +y +z' at screen 0.551613,0.135494 left noenhanced front tc rgb '#202020'
set label '-0.6773 MPa' at screen 0.893548,0.135494 right noenhanced front tc rgb '#202020'
set label '0.4 %' at screen 0.983871,0.135494 right noenhanced front tc rgb '#202020'
set label '17' at screen 0.53871,0.108395 right noenhanced front tc rgb '#202020'
set label 'seam +y +z throat' at screen 0.551613,0.108395 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.108395 right noenhanced front tc rgb '#202020'
set label '0.3 %' at screen 0.983871,0.108395 right noenhanced front tc rgb '#202020'
set label '18' at screen 0.53871,0.0812965 right noenhanced front tc rgb '#202020'
set label 'seam -y -z throat' at screen 0.551613,0.0812965 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0812965 right noenhanced front tc rgb '#202020'
set label '0.2 %' at screen 0.983871,0.0812965 right noenhanced front tc rgb '#202020'
set label '19' at screen 0.53871,0.0541977 right noenhanced front tc rgb '#202020'
set label 'seam -y +z throat' at screen 0.551613,0.0541977 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0541977 right noenhanced front tc rgb '#202020'
set label '0.1 %' at screen 0.983871,0.0541977 right noenhanced front tc rgb '#202020'
set label '20' at screen 0.53871,0.0270988 right noenhanced front tc rgb '#202020'
set label 'seam +y -z throat' at screen 0.551613,0.0270988 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0270988 right noenhanced front tc rgb '#202020'
set label '0.1 %' at screen 0.983871,0.0270988 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 3.857598300e-01
set tmargin at screen 9.202975558e-01
set xrange [7.525423729e+01:-7.525423729e+01]
set yrange [-8.525423729e+01:8.525423729e+01]
set xtics 5.000000000e+01
set ytics 2.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.944208 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.331562 center noenhanced front tc rgb '#202020'
$loop0 << e
-6.000000000e+01 -7.000000000e+01
6.000000000e+01 -7.000000000e+01
6.000000000e+01 7.000000000e+01
-6.000000000e+01 7.000000000e+01
-6.000000000e+01 -7.000000000e+01
e
$loop1 << e
-5.000000000e+01 6.000000000e+01
5.000000000e+01 6.000000000e+01
5.000000000e+01 -6.000000000e+01
-5.000000000e+01 -6.000000000e+01
-5.000000000e+01 6.000000000e+01
e
$welds << e
6.000000000e+01 6.000000000e+01
6.000000000e+01 -6.000000000e+01
-6.000000000e+01 6.000000000e+01
-6.000000000e+01 -6.000000000e+01
e
$places << e
-6.000000000e+01 7.000000000e+01
5.000000000e+01 -7.000000000e+01
6.000000000e+01 -6.000000000e+01
-5.000000000e+01 7.000000000e+01
-6.000000000e+01 6.000000000e+01
0.000000000e+00 -7.000000000e+01
0.000000000e+00 7.000000000e+01
6.000000000e+01 0.000000000e+00
-6.000000000e+01 0.000000000e+00
-6.000000000e+01 -7.000000000e+01
6.000000000e+01 7.000000000e+01
-6.000000000e+01 -6.000000000e+01
6.000000000e+01 6.000000000e+01
e
$governing << e
6.000000000e+01 -7.000000000e+01
e
set label '1' at screen 0.15,0.449925 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.530645,0.88882 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.18172,0.449925 left noenhanced front tc rgb '#0b5fa5'
set label '4, 5, 20' at screen 0.172581,0.497055 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.172581,0.485099 to screen 0.13871,0.464931 nohead lw 0.6 lc rgb '#0b5fa5'
set label '6' at screen 0.498925,0.88882 left noenhanced front tc rgb '#0b5fa5'
set label '7, 8, 19' at screen 0.405742,0.809003 left noenhanced front tc rgb '#0b5fa5'
set arrow from screen 0.485484,0.820958 to screen 0.519355,0.841126 nohead lw 0.6 lc rgb '#0b5fa5'
set label '9' at screen 0.340323,0.449925 left noenhanced front tc rgb '#0b5fa5'
set label '10' at screen 0.340323,0.88882 left noenhanced front tc rgb '#0b5fa5'
set label '11' at screen 0.102645,0.669372 left noenhanced front tc rgb '#0b5fa5'
set label '12' at screen 0.530645,0.669372 left noenhanced front tc rgb '#0b5fa5'
set label '13' at screen 0.530645,0.449925 left noenhanced front tc rgb '#0b5fa5'
set label '14' at screen 0.15,0.88882 left noenhanced front tc rgb '#0b5fa5'
set label '15, 18' at screen 0.443419,0.448587 left noenhanced front tc rgb '#0b5fa5'
set label '16, 17' at screen 0.15,0.85747 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.857598300e-01
set tmargin at screen 9.202975558e-01
set xrange [-1.299872101e+01:1.341170808e+01]
set yrange [-8.525423729e+01:8.525423729e+01]
set xtics 1.000000000e+01
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.944208 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.331562 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
8.671374651e+00 -7.000000000e+01
8.042135820e+00 -6.125000000e+01
7.412896989e+00 -5.250000000e+01
6.783658159e+00 -4.375000000e+01
6.154419328e+00 -3.500000000e+01
5.525180497e+00 -2.625000000e+01
4.895941666e+00 -1.750000000e+01
4.266702836e+00 -8.750000000e+00
3.682197534e+00 0.000000000e+00
3.222577660e+00 8.750000000e+00
2.762957787e+00 1.750000000e+01
2.303337913e+00 2.625000000e+01
1.843718040e+00 3.500000000e+01
1.384098166e+00 4.375000000e+01
9.244782930e-01 5.250000000e+01
4.648584195e-01 6.125000000e+01
5.238546059e-03 7.000000000e+01
-8.258387581e+00 7.000000000e+01
-7.629148750e+00 6.125000000e+01
-6.999909919e+00 5.250000000e+01
-6.370671089e+00 4.375000000e+01
-5.741432258e+00 3.500000000e+01
-5.112193427e+00 2.625000000e+01
-4.482954597e+00 1.750000000e+01
-3.853715766e+00 8.750000000e+00
-3.224476935e+00 0.000000000e+00
-2.732689521e+00 -8.750000000e+00
-2.273069648e+00 -1.750000000e+01
-1.813449774e+00 -2.625000000e+01
-1.353829901e+00 -3.500000000e+01
-8.942100273e-01 -4.375000000e+01
-4.345901539e-01 -5.250000000e+01
2.502971958e-02 -6.125000000e+01
4.846495930e-01 -7.000000000e+01
8.671374651e+00 -7.000000000e+01
e
$high << e
8.671374651e+00 -7.000000000e+01
8.042135820e+00 -6.125000000e+01
7.412896989e+00 -5.250000000e+01
6.783658159e+00 -4.375000000e+01
6.154419328e+00 -3.500000000e+01
5.525180497e+00 -2.625000000e+01
4.895941666e+00 -1.750000000e+01
4.266702836e+00 -8.750000000e+00
3.682197534e+00 0.000000000e+00
3.222577660e+00 8.750000000e+00
2.762957787e+00 1.750000000e+01
2.303337913e+00 2.625000000e+01
1.843718040e+00 3.500000000e+01
1.384098166e+00 4.375000000e+01
9.244782930e-01 5.250000000e+01
4.648584195e-01 6.125000000e+01
5.238546059e-03 7.000000000e+01
e
$low << e
4.846495930e-01 -7.000000000e+01
2.502971958e-02 -6.125000000e+01
-4.345901539e-01 -5.250000000e+01
-8.942100273e-01 -4.375000000e+01
-1.353829901e+00 -3.500000000e+01
-1.813449774e+00 -2.625000000e+01
-2.273069648e+00 -1.750000000e+01
-2.732689521e+00 -8.750000000e+00
-3.224476935e+00 0.000000000e+00
-3.853715766e+00 8.750000000e+00
-4.482954597e+00 1.750000000e+01
-5.112193427e+00 2.625000000e+01
-5.741432258e+00 3.500000000e+01
-6.370671089e+00 4.375000000e+01
-6.999909919e+00 5.250000000e+01
-7.629148750e+00 6.125000000e+01
-8.258387581e+00 7.000000000e+01
e
set arrow from screen 0.813758,0.38576 to screen 0.813758,0.920298 nohead lw 0.9 lc rgb '#505050'
$point << e
8.671374651e+00 -7.000000000e+01
e
set label '8.671 (1)' at screen 0.867252,0.412062 left noenhanced front tc rgb '#c8500a'
set label '0.4846' at screen 0.829,0.448798 left noenhanced front tc rgb '#00785a'
set label '0.005239' at screen 0.823496,0.887693 left noenhanced front tc rgb '#0b5fa5'
set label '-8.258' at screen 0.728619,0.887693 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
