# Redraw in the folder above: gnuplot plots/peers-four-bars.gp; as PDF: gnuplot -e 'pdf = 1' plots/peers-four-bars.gp
if (!exists('pdf')) pdf = 0
if (pdf) {
  set terminal pdfcairo size 6.5000,7.8944 enhanced font 'Latin Modern Sans,7.5' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded
  set output 'peers-four-bars.pdf'
} else {
  set terminal svg size 620,753 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff' rounded
  set output 'peers-four-bars.svg'
}
set encoding utf8
set border 3 lc rgb '#606060'
set tics out nomirror scale 0.5
set xtics offset 0,0.4
set grid lc rgb '#e4e4e4' lw 0.7 lt 1
unset key
set multiplot
set label 'Three cranks through their singular position, in other programs' at screen 0.0193548,0.979416 left noenhanced front tc rgb '#202020'
set label 'on N-four-bar A02 of the IFToMM library, N = 2, 10 s, ten times through the flat position' at screen 0.0193548,0.956839 left noenhanced front tc rgb '#5d6b79'
set label 'reference: elliptic functions, 30 digits' at screen 0.0193548,0.936919 left noenhanced front tc rgb '#5d6b79'
set label 'distance from the exact place after 10 s / 1 m' at screen 0.0193548,0.909031 left noenhanced front tc rgb '#202020'
set label 'failed: Simbody, Runge-Kutta-Merson, accuracy 1e-09: Simbody: Integrator step failed at' at screen 0.0193548,0.254316 left noenhanced front tc rgb '#5d6b79'
set label 'time 6.5692102133341432 apparently because: SimTK Ex...' at screen 0.0193548,0.234396 left noenhanced front tc rgb '#5d6b79'
set label 'failed: Simbody, Runge-Kutta-Merson, accuracy 1e-12: Simbody: Integrator step failed at' at screen 0.0193548,0.214475 left noenhanced front tc rgb '#5d6b79'
set label 'time 8.8453376696453798 apparently because: SimTK Ex...' at screen 0.0193548,0.194555 left noenhanced front tc rgb '#5d6b79'
set label 'failed: scipy DOP853, 15 coordinates, index 1, not projected, rtol 1e-04, rtol 1e-06:' at screen 0.0193548,0.174635 left noenhanced front tc rgb '#5d6b79'
set label 'Required step size is less than spacing between numbers.' at screen 0.0193548,0.154714 left noenhanced front tc rgb '#5d6b79'
set label 'failed: scipy DOP853, 15 coordinates, index 1, not projected, rtol 1e-09, rtol 1e-10: not' at screen 0.0193548,0.134794 left noenhanced front tc rgb '#5d6b79'
set label 'at the end after 30000 evaluations, at 1.228 s' at screen 0.0193548,0.114874 left noenhanced front tc rgb '#5d6b79'
set label 'failed: scipy DOP853, 15 coordinates, index 1, not projected, rtol 1e-11, rtol 1e-12: not' at screen 0.0193548,0.0949535 left noenhanced front tc rgb '#5d6b79'
set label 'at the end after 30000 evaluations, at 0.714 s' at screen 0.0193548,0.0750332 left noenhanced front tc rgb '#5d6b79'
set label 'failed: scipy Radau, 15 coordinates, index 1, not projected, rtol 1e-05: not at the end' at screen 0.0193548,0.0551129 left noenhanced front tc rgb '#5d6b79'
set label 'after 30000 evaluations, at 8.228 s' at screen 0.0193548,0.0351926 left noenhanced front tc rgb '#5d6b79'
set label 'and 2 more, which the data tell' at screen 0.0193548,0.0152722 left noenhanced front tc rgb '#5d6b79'
set arrow from screen 0.185516,0.422311 to screen 0.233903,0.422311 nohead lw 1.7 dt 1 lc rgb '#0b5fa5'
set label '' at screen 0.20971,0.422311 point pt 7 ps 0.55 lc rgb '#0b5fa5'
set label 'boxbeam' at screen 0.246806,0.422311 left noenhanced front tc rgb '#202020'
set arrow from screen 0.185516,0.398406 to screen 0.233903,0.398406 nohead lw 1.1 dt 1 lc rgb '#5a6670'
set label '' at screen 0.20971,0.398406 point pt 6 ps 0.55 lw 1 lc rgb '#5a6670'
set label 'Simbody, Runge-Kutta-Merson' at screen 0.246806,0.398406 left noenhanced front tc rgb '#202020'
set arrow from screen 0.185516,0.374502 to screen 0.233903,0.374502 nohead lw 1.1 dt (9,4) lc rgb '#857650'
set label '' at screen 0.20971,0.374502 point pt 4 ps 0.55 lw 1 lc rgb '#857650'
set label 'scipy DOP853, one angle, by hand' at screen 0.246806,0.374502 left noenhanced front tc rgb '#202020'
set arrow from screen 0.185516,0.350598 to screen 0.233903,0.350598 nohead lw 1.1 dt (3,3) lc rgb '#7a6a8c'
set label '' at screen 0.20971,0.350598 point pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c'
set label 'scipy DOP853, 15 coordinates, index 1, not projected' at screen 0.246806,0.350598 left noenhanced front tc rgb '#202020'
set arrow from screen 0.185516,0.326693 to screen 0.233903,0.326693 nohead lw 1.1 dt (9,3,2,3) lc rgb '#4a716a'
set label '' at screen 0.20971,0.326693 point pt 12 ps 0.55 lw 1 lc rgb '#4a716a'
set label 'scipy Radau, 15 coordinates, index 1, not projected' at screen 0.246806,0.326693 left noenhanced front tc rgb '#202020'
set arrow from screen 0.185516,0.302789 to screen 0.233903,0.302789 nohead lw 9 lc rgb '#dcebd3'
set label 'good enough for a strength check' at screen 0.246806,0.302789 left noenhanced front tc rgb '#202020'
set label '' at screen 0.20971,0.278884 point pt 6 ps 1.5 lw 1.6 lc rgb '#202020'
set label 'default of the program' at screen 0.246806,0.278884 left noenhanced front tc rgb '#202020'
set logscale xy
set errorbars 0.35
set lmargin at screen 1.000000000e-01
set rmargin at screen 5.096774194e-01
set bmargin at screen 5.006640106e-01
set tmargin at screen 8.857901726e-01
set xrange [2.983279681e+02:6.479734408e+04]
set yrange [1.000000000e-12:2.450828811e+02]
set xtics ('300' 300, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '1000' 1000, '' 2000 1, '3000' 3000, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '10^{4}' 10000, '' 20000 1, '3·10^{4}' 30000, '' 40000 1, '' 50000 1, '' 60000 1)
set ytics ('10^{-12}' 1e-12, '10^{-10}' 1e-10, '10^{-8}' 1e-08, '10^{-6}' 1e-06, '10^{-4}' 0.0001, '10^{-2}' 0.01, '1' 1, 'failed' 49.5058462)
set label 'evaluations of the accelerations' at screen 0.304839,0.455511 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.1,0.848606 to screen 0.509677,0.848606 nohead lw 0.8 lc rgb '#606060'
$p0line0_0 << e
9.920000000e+02 1.111654862e-02
5.840000000e+02 1.360129257e-02
7.530000000e+02 1.602586858e-03
1.884000000e+03 1.451025357e-04
2.157000000e+03 2.092111429e-05
3.275000000e+03 1.415266110e-06
3.977000000e+03 1.156348029e-07
4.549000000e+03 1.432337468e-08
4.653000000e+03 1.490846036e-08
6.187000000e+03 6.841967261e-11
6.434000000e+03 1.093170826e-08
e
$p0points0 << e
9.920000000e+02 1.111654862e-02
5.840000000e+02 1.360129257e-02
7.530000000e+02 1.602586858e-03
1.884000000e+03 1.451025357e-04
2.157000000e+03 2.092111429e-05
3.275000000e+03 1.415266110e-06
3.977000000e+03 1.156348029e-07
4.549000000e+03 1.432337468e-08
4.653000000e+03 1.490846036e-08
6.187000000e+03 6.841967261e-11
6.434000000e+03 1.093170826e-08
e
$p0line1_0 << e
3.411000000e+03 9.799933948e-01
4.408000000e+03 1.157646254e+00
9.223000000e+03 3.918982589e-01
1.042800000e+04 1.158914721e+00
2.131500000e+04 1.968677664e+00
2.143700000e+04 1.158924004e+00
e
$p0line1_1 << e
3.455900000e+04 1.158918143e+00
4.857000000e+04 1.983571009e+00
e
$p0points1 << e
3.411000000e+03 9.799933948e-01
4.408000000e+03 1.157646254e+00
9.223000000e+03 3.918982589e-01
1.042800000e+04 1.158914721e+00
2.131500000e+04 1.968677664e+00
2.143700000e+04 1.158924004e+00
3.455900000e+04 1.158918143e+00
4.857000000e+04 1.983571009e+00
e
$p0failed1 << e
2.143700000e+04 4.950584623e+01
4.857000000e+04 4.950584623e+01
e
$p0line2_0 << e
3.980000000e+02 6.231444763e-02
4.580000000e+02 1.356254015e-01
5.300000000e+02 1.327374595e-03
7.940000000e+02 6.353534504e-05
9.380000000e+02 7.172939306e-06
1.310000000e+03 5.723251312e-07
1.670000000e+03 8.524681040e-08
2.102000000e+03 5.401460524e-09
2.774000000e+03 6.913686743e-10
3.386000000e+03 8.315825829e-11
4.358000000e+03 6.849541811e-12
e
$p0points2 << e
3.980000000e+02 6.231444763e-02
4.580000000e+02 1.356254015e-01
5.300000000e+02 1.327374595e-03
7.940000000e+02 6.353534504e-05
9.380000000e+02 7.172939306e-06
1.310000000e+03 5.723251312e-07
1.670000000e+03 8.524681040e-08
2.102000000e+03 5.401460524e-09
2.774000000e+03 6.913686743e-10
3.386000000e+03 8.315825829e-11
4.358000000e+03 6.849541811e-12
e
$p0line3_2 << e
1.873400000e+04 1.158944101e+00
2.071400000e+04 4.718904066e-01
e
$p0points3 << e
4.070000000e+03 1.172695360e+00
7.538000000e+03 1.158920119e+00
1.873400000e+04 1.158944101e+00
2.071400000e+04 4.718904066e-01
e
$p0failed3 << e
4.070000000e+03 4.950584623e+01
7.538000000e+03 4.950584623e+01
2.071400000e+04 4.950584623e+01
2.071400000e+04 4.950584623e+01
2.071400000e+04 4.950584623e+01
2.071400000e+04 4.950584623e+01
e
$p0line4_0 << e
1.215900000e+04 1.150531701e+00
1.513900000e+04 1.817927912e+00
e
$p0points4 << e
1.215900000e+04 1.150531701e+00
1.513900000e+04 1.817927912e+00
e
$p0failed4 << e
1.513900000e+04 4.950584623e+01
1.513900000e+04 4.950584623e+01
1.513900000e+04 4.950584623e+01
e
set label 'default' at screen 0.322056,0.62692 left noenhanced front tc rgb '#202020'
$p0default << e
4.653000000e+03 1.490846036e-08
e
plot $p0line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p0points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p0line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0line1_1 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p0points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p0failed1 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p0line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p0points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p0line3_2 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p0points3 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p0failed3 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#7a6a8c' notitle, $p0line4_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p0points4 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p0failed4 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#4a716a' notitle, $p0default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
set lmargin at screen 5.580645161e-01
set rmargin at screen 9.677419355e-01
set bmargin at screen 5.006640106e-01
set tmargin at screen 8.857901726e-01
set xrange [6.229424764e-04:2.165709300e+00]
set yrange [1.000000000e-12:2.450828811e+02]
set xtics ('' 0.0007 1, '' 0.0008 1, '' 0.0009 1, '1 ms' 0.001, '' 0.002 1, '' 0.003 1, '' 0.004 1, '' 0.005 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '10 ms' 0.01, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '100 ms' 0.1, '' 0.2 1, '' 0.3 1, '' 0.4 1, '' 0.5 1, '' 0.6 1, '' 0.7 1, '' 0.8 1, '' 0.9 1, '1 s' 1, '' 2 1)
set ytics ('' 1e-12, '' 1e-10, '' 1e-08, '' 1e-06, '' 0.0001, '' 0.01, '' 1)
set label 'time per run of 10 s' at screen 0.762903,0.455511 center noenhanced front tc rgb '#202020'
set object rectangle from graph 0, first 0.0001 to graph 1, first 0.001 behind fs solid noborder fc rgb '#dcebd3'
set arrow from screen 0.558065,0.848606 to screen 0.967742,0.848606 nohead lw 0.8 lc rgb '#606060'
$p1line0_0 << e
2.611285500e-03 1.111654862e-02
9.740477059e-04 1.360129257e-02
1.504983182e-03 1.602586858e-03
3.039216167e-03 1.451025357e-04
3.534166000e-03 2.092111429e-05
4.182797500e-03 1.415266110e-06
5.305662667e-03 1.156348029e-07
6.611787500e-03 1.432337468e-08
6.315217667e-03 1.490846036e-08
6.232774000e-03 6.841967261e-11
5.755958333e-03 1.093170826e-08
e
$p1spread0 << e
2.611285500e-03 1.111654862e-02 2.575328500e-03 2.635470333e-03
9.740477059e-04 1.360129257e-02 9.641675882e-04 1.058790765e-03
1.504983182e-03 1.602586858e-03 1.495050091e-03 1.520223273e-03
3.039216167e-03 1.451025357e-04 3.009960500e-03 3.084519167e-03
3.534166000e-03 2.092111429e-05 3.486542400e-03 3.589633200e-03
4.182797500e-03 1.415266110e-06 4.118328000e-03 4.222449500e-03
5.305662667e-03 1.156348029e-07 5.265529000e-03 5.630256333e-03
6.611787500e-03 1.432337468e-08 6.513805500e-03 8.061393500e-03
6.315217667e-03 1.490846036e-08 6.152623667e-03 6.410661000e-03
6.232774000e-03 6.841967261e-11 6.105686667e-03 7.558520333e-03
5.755958333e-03 1.093170826e-08 5.621720333e-03 5.975795000e-03
e
$p1points0 << e
2.611285500e-03 1.111654862e-02
9.740477059e-04 1.360129257e-02
1.504983182e-03 1.602586858e-03
3.039216167e-03 1.451025357e-04
3.534166000e-03 2.092111429e-05
4.182797500e-03 1.415266110e-06
5.305662667e-03 1.156348029e-07
6.611787500e-03 1.432337468e-08
6.315217667e-03 1.490846036e-08
6.232774000e-03 6.841967261e-11
5.755958333e-03 1.093170826e-08
e
$p1line1_0 << e
9.856351000e-02 9.799933948e-01
1.267594480e-01 1.157646254e+00
2.631117430e-01 3.918982589e-01
2.963501510e-01 1.158914721e+00
6.041276670e-01 1.968677664e+00
6.085034320e-01 1.158924004e+00
e
$p1line1_1 << e
9.854346800e-01 1.158918143e+00
1.379044006e+00 1.983571009e+00
e
$p1spread1 << e
9.856351000e-02 9.799933948e-01 9.675974400e-02 9.974260100e-02
1.267594480e-01 1.157646254e+00 1.245927060e-01 1.282665890e-01
2.631117430e-01 3.918982589e-01 2.588457390e-01 2.716102170e-01
2.963501510e-01 1.158914721e+00 2.942996460e-01 3.023420660e-01
6.041276670e-01 1.968677664e+00 5.963816610e-01 6.104442640e-01
6.085034320e-01 1.158924004e+00 6.005586730e-01 6.132712890e-01
9.854346800e-01 1.158918143e+00 9.806262270e-01 1.003127195e+00
1.379044006e+00 1.983571009e+00 1.365741643e+00 1.399250847e+00
e
$p1points1 << e
9.856351000e-02 9.799933948e-01
1.267594480e-01 1.157646254e+00
2.631117430e-01 3.918982589e-01
2.963501510e-01 1.158914721e+00
6.041276670e-01 1.968677664e+00
6.085034320e-01 1.158924004e+00
9.854346800e-01 1.158918143e+00
1.379044006e+00 1.983571009e+00
e
$p1failed1 << e
6.085034320e-01 4.950584623e+01
1.379044006e+00 4.950584623e+01
e
$p1line2_0 << e
1.585373300e-03 6.231444763e-02
1.822522077e-03 1.356254015e-01
2.134138273e-03 1.327374595e-03
3.185432000e-03 6.353534504e-05
3.754664833e-03 7.172939306e-06
5.220434500e-03 5.723251312e-07
6.692474000e-03 8.524681040e-08
8.362800250e-03 5.401460524e-09
1.104353900e-02 6.913686743e-10
1.359132800e-02 8.315825829e-11
1.749800550e-02 6.849541811e-12
e
$p1spread2 << e
1.585373300e-03 6.231444763e-02 1.577475591e-03 1.639840091e-03
1.822522077e-03 1.356254015e-01 1.788031923e-03 1.859509923e-03
2.134138273e-03 1.327374595e-03 2.071117364e-03 2.144631273e-03
3.185432000e-03 6.353534504e-05 3.077678857e-03 3.208337857e-03
3.754664833e-03 7.172939306e-06 3.635027000e-03 3.774855333e-03
5.220434500e-03 5.723251312e-07 5.059665750e-03 5.389158000e-03
6.692474000e-03 8.524681040e-08 6.538820000e-03 6.824649000e-03
8.362800250e-03 5.401460524e-09 8.289826250e-03 8.462385000e-03
1.104353900e-02 6.913686743e-10 1.091690400e-02 1.134588050e-02
1.359132800e-02 8.315825829e-11 1.326933400e-02 1.394313050e-02
1.749800550e-02 6.849541811e-12 1.713543150e-02 1.794958800e-02
e
$p1points2 << e
1.585373300e-03 6.231444763e-02
1.822522077e-03 1.356254015e-01
2.134138273e-03 1.327374595e-03
3.185432000e-03 6.353534504e-05
3.754664833e-03 7.172939306e-06
5.220434500e-03 5.723251312e-07
6.692474000e-03 8.524681040e-08
8.362800250e-03 5.401460524e-09
1.104353900e-02 6.913686743e-10
1.359132800e-02 8.315825829e-11
1.749800550e-02 6.849541811e-12
e
$p1line3_2 << e
5.767112540e-01 1.158944101e+00
6.418171760e-01 4.718904066e-01
e
$p1spread3 << e
1.260705720e-01 1.172695360e+00 1.240026990e-01 1.279722570e-01
2.331467190e-01 1.158920119e+00 2.291463460e-01 2.358090250e-01
5.767112540e-01 1.158944101e+00 5.687205890e-01 5.842872420e-01
6.418171760e-01 4.718904066e-01 6.313547170e-01 6.587764620e-01
e
$p1points3 << e
1.260705720e-01 1.172695360e+00
2.331467190e-01 1.158920119e+00
5.767112540e-01 1.158944101e+00
6.418171760e-01 4.718904066e-01
e
$p1failed3 << e
1.260705720e-01 4.950584623e+01
2.331467190e-01 4.950584623e+01
6.418171760e-01 4.950584623e+01
6.418171760e-01 4.950584623e+01
6.418171760e-01 4.950584623e+01
6.418171760e-01 4.950584623e+01
e
$p1line4_0 << e
4.389298180e-01 1.150531701e+00
5.493905510e-01 1.817927912e+00
e
$p1spread4 << e
4.389298180e-01 1.150531701e+00 4.280877710e-01 4.477615570e-01
5.493905510e-01 1.817927912e+00 5.428860270e-01 5.647386370e-01
e
$p1points4 << e
4.389298180e-01 1.150531701e+00
5.493905510e-01 1.817927912e+00
e
$p1failed4 << e
5.493905510e-01 4.950584623e+01
5.493905510e-01 4.950584623e+01
5.493905510e-01 4.950584623e+01
e
set label 'default' at screen 0.687345,0.62692 left noenhanced front tc rgb '#202020'
$p1default << e
6.315217667e-03 1.490846036e-08
e
plot $p1line0_0 using 1:2 with lines lw 1.7 dt 1 lc rgb '#0b5fa5' notitle, $p1spread0 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#0b5fa5' notitle, $p1points0 using 1:2 with points pt 7 ps 0.55 lc rgb '#0b5fa5' notitle, $p1line1_0 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1line1_1 using 1:2 with lines lw 1.1 dt 1 lc rgb '#5a6670' notitle, $p1spread1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#5a6670' notitle, $p1points1 using 1:2 with points pt 6 ps 0.55 lw 1 lc rgb '#5a6670' notitle, $p1failed1 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#5a6670' notitle, $p1line2_0 using 1:2 with lines lw 1.1 dt (9,4) lc rgb '#857650' notitle, $p1spread2 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#857650' notitle, $p1points2 using 1:2 with points pt 4 ps 0.55 lw 1 lc rgb '#857650' notitle, $p1line3_2 using 1:2 with lines lw 1.1 dt (3,3) lc rgb '#7a6a8c' notitle, $p1spread3 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#7a6a8c' notitle, $p1points3 using 1:2 with points pt 8 ps 0.55 lw 1 lc rgb '#7a6a8c' notitle, $p1failed3 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#7a6a8c' notitle, $p1line4_0 using 1:2 with lines lw 1.1 dt (9,3,2,3) lc rgb '#4a716a' notitle, $p1spread4 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 0.7 lc rgb '#4a716a' notitle, $p1points4 using 1:2 with points pt 12 ps 0.55 lw 1 lc rgb '#4a716a' notitle, $p1failed4 using 1:2 with points pt 2 ps 0.7 lw 1.8 lc rgb '#4a716a' notitle, $p1default using 1:2 with points pt 6 ps 1.5 lw 1.6 lc rgb '#202020' notitle
unset label
unset arrow
unset object
unset multiplot
