"""Beams as shells in CalculiX, an independent finite-element program, beside our stresses: a prismatic box, a
tapered box, a box in space under bending both ways and torsion, and the sledge rig.

Compared in the middle of the elements, where membrane stress is the mean of the integration points: normal
stress along the beam and shear stress around the profile, in webs and in flanges; farther than one height of the section from every place where a
force or couple acts, a plate begins or ends, or the beam is held rigid. Errors of normal
stress are of the largest in the same section, those of shear of the largest in the webs of what is compared; of the
largest in the same section they are printed, too, for shear may be small in a taper whose plates carry it inclined.

Where CalculiX (ccx) is not installed it ends with 77, which CTest counts as skipped.

Usage: calculix.py PROGRAM ROOT
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from exported import Grid, table, verify  # noqa: E402

LIMIT = 0.03
IN_SECTION = "shear stress in the section [Pa]"
DEMANDS = '[material]\nsteel = "S355"\n[strength]\nrequired = 1.0\nshear_lag = false\n'


def box(name, width, height, flange, web):
    return (f'[sections.{name}]\nkind = "box"\nwidth = "{width} mm"\nheight = "{height} mm"\nflange = "{flange} mm"\n'
            f'web = "{web} mm"\n')


PRISMATIC = ('[case]\nname = "prismatic"\nkind = "static"\n[frame]\ngravity = ["0 m/s^2", "-9.81 m/s^2"]\n' + DEMANDS
             + box("a", 300, 500, 14, 10)
             + '[beam]\ndensity = "7850 kg/m^3"\nfrom = ["0 m", "0 m"]\nangle = "0 deg"\n[[beam.segments]]\n'
             'length = "6 m"\nsection = "a"\n[supports.wall]\nkind = "fixed"\nat = "0 m"\n'
             '[loads.tip]\nkind = "force"\nat = "6 m"\nforce = ["300 kN", "-90 kN"]\n')
TAPERED = (PRISMATIC.replace('"prismatic"', '"tapered"').replace('section = "a"', 'from = "b"\nto = "c"')
           + box("b", 360, 700, 14, 10) + box("c", 240, 350, 14, 10))
SPACE = ('[case]\nname = "space"\nkind = "static"\n[frame]\nspace = true\n'
         'gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]\n' + DEMANDS + box("a", 300, 500, 14, 10)
         + '[beam]\ndensity = "7850 kg/m^3"\nfrom = ["0 m", "0 m", "0 m"]\naxis = "x"\nz = "z"\n[[beam.segments]]\n'
         'length = "6 m"\nsection = "a"\n[supports.wall]\nkind = "fixed"\nat = "0 m"\n'
         '[loads.tip]\nkind = "force"\nat = "6 m"\nforce = ["100 kN", "40 kN", "-60 kN"]\n'
         'moment = ["180 kN m", "0 kN m", "0 kN m"]\n')


def stresses(path):
    """Mean stress of every element over its integration points, and the forces at what is held."""
    sums, held, kind = {}, [], ""
    for line in path.read_text().splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] in ("stresses", "forces"):
            kind = words[0]
        elif kind == "stresses":
            of = sums.setdefault(int(words[0]), [0] + [0.0] * 6)
            of[0] += 1
            for k in range(6):
                of[k + 1] += float(words[k + 2])
        elif kind == "forces":
            held.append([float(word) for word in words[1:4]])
    return {element: [value / of[0] for value in of[1:]] for element, of in sums.items()}, held


def imbalance(path):
    """What the nodal forces leave of force, and of moment over the beam's length, over the largest sum."""
    nodes, keyword, sums, largest = {}, "", [0.0] * 6, 0.0
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            keyword = line.split(",")[0] if not line.startswith("**") else keyword
            continue
        words = line.split(",")
        if keyword == "*NODE":
            nodes[int(words[0])] = [float(word) for word in words[1:4]]
        elif keyword == "*CLOAD":
            x, y, z = nodes[int(words[0])]
            force = [0.0, 0.0, 0.0]
            force[int(words[1]) - 1] = float(words[2])
            moment = [y * force[2] - z * force[1], z * force[0] - x * force[2], x * force[1] - y * force[0]]
            for k, value in enumerate(force + moment):
                sums[k] += value
            largest += abs(float(words[2]))
    length = max(x for x, _, _ in nodes.values())
    return max(abs(value) / (largest * (1.0 if k < 3 else length)) for k, value in enumerate(sums))


