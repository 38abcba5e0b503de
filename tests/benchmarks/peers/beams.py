"""Elastic beams: boxbeam's rigid finite elements beside the beam elements of CalculiX.

A steel bar of rectangular section, clamped; slender (height / length 1/100), so that the models
agree far below what is charted: CalculiX expands its beams to solids, whose shear area is the whole
section. No lateral contraction, without which its tapered beams are too stiff. CalculiX runs as a
process, so boxbeam does as well; calls of its library are given beside.
"""
import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from measure import Refusal, chart, point, series, smallest_error, take_times
from spectral_beam import SpectralBeam

REPETITIONS = 9
MIDDLE, LENGTH, WIDTH, MODULUS, DENSITY = 5.0, 10.0, 0.05, 2.1e11, 7850.0
ELEMENTS = (1, 2, 4, 8, 16, 32, 64, 128)
MODES = (1, 2, 3, 4, 6, 8, 12, 16)
LOAD = 1000.0
DEFAULT_PARTS = 16  # of a link of which the case does not say it

CASE = """
[case]
name = "beam"
title = "A beam in other programs"
kind = "flexible"

[mechanism]
gravity = ["0 m/s^2", "0 m/s^2"]

[model]
element = "{element}"
youngs_modulus = "210 GPa"
shear_modulus = "105 GPa"

[links.beam]
kind = "bending"
origin = ["0 m", "0 m"]
angle = "0 deg"
{parts}
points = {{ middle = ["5 m", "0 m"] }}

[joints.clamp]
kind = "revolute"
connect = ["beam.start", "ground"]
stiffness = "rigid"
turning_stiffness = "rigid"
{prop}
[sections.root]
kind = "plate"
width = "50 mm"
height = "{h_0} m"

[sections.tip]
kind = "plate"
width = "50 mm"
height = "{h_1} m"

[beam]
link = "beam"
density = "7850 kg/m^3"
rotary_inertia = true

[[beam.segments]]
length = "10 m"
from = "root"
to = "tip"

[material]
steel = "S355"

[strength]
required = 1.0

[fatigue]
category = 80
cycles = 1e6
loading = "spectrum"
gamma_Ff = 1.0
gamma_Mf = 1.0
required = 1.0
"""

PROP = """
[joints.prop]
kind = "general"
connect = ["beam.end", "ground"]
stiffness = ["0 N/m", "rigid"]
turning_stiffness = "0 N m/rad"

[motion]
frequency = "{frequency!r} Hz"

[loads.load]
on = "beam.middle"
amplitude_force = ["0 N", "1000 N"]
"""


def heights(beam, x):
    return beam["h_0"] + (beam["h_1"] - beam["h_0"]) * x / LENGTH


def sections(beam, shear_share=5 / 6):
    def at(x):
        h = heights(beam, x)
        A, I = WIDTH * h, WIDTH * h**3 / 12
        return MODULUS * I, MODULUS / 2 * A * shear_share, DENSITY * A, DENSITY * I
    return at


def truth(beam, shear_share=5 / 6):
    return SpectralBeam(LENGTH, MIDDLE, sections(beam, shear_share), beam["propped"])


def run_process(command, folder):
    """Runs to the end; processor time of the whole process [s], and its output."""
    with open(Path(folder) / "output", "w+", encoding="utf-8") as output:
        process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        raise Refusal(text.strip().splitlines()[-1] if text.strip() else "failed")
    return usage.ru_utime + usage.ru_stime, text


