#!/usr/bin/env bash
# Sweeps a study of so many designs of a simple case, a box beam under given cut forces of which plates and life
# scatter; says wall seconds, processor time and peak memory.
#
#     tests/benchmarks/simple_study.sh [DESIGNS [PROGRAM]]       default 10000, build/boxbeam; one thread
set -euo pipefail
cd "$(dirname "$0")/../.."
designs=${1:-10000}
program=${2:-build/boxbeam}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/forces.csv" <<'END'
time [s], V [kN], M [kN m]
0, 0, 0
1, 60, -180
2, 0, 0
END
cat >"$folder/girder.toml" <<'END'
[case]
name = "girder"
title = "Box beam under given cut forces"
kind = "loads"

[sections.box]
kind = "box"
width = "200 mm"
height = "400 mm"
flange = "16 mm"
web = "12 mm"

[beam]
density = "7850 kg/m^3"

[[beam.segments]]
length = "3 m"
section = "box"

[files.forces]
path = "forces.csv"

[[cut_forces]]
station = "0 m"
columns = { V_z = "V", M_y = "M" }

[[cut_forces]]
station = "3 m"

[material]
steel = "S355"

[strength]
required = 1.5

[fatigue]
category = 71
loading = "spectrum"
cycles = 1e5
gamma_Mf = 1.35
required = 1.0
END
cat >"$folder/study.toml" <<END
[study]
case = "girder.toml"
seed = 1
samples = $designs

[variables.flange]
key = "sections.box.flange"
distribution = "normal"
mean = "16 mm"
sd = "0.4 mm"

[variables.web]
key = "sections.box.web"
distribution = "normal"
mean = "12 mm"
sd = "0.3 mm"

[variables.cycles]
key = "fatigue.cycles"
distribution = "lognormal"
mean = 1e5
sd = 3e4

[results]
columns = ["verdict", "fatigue.safety_factor", "yield.safety_factor"]
END
/usr/bin/time -f "%e s, %M kB of memory at most, %U s of processors" \
  "$program" sweep "$folder/study.toml" --threads 1 --quiet --out "$folder/out"
