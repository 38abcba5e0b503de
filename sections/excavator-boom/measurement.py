#!/usr/bin/env python3
"""Writes the files of this folder: what the boom does in a working cycle, and what sensors on it
would have read. It stands in for a measurement and knows nothing of boxbeam: one freedom, the angle of
the boom; the cylinder's force from the balance of moments about the boom's foot A.

Usage: measurement.py FOLDER
"""

import csv
import math
import pathlib
import sys

GRAVITY, DENSITY = 9.81, 7850.0
FOOT = (0.55, -0.9)   # of the cylinder, from A [m]
LUG = (2.1, -0.45)    # of the cylinder on the boom: along it, to its left [m]
TIP = 5.2             # of the boom [m]
CYCLE = 12.0          # [s]
# Boxes b x h with flanges 12 and webs 8 mm: width is constant, the height is linear between stations.
STATIONS = [(0.0, 0.34), (2.1, 0.524), (5.2, 0.24)]
WIDTH, FLANGE, WEB = 0.26, 0.012, 0.008
# The boom's angle [deg] and the stick's force on its tip, world axes [kN]: cycloidal steps between.
ANGLE = [(0.0, 0.0), (3.0, 0.0), (6.0, 45.0), (9.0, 45.0), (12.0, 0.0)]
FORCE_X = [(0.0, 0.0), (1.0, 0.0), (1.5, -22.0), (2.5, -22.0), (3.0, 0.0), (12.0, 0.0)]
FORCE_Z = [(0.0, -16.0), (1.0, -16.0), (1.5, -40.0), (2.5, -40.0), (3.0, -34.0), (7.5, -34.0),
           (8.5, -16.0), (12.0, -16.0)]


def area(height):
    return 2.0 * WIDTH * FLANGE + 2.0 * (height - 2.0 * FLANGE) * WEB


def moments_of_mass():
    """Mass, first and second moment about A, by Gauss' rule of three points (exact to degree five)."""
    sums = [0.0, 0.0, 0.0]
    for (a, ha), (b, hb) in zip(STATIONS, STATIONS[1:]):
        middle, half = 0.5 * (a + b), 0.5 * (b - a)
        for point, weight in ((-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9)):
            s = middle + half * point
            dm = DENSITY * area(ha + (hb - ha) * (s - a) / (b - a)) * weight * half
            for k in range(3):
                sums[k] += dm * s ** k
    return sums


def smooth_between(points, t):
    """Value and first two derivatives of cycloidal steps between points, without jumps."""
    for (ta, a), (tb, b) in zip(points, points[1:]):
        if ta <= t <= tb:
            w, x = 2.0 * math.pi / (tb - ta), (t - ta) / (tb - ta)
            d, u = b - a, 2.0 * math.pi * (t - ta) / (tb - ta)
            return (a + d * (x - math.sin(u) / (2.0 * math.pi)),
                    d / (tb - ta) * (1.0 - math.cos(u)), d / (tb - ta) * w * math.sin(u))
    raise ValueError(t)


def linear_between(points, t):
    for (ta, a), (tb, b) in zip(points, points[1:]):
        if ta <= t <= tb:
            return a + (b - a) * (t - ta) / (tb - ta)
    raise ValueError(t)


def turned(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return (c * v[0] - s * v[1], s * v[0] + c * v[1])


def cylinder_length(angle):
    lug = turned(LUG, angle)
    return math.hypot(lug[0] - FOOT[0], lug[1] - FOOT[1])


def readings(t):
    """Forces of cylinder and stick in the boom's axes [N], and the boom's angle [rad]."""
    angle, _, acceleration = (math.radians(v) for v in smooth_between(ANGLE, t))
    _, first, second = moments_of_mass()
    tip = tuple(1e3 * linear_between(of, t) for of in (FORCE_X, FORCE_Z))
    lug = turned(LUG, angle)
    length = cylinder_length(angle)
    along = ((lug[0] - FOOT[0]) / length, (lug[1] - FOOT[1]) / length)
    arm = lug[0] * along[1] - lug[1] * along[0]
    end = turned((TIP, 0.0), angle)
    others = end[0] * tip[1] - end[1] * tip[0] - GRAVITY * first * math.cos(angle)
    force = (second * acceleration - others) / arm
    cylinder = turned((force * along[0], force * along[1]), -angle)
    return cylinder, turned(tip, -angle), angle


def write(path, header, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def main(folder):
    folder = pathlib.Path(folder)
    steps = 48
    write(folder / "cylinder-length.csv", ["time [s]", "length [m]"],
          [[f"{CYCLE * i / steps:g}", f"{cylinder_length(math.radians(smooth_between(ANGLE, CYCLE * i / steps)[0])):.9f}"]
           for i in range(steps + 1)])
    for name, points in (("stick-x", FORCE_X), ("stick-z", FORCE_Z)):
        write(folder / f"{name}.csv", ["time [s]", "force [kN]"], points)
    rate = 50
    rows = []
    for i in range(int(CYCLE * rate) + 1):
        t = i / rate
        cylinder, tip, angle = readings(t)
        rows.append([f"{t:g}", *(f"{v / 1e3:.5f}" for v in (*cylinder, *tip)), "0", "0",
                     f"{math.degrees(angle):.6f}"])
    write(folder / "measured.csv",
          ["time [s]", "cylinder x [kN]", "cylinder z [kN]", "stick x [kN]", "stick z [kN]",
           "foot x [m]", "foot z [m]", "boom angle [deg]"], rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
