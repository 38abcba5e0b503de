"""What `boxbeam verify --export` writes of the sledge rig, read by a reader of its own: the tables beside
results.json and closed forms, the case of loads verified again (of two more cases, too), the plates in beam.vtk
beside Navier's stress of the cut forces that stand in the same file.

Usage: export.py PROGRAM ROOT
"""
import json
import math
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from exported import Grid, run, table, verify  # noqa: E402

failures = []


def check(holds, words):
    if not holds:
        failures.append(words)


def near(a, b, relative, words):
    check(abs(a - b) <= relative * max(abs(a), abs(b)), f"{words}: {a!r} and {b!r}")


def check_tables(export, results):
    checks = table(export / "checks.csv")
    check(len(checks) == len(results["checks"]), "checks.csv has another number of checks")
    for row, of in zip(checks, results["checks"]):
        check(row["id"] == of["id"], f"{row['id']} stands for {of['id']}")
        for key in ("safety_factor", "utilisation", "acting", "resisting"):
            check(row[key] == of[key], f"{of['id']}: {key} {row[key]} and {of[key]}")
        check(row["station [m]"] == of["station"] and row["side"] == of["side"], f"{of['id']}: another place")

    # Every cut force lies between the extremes of its station, and comes near them.
    extremes = {(at["s"], at["side"]): at for at in results["beam"]["stations"]}
    reached = {key: [math.inf, -math.inf] for key in extremes}
    for row in table(export / "cut-forces.csv"):
        at = extremes[(row["s [m]"], row["side"])]
        for name, column in (("N", "N [N]"), ("V", "V_z [N]"), ("M", "M_y [N m]")):
            low, high = at[name]
            slack = 1e-9 * max(abs(low), abs(high), 1.0)
            check(low - slack <= row[column] <= high + slack, f"{name} at {row['s [m]']}{row['side']}")
        of = reached[(row["s [m]"], row["side"])]
        of[0], of[1] = min(of[0], row["M_y [N m]"]), max(of[1], row["M_y [N m]"])
    most = max(abs(value) for at in extremes.values() for value in at["M"])
    for key, of in reached.items():
        for mine, theirs in zip(of, extremes[key]["M"]):
            check(abs(mine - theirs) <= 0.01 * most, f"M at {key} is not reached")

    utilisation = table(export / "utilisation.csv")
    worst = max(row["worst"] for row in utilisation)
    near(worst, max(of["utilisation"] for of in results["checks"]), 0.0, "worst utilisation")
    for row in utilisation:
        judged = [row[of] for of in ("yield", "fatigue") if row[of] is not None]
        check(row["worst"] >= max(judged, default=0.0), f"the worst at {row['s [m]']}")
    check(len({(row["s [m]"], row["side"]) for row in utilisation}) == len(utilisation), "a station stands twice")

    # A1 is a box of 400 x 600 mm, all plates 50 mm; A2 is 1000 mm high.
    for row in table(export / "sections.csv"):
        height = {0.0: 0.6, 1.5: 0.6, 3.2: 1.0}.get(row["s [m]"])
        if height is None:
            continue
        near(row["A [m^2]"], 0.4 * height - 0.3 * (height - 0.1), 1e-12, "A")
        second = (0.4 * height**3 - 0.3 * (height - 0.1)**3) / 12
        near(row["I_y [m^4]"], second, 1e-12, "I_y")
        near(row["W_y [m^3]"], second / (height / 2), 1e-12, "W_y")
        near(row["mass per length [kg/m]"], 7800 * row["A [m^2]"], 1e-12, "mass per length")
        check(row["height [m]"] == height and row["left web [m]"] == 0.05, "sizes")