class CalculiX:
    """A deck in a folder of its own."""

    def __init__(self, folder, beam, element, count, frequency=None, modes=1):
        self.folder = Path(folder)
        self.folder.mkdir()
        self.nodes = 2 * count + 1 if element.startswith("B32") else count + 1
        x = np.linspace(0.0, LENGTH, self.nodes)
        step = (self.nodes - 1) // count
        lines = ["*NODE,NSET=ALL"]
        lines += [f"{i + 1},{p!r},0.,0." for i, p in enumerate(map(float, x))]
        lines += [f"*ELEMENT,TYPE={element},ELSET=BEAM"]
        lines += [",".join(str(n) for n in (e + 1, *range(step * e + 1, step * e + step + 2)))
                  for e in range(count)]
        lines += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{MODULUS!r},0.", "*DENSITY", f"{DENSITY!r}",
                  "*BEAM SECTION,ELSET=BEAM,MATERIAL=STEEL,SECTION=RECT,NODAL THICKNESS",
                  f"{beam['h_0']!r},{WIDTH!r}", "0.,1.,0.", "*NODAL THICKNESS"]
        lines += [f"{i + 1},{h!r},{WIDTH!r}" for i, h in enumerate(map(float, heights(beam, x)))]
        lines += ["*BOUNDARY", "1,1,6", "ALL,3,5"]  # in the plane
        if beam["propped"]:
            lines += [f"{self.nodes},2,2"]
        middle = (self.nodes + 1) // 2
        lines += ["*STEP", "*FREQUENCY,STORAGE=YES" if frequency else "*FREQUENCY", f"{modes}"]
        if frequency:  # as its manual asks: the load's nodes must be known when modes are stored
            lines += ["*CLOAD", f"{middle},2,0."]
        lines += ["*NODE PRINT,NSET=ALL", "U", "*END STEP"]
        if frequency:
            lines += ["*STEP", "*STEADY STATE DYNAMICS", f"{frequency!r},{frequency!r},2", "*CLOAD",
                      f"{middle},2,{LOAD!r}", "*NODE PRINT,NSET=ALL", "RF", "*END STEP"]
        (self.folder / "deck.inp").write_text("\n".join(lines) + "\n", encoding="utf-8")

    def run(self):
        return run_process(["ccx", "deck"], self.folder)[0]

    def lines(self):
        if not (self.folder / "deck.dat").exists():
            raise Refusal("no results")
        return (self.folder / "deck.dat").read_text(encoding="utf-8").splitlines()

    def frequency(self):
        """Of the first mode, from the square, which is printed with seven digits [Hz]."""
        lines = self.lines()
        start = next((i for i, line in enumerate(lines) if "E I G E N V A L U E" in line), None)
        rows = [line.split() for line in lines[start or 0:] if line.split()[:1] == ["1"]]
        if start is None or not rows:
            raise Refusal("no frequency")
        return float(np.sqrt(float(rows[0][1]))) / (2 * np.pi)

    def prop_force(self):
        """Of the prop on the beam under a unit load."""
        lines = self.lines()
        start = next((i for i, line in enumerate(lines) if "forces (fx,fy,fz)" in line), None)
        if start is None:
            raise Refusal("no forces")
        row = next(line.split() for line in lines[start + 1:]
                   if line.split()[:1] == [str(self.nodes)])
        return float(row[2]) / LOAD


class Process:
    """boxbeam motion on a case; `parts` None: what the program takes."""

    def __init__(self, program, folder, beam, element, parts, frequency=None):
        self.program, self.folder = program, Path(folder)
        self.folder.mkdir()
        (self.folder / "beam.toml").write_text(CASE.format(
            element=element, parts=f"parts = {parts}" if parts else "",
            prop=PROP.format(frequency=frequency) if beam["propped"] else "", **{
                key: repr(beam[key]) for key in ("h_0", "h_1")}), encoding="utf-8")

    def run(self):
        spent, text = run_process([self.program, "motion", "beam.toml", "--json", "-"], self.folder)
        self.result = json.loads(text)
        return spent

    def frequency(self):
        return self.result["frequencies"][0]

    def prop_force(self):
        return self.result["harmonic"]["joints"]["prop"]["fy"][0] / LOAD


def beam_of(h_1, propped):
    return {"L": LENGTH, "b": WIDTH, "E": MODULUS, "rho": DENSITY, "h_0": 0.1, "h_1": h_1,
            "propped": propped, "load_at": MIDDLE}


class Charted:
    """Points of a chart against a right value, with what times them."""

    def __init__(self, library, right):
        self.library, self.right, self.timers = library, right, []

    def error(self, value):
        return abs(value / self.right - 1)

    def process(self, words, parameter, operations, process, value, default=False):
        try:
            process.run()
            own = point(words, parameter, error=self.error(value(process)), operations=operations,
                        default=default)
        except Refusal as error:
            return point(words, parameter, failure=error, default=default)
        self.timers.append(([own], process.run))
        return own

    def call(self, words, parameter, operations, **request):
        answer = self.library.ask("beam", **request)
        own = point(words, parameter, error=self.error(answer["value"]), operations=operations)
        turns = max(1, int(0.01 / answer["seconds"]))
        self.timers.append(
            ([own], lambda: self.library.ask("beam", turns=turns, **request)["seconds"]))
        return own


