#!/usr/bin/env python3
"""Times whole commands over long mechanisms: parallelograms in a row, the first crank driven.

    tests/benchmarks/many_loops.py BOXBEAM [LOOPS...]

Says the processor time of `motion` and `verify` for each number of loops (33 99 333 999), medians of
five runs.
"""

import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def case_of(loops):
    """A case of so many loops; the last crank is the beam."""
    parts = ["""[case]
name = "many-loops"
kind = "planar"
[mechanism]
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[sections.box]
kind = "box"
width = "100 mm"
height = "200 mm"
flange = "8 mm"
web = "8 mm"
[beam]
body = "lever"
density = "7850 kg/m^3"
[[beam.segments]]
length = "1 m"
section = "box"
[material]
steel = "S355"
[strength]
required = 1.5
[drivers.motor]
point = "crank-0.O"
coordinate = "angle"
kind = "harmonic"
mean = "90 deg"
amplitude = "20 deg"
frequency = "0.7 Hz"
"""]
    cranks = [f"crank-{i}" for i in range(loops)] + ["lever"]
    rod = 'mass = "10 kg"\nuniform_rod = "1 m"\n'
    for i, crank in enumerate(cranks):
        if crank == "lever":
            parts.append(f'[bodies.lever]\npoints = {{ O = ["0 m", "0 m"], A = ["1 m", "0 m"] }}\n'
                         f'sketch = {{ at = ["{i} m", "0 m"], angle = "90 deg" }}\n')
        else:
            parts.append(f'[bodies.{crank}]\n{rod}points = {{ O = ["-0.5 m", "0 m"], A = ["0.5 m", "0 m"] }}\n'
                         f'sketch = {{ at = ["{i} m", "0.5 m"], angle = "90 deg" }}\n')
        parts.append(f'[joints.O-{i}]\nkind = "pin"\nconnect = ["{crank}.O", "ground"]\nat = ["{i} m", "0 m"]\n')
    for i in range(loops):
        parts.append(f'[bodies.coupler-{i}]\n{rod}points = {{ A = ["-0.5 m", "0 m"], B = ["0.5 m", "0 m"] }}\n'
                     f'sketch = {{ at = ["{i}.5 m", "1 m"], angle = "0 deg" }}\n')
        parts.append(f'[joints.A-{i}]\nkind = "pin"\nconnect = ["{cranks[i]}.A", "coupler-{i}.A"]\n')
        parts.append(f'[joints.B-{i}]\nkind = "pin"\nconnect = ["coupler-{i}.B", "{cranks[i + 1]}.A"]\n')
    return "\n".join(parts)


def time_of(command):
    """Processor time of a command [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    if code.returncode > 1:
        sys.exit(code.stderr.decode())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    boxbeam = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        print("loops  bodies  motion [s]  verify [s]")
        for loops in [int(of) for of in sys.argv[2:]] or [33, 99, 333, 999]:
            case = Path(folder) / f"{loops}.toml"
            case.write_text(case_of(loops), encoding="utf-8")
            motion = [time_of([boxbeam, "motion", case]) for _ in range(5)]
            verify = [time_of([boxbeam, "verify", case, "--no-plots", "--no-pdf", "--no-html", "-q", "--out",
                               folder]) for _ in range(5)]
            print(f"{loops:5d}  {2 * loops + 1:6d}  {statistics.median(motion):10.3f}  "
                  f"{statistics.median(verify):10.3f}")


main()