def compare(program, case, folder, broken, height):
    """Compares one case; `broken`: places besides the ends where the stress is disturbed."""
    code, said, results = verify(program, case, folder)
    export = pathlib.Path(folder) / "export"
    done = subprocess.run(["ccx", "beam"], cwd=export, capture_output=True, text=True, timeout=900,
                          env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
    if not (export / "beam.dat").exists() or "*ERROR" in done.stdout:
        print(done.stdout[-3000:])
        raise SystemExit(f"ccx does not run {case}")
    found, held = stresses(export / "beam.dat")
    length = results["beam"]["length"]
    rows = table(export / "beam-elements.csv")
    sections = {}
    for row in rows:
        s = row["s [m]"]
        if any(abs(s - at) < height(s) for at in (0.0, length, *broken)):
            continue
        sections.setdefault(s, []).append(row)
    largest_shear = max(abs(row[IN_SECTION]) for of in sections.values() for row in of if "web" in row["part"])
    kinds = ("normal", "web shear", "flange shear", "shear of its section's")
    worst = {kind: (0.0, None) for kind in kinds}
    compared = 0
    for s, of in sections.items():
        normal = max(abs(row["normal stress [Pa]"]) for row in of)
        shear = max(abs(row[IN_SECTION]) for row in of if "web" in row["part"])
        for row in of:
            # In the shell's own axes: the first along the beam, the second around the profile, to the left at
            # the bottom and up in the left web.
            along, _, _, around, _, _ = found[int(row["element"])]
            shear_here = around if row["part"] in ("bottom flange", "left web") else -around
            kind_of_shear = "web shear" if "web" in row["part"] else "flange shear"
            apart = shear_here - row[IN_SECTION]
            for kind, error, scale in (("normal", along - row["normal stress [Pa]"], normal),
                                       (kind_of_shear, apart, largest_shear), (kinds[3], apart, shear)):
                if abs(error) / scale > worst[kind][0]:
                    worst[kind] = (abs(error) / scale, (s, row["part"], row["y [m]"], row["z [m]"]))
            compared += 1
    load = max(abs(value) for at in results["beam"]["stations"]
               for key in ("N", "V", "V_z") for value in at.get(key, [0.0]))
    reaction = max(abs(value) for forces in held for value in forces) / load
    name = results["case"]
    print(f"  {name}: {len(rows)} elements, {compared} compared; largest error of normal stress "
          f"{100 * worst['normal'][0]:.2f} %, of shear in webs {100 * worst['web shear'][0]:.2f} %, in flanges "
          f"{100 * worst['flange shear'][0]:.2f} %; reactions {reaction:.1e} of the largest force")
    for kind, (error, place) in worst.items():
        print(f"    {kind}: {100 * error:.2f} % at {place}")
    failures = [f"{name}: {kind} {100 * worst[kind][0]:.2f} %" for kind in kinds[:3] if worst[kind][0] > LIMIT]
    if compared < 60:
        failures.append(f"{name}: only {compared} elements are compared")
    # CalculiX joins plates at an edge by rigid knots, which leave so much; the loads themselves are in balance.
    if reaction > 3e-3:
        failures.append(f"{name}: what is held bears {reaction:.1e} of the largest force")
    left = imbalance(export / "beam.inp")
    if left > 1e-9:
        failures.append(f"{name}: the nodal forces leave {left:.1e} of the largest force")
    Grid(export / "beam.vtk")  # is read without complaint
    return failures


def main():
    if shutil.which("ccx") is None:
        print("skipped: ccx (Debian package calculix-ccx) is not installed")
        return 77
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    failures = []
    with tempfile.TemporaryDirectory() as base:
        base = pathlib.Path(base)
        for name, text, height in (("prismatic", PRISMATIC, lambda s: 0.5),
                                   ("tapered", TAPERED, lambda s: 0.7 - 0.35 * s / 6), ("space", SPACE, lambda s: 0.5)):
            (base / name).mkdir()
            case = base / name / "case.toml"
            case.write_text(text)
            failures += compare(program, case, base / name, [], height)
        (base / "rig").mkdir()

        def height(s):
            if s > 5.2:
                return 0.49
            return 0.6 if s <= 1.5 or s >= 4.2 else 0.6 + 0.4 * ((s - 1.5) / 1.7 if s < 3.2 else 4.2 - s)
        failures += compare(program, root / "sections/sledge-rig/rig.toml", base / "rig",
                            [1.5, 3.2, 4.2, 4.7, 5.2], height)
    for words in failures:
        print("FAILED", words)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
