"""The sledge rig, positions to reactions: boxbeam, Simbody, scipy and plain Newton in numpy.

Reference: the independent calculation of tests/validation (circles in closed form, forces body by
body), here with 30 digits.
"""
import sys
from functools import lru_cache
from pathlib import Path

import mpmath
import numpy as np
import scipy.linalg
import scipy.optimize

from measure import Refusal, chart, point, series, smallest_error, take_times, timed
from pinned_bodies import PinnedBodies

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "validation"))
import independent_sledge_rig as rig  # noqa: E402

mpmath.mp.dps = 30
rig.cmath = rig.math = mpmath  # the same calculation with 30 digits

BEAM, UPPER_ROD, BLADE, LOWER_ROD, SLEDGE = range(5)
PINS = ("O", "B", "A", "C", "E")
INSTANTS = 96
REPETITIONS = 9


class Truth:
    """Places of B and E and forces of the pins (on the first body of each) at a time."""

    def __init__(self, data, rod=rig.UPPER_ROD, amplitude=rig.BLADE_AMPLITUDE):
        self.omega, self.period = data["omega"], data["period"]
        self.rod, self.amplitude = rod, amplitude
        assert abs(rig.BEAM_MASS / data["beam_mass"] - 1) < 1e-14

    def _set(self):
        rig.OMEGA, rig.UPPER_ROD, rig.BLADE_AMPLITUDE = self.omega, self.rod, self.amplitude
        rig.motion.cache_clear()

    @lru_cache(maxsize=None)
    def places(self, time):
        """None where the linkage cannot reach."""
        self._set()
        _, _, b, _, e = rig.motion(mpmath.mpf(time))
        blade = rig.BLADE_MEAN + self.amplitude * mpmath.sin(self.omega * mpmath.mpf(time))
        distance = mpmath.hypot(blade, rig.BLADE_HEIGHT)
        arm = rig.LENGTH - rig.PIVOT
        if not arm - self.rod <= distance <= arm + self.rod:
            return None
        return b.v, e.v

    def forces(self, time):
        self._set()
        state = rig.motion(mpmath.mpf(time))
        _, a, b, c, e = state
        at_c, at_o, at_b, _ = rig.joint_forces(state)
        at_a = rig.UPPER_ROD_MASS * ((a.dd + b.dd) / 2 - rig.GRAVITY) + at_b
        at_e = rig.LOWER_ROD_MASS * ((c.dd + e.dd) / 2 - rig.GRAVITY) + at_c
        return at_o, -at_b, at_a, -at_c, at_e


