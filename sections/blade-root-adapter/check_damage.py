#!/usr/bin/env python3
"""The governing checks of adapter.toml once more, with nothing of boxbeam: the file by weio, the stress by N/A and
M/W of a round tube, cycles by the package rainflow, damage by EN 1993-1-9 written down here.

    python3 -m venv /tmp/venv && /tmp/venv/bin/pip install weio==2.0.0 rainflow==3.2.0
    /tmp/venv/bin/python sections/blade-root-adapter/check_damage.py
"""

import pathlib
from math import pi

import numpy as np
import rainflow
from weio.fast_output_file import FASTOutputFile

REPETITIONS, CATEGORY, GAMMA_MF = 2e4, 56.0, 1.35
OUTSIDE, WALL = 240.0, 10.0                                     # mm, at the blade's flange
INSIDE = OUTSIDE - 2 * WALL
AREA = pi / 4 * (OUTSIDE**2 - INSIDE**2)
MODULUS = pi / 32 * (OUTSIDE**4 - INSIDE**4) / OUTSIDE


def cycles_to_failure(stress_range):
    """EN 1993-1-9, 7.1(3): slope 3 to 5e6 cycles, 5 to 1e8, nothing below."""
    reference = CATEGORY / GAMMA_MF
    knee = reference * (2 / 5) ** (1 / 3)
    if stress_range >= knee:
        return 2e6 * (reference / stress_range) ** 3
    return 5e6 * (knee / stress_range) ** 5 if stress_range >= knee * (5 / 100) ** (1 / 5) else np.inf


def damage(history, factor=1.0):
    """Of all repetitions; the record repeats, so it is counted from its largest value round to it."""
    turned = np.roll(history[:-1], -int(np.argmax(history[:-1])))
    turned = np.append(turned, turned[0])
    return sum(REPETITIONS * count / cycles_to_failure(factor * size)
               for size, _, count, _, _ in rainflow.extract_cycles(turned))


def largest_factor(history):
    low, high = 0.01, 100.0
    while high / low > 1 + 1e-10:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if damage(history, middle) <= 1 else (low, middle)
    return low


record = FASTOutputFile(str(pathlib.Path(__file__).with_name("root-loads.outb"))).toDataFrame()
axial = record["RootFzc1_[kN]"].to_numpy() * 1e3
about_y, about_z = record["RootMxc1_[kN-m]"].to_numpy() * 1e6, record["RootMyc1_[kN-m]"].to_numpy() * 1e6


def stress(angle):
    """Normal stress [MPa] at the blade's flange, at the outside of the wall at an angle from +y to +z."""
    return axial / AREA + (about_y * np.sin(angle) - about_z * np.cos(angle)) / MODULUS


angles = np.radians(np.arange(0.0, 360.0, 0.5))
print(f"A = {AREA:.1f} mm^2, W = {MODULUS:.4g} mm^3")
largest = axial / AREA + np.hypot(about_y, about_z) / MODULUS
i = int(np.argmax(largest))
print(f"yield: t = {record['Time_[s]'][i]:.2f} s, N = {axial[i] / 1e3:.3f} kN, edgewise {about_y[i] / 1e6:.3f}, "
      f"flapwise {about_z[i] / 1e6:.3f} kN m: {largest[i]:.2f} MPa, factor {355 / largest[i]:.4f}")
factors = [largest_factor(stress(angle)) for angle in angles]
worst = angles[int(np.argmin(factors))]
history = stress(worst)
print(f"fatigue: at {np.degrees(worst):.1f} deg, range {np.ptp(history):.2f} MPa, "
      f"damage {damage(history):.4f}, factor {min(factors):.5f}")