def frequency_chart(library, program, folder, name, title, scene, beam, repetitions):
    folder.mkdir()
    right = truth(beam).frequency()
    models = abs(truth(beam, shear_share=1.0).frequency() / right - 1)
    charted = Charted(library, right)

    def words(count):
        return "1 element" if count == 1 else f"{count} elements"

    all_series = []
    for element in ("corrected", "classical"):
        points = []
        for count in ELEMENTS:
            default = element == "corrected" and count == DEFAULT_PARTS
            process = Process(program, folder / f"{element}-{count}", beam, element,
                              None if default else count)
            points.append(charted.process(words(count), count, count, process, Process.frequency,
                                          default))
        all_series.append(series(f"boxbeam, {element}, whole process", points, yardstick=False))
    for element in ("corrected", "classical"):
        all_series.append(series(f"boxbeam, {element}, call of the library", [
            charted.call(words(count), count, count, what="frequency", element=element, parts=count,
                         beam=beam) for count in ELEMENTS], yardstick=False))
    for element in ("B31", "B32", "B32R"):
        all_series.append(series(f"CalculiX {element}, whole process", [
            charted.process(words(count), count, count,
                            CalculiX(folder / f"{element}-{count}", beam, element, count),
                            CalculiX.frequency) for count in ELEMENTS]))
    take_times(charted.timers, repetitions)

    default = next(p for p in all_series[0]["points"] if p["default"])
    same = {s["method"].split(",")[0] + " " + s["method"].split(",")[1].strip(): s["points"][ELEMENTS.index(DEFAULT_PARTS)]
            for s in (all_series[1], *all_series[4:])}
    others = ", ".join(f"{method.replace(' whole process', '')} {p['error']:.0e}"
                       for method, p in same.items() if not p["failure"])
    return chart(
        name, title, scene=scene, error="relative error of the lowest natural frequency",
        reference=f"Timoshenko's beam by spectral elements, long double, {right:.9f} Hz",
        operations="elements", unit="lowest frequency", series=all_series,
        guides=[{"order": 3.0, "series": 0}, {"order": 2.0, "series": 1}],
        floor={"error": models, "name": "models: shear over 5/6 or all of the section"},
        lesson=f"{DEFAULT_PARTS} corrected elements, the default, are right to "
               f"{default['error']:.0e}; as many of the others: {others}. None comes below the difference of the "
               "models, and a strength check needs no more than the default.")


def modes_chart(library, program, folder, beam, repetitions):
    folder.mkdir()
    reference = truth(beam)
    frequency = round(0.5 * reference.frequency(), 3)
    right = reference.prop_force(frequency)
    models = abs(truth(beam, shear_share=1.0).prop_force(frequency) / right - 1)
    charted = Charted(library, right)
    count = 64
    request = {"what": "harmonic", "element": "corrected", "parts": count, "frequency": frequency,
               "beam": beam}

    def words(modes):
        return "1 mode" if modes == 1 else f"{modes} modes"

    direct = Process(program, folder / "direct", beam, "corrected", count, frequency)
    all_series = [
        series("boxbeam, all elements, whole process",
               [charted.process("no modes", 0, None, direct, Process.prop_force, default=True)],
               yardstick=False),
        series("boxbeam, all elements, call of the library",
               [charted.call("no modes", 0, None, **request)], yardstick=False),
        series("boxbeam, modes with static correction, call of the library",
               [charted.call(words(m), m, m, modes=m, **request) for m in MODES], yardstick=False),
        series("boxbeam, modes alone, call of the library",
               [charted.call(words(m), m, m, modes=m, static_correction=False, **request)
                for m in MODES]),
        series("CalculiX B32R, steady state dynamics, whole process",
               [charted.process(words(m), m, m, CalculiX(folder / f"B32R-{m}", beam, "B32R", count,
                                                         frequency, m), CalculiX.prop_force)
                for m in MODES])]
    take_times(charted.timers, repetitions)
    corrected, plain = all_series[2]["points"], all_series[4]["points"]
    return chart(
        "peers-harmonic", "A harmonic reaction by modes, in other programs",
        scene=f"tapered bar, clamped and propped, {count} elements, force at its middle at "
              f"{frequency} Hz, half its lowest frequency",
        error="relative error of the prop's force",
        reference="Timoshenko's beam by spectral elements, long double", operations="modes",
        unit="harmonic response, modes included", series=all_series,
        floor={"error": models, "name": "models: shear over 5/6 or all of the section"},
        lesson=f"One mode with static correction is off by {corrected[0]['error']:.0e}; CalculiX, "
               f"which has modes alone, by {plain[0]['error']:.0e} with one and by "
               f"{plain[-1]['error']:.0e} with {MODES[-1]}.")


def charts(library, program, repetitions=REPETITIONS):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        return [
            frequency_chart(library, program, folder / "uniform", "peers-frequency",
                            "A cantilever's lowest frequency in other programs",
                            "uniform steel bar of 10 m, 50 x 100 mm, clamped",
                            beam_of(0.1, False), repetitions),
            frequency_chart(library, program, folder / "tapered", "peers-frequency-tapered",
                            "A tapered cantilever's lowest frequency in other programs",
                            "steel bar of 10 m, 50 mm wide, 100 mm high at the clamp and 50 mm at "
                            "the tip", beam_of(0.05, False), repetitions),
            modes_chart(library, program, folder / "propped", beam_of(0.05, True), repetitions)]