class NumpyRig:
    """The rig in numpy with 15 unknowns; positions by `solve(f, jacobian, start) -> q`."""

    def __init__(self, data, solve, rod=rig.UPPER_ROD, amplitude=rig.BLADE_AMPLITUDE):
        to_b = rig.LENGTH - rig.PIVOT - rig.BEAM_CENTRE
        to_o, to_c = -rig.BEAM_CENTRE, -rig.PIVOT - rig.BEAM_CENTRE
        lower = rig.LOWER_ROD
        self.omega, self.amplitude, self.solve = data["omega"], amplitude, solve
        self.to_b, self.rod = to_b, rod
        self.bodies = PinnedBodies(
            masses=[(data["beam_mass"], data["beam_inertia"]),
                    (rig.UPPER_ROD_MASS, rig.UPPER_ROD_MASS * rod**2 / 12), (0.0, 0.0),
                    (rig.LOWER_ROD_MASS, rig.LOWER_ROD_MASS * lower**2 / 12),
                    (rig.SLEDGE_MASS, 0.0)],
            pins=[(BEAM, (to_o, 0), -1, (0, 0)), (UPPER_ROD, (-rod / 2, 0), BEAM, (to_b, 0)),
                  (UPPER_ROD, (rod / 2, 0), BLADE, (0, 0)),
                  (LOWER_ROD, (-lower / 2, 0), BEAM, (to_c, 0)),
                  (LOWER_ROD, (lower / 2, 0), SLEDGE, (0, 0))],
            fixed=[3 * BLADE, 3 * BLADE + 1, 3 * BLADE + 2, 3 * SLEDGE + 1, 3 * SLEDGE + 2],
            gravity=rig.GRAVITY.imag)
        self.rates = np.zeros(self.bodies.rows)
        self.accelerations = np.zeros(5)
        self.values = np.array([0.0, rig.BLADE_HEIGHT, 0.0, rig.RAIL_HEIGHT, 0.0])

    def posture(self, places, time):
        """All coordinates where B and E are known."""
        b, e = complex(places[0]), complex(places[1])
        a = complex(self.blade(time)[0], rig.BLADE_HEIGHT)
        axis = b / abs(b)
        c = -rig.PIVOT * axis
        bodies = [(rig.BEAM_CENTRE * axis, axis), ((a + b) / 2, a - b), (a, 1), ((c + e) / 2, e - c),
                  (e, 1)]
        return np.array([x for p, d in bodies for x in (p.real, p.imag, np.angle(d))])

    def blade(self, time):
        s, c = np.sin(self.omega * time), np.cos(self.omega * time)
        return (rig.BLADE_MEAN + self.amplitude * s, self.amplitude * self.omega * c,
                -self.amplitude * self.omega**2 * s)

    def find(self, time, start):
        """Everything of the instant from a rough position; returns the pins' forces."""
        x, rate, acceleration = self.blade(time)
        self.values[0] = x
        q = self.solve(lambda q: self.bodies.equations(q, self.values), self.bodies.jacobian, start)
        factors = scipy.linalg.lu_factor(self.bodies.jacobian(q), check_finite=False)
        self.rates[10] = rate
        v = scipy.linalg.lu_solve(factors, self.rates, check_finite=False)
        self.accelerations[0] = acceleration
        gamma = self.bodies.acceleration_side(q, v, self.accelerations)
        a = scipy.linalg.lu_solve(factors, gamma, check_finite=False)
        multipliers = scipy.linalg.lu_solve(
            factors, self.bodies.weight - self.bodies.mass * a, trans=1, check_finite=False)
        self.time, self.q, self.v, self.a = time, q, v, a
        return -multipliers[:10]

    def advance(self, time):
        dt = time - self.time
        return self.find(time, self.q + dt * (self.v + 0.5 * dt * self.a))

    def places(self):
        return np.concatenate([self.bodies.place(self.q, BEAM, (self.to_b, 0.0)),
                               self.q[3 * SLEDGE:3 * SLEDGE + 2]])


def newton(tolerance):
    """Plain Newton's method: until the step is below the tolerance, 50 at the most."""
    def solve(f, jacobian, q):
        for _ in range(50):
            try:
                step = np.linalg.solve(jacobian(q), f(q))
            except np.linalg.LinAlgError as error:
                raise Refusal(str(error)) from error
            q = q - step
            if np.abs(step).max() < tolerance:
                return q
        raise Refusal("no convergence in 50 iterations")
    return solve


def fsolve(tolerance):
    def solve(f, jacobian, q):
        x, _, status, message = scipy.optimize.fsolve(f, q, fprime=jacobian, xtol=tolerance,
                                                      full_output=True)
        if status != 1:
            raise Refusal(message)
        return x
    return solve


def levenberg_marquardt(tolerance):
    def solve(f, jacobian, q):
        found = scipy.optimize.root(f, q, jac=jacobian, method="lm", options={"xtol": tolerance})
        # A minimum of the squares is a success to it, a root or not: its user has to look.
        if not found.success or np.abs(found.fun).max() > 1e-10:
            raise Refusal(found.message if not found.success else "the residual is not zero")
        return found.x
    return solve


SCIPY = (("numpy, plain Newton, 15 unknowns", newton),
         ("scipy fsolve with Jacobian, 15 unknowns", fsolve),
         ("scipy root, method lm, 15 unknowns", levenberg_marquardt))
SIMBODY = (("Simbody, compact tree, predicted", {"tree": True, "predicted": True}),
           ("Simbody, compact tree, from the last", {"tree": True, "predicted": False}),
           ("Simbody, planar joints, predicted", {"tree": False, "predicted": True}),
           ("Simbody, planar joints, from the last", {"tree": False, "predicted": False}))


def follow(data, truth, solve, count):
    """Rows (B, E, forces) of the instants of a period in numpy; a refusal ends them."""
    own = NumpyRig(data, solve, truth.rod, truth.amplitude)
    rows = []
    try:
        own.find(0.0, own.posture(truth.places(0.0), 0.0))
        for i in range(1, count + 1):
            forces = own.advance(data["period"] * i / count)
            rows.append(np.concatenate([own.places(), forces]))
    except Refusal as error:
        return {"rows": rows, "refused": str(error)}
    return {"rows": rows}


