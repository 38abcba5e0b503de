"""boxbeam: strength and fatigue of welded beams moved by a mechanism, from Python.

    import boxbeam
    rig = boxbeam.verify("sections/sledge-rig/rig.toml", set={"drivers.exciter.amplitude": "0.14 m"})
    rig.verdict, rig.governing["fatigue"].safety_factor, rig.stations["M"]

A case is the path of its file, or a dictionary of what would stand in it. Values of a case are texts with their unit,
"8 mm", as in the file; results and arrays are in SI units. The interpreter's lock is released while the program works.
"""

import os

import numpy as np

from . import _core, _toml
from ._errors import AnalysisError, Error, InputError, OutputError, Problem
from .results import Check, Cycles, Fatigue, Motion, Section, Sweep, Verification, study_to_parquet

__version__ = _core.version
__all__ = ["AnalysisError", "Check", "Cycles", "Error", "Fatigue", "InputError", "Motion", "OutputError", "Problem",
           "Section", "Sweep", "Verification", "damage", "fatigue", "motion", "rainflow", "section", "study_to_parquet",
           "sweep", "verify"]


def _case(case, folder):
    """The path of a case and, where it is a dictionary, its text."""
    if isinstance(case, dict):
        return os.path.join(os.fspath(folder), "case.toml") if folder else "case.toml", _toml.document(case)
    if folder is not None:
        raise TypeError("folder is that of a case given as a dictionary")
    return os.fspath(case), None


def _settings(values):
    return [f"{key}={_toml.value(value)}" for key, value in (values or {}).items()]


def verify(case, set=None, *, folder=None):
    """Verifies a case, with other values of keys where `set` gives them, {"sections.A1.flange": "45 mm"}.

    folder: of a dictionary, from which files that it names are found. Raises InputError and AnalysisError."""
    path, text = _case(case, folder)
    return Verification(_core.verify(path, text, _settings(set)))


def motion(case, times=(), set=None, *, folder=None):
    """Moves the mechanism alone, at instants [s]; without any at twelve of its period."""
    path, text = _case(case, folder)
    return Motion(_core.Moved(path, text, _settings(set), np.asarray(times, dtype=float)))


def section(profile, steel="S355", forces=None):
    """Properties of a section: "RHS 200x100x8", "box 400x600 flange 50 web 50", "FILE.toml:SECTION".

    forces: under which its plates are judged, {"N": -600e3, "M_y": 1.5e6} [N, N m]."""
    names = ("N", "V_y", "V_z", "T", "M_y", "M_z")
    unknown = [name for name in forces or {} if name not in names]
    if unknown:
        raise ValueError(f"there is no cut force {unknown[0]!r}; known are {', '.join(names)}")
    values = [float((forces or {}).get(name, 0.0)) for name in names]
    return Section(_core.section([profile], steel, values, forces is not None))


def rainflow(history, counting="astm", residue="half-cycles"):
    """Cycles of a history of stress [Pa]; counting: "astm", "4-point", "periodic"; residue, of open cycles of 4-point:
    "half-cycles", "repeated", "discard". A contiguous array of doubles is read where it is."""
    return Cycles(*_core.rainflow(history, counting, residue))


def damage(cycles, detail, *, thickness=None, gamma_Ff=1.0, gamma_Mf=1.0, loading="spectrum", stress_relieved=False,
           shear=False):
    """Damage of cycles by Palmgren and Miner, and what follows of it: (damage, safety factor on the loads, equivalent
    range of 2e6 cycles [Pa], name of the curve). detail: "100", "8.2/6", "DNV-RP-C203 air:D"; thickness of the plate [m];
    loading: "spectrum" or "constant"."""
    return _core.damage(cycles.range, cycles.mean, cycles.count, str(detail), thickness, gamma_Ff, gamma_Mf, loading,
                        stress_relieved, shear)


def fatigue(history, detail, *, repetitions=1.0, counting="astm", residue="half-cycles", **more):
    """What a history of stress [Pa] does to a detail within so many repetitions of it; `more` is that of `damage`."""
    cycles = rainflow(history, counting, residue)
    if not (repetitions > 0.0 and np.isfinite(repetitions)):
        raise InputError("repetitions are not above zero", [("", 0, 0, "", "repetitions are not above zero", "")])
    life = Cycles(cycles.range, cycles.mean, cycles.count * repetitions)
    total, factor, equivalent, curve = damage(life, detail, **more)
    return Fatigue(cycles, total, factor, equivalent, repetitions / total if total > 0.0 else float("inf"), curve)


def _design_values(values):
    """The values of a key over all designs as texts of the case: texts, numbers, or (numbers, unit)."""
    unit = None
    if isinstance(values, tuple) and len(values) == 2 and isinstance(values[1], str):
        values, unit = values
    if unit is not None:
        return [_toml.text(f"{float(value)!r} {unit}") for value in np.asarray(values, dtype=float)]
    return [_toml.value(value) for value in (values.tolist() if isinstance(values, np.ndarray) else values)]


def sweep(case, designs, columns=("verdict", "utilisation"), *, threads=0, folder=None):
    """Verifies a case once for each design: {key: values}, as many values of each key, texts or (numbers, unit):
    {"drivers.exciter.amplitude": (np.linspace(0.1, 0.3, 9), "m")}.

    columns: "verdict", "governing", "utilisation", "effective_section.utilisation" and the like of every criterion, and keys
    of results.json such as "fatigue.safety_factor" or "beam.mass".
    threads: how many designs are verified at once; 0: as many as the machine can. A design that cannot be verified is an
    entry of `status`, and raises nothing; a key that the case has not raises InputError before any is."""
    path, text = _case(case, folder)
    values = {key: _design_values(of) for key, of in designs.items()}
    counts = {len(of) for of in values.values()}
    if len(counts) != 1:
        raise ValueError("every key has as many values as there are designs, and there is one key at least")
    settings = [[f"{key}={of[i]}" for key, of in values.items()] for i in range(counts.pop())]
    if isinstance(columns, str):
        raise TypeError(f"columns is a list of names, [{columns!r}]")
    columns = list(columns)
    results, units, status = _core.sweep(path, text, list(values), settings, columns, threads)
    return Sweep(dict(zip(columns, results)), {name: unit for name, unit in zip(columns, units) if unit}, status)