def check_loads(program, export, said, results, limit):
    stated = re.search(r"governing safety factors within (\S+) \(relative\); between its stations and instants "
                       r"forces within (\S+) and moments within (\S+) of the largest", said)
    check(stated is not None, f"nothing is said of loads.toml: {said[-600:]}")
    if not stated:
        return
    code, text, error = run(program, "verify", export / "loads.toml", "--out", export / "again", "--no-plots",
                            "--no-pdf", "--no-html", "--json", "-")
    check(code == (0 if results["verdict"] == "pass" else 1), f"exit code {code}\n{error}")
    again = json.loads(text)
    check(again["verdict"] == results["verdict"], f"another verdict: {again['verdict']}")
    largest, judged = 0.0, 0
    # Cut forces do not say how forces come in, nor what that does to welds.
    compared = [of for of in results["checks"]
                if of["criterion"] not in ("patch loading", "patch fatigue") and " under " not in of["point"]]
    for criterion in sorted({of["criterion"] for of in compared}):
        mine = next(of for of in compared if of["criterion"] == criterion)
        other = next((of for of in again["checks"]
                      if of["criterion"] == criterion and " under " not in of["point"]), None)
        check(other is not None, f"{criterion} is not judged")
        if other is None:
            continue
        judged += 1
        apart = abs(other["safety_factor"] / mine["safety_factor"] - 1)
        largest = max(largest, apart)
        print(f"  {criterion}: {mine['safety_factor']:.9g} by the mechanism, {other['safety_factor']:.9g} by its "
              f"cut forces, apart by {apart:.2g}; {mine['id']}, {other['id']}")
    check(judged >= 3, "fewer than three criteria")
    check(largest <= limit, f"a governing factor is {largest:.2g} apart")
    # It says two digits.
    check(largest <= 1.06 * float(stated.group(1)) + 1e-15, f"{largest} where {stated.group(1)} is stated")
    for of in stated.groups()[1:]:
        check(0 < float(of) < 1e-4, f"the sampling error is {of}")