class Errors:
    """Largest errors over a period, against the truth."""

    def __init__(self, data, count):
        truth = Truth(data)
        times = [data["period"] * i / count for i in range(1, count + 1)]
        self.places = [truth.places(time) for time in times]
        self.forces = [truth.forces(time) for time in times]
        self.largest = [max(abs(f[j]) for f in self.forces) for j in range(len(PINS))]

    def of(self, rows):
        """Of B and E relative to the beam's length, of forces relative to the pin's largest."""
        place = force = mpmath.mpf(0)
        for row, places, forces in zip(rows, self.places, self.forces):
            found = [mpmath.mpc(float(x), float(y)) for x, y in zip(row[0::2], row[1::2])]
            place = max(place, *(abs(f - p) for f, p in zip(found[:2], places)))
            force = max(force, *(abs(f - p) / m
                                 for f, p, m in zip(found[2:], forces, self.largest)))
        return float(place / rig.LENGTH), float(force)


def charts(library, instants=INSTANTS, repetitions=REPETITIONS):
    data = library.ask("sledge", what="data")
    errors = Errors(data, instants)
    truth = Truth(data)
    place_series, force_series, timers = [], [], []

    def add(method, settings, yardstick=True):
        """`settings`: (words, parameter, answer, timer, default)."""
        place_points, force_points = [], []
        for words, parameter, answer, timer, default in settings:
            if "refused" in answer:
                both = [point(words, parameter, failure=answer["refused"], default=default)
                        for _ in range(2)]
            else:
                both = [point(words, parameter, error=error, default=default)
                        for error in errors.of(answer["rows"])]
                timers.append((both, timer))
            place_points.append(both[0])
            force_points.append(both[1])
        place_series.append(series(method, place_points, yardstick))
        force_series.append(series(method, force_points, yardstick))

    def in_library(**way):
        turns = max(1, (4000 if way["way"] == "boxbeam" else 500) // instants)
        answer = library.ask("sledge", what="followed", instants=instants, **way)
        return answer, lambda: library.ask("sledge", what="time", instants=instants, turns=turns,
                                           **way)["seconds"]

    def in_numpy(solve):
        answer = follow(data, truth, solve, instants)

        def one_turn():
            own = NumpyRig(data, solve)
            own.find(0.0, own.posture(truth.places(0.0), 0.0))
            for i in range(1, instants + 1):
                own.advance(data["period"] * i / instants)
        return answer, lambda: timed(one_turn) / instants

    add("boxbeam, sparse order",
        [("to round-off", 1e-15, *in_library(way="boxbeam"), True)], yardstick=False)
    add("boxbeam, dense", [("to round-off", 1e-15, *in_library(way="boxbeam", dense=True), False)],
        yardstick=False)
    for method, model in SIMBODY:
        add(method, [(f"accuracy {a:.0e}", a, *in_library(way="simbody", accuracy=a, **model), False)
                     for a in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)])
    for method, way in SCIPY:
        add(method, [(f"tolerance {t:.0e}", t, *in_numpy(way(t)), False)
                     for t in (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)])
    take_times(timers, repetitions)

    def lesson(all_series, what):
        best = min(map(smallest_error, all_series[2:]))
        return (f"boxbeam iterates to round-off at every instant: its {what} are right to "
                f"{smallest_error(all_series[0]):.0e}; the best of the others comes to {best:.0e}. "
                "Nothing is gained by a looser tolerance where the exact answer costs less.")

    common = {"scene": f"sledge-rig, one period of {data['period']:.4f} s in {instants} instants, "
                       "each from the one before",
              "reference": "circles in closed form, forces body by body, 30 digits",
              "unit": "instant, positions to reactions"}
    return [chart("peers-positions", "The rig in other programs: positions",
                  error="largest distance of B and E from where they are / length of the beam",
                  series=place_series, lesson=lesson(place_series, "positions"),
                  floor={"error": 2.2e-16, "name": "round-off of double"}, **common),
            chart("peers-reactions", "The rig in other programs: reactions",
                  error="largest error of a pin's force / its largest force",
                  series=force_series, lesson=lesson(force_series, "reactions"), **common)]
