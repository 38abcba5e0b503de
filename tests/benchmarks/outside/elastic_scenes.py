#!/usr/bin/env python3
"""Slender tapered beams in planar mechanisms by chance, verified by boxbeam and computed by Exudyn.

    python3 -m venv /tmp/outside && /tmp/outside/bin/pip install exudyn numpy
    /tmp/outside/bin/python tests/benchmarks/outside/elastic_scenes.py build/boxbeam [COUNT [SEED]]

Three kinds of mechanism, of which a rigid crank turns evenly: a slider-crank whose rod bends, a
four-bar whose rocker does, with an overhang, and one whose coupler does. Compared is the governing
normal stress, the largest |N/A +- M/W| over the beam and a cycle: of boxbeam that of the
fibres in its checks of yield, by the model that it chooses at a tolerance of 1 %; of Exudyn
(https://github.com/jgerstmayr/EXUDYN) in beams of large deflection, `ObjectANCFCable2D`, 32 of
them with the section's stiffness, mass and damping at the middle of each, generalised-alpha, 800
steps to a period, until the last two periods agree to 1e-3; before the first the crank comes up to
its speed over a period.

Where the verdict says that vibration is not proven or that the beam buckles, and where boxbeam
refuses, nothing is asserted.
Exit code 1 where a scene that is judged is off by more than 1 % and what Exudyn itself leaves open.
"""

import json
import math
import os
import random
import subprocess
import sys
import tempfile

import exudyn as exu
from exudyn.utilities import *  # noqa: F403  (items are named by it)

E = 210e9
DENSITY = 7800.0
GRAVITY = 9.81
TOLERANCE = 0.01


