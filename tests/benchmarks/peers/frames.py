#!/usr/bin/env python3
"""Random plane frames at rest: boxbeam beside PyNite, member by member.

    python3 -m venv /tmp/venv && /tmp/venv/bin/pip install PyNiteFEA==3.2.0
    /tmp/venv/bin/python tests/benchmarks/peers/frames.py build/boxbeam [COUNT [SEED]]

A beam at any angle, clamped or pinned, on one to three members of their own sections, hinged or rigid, on feet that
are clamped or pinned; forces and couples anywhere on the beam, lines of force and weight on all members. Prismatic
members by the theory of Euler and Bernoulli, in which both programs are exact (boxbeam with a shear modulus that
leaves no shear). Compared: what supports and members do to the beam, N, V and M on both sides of every station of
boxbeam's results, and the largest deflection. Prints the largest differences, relative to the largest force, moment
and deflection of each frame, and ends with 1 where one is above the tolerance.
"""
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from Pynite import FEModel3D

# Between the places to which boxbeam integrates the bent line, a sixteenth of a segment apart at most, it is a cubic.
TOLERANCE = {"deflection": 1e-4}
OTHERS = 1e-9
# As soft as boxbeam lets it be beside a shear modulus as stiff as it lets it be: forces do not know it.
YOUNG, SHEAR, DENSITY, GRAVITY = 2.1e4, 1e15, 7850.0, 9.81


def vector(x, y, unit):
    return f'["{x!r} {unit}", "{y!r} {unit}"]'


class Frame:
    """What both programs are told."""

    def __init__(self, seed):
        pick = random.Random(seed)
        self.length, self.angle = pick.uniform(2, 8), pick.uniform(-1.2, 1.2)
        self.along = (math.cos(self.angle), math.sin(self.angle))
        self.section = (pick.uniform(0.05, 0.1), pick.uniform(0.2, 0.4))
        self.start = pick.choice(["fixed", "pinned"])
        # Not too near each other: in a piece of 1 mm PyNite loses half of its digits.
        places = [self.length * (i + pick.uniform(-0.2, 0.2)) / 12 for i in range(1, 12)]
        held = sorted(pick.sample(places[3:], pick.choice([1, 2, 3])))
        free = [s for s in places if s not in held]
        self.members = []
        for i, s in enumerate(held):
            x, y = self.place(s)
            self.members.append({
                "name": f"m{i}", "s": s, "foot": (x + pick.uniform(-2, 2), y - pick.uniform(1, 4)),
                "support": pick.choice(["fixed", "pinned"]), "joint": pick.choice(["rigid", "hinge"]),
                "section": (pick.uniform(0.05, 0.1), pick.uniform(0.1, 0.3)),
                "line": (pick.uniform(-5e3, 5e3), pick.uniform(-5e3, 5e3))})
        self.forces = [(s, pick.uniform(-2e4, 2e4), pick.uniform(-2e4, 2e4),
                        pick.uniform(-1e4, 1e4)) for s in pick.sample(free, pick.choice([1, 2, 4]))]
        self.line = [(pick.uniform(-5e3, 5e3), pick.uniform(-5e3, 5e3)) for _ in range(2)]

    def place(self, s):
        return s * self.along[0], s * self.along[1]

    def case(self):
        def plate(name, section):
            return (f'[sections.{name}]\nkind = "plate"\nwidth = "{section[0]!r} m"\n'
                    f'height = "{section[1]!r} m"\n')

        elastic = f'youngs_modulus = "{YOUNG!r} Pa"\nshear_modulus = "{SHEAR!r} Pa"\n'
        points = ", ".join(f'{m["name"]} = ["{m["s"]!r} m", "0 m"]' for m in self.members)
        text = ('[case]\nname = "frame"\nkind = "static"\n[model]\n' + elastic + plate("beam", self.section) +
                f'[beam]\ndensity = "{DENSITY} kg/m^3"\nangle = "{self.angle!r} rad"\npoints = {{ {points} }}\n'
                f'[[beam.segments]]\nlength = "{self.length!r} m"\nsection = "beam"\n'
                f'[supports.start]\nkind = "{self.start}"\nat = "0 m"\n')
        for m in self.members:
            name = m["name"]
            text += (plate(name, m["section"]) +
                     f'[members.{name}]\nfrom = {vector(*m["foot"], "m")}\nto = "beam.{name}"\n'
                     f'section = "{name}"\n{elastic}'
                     f'[supports.foot_{name}]\nkind = "{m["support"]}"\nat = "{name}.start"\n'
                     f'[joints.top_{name}]\nkind = "{m["joint"]}"\nconnect = ["{name}.end", "beam.{name}"]\n'
                     f'[loads.line_{name}]\nkind = "line"\non = "{name}"\n'
                     f'force_per_length = {vector(*m["line"], "N/m")}\n')
        for i, (s, x, y, couple) in enumerate(self.forces):
            text += (f'[loads.f{i}]\nkind = "force"\nat = "{s!r} m"\nforce = {vector(x, y, "N")}\n'
                     f'moment = "{couple!r} N m"\n')
        text += (f'[loads.line]\nkind = "line"\nforce_per_length = {vector(*self.line[0], "N/m")}\n'
                 f'to_force_per_length = {vector(*self.line[1], "N/m")}\n')
        return (text + '[deflection]\nlimit = "1 m"\n[material]\nsteel = "S355"\n'
                '[strength]\nrequired = 1.0\nshear_lag = false\n')


