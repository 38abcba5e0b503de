"""The Python module as its users call it: results beside `boxbeam` itself, closed forms, errors with their place, threads.

Usage: python_module.py PROGRAM ROOT FOLDER    FOLDER: in which the package boxbeam stands

Exit code 77: numpy or the module is missing, so that nothing was tested.
"""
import json
import pathlib
import pickle
import resource
import subprocess
import sys
import tempfile
import threading
import time

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, sys.argv[3])
sys.dont_write_bytecode = True
try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed (Debian: python3-numpy)")
    sys.exit(77)
try:
    import boxbeam
except ImportError as error:
    print(f"skipped: {error}; build with -DBOXBEAM_PYTHON=ON for the Python that runs this")
    sys.exit(77)
import tomllib  # noqa: E402

RIG = ROOT / "sections/sledge-rig/rig.toml"
failures = []


def check(holds, words):
    if not holds:
        failures.append(words)


def program(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    check(done.returncode <= 1, f"{arguments}: exit code {done.returncode}, {done.stderr[-400:]}")
    return json.loads(done.stdout)


def raised(kind, call):
    try:
        call()
    except kind as error:
        return error
    check(False, f"{kind.__name__} was not raised")
    return None


def check_verify(folder):
    stroke = {"drivers.exciter.amplitude": "0.14 m"}
    rig = boxbeam.verify(RIG, set=stroke)
    same = program("verify", RIG, "--set", "drivers.exciter.amplitude=0.14 m", "--out", folder, "--no-plots", "--no-pdf",
                   "--no-html", "--json", "-")
    check(rig.to_dict() == {**same, "input_sha256": rig["input_sha256"]}, "results are not those of the program")
    check(rig.verdict == same["verdict"] and rig.passes, "verdict")
    check(rig.checks[0].utilisation == same["checks"][0]["utilisation"] and rig.checks[0].passes, "first check")
    check(rig.governing["fatigue"].safety_factor == same["governing"]["fatigue"]["safety_factor"], "governing")
    # But for round-off, by which the order of what is used alike does not hang.
    check(all(of.utilisation <= rig.governing[of.criterion].utilisation * (1 + 1e-8) for of in rig.checks),
          "a criterion is not governed by its most used check")
    with open(RIG, "rb") as file:
        strength = tomllib.load(file)
    del strength["fatigue"]
    only = boxbeam.verify(strength, folder=RIG.parent).governing
    check("yield" in only and "fatigue" not in only, f"criteria of strength only: {list(only)}")
    check(rig.mass == same["beam"]["mass"], "mass")
    stations = rig.stations
    check(stations["M"].shape == (len(same["beam"]["stations"]), 2), f"shape of M {stations['M'].shape}")
    check(stations["M"][3, 1] == same["beam"]["stations"][3]["M"][1], "M at a station")
    check(bool(np.all(np.diff(stations["s"]) >= 0)), "stations go along the beam")
    # The moment falls to nothing at free ends, whatever the case.
    check(abs(stations["M"][0]).max() < 1e-6 * abs(stations["M"]).max(), "M at the beam's start")
    again = pickle.loads(pickle.dumps(rig))
    check(again.to_json() == rig.to_json() and repr(again) == repr(rig), "a result in another process")
    # The same case as a dictionary.
    case = tomllib.loads(RIG.read_text(encoding="utf-8"))
    case["drivers"]["exciter"]["amplitude"] = "0.14 m"
    other = boxbeam.verify(case, folder=RIG.parent)
    check(other["checks"] == rig["checks"], "a case as a dictionary has other checks")


def check_errors():
    error = raised(boxbeam.InputError, lambda: boxbeam.verify(RIG, set={"drivers.exciter.amplitude": "0.14 s"}))
    check(isinstance(error, ValueError) and isinstance(error, boxbeam.Error), "kinds of InputError")
    with tempfile.TemporaryDirectory() as name:
        broken = pathlib.Path(name) / "broken.toml"
        broken.write_text(RIG.read_text(encoding="utf-8").replace('amplitude = "0.25 m"', 'amplitude = "0.25 s"', 1),
                          encoding="utf-8")
        line = next(i for i, text in enumerate(broken.read_text(encoding="utf-8").split("\n"), 1) if '"0.25 s"' in text)
        error = raised(boxbeam.InputError, lambda: boxbeam.verify(broken))
        check((error.file, error.line, error.key) == (str(broken), line, "amplitude"),
              f"place of the error: {error.file}, {error.line}, {error.key}")
        check(len(error.problems) == 1 and error.hint != "", f"problems: {error.problems}")
        again = pickle.loads(pickle.dumps(error))
        check(again.problems == error.problems and str(again) == str(error), "an error in another process")
    case = tomllib.loads(RIG.read_text(encoding="utf-8"))
    case["drivers"]["exciter"]["amplitude"] = "0.25 s"
    error = raised(boxbeam.InputError, lambda: boxbeam.verify(case))
    check(error.key == "amplitude" and error.line > 1, f"in a dictionary: {error.key}, {error.line}")
    raised(boxbeam.InputError, lambda: boxbeam.verify("missing.toml"))
    raised(TypeError, lambda: boxbeam.verify({"case": {"name": None}}))
    # The beam reaches nowhere: no assembly.
    error = raised(boxbeam.AnalysisError, lambda: boxbeam.verify(RIG, set={"drivers.exciter.amplitude": "20 m"}))
    check(isinstance(error, RuntimeError) and error.what != "", f"AnalysisError: {error and error.what}")


def same_columns(one, other):
    if isinstance(one, dict):
        return isinstance(other, dict) and one.keys() == other.keys() and all(same_columns(one[k], other[k]) for k in one)
    if isinstance(one, np.ndarray) and one.dtype == float:
        return np.array_equal(one, np.array(other, dtype=float), equal_nan=True)
    return list(one) == list(other)


def check_motion():
    times = np.linspace(0.0, 1.0, 5)
    motion = boxbeam.motion(RIG, times)
    same = program("motion", RIG, *(f"--at={time!r}" for time in times.tolist()), "--json", "-")
    check(motion.to_dict() == same, "motion is not that of the program")
    check(motion.kind == "planar" and np.array_equal(motion.time, times), "instants")
    bodies = motion.columns["bodies"]
    check(bodies["beam"]["ax"].shape == (5,), "accelerations as an array")
    check(bodies["beam"]["omega"][2] == same["states"][2]["bodies"]["beam"]["omega"], "omega at an instant")
    check(not bodies["beam"]["ax"].flags["OWNDATA"], "numbers of a motion are copied")
    # What is made of the document is what comes without it: numbers, vectors, words, what is not known.
    gear = ROOT / "sections/landing-gear/retraction.toml"
    for of in (motion, boxbeam.motion(gear, [0.0, 0.5, 1.0]), boxbeam.motion(RIG, [])):
        read_back = pickle.loads(pickle.dumps(of))
        check(same_columns(of.columns, read_back.columns) and of.to_dict() == read_back.to_dict(), "columns of a document")
    raised(ValueError, lambda: boxbeam.motion(RIG, [[0.0, 1.0]]))


def check_section():
    box = boxbeam.section("box 400x600 flange 50 web 50")
    area, inertia = 0.4 * 0.6 - 0.3 * 0.5, (0.4 * 0.6 ** 3 - 0.3 * 0.5 ** 3) / 12
    check(abs(box["area"] / area - 1) < 1e-12 and abs(box["I_y"] / inertia - 1) < 1e-12, "a box by hand")
    forced = boxbeam.section("box 600x1224 flange 12 web 8", forces={"N": -600e3, "M_y": 1.5e6})
    same = program("section", "box 600x1224 flange 12 web 8", "--forces", "N = -600 kN, M_y = 1500 kN m", "--json", "-")
    check(forced.to_dict() == same, "a section under forces is not that of the program")
    raised(boxbeam.InputError, lambda: boxbeam.section("box 400x600"))
    raised(ValueError, lambda: boxbeam.section("RHS 200x100x8", forces={"Q": 1.0}))


def check_fatigue():
    # ASTM E1049-85, figure 6: -2, 1, -3, 5, -1, 3, -4, 4, -2.
    history = np.array([-2, 1, -3, 5, -1, 3, -4, 4, -2], dtype=float)
    cycles = boxbeam.rainflow(history)
    found = {}
    for size, count in zip(cycles.range, cycles.count):
        found[size] = found.get(size, 0.0) + count
    check(found == {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}, f"ASTM's example: {found}")
    # One range of 100 MPa on detail 100: 2e6 cycles endured, by definition.
    result = boxbeam.fatigue(np.array([0.0, 100e6] * 50 + [0.0]), "100", repetitions=20000)
    check(abs(result.damage - 0.5) < 1e-12, f"damage {result.damage}")
    check(abs(result.life - 40000) < 1e-6, f"life {result.life}")
    check(abs(result.equivalent_range / (100e6 * 0.5 ** (1 / 3)) - 1) < 1e-12, "equivalent range")
    check(abs(result.safety_factor - 2 ** (1 / 3)) < 1e-3, f"factor {result.safety_factor}")
    double = boxbeam.damage(result.cycles, "100", gamma_Mf=2.0)[0] / boxbeam.damage(result.cycles, "100")[0]
    check(abs(double - 8) < 1e-9, f"the partial factor to the third power: {double}")
    raised(boxbeam.InputError, lambda: boxbeam.rainflow(np.array([1.0, np.nan])))
    raised(boxbeam.InputError, lambda: boxbeam.rainflow(history, counting="rain"))
    raised(boxbeam.InputError, lambda: boxbeam.fatigue(history, "101"))
    raised(ValueError, lambda: boxbeam.rainflow(np.zeros((2, 2))))
    # What is contiguous is not copied: constant memory, whatever the length.
    flat = np.zeros(30_000_000)
    flat[1::2] = 1.0
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    boxbeam.rainflow(flat[:1000])
    flat[:] = 0.0
    boxbeam.rainflow(flat)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    check(grown < 60_000, f"{grown} kB more for an array of 240 MB")
    view = np.arange(10.0)[::2]
    check(boxbeam.rainflow(view).range.tolist() == [8.0], "an array with gaps")


def check_sweep():
    strokes = np.array([0.10, 0.14, 0.25, 20.0])
    swept = boxbeam.sweep(RIG, {"drivers.exciter.amplitude": (strokes, "m")},
                          ["verdict", "governing", "utilisation", "fatigue.safety_factor", "beam.mass"], threads=2)
    check(swept.ok.tolist() == [True, True, True, False] and swept.status[0] == "ok", f"status {swept.status}")
    check(swept["verdict"][:3] == ["pass", "pass", "fail"], f"verdicts {swept['verdict']}")
    for i, stroke in enumerate(strokes[:3]):
        one = boxbeam.verify(RIG, set={"drivers.exciter.amplitude": f"{stroke} m"})
        check(swept["fatigue.safety_factor"][i] == one.governing["fatigue"].safety_factor, f"factor at {stroke}")
        check(swept["utilisation"][i] == one.checks[0].utilisation, f"use at {stroke}")
    check(bool(np.isnan(swept["beam.mass"][3])) and swept.units == {"beam.mass": "kg"}, f"units {swept.units}")
    alone = boxbeam.sweep(RIG, {"drivers.exciter.amplitude": (strokes, "m")}, ["utilisation"], threads=1)
    check(np.array_equal(alone["utilisation"], swept["utilisation"], equal_nan=True), "threads change results")
    words = boxbeam.sweep(RIG, {"drivers.exciter.amplitude": ["0.1 m"], "fatigue.cycles": np.array([1e7])})
    check(words.ok.all() and words["verdict"] == ["pass"], f"texts and numbers: {words.status}")
    error = raised(boxbeam.InputError, lambda: boxbeam.sweep(RIG, {"fatigue.cycles": [1e7]}, ["fatige.safety_factor"]))
    check("fatige" in str(error), f"an unknown column: {error}")
    raised(ValueError, lambda: boxbeam.sweep(RIG, {"a": [1], "b": [1, 2]}))
    raised(TypeError, lambda: boxbeam.sweep(RIG, {"fatigue.cycles": [1e7]}, "utilisation"))
    # What is wrong with a key is wrong with every design; what is wrong with a value is not.
    for key, values, said in (("drivers.exciter.amplitud", (strokes, "m"), "drivers.exciter.amplitude"),
                              ("drivers.exciter.amplitude", (strokes, "kg"), "the case has"),
                              ("drivers.exciter.amplitude", strokes, "the case has")):
        error = raised(boxbeam.InputError, lambda: boxbeam.sweep(RIG, {key: values}))
        check(said in str(error), f"a wrong key: {error}")
    later = boxbeam.sweep(RIG, {"drivers.exciter.amplitude": (strokes[::-1], "m"), "strength.gamma_M2": [1.25] * 4})
    check(later.ok.tolist() == [False, True, True, True], f"a first design that is none: {later.status}")


def check_parquet(folder):
    """Tables as columns of a file: written, read by pyarrow itself, the same numbers, texts and units."""
    try:
        import pyarrow.parquet
    except ImportError:
        print("  pyarrow is not installed: Parquet is not tested")
        return
    strokes = np.array([0.10, 0.25, 20.0])
    swept = boxbeam.sweep(RIG, {"drivers.exciter.amplitude": (strokes, "m")}, ["verdict", "utilisation", "beam.mass"])
    swept.to_parquet(folder / "swept.parquet")
    table = pyarrow.parquet.read_table(folder / "swept.parquet")
    check(table.column("beam.mass").to_pylist()[:2] == swept["beam.mass"][:2].tolist(), "masses")
    check(table.column("beam.mass").null_count == 1, "a design without a mass")
    check(table.column("status").to_pylist() == swept.status and table.column("verdict").to_pylist() == swept["verdict"],
          "texts")
    check(table.schema.field("beam.mass").metadata == {b"unit": b"kg"}, "unit of the mass")
    study = folder / "study.toml"
    study.write_text(f'[study]\ncase = "{RIG}"\n[variables.stroke]\nkey = "drivers.exciter.amplitude"\n'
                     'values = ["0.1 m", "0.25 m", "20 m"]\n[results]\ncolumns = ["verdict", "beam.mass"]\n')
    subprocess.run([PROGRAM, "sweep", study, "--out", folder / "study", "--quiet"], check=True, capture_output=True)
    path = boxbeam.study_to_parquet(folder / "study")
    table = pyarrow.parquet.read_table(path)
    check(path == str(folder / "study/rows.parquet"), f"path {path}")
    check(table.column_names == ["design", "stroke", "verdict", "beam.mass", "status"], f"columns {table.column_names}")
    check(table.column("design").to_pylist() == [1, 2, 3] and table.column("stroke").to_pylist() == [0.1, 0.25, 20.0],
          "numbers of designs")
    check(table.column("beam.mass").to_pylist() == [swept["beam.mass"][0], swept["beam.mass"][1], None], "masses of a study")
    check(table.column("verdict").to_pylist() == ["pass", "fail", ""], "verdicts of a study")
    check(table.schema.field("stroke").metadata == {b"unit": b"m"}, "unit of the stroke")


def check_lock():
    """While one thread verifies others of Python go on."""
    ticks = 0
    done = threading.Event()

    def verify():
        boxbeam.sweep(RIG, {"drivers.exciter.amplitude": [f"{x} m" for x in np.linspace(0.1, 0.2, 20)]}, threads=1)
        done.set()

    start = time.monotonic()
    thread = threading.Thread(target=verify)
    thread.start()
    while not done.wait(0.005):
        ticks += 1
    thread.join()
    took = time.monotonic() - start
    check(ticks > 20 * min(took, 1.0), f"only {ticks} turns of another thread in {took:.1f} s")


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_verify(pathlib.Path(folder))
        check_parquet(pathlib.Path(folder))
    for one in (check_errors, check_motion, check_section, check_fatigue, check_sweep, check_lock):
        start = time.monotonic()
        one()
        print(f"  {one.__name__}: {time.monotonic() - start:.1f} s")
    for words in failures[:30]:
        print("FAILED", words)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
