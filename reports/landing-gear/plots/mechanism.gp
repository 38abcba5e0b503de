# Redraw with: gnuplot mechanism.gp
set terminal svg size 1120,875 dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'
set output 'mechanism.svg'
set encoding utf8
set border 3 lc rgb '#505050'
set tics out nomirror
set grid lc rgb '#e2e2e2' lw 0.7 lt 1
set key noenhanced samplen 2.5 spacing 1.2
set multiplot layout 2,3 margins 0.068,0.985,7.085714286e-02,9.028571429e-01 spacing 0.065,1.005714286e-01 title 'Bodies from the beam''s joint on at the critical instants; forces on the beam, the longest arrow of each row its largest; grey: t = 0.0000 s' noenhanced
set size ratio -1
unset key
set xtics autofreq
$rest1_02_guides << e
0.000000000e+00 -1.461777269e-02 0.000000000e+00 2.923554537e-02
-8.855947866e-01 -8.157555588e-01 2.697265243e-01 -1.134688277e-01
e
$rest1_02_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 -1.008105478e+00
e
$rest1_02_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 -1.008105478e+00
e
$rest1_02_1_lines << e
-4.283601765e-01 -1.008105478e+00 -3.223713479e-01 1.356155054e-01
-4.283601765e-01 -1.008105478e+00 -4.508794009e-01 -1.668161380e-01
e
$rest1_02_1 << e
-4.283601765e-01 -1.008105478e+00
-7.507315244e-01 -8.724899726e-01
-8.792395774e-01 -1.174921616e+00
e
$rest1_02_2 << e
-7.507315244e-01 -8.724899726e-01
e
$rest1_02_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_02_guides << e
0.000000000e+00 -1.461777269e-02 0.000000000e+00 2.923554537e-02
-8.855947866e-01 -8.157555588e-01 2.697265243e-01 -1.134688277e-01
e
$at1_02_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 -1.008105478e+00
e
$at1_02_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 -1.008105478e+00
e
$at1_02_1_lines << e
-4.283601765e-01 -1.008105478e+00 -3.223713479e-01 1.356155054e-01
-4.283601765e-01 -1.008105478e+00 -4.508794009e-01 -1.668161380e-01
e
$at1_02_1 << e
-4.283601765e-01 -1.008105478e+00
-7.507315244e-01 -8.724899726e-01
-8.792395774e-01 -1.174921616e+00
e
$at1_02_2 << e
-7.507315244e-01 -8.724899726e-01
e
$at1_02_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.037247449e-03,-3.343713886e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.037247449e-03,-3.343713886e-01 center offset 9.926614475e-03,-8.999956697e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -4.286584943e-01,-7.811184947e-01 to -4.283601765e-01,-1.008105478e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at -4.286584943e-01,-7.811184947e-01 center offset -4.205598650e-03,8.999992227e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-1.659445264e+00:4.392649228e-01]
set yrange [-1.636815901e+00:4.618942853e-01]
set label 1000 't = 0.0000 s   most negative M_z   hinge 1.366 kN, foot 0.8688 kN' at graph 0,1.13 left noenhanced
set title 'seen along y' offset 0,-0.6
plot $rest1_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest1_12_guides << e
-1.456901426e-01 -1.461777269e-02 2.913802852e-01 2.923554537e-02
8.184856650e-02 -8.157555588e-01 1.138485761e-02 -1.134688277e-01
e
$rest1_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.011479326e-01 -1.008105478e+00
e
$rest1_12_0 << e
0.000000000e+00 0.000000000e+00
1.011479326e-01 -1.008105478e+00
e
$rest1_12_1_lines << e
1.011479326e-01 -1.008105478e+00 -1.360693727e-02 1.356155054e-01
1.011479326e-01 -1.008105478e+00 1.673744250e-02 -1.668161380e-01
e
$rest1_12_1 << e
1.011479326e-01 -1.008105478e+00
8.754099530e-02 -8.724899726e-01
1.178853751e-01 -1.174921616e+00
e
$rest1_12_2 << e
8.754099530e-02 -8.724899726e-01
e
$rest1_12_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_12_guides << e
-1.456901426e-01 -1.461777269e-02 2.913802852e-01 2.923554537e-02
8.184856650e-02 -8.157555588e-01 1.138485761e-02 -1.134688277e-01
e
$at1_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.011479326e-01 -1.008105478e+00
e
$at1_12_0 << e
0.000000000e+00 0.000000000e+00
1.011479326e-01 -1.008105478e+00
e
$at1_12_1_lines << e
1.011479326e-01 -1.008105478e+00 -1.360693727e-02 1.356155054e-01
1.011479326e-01 -1.008105478e+00 1.673744250e-02 -1.668161380e-01
e
$at1_12_1 << e
1.011479326e-01 -1.008105478e+00
8.754099530e-02 -8.724899726e-01
1.178853751e-01 -1.174921616e+00
e
$at1_12_2 << e
8.754099530e-02 -8.724899726e-01
e
$at1_12_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -1.489641045e-01,-3.343713886e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -1.489641045e-01,-3.343713886e-01 center offset -1.302231132e+00,-8.221065028e-01 tc rgb '#202020' front noenhanced
set arrow 2 from 1.527694651e-01,-7.811184947e-01 to 1.011479326e-01,-1.008105478e+00 lw 2 lc rgb '#202020' front
set label 2 'foot' at 1.527694651e-01,-7.811184947e-01 center offset 7.096264898e-01,8.775915027e-01 tc rgb '#202020' front noenhanced
set xlabel 'y [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-9.904124058e-01:1.108297781e+00]
set yrange [-1.636815901e+00:4.618942853e-01]
set title 'seen along x' offset 0,-0.6
plot $rest1_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest1_01_guides << e
0.000000000e+00 -1.456901426e-01 0.000000000e+00 2.913802852e-01
-8.855947866e-01 8.184856650e-02 2.697265243e-01 1.138485761e-02
e
$rest1_01_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 1.011479326e-01
e
$rest1_01_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 1.011479326e-01
e
$rest1_01_1_lines << e
-4.283601765e-01 1.011479326e-01 -3.223713479e-01 -1.360693727e-02
-4.283601765e-01 1.011479326e-01 -4.508794009e-01 1.673744250e-02
e
$rest1_01_1 << e
-4.283601765e-01 1.011479326e-01
-7.507315244e-01 8.754099530e-02
-8.792395774e-01 1.178853751e-01
e
$rest1_01_2 << e
-7.507315244e-01 8.754099530e-02
e
$rest1_01_grounds << e
0.000000000e+00 0.000000000e+00
e
$at1_01_guides << e
0.000000000e+00 -1.456901426e-01 0.000000000e+00 2.913802852e-01
-8.855947866e-01 8.184856650e-02 2.697265243e-01 1.138485761e-02
e
$at1_01_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 1.011479326e-01
e
$at1_01_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 1.011479326e-01
e
$at1_01_1_lines << e
-4.283601765e-01 1.011479326e-01 -3.223713479e-01 -1.360693727e-02
-4.283601765e-01 1.011479326e-01 -4.508794009e-01 1.673744250e-02
e
$at1_01_1 << e
-4.283601765e-01 1.011479326e-01
-7.507315244e-01 8.754099530e-02
-8.792395774e-01 1.178853751e-01
e
$at1_01_2 << e
-7.507315244e-01 8.754099530e-02
e
$at1_01_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from 1.037247449e-03,-1.489641045e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at 1.037247449e-03,-1.489641045e-01 center offset 2.228128304e-02,-8.999781828e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -4.286584943e-01,1.527694651e-01 to -4.283601765e-01,1.011479326e-01 lw 2 lc rgb '#202020' front
set label 2 'foot' at -4.286584943e-01,1.527694651e-01 center offset -1.849230328e-02,8.999849721e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'y [m]' offset 0.8,0
set xrange [-1.659445264e+00:4.392649228e-01]
set yrange [-9.904124058e-01:1.108297781e+00]
set title 'seen along z' offset 0,-0.6
plot $rest1_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest1_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest1_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest1_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest1_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest1_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest1_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at1_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#1f5fa8', $at1_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#1f5fa8', $at1_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#1f5fa8', $at1_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#1f5fa8', $at1_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#1f5fa8', $at1_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#1f5fa8', $at1_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_02_guides << e
0.000000000e+00 -1.461777269e-02 0.000000000e+00 2.923554537e-02
-8.855947866e-01 -8.157555588e-01 2.697265243e-01 -1.134688277e-01
e
$rest2_02_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 -1.008105478e+00
e
$rest2_02_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 -1.008105478e+00
e
$rest2_02_1_lines << e
-4.283601765e-01 -1.008105478e+00 -3.223713479e-01 1.356155054e-01
-4.283601765e-01 -1.008105478e+00 -4.508794009e-01 -1.668161380e-01
e
$rest2_02_1 << e
-4.283601765e-01 -1.008105478e+00
-7.507315244e-01 -8.724899726e-01
-8.792395774e-01 -1.174921616e+00
e
$rest2_02_2 << e
-7.507315244e-01 -8.724899726e-01
e
$rest2_02_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_02_guides << e
4.026087626e-03 -1.461224569e-02 -8.052175252e-03 2.922449138e-02
-1.106692454e+00 -4.809929124e-01 2.166665788e-01 -1.953406621e-01
e
$at2_02_0_axis << e
0.000000000e+00 0.000000000e+00 -7.394039233e-01 -8.121302068e-01
e
$at2_02_0 << e
0.000000000e+00 0.000000000e+00
-7.394039233e-01 -8.121302068e-01
e
$at2_02_1_lines << e
-7.394039233e-01 -8.121302068e-01 -2.589552408e-01 2.334669633e-01
-7.394039233e-01 -8.121302068e-01 -4.807764178e-01 -1.017209872e-02
e
$at2_02_1 << e
-7.394039233e-01 -8.121302068e-01
-9.983591641e-01 -5.786632435e-01
-1.220180341e+00 -8.223023055e-01
e
$at2_02_2 << e
-9.983591641e-01 -5.786632435e-01
e
$at2_02_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -8.399698571e-03,-3.348612291e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -8.399698571e-03,-3.348612291e-01 center offset -8.024393619e-02,-8.997169877e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -7.317325838e-01,-5.847310965e-01 to -7.394039233e-01,-8.121302068e-01 lw 2 lc rgb '#202020' front
set label 2 'foot' at -7.317325838e-01,-5.847310965e-01 center offset 1.078910531e-01,8.994883100e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-1.659445264e+00:4.392649228e-01]
set yrange [-1.636815901e+00:4.618942853e-01]
set label 1000 't = 0.5000 s   least negative M_y, least negative M_z, most negative M_y, most negative stress   hinge 1.376 kN, foot 0.8767 kN' at graph 0,1.13 left noenhanced
set title 'seen along y' offset 0,-0.6
plot $rest2_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_02_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_02_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_02_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_02_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_02_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_02_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_02_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_12_guides << e
-1.456901426e-01 -1.461777269e-02 2.913802852e-01 2.923554537e-02
8.184856650e-02 -8.157555588e-01 1.138485761e-02 -1.134688277e-01
e
$rest2_12_0_axis << e
0.000000000e+00 0.000000000e+00 1.011479326e-01 -1.008105478e+00
e
$rest2_12_0 << e
0.000000000e+00 0.000000000e+00
1.011479326e-01 -1.008105478e+00
e
$rest2_12_1_lines << e
1.011479326e-01 -1.008105478e+00 -1.360693727e-02 1.356155054e-01
1.011479326e-01 -1.008105478e+00 1.673744250e-02 -1.668161380e-01
e
$rest2_12_1 << e
1.011479326e-01 -1.008105478e+00
8.754099530e-02 -8.724899726e-01
1.178853751e-01 -1.174921616e+00
e
$rest2_12_2 << e
8.754099530e-02 -8.724899726e-01
e
$rest2_12_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_12_guides << e
-1.456350570e-01 -1.461224569e-02 2.912701140e-01 2.922449138e-02
1.766570406e-02 -4.809929124e-01 2.558919848e-02 -1.953406621e-01
e
$at2_12_0_axis << e
0.000000000e+00 0.000000000e+00 6.104396365e-02 -8.121302068e-01
e
$at2_12_0 << e
0.000000000e+00 0.000000000e+00
6.104396365e-02 -8.121302068e-01
e
$at2_12_1_lines << e
6.104396365e-02 -8.121302068e-01 -3.058366035e-02 2.334669633e-01
6.104396365e-02 -8.121302068e-01 -1.227047126e-02 -1.017209872e-02
e
$at2_12_1 << e
6.104396365e-02 -8.121302068e-01
3.046030330e-02 -5.786632435e-01
4.877349240e-02 -8.223023055e-01
e
$at2_12_2 << e
3.046030330e-02 -5.786632435e-01
e
$at2_12_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -1.476245514e-01,-3.348612291e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -1.476245514e-01,-3.348612291e-01 center offset -1.290855588e+00,-8.235243905e-01 tc rgb '#202020' front noenhanced
set arrow 2 from 1.121740258e-01,-5.847310965e-01 to 6.104396365e-02,-8.121302068e-01 lw 2 lc rgb '#202020' front
set label 2 'foot' at 1.121740258e-01,-5.847310965e-01 center offset 7.019850709e-01,8.780774975e-01 tc rgb '#202020' front noenhanced
set xlabel 'y [m]' offset 0,0.4
set ylabel 'z [m]' offset 0.8,0
set xrange [-9.904124058e-01:1.108297781e+00]
set yrange [-1.636815901e+00:4.618942853e-01]
set title 'seen along x' offset 0,-0.6
plot $rest2_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_12_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_12_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_12_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_12_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_12_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_12_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_12_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
$rest2_01_guides << e
0.000000000e+00 -1.456901426e-01 0.000000000e+00 2.913802852e-01
-8.855947866e-01 8.184856650e-02 2.697265243e-01 1.138485761e-02
e
$rest2_01_0_axis << e
0.000000000e+00 0.000000000e+00 -4.283601765e-01 1.011479326e-01
e
$rest2_01_0 << e
0.000000000e+00 0.000000000e+00
-4.283601765e-01 1.011479326e-01
e
$rest2_01_1_lines << e
-4.283601765e-01 1.011479326e-01 -3.223713479e-01 -1.360693727e-02
-4.283601765e-01 1.011479326e-01 -4.508794009e-01 1.673744250e-02
e
$rest2_01_1 << e
-4.283601765e-01 1.011479326e-01
-7.507315244e-01 8.754099530e-02
-8.792395774e-01 1.178853751e-01
e
$rest2_01_2 << e
-7.507315244e-01 8.754099530e-02
e
$rest2_01_grounds << e
0.000000000e+00 0.000000000e+00
e
$at2_01_guides << e
4.026087626e-03 -1.456350570e-01 -8.052175252e-03 2.912701140e-01
-1.106692454e+00 1.766570406e-02 2.166665788e-01 2.558919848e-02
e
$at2_01_0_axis << e
0.000000000e+00 0.000000000e+00 -7.394039233e-01 6.104396365e-02
e
$at2_01_0 << e
0.000000000e+00 0.000000000e+00
-7.394039233e-01 6.104396365e-02
e
$at2_01_1_lines << e
-7.394039233e-01 6.104396365e-02 -2.589552408e-01 -3.058366035e-02
-7.394039233e-01 6.104396365e-02 -4.807764178e-01 -1.227047126e-02
e
$at2_01_1 << e
-7.394039233e-01 6.104396365e-02
-9.983591641e-01 3.046030330e-02
-1.220180341e+00 4.877349240e-02
e
$at2_01_2 << e
-9.983591641e-01 3.046030330e-02
e
$at2_01_grounds << e
0.000000000e+00 0.000000000e+00
e
set arrow 1 from -8.399698571e-03,-1.476245514e-01 to 0.000000000e+00,0.000000000e+00 lw 2 lc rgb '#202020' front
set label 1 'hinge' at -8.399698571e-03,-1.476245514e-01 center offset -1.817829762e-01,-8.985466515e-01 tc rgb '#202020' front noenhanced
set arrow 2 from -7.317325838e-01,1.121740258e-01 to -7.394039233e-01,6.104396365e-02 lw 2 lc rgb '#202020' front
set label 2 'foot' at -7.317325838e-01,1.121740258e-01 center offset 4.748002287e-01,8.900380435e-01 tc rgb '#202020' front noenhanced
set xlabel 'x [m]' offset 0,0.4
set ylabel 'y [m]' offset 0.8,0
set xrange [-1.659445264e+00:4.392649228e-01]
set yrange [-9.904124058e-01:1.108297781e+00]
set title 'seen along z' offset 0,-0.6
plot $rest2_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c4c4c4', $rest2_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c4c4c4', $rest2_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c4c4c4', $rest2_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c4c4c4', $rest2_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c4c4c4', $rest2_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c4c4c4', $rest2_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050', $at2_01_guides using 1:2:3:4 with vectors nohead lw 1 dt 3 lc rgb '#c8551b', $at2_01_0_axis using 1:2:3:4 with vectors nohead lw 5 lc rgb '#c8551b', $at2_01_0 using 1:2 with points pt 7 ps 0.6 lc rgb '#c8551b', $at2_01_1_lines using 1:2:3:4 with vectors nohead lw 2 lc rgb '#c8551b', $at2_01_1 using 1:2 with points pt 7 ps 0.5 lc rgb '#c8551b', $at2_01_2 using 1:2 with points pt 5 ps 1.6 lc rgb '#c8551b', $at2_01_grounds using 1:2 with points pt 9 ps 1.2 lc rgb '#505050'
unset label
unset arrow
unset multiplot