def meeting(a, from_a, b, from_b):
    """Where links from two places meet, to the left of the line from the first to the second."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    d = math.hypot(dx, dy)
    along = (from_a**2 - from_b**2 + d * d) / (2.0 * d)
    across = math.sqrt(max(0.0, from_a**2 - along**2))
    return (a[0] + (along * dx - across * dy) / d, a[1] + (along * dy + across * dx) / d)


class Box:
    """A box of walls as thick as 0.07 of its height h, 0.8 h wide, whose h changes evenly."""

    def __init__(self, chance, length):
        height = length / math.exp(chance.uniform(math.log(20.0), math.log(60.0)))
        self.length, self.height = length, height
        self.ends = [height * chance.uniform(0.7, 1.3) for _ in range(2)]

    def at(self, s):
        h = self.ends[0] + (self.ends[1] - self.ends[0]) * s / self.length
        area = h * h * (0.8 - 0.66 * 0.86)
        inertia = h**4 * (0.8 - 0.66 * 0.86**3) / 12.0
        return area, inertia, inertia / (0.5 * h)


class Scene:
    def __init__(self, seed):
        chance = random.Random(seed)
        self.kind = ("slider-crank, rod", "four-bar, rocker", "four-bar, coupler")[seed % 3]
        self.turn = chance.uniform(0.0, 2.0 * math.pi)
        if seed % 3 == 0:
            self.length = chance.uniform(0.6, 2.0)
            self.crank = self.length * chance.uniform(0.1, 0.3)
            self.mass = math.exp(chance.uniform(math.log(0.5), math.log(30.0)))
        else:
            self.coupler = chance.uniform(0.6, 1.5)
            self.rocker = self.coupler * chance.uniform(0.7, 1.3)
            self.ground = self.coupler * chance.uniform(0.9, 1.3)
            self.crank = (chance.uniform(0.15, 0.35) * min(self.coupler, self.rocker, self.ground)
                          * min(1.0, (self.rocker + self.coupler - self.ground) / self.coupler))
            self.mass = math.exp(chance.uniform(math.log(2.0), math.log(60.0)))
            overhang = chance.uniform(0.05, 0.25)
            of = self.rocker if seed % 3 == 1 else self.coupler
            self.length = of * (1.0 + overhang)
        self.box = Box(chance, self.length)
        slow = 0.5 * math.pi * 5190.0 * 0.39 * self.box.height / self.length**2
        self.rate = 2.0 * math.pi * slow / math.exp(chance.uniform(math.log(6.0), math.log(40.0)))
        self.damping = chance.uniform(0.02, 0.04) / (math.pi * slow)
        self.period = 2.0 * math.pi / self.rate

    def places(self, turn):
        A = (self.crank * math.cos(turn), self.crank * math.sin(turn))
        if "slider" in self.kind:
            return A, (A[0] + math.sqrt(self.length**2 - A[1] ** 2), 0.0), None
        C = (self.ground, 0.0)
        return A, meeting(A, self.coupler, C, self.rocker), C

    def text(self):
        """The case."""
        A, B, C = self.places(self.turn)

        def body(name, points, at, to, mass=0.0):
            length = max(x for _, x in points)
            listed = ", ".join(f'{n} = ["{x!r} m", "0 m"]' for n, x in points)
            own = (f'mass = "{mass!r} kg"\ninertia = "{mass * length * length / 10.0!r} kg m^2"\n'
                   f'centre = ["{0.45 * length!r} m", "0 m"]\n') if mass else ""
            angle = math.atan2(to[1] - at[1], to[0] - at[0])
            return (f"[bodies.{name}]\n{own}points = {{ {listed} }}\n"
                    f'sketch = {{ at = ["{at[0]!r} m", "{at[1]!r} m"], angle = "{angle!r} rad" }}\n')

        def pin(name, a, b, at=None):
            place = f'at = ["{at[0]!r} m", "{at[1]!r} m"]\n' if at else ""
            return f'[joints.{name}]\nkind = "pin"\nconnect = ["{a}", "{b}"]\n{place}'

        text = ('[case]\nname = "scene"\nkind = "planar"\n[mechanism]\n'
                f'gravity = ["0 m/s^2", "-{GRAVITY} m/s^2"]\n')
        text += body("crank", [("O", 0.0), ("A", self.crank)], (0.0, 0.0), A, 5.0)
        text += pin("O", "crank.O", "ground", (0.0, 0.0))
        if "slider" in self.kind:
            beam = "rod"
            text += body("rod", [("A", 0.0), ("B", self.length)], A, B)
            text += (f'[bodies.slide]\nmass = "{self.mass!r} kg"\n'
                     'points = { B = ["0 m", "0 m"] }\n'
                     f'sketch = {{ at = ["{B[0]!r} m", "0 m"], angle = "0 rad" }}\n')
            text += pin("A", "crank.A", "rod.A") + pin("B", "rod.B", "slide.B")
            text += ('[joints.guide]\nkind = "slider"\npoint = "slide.B"\n'
                     'through = ["0 m", "0 m"]\ndirection = "0 deg"\n')
        else:
            beam = "rocker" if "rocker" in self.kind else "coupler"
            tip = [("T", self.length)]
            text += body("coupler", [("A", 0.0), ("B", self.coupler)]
                         + (tip if beam == "coupler" else []), A, B,
                         0.0 if beam == "coupler" else self.mass)
            text += body("rocker", [("C", 0.0), ("B", self.rocker)]
                         + (tip if beam == "rocker" else []), C, B,
                         0.0 if beam == "rocker" else self.mass)
            text += pin("A", "crank.A", "coupler.A") + pin("B", "coupler.B", "rocker.B")
            text += pin("C", "rocker.C", "ground", C)
        text += ('[drivers.motor]\ncoordinate = "angle"\npoint = "crank.O"\n'
                 f'kind = "constant rate"\nstart = "{self.turn!r} rad"\n'
                 f'rate = "{self.rate!r} rad/s"\n')
        for name, h in zip("ab", self.box.ends):
            text += (f'[sections.{name}]\nkind = "box"\nheight = "{h!r} m"\n'
                     f'width = "{0.8 * h!r} m"\nflange = "{0.07 * h!r} m"\nweb = "{0.07 * h!r} m"\n')
        return text + (f'[beam]\nbody = "{beam}"\ndensity = "{DENSITY} kg/m^3"\n'
                       'rotary_inertia = false\n[[beam.segments]]\n'
                       f'length = "{self.length!r} m"\nfrom = "a"\nto = "b"\n'
                       '[material]\nsteel = "S355"\n[strength]\nrequired = 1.5\n'
                       'shear_lag = false\n[fatigue]\ncategory = 80\ncycles = 1e7\n'
                       'loading = "spectrum"\ngamma_Mf = 1.35\nrequired = 1.0\n'
                       f'[model]\ndamping = "{self.damping!r} s"\nshear_modulus = "1e6 GPa"\n'
                       f'youngs_modulus = "{E!r} Pa"\n')


def by_boxbeam(program, scene, folder):
    """(stress, model), or (None, why not)."""
    case = os.path.join(folder, "scene.toml")
    with open(case, "w") as file:
        file.write(scene.text())
    out = os.path.join(folder, "out")
    run = subprocess.run([program, "verify", case, "--out", out, "--no-plots", "--no-html",
                          "--no-pdf"], capture_output=True, text=True)
    if run.returncode not in (0, 1):
        return None, run.stderr.strip().splitlines()[-1]
    with open(os.path.join(out, "results.json")) as file:
        results = json.load(file)
    model = results["model"]["chosen"]
    if model == "modal":
        model += f" {results['model']['modes']}"
    for said in ("the beam buckles", "vibration is not proven"):
        if said in " ".join(run.stdout.split()):
            return None, said
    largest = max(abs(check["normal_stress"]) for check in results["checks"]
                  if check["criterion"] == "yield" and check["point"].startswith("fibre"))
    return largest, model


def by_exudyn(scene, parts=32, steps=800, most=14):
    """Governing stress, and how far its last two periods are apart."""
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    A, B, C = scene.places(scene.turn)
    start, to = {"s": (A, B), "r": (C, B), "c": (A, B)}[
        "s" if "slider" in scene.kind else scene.kind[10]]
    angle = math.atan2(to[1] - start[1], to[0] - start[0])
    e = (math.cos(angle), math.sin(angle))
    held = {"s": scene.length, "r": getattr(scene, "rocker", 0.0),
            "c": getattr(scene, "coupler", 0.0)}["s" if "slider" in scene.kind else scene.kind[10]]
    # Nodes at equal steps from the start to the joint, and on along the overhang.
    inner = max(4, round(parts * held / scene.length)) if held < scene.length else parts
    stations = [held * i / inner for i in range(inner + 1)]
    beyond = parts - inner
    if held < scene.length:
        beyond = max(2, beyond)
        stations += [held + (scene.length - held) * (i + 1) / beyond for i in range(beyond)]
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[
        start[0] + s * e[0], start[1] + s * e[1], e[0], e[1]])) for s in stations]
    beams = []
    for i in range(len(nodes) - 1):
        length = stations[i + 1] - stations[i]
        area, inertia, _ = scene.box.at(0.5 * (stations[i] + stations[i + 1]))
        beams.append(mbs.AddObject(ObjectANCFCable2D(
            length=length, massPerLength=DENSITY * area,
            bendingStiffness=E * inertia, axialStiffness=E * area,
            bendingDamping=E * inertia * scene.damping,
            axialDamping=E * area * scene.damping,
            nodeNumbers=[nodes[i], nodes[i + 1]])))
        mbs.AddLoad(LoadMassProportional(
            markerNumber=mbs.AddMarker(MarkerBodyMass(bodyNumber=beams[-1])),
            loadVector=[0.0, -GRAVITY, 0.0]))
    ground = mbs.AddObject(ObjectGround())

    def turned(t):
        T = scene.period
        # Up to speed over a period, smoothly in acceleration.
        if t < T:
            x = t / T
            return scene.turn + scene.rate * T * (x**4 * (2.5 - 3.0 * x + x * x))
        return scene.turn + scene.rate * (t - 0.5 * T)

    none = mbs.AddMarker(MarkerNodeCoordinate(
        nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))

    def hold(node, coordinate, function=None):
        arguments = {} if function is None else {"offsetUserFunction": function}
        mbs.AddObject(ObjectConnectorCoordinate(
            markerNumbers=[none, mbs.AddMarker(
                MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))], **arguments))

    def x_of_crank(mbs, t, number, offset):
        return scene.crank * (math.cos(turned(t)) - math.cos(scene.turn))

    def y_of_crank(mbs, t, number, offset):
        return scene.crank * (math.sin(turned(t)) - math.sin(scene.turn))

    at_B = nodes[inner]
    if "rocker" not in scene.kind:
        hold(nodes[0], 0, x_of_crank)
        hold(nodes[0], 1, y_of_crank)
    else:
        hold(nodes[0], 0)
        hold(nodes[0], 1)
    marker_B = mbs.AddMarker(MarkerNodePosition(nodeNumber=at_B))
    if "slider" in scene.kind:
        hold(at_B, 1)
        point = mbs.AddNode(NodePoint2D(referenceCoordinates=list(B)))
        mbs.AddObject(ObjectMassPoint2D(mass=scene.mass, nodeNumber=point))
        mbs.AddObject(ObjectJointRevolute2D(markerNumbers=[
            marker_B, mbs.AddMarker(MarkerNodePosition(nodeNumber=point))]))
    else:
        rocks = "rocker" in scene.kind
        length = scene.coupler if rocks else scene.rocker
        of = A if rocks else C
        way = math.atan2(B[1] - of[1], B[0] - of[0])
        centre = (of[0] + 0.45 * length * math.cos(way), of[1] + 0.45 * length * math.sin(way))
        node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[*centre, way]))
        link = mbs.AddObject(ObjectRigidBody2D(
            mass=scene.mass, inertia=scene.mass * length**2 / 10.0, nodeNumber=node))
        mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerBodyPosition(bodyNumber=link)),
                          loadVector=[0.0, -GRAVITY * scene.mass, 0.0]))
        far = mbs.AddMarker(MarkerBodyPosition(bodyNumber=link,
                                               localPosition=[0.55 * length, 0.0, 0.0]))
        near = mbs.AddMarker(MarkerBodyPosition(bodyNumber=link,
                                                localPosition=[-0.45 * length, 0.0, 0.0]))
        mbs.AddObject(ObjectJointRevolute2D(markerNumbers=[marker_B, far]))
        if rocks:
            point = mbs.AddNode(NodePoint2D(referenceCoordinates=list(A)))
            mbs.AddObject(ObjectMassPoint2D(mass=1e-3, nodeNumber=point))
            hold(point, 0, x_of_crank)
            hold(point, 1, y_of_crank)
            end = mbs.AddMarker(MarkerNodePosition(nodeNumber=point))
        else:
            end = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground,
                                                   localPosition=[C[0], C[1], 0.0]))
        mbs.AddObject(ObjectJointRevolute2D(markerNumbers=[near, end]))

    # Cut forces where cubic beams are most exact, at their two Gauss points.
    watched = []
    for i, beam in enumerate(beams):
        length = stations[i + 1] - stations[i]
        for x in (0.5 - 0.5 / math.sqrt(3.0), 0.5 + 0.5 / math.sqrt(3.0)):
            _, inertia, _ = scene.box.at(0.5 * (stations[i] + stations[i + 1]))
            area, own, modulus = scene.box.at(stations[i] + x * length)
            watched.append((beam, [x * length, 0.0, 0.0], area, modulus))
    largest = {}

    def look(mbs, t):
        period = int(t / scene.period - 1e-9)
        worst = largest.get(period, 0.0)
        for beam, place, area, modulus in watched:
            N = mbs.GetObjectOutputBody(beam, exu.OutputVariableType.ForceLocal,
                                        localPosition=place)
            M = mbs.GetObjectOutputBody(beam, exu.OutputVariableType.TorqueLocal,
                                        localPosition=place)
            N = N[0] if hasattr(N, "__len__") else N
            M = M[-1] if hasattr(M, "__len__") else M
            worst = max(worst, abs(N) / area + abs(M) / modulus)
        largest[period] = worst
        if period >= 4 and period - 1 in largest:
            before, last = largest[period - 2], largest[period - 1]
            if abs(last / before - 1.0) < 1e-3 and (period - 1) not in settled:
                settled.append(period - 1)
                return False
        return True

    settled = []
    mbs.SetPostStepUserFunction(look)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps * most
    settings.timeIntegration.endTime = scene.period * most
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.95
    settings.timeIntegration.newton.relativeTolerance = 1e-7
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    try:
        mbs.SolveDynamic(settings)
    except RuntimeError:
        if not settled:  # else it was ended by us
            raise
    done = max(k for k in largest if k - 1 in largest and k - 1 >= 3) - (0 if not settled else 1)
    return largest[done], abs(largest[done] / largest[done - 1] - 1.0)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 24
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    wrong = judged = 0
    print(f"{'seed':>5}  {'mechanism':<18} {'model':<12} {'boxbeam':>9} {'Exudyn':>9}  difference"
          "  settled to")
    for k in range(seed, seed + count):
        scene = Scene(k)
        with tempfile.TemporaryDirectory() as folder:
            stress, model = by_boxbeam(program, scene, folder)
        if stress is None:
            print(f"{k:>5}  {scene.kind:<18} {model}", flush=True)
            continue
        try:
            other, settled = by_exudyn(scene)
        except (RuntimeError, ValueError) as error:
            print(f"{k:>5}  {scene.kind:<18} Exudyn: {str(error).splitlines()[0]}", flush=True)
            continue
        off = stress / other - 1.0
        judged += 1
        bad = abs(off) > TOLERANCE + settled
        wrong += bad
        print(f"{k:>5}  {scene.kind:<18} {model:<12} {stress / 1e6:>9.4g} {other / 1e6:>9.4g}"
              f"  {100.0 * off:>8.3f} %  {settled:.0e}{'  WRONG' if bad else ''}", flush=True)
    print(f"{judged} judged, {judged - wrong} within {100.0 * TOLERANCE:.0f} % of Exudyn")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
