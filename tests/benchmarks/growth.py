#!/usr/bin/env python3
"""Times whole commands over mechanisms of many parts, and says how time and memory grow with their number.

    tests/benchmarks/growth.py BOXBEAM [loops|chain|loops-in-space|parts]... [--runs 3]

loops           parallelograms in a row, the first crank driven (plane)
chain           bodies in a row in space, every fourth on a driven revolute joint
loops-in-space  four-bars in a row in space: cranks on revolute joints, couplers on universal and spherical ones
parts           an elastic cantilever of five links, divided into many parts, with a load that vibrates

Of each number: the processor time of `motion` and `verify`, medians of so many runs, and the largest memory of the
process. The exponent is that between two numbers: the logarithm of the ratio of times over that of numbers.
"""

import argparse
import math
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

def case_of_loops(loops):
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


BEAM_IN_SPACE = """[sections.box]
kind = "box"
width = "100 mm"
height = "200 mm"
flange = "8 mm"
web = "8 mm"
[beam]
body = "lever"
start = "O"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "1 m"
section = "box"
[material]
steel = "S355"
[strength]
required = 1.5
"""
ROD_IN_SPACE = 'mass = "10 kg"\nuniform_rod = ["O", "A"]\npoints = { O = ["0 m", "0 m", "0 m"], A = ["1 m", "0 m", "0 m"] }\n'
POINTS_OF_BEAM = 'points = { O = ["0 m", "0 m", "0 m"], A = ["1 m", "0 m", "0 m"] }\n'


def case_of_chain(bodies):
    """A case of so many bodies in a row; the last is the beam."""
    parts = ["""[case]
name = "chain"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
""", BEAM_IN_SPACE]
    before = "ground"
    for i in range(bodies):
        name = "lever" if i + 1 == bodies else f"rod-{i}"
        parts.append(f"[bodies.{name}]\n" + (POINTS_OF_BEAM if i + 1 == bodies else ROD_IN_SPACE))
        # As many drivers as a case may have: every fourth joint turns.
        if i % 4:
            parts.append(f'[joints.j-{i}]\nkind = "fixed"\nconnect = ["{before}", "{name}.O"]\nturn = ["y", "{(-1) ** i} deg"]\n')
        else:
            parts.append(f'[joints.j-{i}]\nkind = "revolute"\nconnect = ["{before}", "{name}.O"]\naxis = "{"yz"[i // 4 % 2]}"\n'
                         f'[drivers.j-{i}]\njoint = "j-{i}"\nkind = "harmonic"\nmean = "{3 * (-1) ** (i // 4)} deg"\n'
                         'amplitude = "2 deg"\nfrequency = "0.7 Hz"\n')
        before = f"{name}.A"
    return "\n".join(parts)


def case_of_loops_in_space(loops):
    """A case of so many loops: cranks about axes that differ, couplers between them; the first crank is the beam."""
    parts = ["""[case]
name = "loops-in-space"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[drivers.motor]
joint = "crank-0"
kind = "harmonic"
mean = "0 deg"
amplitude = "10 deg"
frequency = "0.7 Hz"
""", BEAM_IN_SPACE]
    for i in range(loops + 1):
        name = "lever" if i == 0 else f"rod-{i}"
        # Upright, turned about axes that lean in and out.
        parts.append(f"[bodies.{name}]\n" + (POINTS_OF_BEAM if i == 0 else ROD_IN_SPACE))
        parts.append(f'[joints.crank-{i}]\nkind = "revolute"\nconnect = ["ground", "{name}.O"]\nat = ["{i} m", "0 m", "0 m"]\n'
                     f'turn = ["y", "-90 deg"]\naxis = [{0.1 * (-1) ** i}, 1, 0]\n')
        if i == 0:
            continue
        before = "lever" if i == 1 else f"rod-{i - 1}"
        parts.append(f"[bodies.coupler-{i}]\n" + ROD_IN_SPACE)
        parts.append(f'[joints.left-{i}]\nkind = "universal"\nconnect = ["{before}.A", "coupler-{i}.O"]\n'
                     'turn = ["y", "90 deg"]\naxis = "y"\nsecond_axis = "z"\n')
        parts.append(f'[joints.right-{i}]\nkind = "spherical"\ncloses = true\nconnect = ["coupler-{i}.A", "{name}.A"]\n')
    return "\n".join(parts)