def check_grid(export):
    grid = Grid(export / "beam.vtk")
    quads = [cell for cell, kind in zip(grid.cells, grid.types) if kind == 9]
    lines = grid.cells[len(quads):]
    check(grid.types == [9] * len(quads) + [3] * len(lines), "kinds of cells")
    check(all(len(cell) == 4 for cell in quads) and all(len(cell) == 2 for cell in lines), "sizes of cells")
    axis = sorted({node for line in lines for node in line})
    length = sum(math.dist(grid.points[a], grid.points[b]) for a, b in lines)
    near(length, 6.2, 1e-12, "the length of the axis")
    plates = min(axis)
    along = sorted({round(grid.points[node][0], 9) for node in axis})
    check(along[0] == 0.0 and along[-1] == 6.2, f"the axis goes from {along[0]} to {along[-1]}")
    # What is cut at a place; where it jumps both.
    cut = {}
    for node in axis:
        cut.setdefault(round(grid.points[node][0], 9), []).append(
            (grid.point_data["N_N"][node], grid.point_data["M_y_Nm"][node]))
    height = lambda s: 0.6 if s <= 1.5 or s >= 4.2 else 0.6 + 0.4 * ((s - 1.5) / 1.7 if s < 3.2 else 4.2 - s)
    compared = 0
    largest = max(map(abs, grid.point_data["normal_stress_Pa"]))
    for node in range(plates):
        s, y, z = grid.points[node]
        if s > 4.7 - 1e-9:  # the tube, and both
            continue
        h = height(s)
        area, second = 0.4 * h - 0.3 * (h - 0.1), (0.4 * h**3 - 0.3 * (h - 0.1)**3) / 12
        sigma, tau = grid.point_data["normal_stress_Pa"][node], grid.point_data["shear_stress_Pa"][node]
        apart = min(abs(sigma - n / area - m * z / second) for n, m in cut[round(s, 9)])
        check(apart <= 1e-9 * largest, f"normal stress at {(s, y, z)}")
        near(grid.point_data["von_Mises_Pa"][node], math.sqrt(sigma**2 + 3 * tau**2), 1e-12, "von Mises")
        compared += 1
    check(compared > 1000, f"only {compared} places")
    # Plates stand where they are, with their thickness.
    for k, cell in enumerate(quads):
        part, segment = grid.cell_data["part"][k], grid.cell_data["segment"][k]
        if segment not in (1, 2, 3, 4):
            continue
        check(grid.cell_data["thickness_m"][k] == 0.05, "thickness")
        for node in cell:
            s, y, z = grid.points[node]
            place = {1: z - height(s) / 2 + 0.025, 2: z + height(s) / 2 - 0.025, 3: y - 0.175, 4: y + 0.175}[part]
            check(abs(place) < 1e-9, f"part {part} at {(s, y, z)}")
    # The shear flow of both webs is V_z less what the inclined flanges carry; in S1 these are straight.
    rings = {}
    for k, cell in enumerate(quads):
        if grid.cell_data["segment"][k] != 1:
            continue
        a, b = cell[0], cell[3]
        t, length = 0.05, math.dist(grid.points[a], grid.points[b])
        middle = [0.5 * (grid.point_data[of][a] + grid.point_data[of][b])
                  for of in ("normal_stress_Pa", "shear_stress_Pa")]
        ring = rings.setdefault(round(grid.points[a][0], 9), [0.0, 0.0])
        ring[0] += middle[0] * t * length
        if grid.cell_data["part"][k] in (3, 4):
            ring[1] += middle[1] * t * length
            # From the end of a web to the mid-line of the flange the flow goes on.
            for node in (a, b):
                if abs(abs(grid.points[node][2]) - 0.25) < 1e-9:
                    ring[1] += grid.point_data["shear_stress_Pa"][node] * t * 0.025
    shear = {}
    for node in axis:
        shear.setdefault(round(grid.points[node][0], 9), []).append(grid.point_data["V_z_N"][node])
    most = max(abs(v) for of in shear.values() for v in of)
    for s, (force, transverse) in rings.items():
        check(min(abs(force - n) for n, _ in cut[s]) <= 1e-3 * most, f"N of the plates at {s}")
        # The part of V that crosses the flanges' own thickness, I_own/I, is 0.2 %; the flow grows a little on.
        apart = min(abs(transverse - v) for v in shear[s]) / most
        check(apart <= 0.01, f"V of the webs at {s} is {apart:.2g} apart")
    print(f"  beam.vtk: {len(quads)} quads, {compared} places beside Navier's stress")


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        export = pathlib.Path(folder) / "export"
        code, said, results = verify(program, root / "sections/sledge-rig/rig.toml", folder)
        check(code == 1, f"exit code {code}")
        names = sorted(path.name for path in export.iterdir())
        expected = sorted(["beam-elements.csv", "beam.inp", "beam.vtk", "checks.csv", "cut-forces.csv",
                           "loads-1.csv", "loads.toml", "sections.csv", "utilisation.csv"])
        check(names == expected, f"the folder holds {names}")
        check_tables(export, results)
        check_loads(program, export, said, results, 1e-6)
        check_grid(export)
        # In space with three situations; and where a factor is found between the stations.
        for case, limit in (("landing-gear/retraction.toml", 1e-6), ("four-bar-rocker/rocker.toml", 1e-4)):
            _, other_said, other = verify(program, root / "sections" / case, folder)
            check_loads(program, export, other_said, other, limit)
            check(export.joinpath("loads-3.csv").exists() == (limit == 1e-6), f"tables of loads of {case}")
        # Forces at both ends have no name there: neither of them moves along the beam.
        _, other_said, other = verify(program, root / "sections/excavator-boom/boom.toml", folder)
        check_loads(program, export, other_said, other, 1e-4)
        # Of several beams each has a folder of its own.
        _, said, results = verify(program, root / "sections/kinked-boom/boom.toml", folder)
        for name in ("boom", "jib"):
            alone = [of for of in results["checks"] if of["beam"] == name]
            check(len(alone) > 0, f"no checks of beam {name}")
            check(len(table(export / name / "checks.csv")) == len(alone), f"checks.csv of beam {name}")
            passes = all(of["utilisation"] <= 1 for of in alone)
            check_loads(program, export / name, said, {"checks": alone, "verdict": "pass" if passes else "fail"}, 1e-6)
        # What cannot be carried over is said, and what an earlier export left of it is gone.
        code, said, _ = verify(program, root / "sections/sledge-rig/rig-detailed.toml", folder)
        check("loads.toml is not written: pin" in said, f"nothing is said of the pin: {said[-800:]}")
        check(not (export / "loads.toml").exists() and not (export / "loads-1.csv").exists(), "a stale loads.toml")
        check((export / "checks.csv").exists(), "checks.csv is missing")
        file = pathlib.Path(folder) / "file"
        file.write_text("")
        code, _, error = run(program, "verify", root / "sections/sledge-rig/rig.toml", "--out",
                             pathlib.Path(folder) / "none", "--export", file)
        check(code == 4 and "file" in error, f"a file for a folder: exit code {code}, {error}")
    for words in failures[:30]:
        print("FAILED", words)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
