# Redraw in the folder above: gnuplot plots/section.gp; as PDF: gnuplot -e 'pdf = 1' plots/section.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,5.0215 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'section.pdf'
} else {
  set terminal svg size 620,478.978 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'section.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 's = 2.6614 m at t = 1.0982 s' at screen 0.0193548,0.966596 left noenhanced front tc rgb '#202020'
set label 'utilisation' at screen 0.493548,0.179549 right noenhanced front tc rgb '#505050'
set label 'stress then' at screen 0.383871,0.179549 right noenhanced front tc rgb '#505050'
set label 'checked place' at screen 0.0612903,0.179549 left noenhanced front tc rgb '#505050'
set label '1' at screen 0.0483871,0.141969 right noenhanced front tc rgb '#c8500a'
set label 'bottom flange' at screen 0.0612903,0.141969 left noenhanced front tc rgb '#c8500a'
set label '-21.52 MPa' at screen 0.403226,0.141969 right noenhanced front tc rgb '#c8500a'
set label '110 %' at screen 0.493548,0.141969 right noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.0483871,0.106477 right noenhanced front tc rgb '#202020'
set label 'fibre -z' at screen 0.0612903,0.106477 left noenhanced front tc rgb '#202020'
set label '-21.52 MPa' at screen 0.403226,0.106477 right noenhanced front tc rgb '#202020'
set label '110 %' at screen 0.493548,0.106477 right noenhanced front tc rgb '#202020'
set label '3' at screen 0.0483871,0.0709845 right noenhanced front tc rgb '#202020'
set label 'fibre +z' at screen 0.0612903,0.0709845 left noenhanced front tc rgb '#202020'
set label '20.18 MPa' at screen 0.403226,0.0709845 right noenhanced front tc rgb '#202020'
set label '110 %' at screen 0.493548,0.0709845 right noenhanced front tc rgb '#202020'
set label '4' at screen 0.0483871,0.0354922 right noenhanced front tc rgb '#202020'
set label 'web end -z' at screen 0.0612903,0.0354922 left noenhanced front tc rgb '#202020'
set label '-18.29 MPa' at screen 0.403226,0.0354922 right noenhanced front tc rgb '#202020'
set label '93.0 %' at screen 0.493548,0.0354922 right noenhanced front tc rgb '#202020'
set label '5' at screen 0.53871,0.141969 right noenhanced front tc rgb '#202020'
set label 'web end +z' at screen 0.551613,0.141969 left noenhanced front tc rgb '#202020'
set label '16.96 MPa' at screen 0.893548,0.141969 right noenhanced front tc rgb '#202020'
set label '93.0 %' at screen 0.983871,0.141969 right noenhanced front tc rgb '#202020'
set label '6' at screen 0.53871,0.106477 right noenhanced front tc rgb '#202020'
set label 'neutral axis' at screen 0.551613,0.106477 left noenhanced front tc rgb '#202020'
set label '-0.6690 MPa' at screen 0.893548,0.106477 right noenhanced front tc rgb '#202020'
set label '4.8 %' at screen 0.983871,0.106477 right noenhanced front tc rgb '#202020'
set label '7' at screen 0.53871,0.0709845 right noenhanced front tc rgb '#202020'
set label 'seam +z throat' at screen 0.551613,0.0709845 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0709845 right noenhanced front tc rgb '#202020'
set label '0.9 %' at screen 0.983871,0.0709845 right noenhanced front tc rgb '#202020'
set label '8' at screen 0.53871,0.0354922 right noenhanced front tc rgb '#202020'
set label 'seam -z throat' at screen 0.551613,0.0354922 left noenhanced front tc rgb '#202020'
set label 'shear' at screen 0.893548,0.0354922 right noenhanced front tc rgb '#202020'
set label '0.9 %' at screen 0.983871,0.0354922 right noenhanced front tc rgb '#202020'
set lmargin at screen 9.032258065e-02
set rmargin at screen 5.677419355e-01
set bmargin at screen 2.922890955e-01
set tmargin at screen 8.956110373e-01
set xrange [1.003389831e+02:-1.003389831e+02]
set yrange [-9.795859027e+01:9.795859027e+01]
set xtics 5.000000000e+01
set ytics 2.000000000e+01
set label 'z [mm], seen along the beam' at screen 0.0193548,0.926928 left enhanced front tc rgb '#202020'
set label 'y [mm]' at screen 0.329032,0.221305 center noenhanced front tc rgb '#202020'
$loop0 << e
-8.000000000e+01 -7.761960722e+01
8.000000000e+01 -7.761960722e+01
8.000000000e+01 7.761960722e+01
-8.000000000e+01 7.761960722e+01
-8.000000000e+01 -7.761960722e+01
e
$loop1 << e
-6.800000000e+01 6.561960722e+01
6.800000000e+01 6.561960722e+01
6.800000000e+01 -6.561960722e+01
-6.800000000e+01 -6.561960722e+01
-6.800000000e+01 6.561960722e+01
e
$welds << e
8.000000000e+01 6.561960722e+01
8.000000000e+01 -6.561960722e+01
-8.000000000e+01 6.561960722e+01
-8.000000000e+01 -6.561960722e+01
e
$places << e
0.000000000e+00 -7.761960722e+01
0.000000000e+00 7.761960722e+01
7.400000000e+01 -6.561960722e+01
7.400000000e+01 6.561960722e+01
7.400000000e+01 0.000000000e+00
e
$governing << e
6.800000000e+01 -7.761960722e+01
e
set label '1' at screen 0.178548,0.333517 left noenhanced front tc rgb '#c8500a'
set label '2' at screen 0.340323,0.333517 left noenhanced front tc rgb '#0b5fa5'
set label '3' at screen 0.340323,0.854384 left noenhanced front tc rgb '#0b5fa5'
set label '4, 8' at screen 0.173952,0.42214 left noenhanced front tc rgb '#0b5fa5'
set label '5, 7' at screen 0.0921452,0.826287 left noenhanced front tc rgb '#0b5fa5'
set label '6' at screen 0.14679,0.624223 left noenhanced front tc rgb '#0b5fa5'
plot $loop0 using 1:2 with filledcurves closed fc rgb '#d5dde6' notitle, $loop0 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $loop1 using 1:2 with filledcurves closed fc rgb '#ffffff' notitle, $loop1 using 1:2 with lines lw 1.1 lc rgb '#303030' notitle, $welds using 1:2 with points pt 9 ps 0.8 lc rgb '#303030' notitle, $places using 1:2 with points pt 7 ps 0.6 lc rgb '#0b5fa5' notitle, $governing using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set lmargin at screen 6.645161290e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 2.922890955e-01
set tmargin at screen 8.956110373e-01
set xrange [-3.319275831e+01:3.185488643e+01]
set yrange [-9.795859027e+01:9.795859027e+01]
set xtics 5.000000000e+01
set ytics 2.000000000e+01
set label 'highest and lowest over the height' at screen 0.593548,0.926928 left enhanced front tc rgb '#202020'
set label 'nominal stress [MPa]' at screen 0.816129,0.221305 center noenhanced front tc rgb '#202020'
set format y ''
$band << e
1.487721398e+01 -7.761960722e+01
1.293453611e+01 -6.791715632e+01
1.099186998e+01 -5.821470542e+01
9.049223036e+00 -4.851225451e+01
7.106610779e+00 -3.880980361e+01
5.164071466e+00 -2.910735271e+01
3.221732179e+00 -1.940490181e+01
1.280415905e+00 -9.702450903e+00
-3.701654011e-01 0.000000000e+00
1.937511472e+00 9.702450903e+00
4.543372316e+00 1.940490181e+01
7.149383209e+00 2.910735271e+01
9.755425648e+00 3.880980361e+01
1.236147991e+01 4.851225451e+01
1.496753988e+01 5.821470542e+01
1.757360303e+01 6.791715632e+01
2.017966814e+01 7.761960722e+01
-1.620660316e+01 7.761960722e+01
-1.426392052e+01 6.791715632e+01
-1.232124701e+01 5.821470542e+01
-1.037858784e+01 4.851225451e+01
-8.435953004e+00 3.880980361e+01
-6.493364695e+00 2.910735271e+01
-4.550883744e+00 1.940490181e+01
-2.608758270e+00 9.702450903e+00
-6.704081427e-01 0.000000000e+00
-3.275258168e+00 -9.702450903e+00
-5.881215282e+00 -1.940490181e+01
-8.487243375e+00 -2.910735271e+01
-1.109329179e+01 -3.880980361e+01
-1.369934881e+01 -4.851225451e+01
-1.630541027e+01 -5.821470542e+01
-1.891147433e+01 -6.791715632e+01
-2.151754003e+01 -7.761960722e+01
1.487721398e+01 -7.761960722e+01
e
$high << e
1.487721398e+01 -7.761960722e+01
1.293453611e+01 -6.791715632e+01
1.099186998e+01 -5.821470542e+01
9.049223036e+00 -4.851225451e+01
7.106610779e+00 -3.880980361e+01
5.164071466e+00 -2.910735271e+01
3.221732179e+00 -1.940490181e+01
1.280415905e+00 -9.702450903e+00
-3.701654011e-01 0.000000000e+00
1.937511472e+00 9.702450903e+00
4.543372316e+00 1.940490181e+01
7.149383209e+00 2.910735271e+01
9.755425648e+00 3.880980361e+01
1.236147991e+01 4.851225451e+01
1.496753988e+01 5.821470542e+01
1.757360303e+01 6.791715632e+01
2.017966814e+01 7.761960722e+01
e
$low << e
-2.151754003e+01 -7.761960722e+01
-1.891147433e+01 -6.791715632e+01
-1.630541027e+01 -5.821470542e+01
-1.369934881e+01 -4.851225451e+01
-1.109329179e+01 -3.880980361e+01
-8.487243375e+00 -2.910735271e+01
-5.881215282e+00 -1.940490181e+01
-3.275258168e+00 -9.702450903e+00
-6.704081427e-01 0.000000000e+00
-2.608758270e+00 9.702450903e+00
-4.550883744e+00 1.940490181e+01
-6.493364695e+00 2.910735271e+01
-8.435953004e+00 3.880980361e+01
-1.037858784e+01 4.851225451e+01
-1.232124701e+01 5.821470542e+01
-1.426392052e+01 6.791715632e+01
-1.620660316e+01 7.761960722e+01
e
set arrow from screen 0.819247,0.292289 to screen 0.819247,0.895611 nohead lw 0.9 lc rgb '#505050'
$point << e
-2.151754003e+01 -7.761960722e+01
e
set label '-21.52 (1)' at screen 0.669103,0.326737 left noenhanced front tc rgb '#c8500a'
set label '14.88' at screen 0.898276,0.374852 left noenhanced front tc rgb '#0b5fa5'
set label '20.18' at screen 0.846543,0.852907 left noenhanced front tc rgb '#0b5fa5'
set label '-16.21' at screen 0.753376,0.852907 left noenhanced front tc rgb '#00785a'
plot $band using 1:2 with filledcurves closed fc rgb '#e2e2e2' notitle, $high using 1:2 with lines lw 1.6 dt 1 lc rgb '#0b5fa5' notitle, $low using 1:2 with lines lw 1.6 dt (3,3) lc rgb '#00785a' notitle, $point using 1:2 with points pt 7 ps 0.9 lc rgb '#c8500a' notitle
unset label
unset arrow
unset object
set format y '%g'
unset multiplot
