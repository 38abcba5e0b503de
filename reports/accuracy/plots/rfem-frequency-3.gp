# Redraw in the folder above: gnuplot plots/rfem-frequency-3.gp; as PDF: gnuplot -e 'pdf = 1' plots/rfem-frequency-3.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,6.1645 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'rfem-frequency-3.pdf'
} else {
  set terminal svg size 620,588 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'rfem-frequency-3.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Rigid finite elements: third frequency' at screen 0.0193548,0.973639 left noenhanced front tc rgb '#202020'
set label 'on uniform cantilever without shear (Euler and Bernoulli)' at screen 0.0193548,0.944728 left noenhanced front tc rgb '#5d6b79'
set label 'reference: cos(x) cosh(x) = -1, long double' at screen 0.0193548,0.919218 left noenhanced front tc rgb '#5d6b79'
set label 'relative error of the frequency' at screen 0.0193548,0.883503 left noenhanced front tc rgb '#202020'
set arrow from screen 0.18271,0.209184 to screen 0.231097,0.209184 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.206903,0.209184 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'classical' at screen 0.244,0.209184 left noenhanced front tc rgb '#202020'
set arrow from screen 0.18271,0.178571 to screen 0.231097,0.178571 nohead lw 1.7 dt (9,4) lc rgb '#c8500a'
set label '' at screen 0.206903,0.178571 point pt 5 ps 0.55 lc rgb '#c8500a'
set label 'corrected' at screen 0.244,0.178571 left noenhanced front tc rgb '#202020'
set arrow from screen 0.18271,0.147959 to screen 0.231097,0.147959 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.206903,0.147959 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'classical, extrapolated (Richardson)' at screen 0.244,0.147959 left noenhanced front tc rgb '#202020'
set arrow from screen 0.18271,0.117347 to screen 0.231097,0.117347 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.206903,0.117347 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'Hermite finite elements' at screen 0.244,0.117347 left noenhanced front tc rgb '#202020'
set arrow from screen 0.18271,0.0867347 to screen 0.231097,0.0867347 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.244,0.0867347 left noenhanced front tc rgb '#202020'
set label 'round-off of double: 2.2e-16, below all that is shown' at screen 0.244,0.0561224 left noenhanced front tc rgb '#202020'
set label '' at screen 0.206903,0.0255102 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.244,0.0255102 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 3.605442177e-01
set tmargin at screen 8.537414966e-01
set xrange [6.083502810e+00:1.009944466e+03]
set yrange [1.000000000e-10:1.000000000e+00]
set xtics ('' 7 1, '' 8 1, '' 9 1, '10' 10, '' 20 1, '30' 30, '' 40 1, '' 50 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '100' 100, '' 200 1, '300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000)
set ytics ('10^{-10}' 1e-10, '10^{-9}' 1e-09, '10^{-8}' 1e-08, '10^{-7}' 1e-07, '10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '10^{-3}' 0.001, '10^{-2}' 0.01, '0.1' 0.1, '1' 1)
set label 'unknowns of the division' at screen 0.304839,0.302721 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p0line0_0 << e
8.000000000e+00 7.485907680e-02
1.600000000e+01 2.030303341e-02
3.200000000e+01 5.102040014e-03
6.400000000e+01 1.276968647e-03
1.280000000e+02 3.193328172e-04
2.560000000e+02 7.983887072e-05
5.120000000e+02 1.996007187e-05
e
$p0points0 << e
8.000000000e+00 7.485907680e-02
1.600000000e+01 2.030303341e-02
3.200000000e+01 5.102040014e-03
6.400000000e+01 1.276968647e-03
1.280000000e+02 3.193328172e-04
2.560000000e+02 7.983887072e-05
5.120000000e+02 1.996007187e-05
e
$p0line1_0 << e
8.000000000e+00 5.997165380e-02
1.600000000e+01 4.394149970e-03
3.200000000e+01 4.646619649e-04
6.400000000e+01 5.484565073e-05
1.280000000e+02 6.686743711e-06
2.560000000e+02 8.258154254e-07
5.120000000e+02 1.026086284e-07
e
$p0points1 << e
8.000000000e+00 5.997165380e-02
1.600000000e+01 4.394149970e-03
3.200000000e+01 4.646619649e-04
6.400000000e+01 5.484565073e-05
1.280000000e+02 6.686743711e-06
2.560000000e+02 8.258154254e-07
5.120000000e+02 1.026086284e-07
e
$p0line2_0 << e
1.200000000e+01 2.654394481e-01
2.400000000e+01 2.117685610e-03
4.800000000e+01 3.504221601e-05
9.600000000e+01 1.944858463e-06
1.920000000e+02 1.208738909e-07
3.840000000e+02 7.555216008e-09
7.680000000e+02 4.722531255e-10
e
$p0points2 << e
1.200000000e+01 2.654394481e-01
2.400000000e+01 2.117685610e-03
4.800000000e+01 3.504221601e-05
9.600000000e+01 1.944858463e-06
1.920000000e+02 1.208738909e-07
3.840000000e+02 7.555216008e-09
7.680000000e+02 4.722531255e-10
e
$p0line3_0 << e
8.000000000e+00 7.742296259e-03
1.600000000e+01 6.082410487e-04
3.200000000e+01 3.975377736e-05
6.400000000e+01 2.511865749e-06
1.280000000e+02 1.574185653e-07
2.560000000e+02 9.845335436e-09
5.120000000e+02 6.154370347e-10
e
$p0points3 << e
8.000000000e+00 7.742296259e-03
1.600000000e+01 6.082410487e-04
3.200000000e+01 3.975377736e-05
6.400000000e+01 2.511865749e-06
1.280000000e+02 1.574185653e-07
2.560000000e+02 9.845335436e-09
5.120000000e+02 6.154370347e-10
e
set label 'default' at screen 0.120527,0.65389 left noenhanced front tc rgb '#202020'
set arrow from screen 0.19756,0.666645 to screen 0.233044,0.689366 nohead lw 0.6 lc rgb '#202020'
$p0default << e
3.200000000e+01 4.646619649e-04
e
set arrow from screen 0.273817,0.697946 to screen 0.34287,0.661034 nohead lw 1 lc rgb '#404040'
set label 'order 2' at screen 0.308899,0.710952 left noenhanced front tc rgb '#404040'
set arrow from screen 0.274814,0.630875 to screen 0.336439,0.581462 nohead lw 1 lc rgb '#404040'
set label 'order 3' at screen 0.323369,0.628416 left noenhanced front tc rgb '#404040'
set arrow from screen 0.276552,0.56381 to screen 0.330916,0.50569 nohead lw 1 lc rgb '#404040'
set label 'order 4' at screen 0.213799,0.519718 left noenhanced front tc rgb '#404040'
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p0points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 3.605442177e-01
set tmargin at screen 8.537414966e-01
set xrange [1.532084431e-05:1.267614173e-03]
set yrange [1.000000000e-10:1.000000000e+00]
set xtics ('' 2e-05 1, '30 µs' 3e-05, '' 4e-05 1, '' 5e-05 1, '' 6e-05 1, '' 7e-05 1, '' 8e-05 1, '' 9e-05 1, '100 µs' 0.0001, '' 0.0002 1, '300 µs' 0.0003, '' 0.0004 1, '' 0.0005 1, '' 0.0006 1, '' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001)
set ytics ('' 1e-10, '' 1e-09, '' 1e-08, '' 1e-07, '' 1e-06, '' 1e-05, '' 0.0001, '' 0.001, '' 0.01, '' 0.1, '' 1)
set label 'time per frequency from the beam' at screen 0.762903,0.302721 center noenhanced front tc rgb '#202020'
set label '(Hermite: sparse Cholesky and subspace' at screen 0.762903,0.277211 center noenhanced front tc rgb '#202020'
set label 'iteration)' at screen 0.762903,0.251701 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
$p1line0_0 << e
1.949548062e-05 7.485907680e-02
4.738421127e-05 2.030303341e-02
1.632227097e-04 5.102040014e-03
8.155886154e-04 1.276968647e-03
1.039230521e-04 3.193328172e-04
1.785211818e-04 7.983887072e-05
3.375349000e-04 1.996007187e-05
e
$p1spread0 << e
1.949548062e-05 7.485907680e-02 1.940961240e-05 1.958233527e-05
4.738421127e-05 2.030303341e-02 4.724221127e-05 4.766844131e-05
1.632227097e-04 5.102040014e-03 1.629485806e-04 1.640566935e-04
8.155886154e-04 1.276968647e-03 8.132651538e-04 8.212856154e-04
1.039230521e-04 3.193328172e-04 1.034986563e-04 1.042067083e-04
1.785211818e-04 7.983887072e-05 1.776460545e-04 1.808160909e-04
3.375349000e-04 1.996007187e-05 3.350715333e-04 3.386562333e-04
e
$p1points0 << e
1.949548062e-05 7.485907680e-02
4.738421127e-05 2.030303341e-02
1.632227097e-04 5.102040014e-03
8.155886154e-04 1.276968647e-03
1.039230521e-04 3.193328172e-04
1.785211818e-04 7.983887072e-05
3.375349000e-04 1.996007187e-05
e
$p1line1_0 << e
2.036594456e-05 5.997165380e-02
5.022238308e-05 4.394149970e-03
1.763954386e-04 4.646619649e-04
8.823567500e-04 5.484565073e-05
9.702224038e-05 6.686743711e-06
1.665793443e-04 8.258154254e-07
3.121381212e-04 1.026086284e-07
e
$p1spread1 << e
2.036594456e-05 5.997165380e-02 2.031883162e-05 2.052776797e-05
5.022238308e-05 4.394149970e-03 5.010554229e-05 5.036707960e-05
1.763954386e-04 4.646619649e-04 1.759292807e-04 1.769905263e-04
8.823567500e-04 5.484565073e-05 8.820061667e-04 8.928583333e-04
9.702224038e-05 6.686743711e-06 9.631184615e-05 9.794575000e-05
1.665793443e-04 8.258154254e-07 1.660770984e-04 1.677184262e-04
3.121381212e-04 1.026086284e-07 3.089554848e-04 3.125426970e-04
e
$p1points1 << e
2.036594456e-05 5.997165380e-02
5.022238308e-05 4.394149970e-03
1.763954386e-04 4.646619649e-04
8.823567500e-04 5.484565073e-05
9.702224038e-05 6.686743711e-06
1.665793443e-04 8.258154254e-07
3.121381212e-04 1.026086284e-07
e
$p1line2_0 << e
3.004099403e-05 2.654394481e-01
6.756345205e-05 2.117685610e-03
2.122157234e-04 3.504221601e-05
9.922919091e-04 1.944858463e-06
9.202583636e-04 1.208738909e-07
2.840646000e-04 7.555216008e-09
5.192366316e-04 4.722531255e-10
e
$p1spread2 << e
3.004099403e-05 2.654394481e-01 3.000739104e-05 3.024598806e-05
6.756345205e-05 2.117685610e-03 6.704562329e-05 6.771298630e-05
2.122157234e-04 3.504221601e-05 2.111419787e-04 2.131298511e-04
9.922919091e-04 1.944858463e-06 9.868500909e-04 1.000582545e-03
9.202583636e-04 1.208738909e-07 9.143240000e-04 9.280154545e-04
2.840646000e-04 7.555216008e-09 2.829183143e-04 2.843003714e-04
5.192366316e-04 4.722531255e-10 5.147894211e-04 5.217846316e-04
e
$p1points2 << e
3.004099403e-05 2.654394481e-01
6.756345205e-05 2.117685610e-03
2.122157234e-04 3.504221601e-05
9.922919091e-04 1.944858463e-06
9.202583636e-04 1.208738909e-07
2.840646000e-04 7.555216008e-09
5.192366316e-04 4.722531255e-10
e
$p1line3_0 << e
3.278868932e-05 7.742296259e-03
4.678742326e-05 6.082410487e-04
1.217173580e-04 3.975377736e-05
6.421656863e-05 2.511865749e-06
2.478349500e-04 1.574185653e-07
2.426341463e-04 9.845335436e-09
9.566902727e-04 6.154370347e-10
e
$p1spread3 << e
3.278868932e-05 7.742296259e-03 3.235418770e-05 3.290209385e-05
4.678742326e-05 6.082410487e-04 4.660059070e-05 4.690220000e-05
1.217173580e-04 3.975377736e-05 1.214808272e-04 1.225291975e-04
6.421656863e-05 2.511865749e-06 6.406509804e-05 6.452153595e-05
2.478349500e-04 1.574185653e-07 2.473697500e-04 2.488942750e-04
2.426341463e-04 9.845335436e-09 2.417774634e-04 2.437575122e-04
9.566902727e-04 6.154370347e-10 9.515225455e-04 9.606426364e-04
e
$p1points3 << e
3.278868932e-05 7.742296259e-03
4.678742326e-05 6.082410487e-04
1.217173580e-04 3.975377736e-05
6.421656863e-05 2.511865749e-06
2.478349500e-04 1.574185653e-07
2.426341463e-04 9.845335436e-09
9.566902727e-04 6.154370347e-10
e
set label 'default' at screen 0.746253,0.715726 left noenhanced front tc rgb '#202020'
$p1default << e
1.763954386e-04 4.646619649e-04
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.7 dt (9,4) lc rgb '#c8500a' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#c8500a' notitle, $p1points1 using 1:2 with points pt 5 ps 0.55 lc rgb '#c8500a' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points2 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1line3_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points3 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
