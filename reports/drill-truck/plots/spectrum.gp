# Redraw in the folder above: gnuplot plots/spectrum.gp; as PDF: gnuplot -e 'pdf = 1' plots/spectrum.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,3.6274 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'spectrum.pdf'
} else {
  set terminal svg size 620,346 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'spectrum.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set logscale x
set format x '10^{%T}'
set xtics 10
set mxtics 1
set lmargin at screen 9.032258065e-02
set rmargin at screen 9.677419355e-01
set bmargin at screen 1.271676301e-01
set tmargin at screen 8.497109827e-01
set xrange [1.000000000e+04:1.000000000e+08]
set yrange [0.000000000e+00:1.211572528e+01]
set ytics 2.000000000e+00
set label 'cycles in the wanted life with this range or a larger one' at screen 0.529032,0.0289017 center noenhanced front tc rgb '#202020'
set label 'no damage; s = 1.5+ m, fibre -z' at screen 0.0193548,0.947977 left noenhanced front tc rgb '#202020'
set label 'stress range [MPa]: share of the damage, loads as they are with partial factors' at screen 0.0193548,0.893064 left enhanced front tc rgb '#202020'
$stair << e
1.000000000e+04 1.053541329e+01
1.000000000e+05 1.053541329e+01
1.000000000e+05 9.362886785e+00
2.000000000e+05 9.362886785e+00
2.000000000e+05 9.072076985e+00
3.000000000e+05 9.072076985e+00
3.000000000e+05 8.413245118e+00
4.000000000e+05 8.413245118e+00
4.000000000e+05 7.485758715e+00
5.000000000e+05 7.485758715e+00
5.000000000e+05 7.461044619e+00
6.000000000e+05 7.461044619e+00
6.000000000e+05 7.365400010e+00
7.000000000e+05 7.365400010e+00
7.000000000e+05 7.299112842e+00
8.000000000e+05 7.299112842e+00
8.000000000e+05 7.255025886e+00
9.000000000e+05 7.255025886e+00
9.000000000e+05 7.153365219e+00
1.000000000e+06 7.153365219e+00
1.000000000e+06 6.584603175e+00
1.100000000e+06 6.584603175e+00
1.100000000e+06 6.214299303e+00
1.200000000e+06 6.214299303e+00
1.200000000e+06 6.080913278e+00
1.300000000e+06 6.080913278e+00
1.300000000e+06 5.892784678e+00
1.400000000e+06 5.892784678e+00
1.400000000e+06 5.812728459e+00
1.500000000e+06 5.812728459e+00
1.500000000e+06 5.710568356e+00
1.600000000e+06 5.710568356e+00
1.600000000e+06 5.469566204e+00
1.700000000e+06 5.469566204e+00
1.700000000e+06 5.386451998e+00
1.800000000e+06 5.386451998e+00
1.800000000e+06 5.378835374e+00
1.900000000e+06 5.378835374e+00
1.900000000e+06 5.376457950e+00
2.000000000e+06 5.376457950e+00
2.000000000e+06 5.329001079e+00
2.100000000e+06 5.329001079e+00
2.100000000e+06 3.734987602e+00
5.210000000e+07 3.734987602e+00
5.210000000e+07 2.630478414e+00
5.220000000e+07 2.630478414e+00
5.220000000e+07 2.496322027e+00
5.230000000e+07 2.496322027e+00
5.230000000e+07 2.481527429e+00
5.240000000e+07 2.481527429e+00
5.240000000e+07 2.403362208e+00
5.250000000e+07 2.403362208e+00
5.250000000e+07 2.346714149e+00
5.260000000e+07 2.346714149e+00
5.260000000e+07 2.109337267e+00
5.270000000e+07 2.109337267e+00
5.270000000e+07 2.102408760e+00
5.280000000e+07 2.102408760e+00
5.280000000e+07 2.014506739e+00
5.290000000e+07 2.014506739e+00
5.290000000e+07 1.936111507e+00
5.300000000e+07 1.936111507e+00
5.300000000e+07 1.894882501e+00
5.310000000e+07 1.894882501e+00
5.310000000e+07 1.786376126e+00
5.320000000e+07 1.786376126e+00
5.320000000e+07 1.777907144e+00
5.330000000e+07 1.777907144e+00
5.330000000e+07 1.660475804e+00
5.340000000e+07 1.660475804e+00
5.340000000e+07 1.521708614e+00
5.350000000e+07 1.521708614e+00
5.350000000e+07 1.444328695e+00
5.360000000e+07 1.444328695e+00
5.360000000e+07 1.365805349e+00
5.370000000e+07 1.365805349e+00
5.370000000e+07 1.359989628e+00
5.380000000e+07 1.359989628e+00
5.380000000e+07 1.222273924e+00
5.390000000e+07 1.222273924e+00
5.390000000e+07 6.545033319e-01
5.400000000e+07 6.545033319e-01
5.400000000e+07 5.812018414e-01
5.410000000e+07 5.812018414e-01
5.410000000e+07 2.010073097e-01
5.420000000e+07 2.010073097e-01
5.420000000e+07 1.648977562e-01
5.430000000e+07 1.648977562e-01
5.430000000e+07 4.335363438e-02
5.440000000e+07 4.335363438e-02
5.440000000e+07 4.100802870e-02
5.450000000e+07 4.100802870e-02
5.450000000e+07 1.569183494e-02
5.460000000e+07 1.569183494e-02
5.460000000e+07 0.000000000e+00
e
set label '10.5: no damage, start' at screen 0.317742,0.781012 left noenhanced front tc rgb '#c8500a'
set label '9.36: no damage, start' at screen 0.383774,0.711086 left noenhanced front tc rgb '#c8500a'
set label '9.07: no damage, start' at screen 0.165691,0.642652 left noenhanced front tc rgb '#c8500a'
set label '8.41: no damage, start' at screen 0.449807,0.654452 left noenhanced front tc rgb '#c8500a'
set label '7.49: no damage, start' at screen 0.471064,0.59914 left noenhanced front tc rgb '#c8500a'
set label '7.46: no damage, start' at screen 0.231724,0.546575 left noenhanced front tc rgb '#c8500a'
set label '7.37: no damage, start' at screen 0.268037,0.489827 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.495054,0.511503 to screen 0.495054,0.566417 nohead lw 0.6 lc rgb '#c8500a'
set label '7.30: no damage, start' at screen 0.255667,0.42229 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.496248,0.443966 to screen 0.507775,0.562464 nohead lw 0.6 lc rgb '#c8500a'
set label '7.26: no damage, start' at screen 0.54964,0.505678 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.54964,0.527354 to screen 0.518995,0.559834 nohead lw 0.6 lc rgb '#c8500a'
set label '7.15: no damage, start' at screen 0.546774,0.553772 left noenhanced front tc rgb '#c8500a'
set label '6.58: no damage, start' at screen 0.604241,0.420736 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.604241,0.442412 to screen 0.538112,0.519852 nohead lw 0.6 lc rgb '#c8500a'
set label '6.21: no damage, start' at screen 0.294294,0.357595 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.534874,0.379272 to screen 0.546401,0.497769 nohead lw 0.6 lc rgb '#c8500a'
set label '6.08: no damage, start' at screen 0.433736,0.309178 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.554026,0.330854 to screen 0.554026,0.489814 nohead lw 0.6 lc rgb '#c8500a'
set label '5.89: no damage, start' at screen 0.558927,0.373103 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.561086,0.39478 to screen 0.561086,0.478595 nohead lw 0.6 lc rgb '#c8500a'
set label '5.81: no damage, start' at screen 0.447368,0.235381 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.567659,0.257057 to screen 0.567659,0.47382 nohead lw 0.6 lc rgb '#c8500a'
set label '5.71: no damage, start' at screen 0.694775,0.299127 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.694775,0.320804 to screen 0.573807,0.467728 nohead lw 0.6 lc rgb '#c8500a'
set label '5.38: no damage, start' at screen 0.716032,0.616403 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.716032,0.594727 to screen 0.595065,0.447802 nohead lw 0.6 lc rgb '#c8500a'
set label '3.73: no damage, drilling' at screen 0.614096,0.169275 left noenhanced front tc rgb '#c8500a'
set arrow from screen 0.88216,0.190951 to screen 0.905629,0.34991 nohead lw 0.6 lc rgb '#c8500a'
set label '2.63: no damage, start' at screen 0.694762,0.247914 left noenhanced front tc rgb '#c8500a'
plot $stair using 1:2 with filledcurves y1=0 fc rgb '#e3eaf2' notitle, $stair using 1:2 with lines lw 1.8 dt 1 lc rgb '#0b5fa5' notitle
unset label
unset arrow
unset object
unset multiplot