class Peer:
    """The frame in PyNite: the beam in pieces between the places of its members and forces."""

    def __init__(self, frame):
        self.frame = frame
        model = self.model = FEModel3D()
        model.add_material("steel", YOUNG, SHEAR, 0.3, DENSITY)
        self.cuts = sorted({0.0, frame.length, *(m["s"] for m in frame.members),
                            *(s for s, _, _, _ in frame.forces)})
        for i, s in enumerate(self.cuts):
            model.add_node(f"b{i}", *frame.place(s), 0.0)
        self.section("beam", frame.section)
        for i in range(len(self.cuts) - 1):
            model.add_member(f"beam{i}", f"b{i}", f"b{i + 1}", "steel", "beam")
            self.beam_loads(i)
        for s, x, y, couple in frame.forces:
            for direction, value in (("FX", x), ("FY", y), ("MZ", couple)):
                model.add_node_load(f"b{self.cuts.index(s)}", direction, value)
        for m in frame.members:
            name = m["name"]
            self.section(name, m["section"])
            model.add_node(f"foot_{name}", *m["foot"], 0.0)
            model.add_member(name, f"foot_{name}", f"b{self.cuts.index(m['s'])}", "steel", name)
            if m["joint"] == "hinge":
                model.def_releases(name, Rzj=True)
            weight = -DENSITY * GRAVITY * m["section"][0] * m["section"][1]
            for direction, w in (("FX", m["line"][0]), ("FY", m["line"][1] + weight)):
                model.add_member_dist_load(name, direction, w, w)
        clamped = {"b0": frame.start == "fixed"}
        clamped.update({f"foot_{m['name']}": m["support"] == "fixed" for m in frame.members})
        for node in model.nodes:
            held = node in clamped
            model.def_support(node, held, held, True, True, True, clamped.get(node, False))
        model.analyze_linear(check_stability=False)

    def section(self, name, size):
        width, height = size
        self.model.add_section(name, width * height, height * width**3 / 12, width * height**3 / 12, 1.0)

    def beam_loads(self, i):
        frame, low, high = self.frame, self.cuts[i], self.cuts[i + 1]
        weight = -DENSITY * GRAVITY * frame.section[0] * frame.section[1]

        def at(s, k):
            (from_x, from_y), (to_x, to_y) = frame.line
            part = s / frame.length
            return (from_x + part * (to_x - from_x), from_y + part * (to_y - from_y) + weight)[k]

        for k, direction in enumerate(("FX", "FY")):
            self.model.add_member_dist_load(f"beam{i}", direction, at(low, k), at(high, k))

    def piece(self, s, behind):
        for i in range(len(self.cuts) - 1):
            if s < self.cuts[i + 1] or (s == self.cuts[i + 1] and not behind):
                break
        return self.model.members[f"beam{i}"], s - self.cuts[i]

    def cut(self, s, behind):
        """N tension positive, V, M in boxbeam's signs, on one side of a station."""
        member, x = self.piece(s, behind)
        x = min(x, member.L())
        return -member.axial(x), -member.shear("Fy", x), member.moment("Mz", x)

    def deflection(self, s):
        member, x = self.piece(s, True)
        return member.deflection("dy", min(x, member.L()))

    def on_beam(self):
        """Force (x, y) and moment of everything that holds the beam, by its name there."""
        node = self.model.nodes["b0"]
        loads = {"start": (node.RxnFX["Combo 1"], node.RxnFY["Combo 1"], node.RxnMZ["Combo 1"])}
        for m in self.frame.members:
            end = self.model.members[m["name"]].F("Combo 1")[6:12, 0]  # on the member, world axes
            loads["top_" + m["name"]] = (-end[0], -end[1], -end[5])
        return loads