def case_of_parts(parts):
    """Five elastic links in line, together of so many parts, the first held and the last shaken at 25 Hz."""
    lines = ["""[case]
name = "parts"
kind = "flexible"
[mechanism]
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[motion]
frequency = "25 Hz"
[model]
youngs_modulus = "210 GPa"
shear_modulus = "81 GPa"
damping = { ratio = 0.01, at = "25 Hz" }
[sections.box]
kind = "box"
width = "150 mm"
height = "300 mm"
flange = "10 mm"
web = "8 mm"
[beam]
link = "link-0"
density = "7850 kg/m^3"
[[beam.segments]]
length = "0.6 m"
section = "box"
[material]
steel = "S355"
[strength]
required = 1.5
[loads.shaking]
on = "link-4.end"
amplitude_force = ["0 N", "1 kN"]
"""]
    for i in range(5):
        before = f"link-{i - 1}.end" if i else "ground"
        place = f'"{before}"' if i else '["0 m", "0 m"]'
        rod = "" if i == 0 else 'length = "0.6 m"\nEA = "2 GN"\nEI = "20 MN m^2"\nGA = "400 MN"\nmass_per_length = "60 kg/m"\n'
        lines.append(f'[links.link-{i}]\nkind = "bending"\norigin = {place}\nangle = "20 deg"\nparts = {parts // 5}\n{rod}'
                     f'[joints.joint-{i}]\nkind = "revolute"\nconnect = ["link-{i}.start", "{before}"]\n'
                     'stiffness = "rigid"\nturning_stiffness = "rigid"\n')
    return "\n".join(lines)


SORTS = {"loops": (case_of_loops, [33, 99, 333, 999]), "chain": (case_of_chain, [10, 30, 100, 300, 1000]),
         "loops-in-space": (case_of_loops_in_space, [1, 3, 10, 30, 100, 300, 1000]),
         "parts": (case_of_parts, [100, 300, 1000, 3000, 10000])}


def measured(command):
    """Processor time of a command [s] and its largest memory [MB]; nothing where it is refused."""
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode > 1 or process.returncode < 0:
            said.seek(0)
            sys.stderr.write(said.read().decode())
            return None
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("boxbeam")
    parser.add_argument("sorts", nargs="*", help=" ".join(SORTS))
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for sort in given.sorts or SORTS:
            case_of, counts = SORTS[sort]
            print(f"{sort}\n{'number':>8}" + "".join(f"{word + ' [s]':>14}{'exponent':>10}{'[MB]':>8}"
                                                    for word in ("motion", "verify")))
            before = {}
            for count in counts:
                case = Path(folder) / f"{sort}-{count}.toml"
                case.write_text(case_of(count), encoding="utf-8")
                line = f"{count:8d}"
                for word, rest in (("motion", []), ("verify", ["--no-plots", "--no-pdf", "--no-html", "-q", "--out",
                                                               folder])):
                    runs = [measured([given.boxbeam, word, case, *rest]) for _ in range(given.runs)]
                    if None in runs:
                        line += f"{'refused':>14}{'':>18}"
                        continue
                    time = statistics.median(run[0] for run in runs)
                    exponent = ""
                    if word in before:
                        exponent = f"{math.log(time / before[word][1]) / math.log(count / before[word][0]):.2f}"
                    before[word] = count, time
                    line += f"{time:14.3f}{exponent:>10}{max(run[1] for run in runs):8.0f}"
                print(line, flush=True)


if __name__ == "__main__":
    main()