def results_of(program, text, folder):
    case = Path(folder) / "frame.toml"
    case.write_text(text, encoding="utf-8")
    run = subprocess.run([program, "verify", str(case), "--no-plots", "--no-pdf", "--no-html", "--out",
                          str(Path(folder) / "out"), "--json", "-"], capture_output=True, text=True, check=False)
    if run.returncode > 1:
        sys.exit(f"boxbeam ends with {run.returncode}:\n{run.stderr}\n{text}")
    return json.loads(run.stdout)


def differences(results, peer):
    """Of reactions, N, V, M and deflection, relative to the largest of the frame."""
    pairs = {"reaction": [], "moment of a reaction": [], "N": [], "V": [], "M": [], "deflection": []}
    theirs = peer.on_beam()
    for load in results["loads"]:
        if load["by"] not in theirs:
            continue
        force = theirs[load["by"]]
        pairs["reaction"] += [(load["world"][k], force[k]) for k in range(2)]
        # The axes of a plane beam are the world's, but that its y points away: M_y is clockwise.
        pairs["moment of a reaction"].append((-load["moment"][1], force[2]))
    for station in results["beam"]["stations"]:
        s = station["s"]
        for side in ("-", "+") if station["side"] == "0" else (station["side"],):
            if (s == 0.0 and side == "-") or (s >= peer.frame.length and side == "+"):
                continue
            for name, value in zip("NVM", peer.cut(s, side == "+")):
                pairs[name].append((station[name][0], value))
    check = next(c for c in results["checks"] if c["criterion"] == "deflection")
    pairs["deflection"].append((check["acting"], abs(peer.deflection(check["station"]))))
    largest = {name: max((abs(b) for _, b in values), default=0.0) for name, values in pairs.items()}
    force = max(largest["N"], largest["V"], largest["reaction"])
    moment = max(largest["M"], largest["moment of a reaction"])
    scale = {"reaction": force, "moment of a reaction": moment, "N": force, "V": force, "M": moment,
             "deflection": largest["deflection"]}
    return {name: max((abs(a - b) for a, b in values), default=0.0) / scale[name]
            for name, values in pairs.items()}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    worst = {}
    with tempfile.TemporaryDirectory() as folder:
        for i in range(seed, seed + count):
            frame = Frame(i)
            for name, value in differences(results_of(program, frame.case(), folder), Peer(frame)).items():
                if value >= worst.get(name, (0.0, 0))[0]:
                    worst[name] = (value, i)
    print(f"{count} frames from seed {seed}, largest difference from PyNite:")
    for name, (value, i) in worst.items():
        print(f"  {name:22} {value:.1e}  (frame {i})")
    return any(value > TOLERANCE.get(name, OTHERS) for name, (value, _) in worst.items())


if __name__ == "__main__":
    sys.exit(main())
