"""Motion under forces: the pendulum and the N-four-bar of the IFToMM library of computational
benchmark problems (A01, A02 with N = 2) by boxbeam, Simbody and scipy.

References: both are motions of one angle with elliptic functions for a solution, here with 30
digits. The N-four-bar lies flat twice in a turn, where it has three freedoms instead of one.
"""
import warnings

import mpmath
import numpy as np
from scipy.integrate import solve_ivp

from measure import Refusal, chart, point, series, smallest_error, take_times, timed
from pinned_bodies import PinnedBodies

mpmath.mp.dps = 30
G = 9.81
TIME = 10.0
REPETITIONS = 5
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)
MOST_EVALUATIONS = 30000
N = 2
K = G * ((N + 1) / 2 + N) / ((N + 1) / 3 + N)  # theta'' = K sin(theta), theta from the vertical


def pendulum_truth():
    """From rest at (-1, 0): sin(theta/2) = m sn(K(m^2) - sqrt(g) t), theta from below, m = sin 45."""
    square = mpmath.mpf(1) / 2
    argument = mpmath.ellipk(square) - mpmath.sqrt(mpmath.mpf(G)) * TIME
    half = mpmath.asin(mpmath.sqrt(square) * mpmath.ellipfun("sn", argument, m=square))
    return -mpmath.sin(2 * half), -mpmath.cos(2 * half)


def four_bars_truth():
    """theta'^2 = 1 + 4 K sin^2(theta/2): t = 2 F(theta/2 | -4 K)."""
    k = mpmath.mpf(G) * (mpmath.mpf(N + 1) / 2 + N) / (mpmath.mpf(N + 1) / 3 + N)
    turn = 4 * mpmath.ellipk(-4 * k)
    whole = int(TIME / turn)
    rest = TIME - whole * turn
    half = mpmath.findroot(lambda phi: 2 * mpmath.ellipf(phi, -4 * k) - rest, mpmath.pi * rest / turn)
    return mpmath.sin(2 * half), mpmath.cos(2 * half)


def pendulum_by_hand():
    """theta'' = -g sin(theta), theta from below."""
    return (lambda t, y: (y[1], -G * np.sin(y[0]))), [-np.pi / 2, 0.0], \
        (lambda y: (np.sin(y[0]), -np.cos(y[0])))


def four_bars_by_hand():
    return (lambda t, y: (y[1], K * np.sin(y[0]))), [0.0, 1.0], \
        (lambda y: (np.sin(y[0]), np.cos(y[0])))


def index_1(bodies, q, v, body, p):
    """[M J^T; J 0] (a, lambda) = (Q, gamma): as textbooks have it, nothing projected."""
    n, m = bodies.size, bodies.rows
    matrix = np.zeros((n + m, n + m))
    right = np.empty(n + m)
    nothing = np.empty(0)

    def rates(_, y):
        q, v = y[:n], y[n:]
        jacobian = bodies.jacobian(q)
        matrix[range(n), range(n)] = bodies.mass
        matrix[:n, n:] = jacobian.T
        matrix[n:, :n] = jacobian
        right[:n] = bodies.weight
        right[n:] = bodies.acceleration_side(q, v, nothing)
        return np.concatenate([v, np.linalg.solve(matrix, right)[:n]])
    return rates, np.concatenate([q, v]), lambda y: bodies.place(y[:n], body, p)


def pendulum_index_1():
    """x and y with the rod's force l: x'' = -l x, y'' = -l y - g, l from the second derivative of
    x^2 + y^2 = 1."""
    def rates(_, state):
        x, y, vx, vy = state
        rod = (vx * vx + vy * vy - G * y) / (x * x + y * y)
        return vx, vy, -rod * x, -rod * y - G
    return rates, np.array([-1.0, 0.0, 0.0, 0.0]), lambda y: y[:2]


def four_bars_index_1():
    rod = (1.0, 1.0 / 12.0)
    pins = [(i, (-0.5, 0.0), -1, (i, 0.0)) for i in range(N + 1)]
    for i in range(N):
        pins += [(i, (0.5, 0.0), N + 1 + i, (-0.5, 0.0)),
                 (i + 1, (0.5, 0.0), N + 1 + i, (0.5, 0.0))]
    bodies = PinnedBodies([rod] * (2 * N + 1), pins, [], -G)
    q = [x for i in range(N + 1) for x in (i, 0.5, np.pi / 2)]
    q += [x for i in range(N) for x in (i + 0.5, 1.0, 0.0)]
    v = [0.5, 0.0, -1.0] * (N + 1) + [1.0, 0.0, 0.0] * N
    return index_1(bodies, np.array(q), np.array(v), 0, (0.5, 0.0))


class Counted:
    """Right sides of a differential equation, counted: solvers leave those of Jacobians out."""

    def __init__(self, rates):
        self.rates, self.count = rates, 0

    def __call__(self, t, y):
        self.count += 1
        if self.count > MOST_EVALUATIONS:
            raise Refusal(f"not at the end after {MOST_EVALUATIONS} evaluations, at {t:.3f} s")
        return self.rates(t, y)


def by_scipy(method, system, tolerance):
    """The place at the end, how many evaluations it took, and why there is none."""
    rates, start, place = system
    counted = Counted(rates)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = solve_ivp(counted, (0.0, TIME), start, method=method, rtol=tolerance,
                              atol=tolerance)
    except (Refusal, np.linalg.LinAlgError) as error:
        return None, counted.count, str(error)
    if not found.success:
        return None, counted.count, found.message
    return place(found.y[:, -1]), counted.count, ""


def chart_of(library, name, title, scene, system, truth, ways, repetitions):
    """`ways`: (method, scipy's name of it, equations, smallest tolerance)."""
    truth = np.array([float(x) for x in truth])
    all_series, timers = [], []

    def add(method, points, yardstick):
        all_series.append(series(method, points, yardstick))

    def in_library(way, words, parameter, default=False, **accuracy):
        request = {"system": system, "way": way, "time": TIME, **accuracy}
        answer = library.ask("free", **request)
        if "refused" in answer:
            return point(words, parameter, failure=answer["refused"], default=default)
        error = np.linalg.norm(np.array(answer["place"]) - truth)
        own = point(words, parameter, error=error, operations=answer["evaluations"],
                    default=default)
        turns = max(1, int(0.02 / answer["seconds"]))
        timers.append(([own], lambda: library.ask("free", turns=turns, **request)["seconds"]))
        return own

    # The program's own tolerance is asked for by leaving it out.
    add("boxbeam", [in_library("boxbeam", f"tolerance {t:.0e}", t, default=t == 1e-11,
                               **({} if t == 1e-11 else {"accuracy": t})) for t in TOLERANCES],
        yardstick=False)
    add("Simbody, Runge-Kutta-Merson",
        [in_library("simbody", f"accuracy {t:.0e}", t, accuracy=t) for t in TOLERANCES
         if t >= 1e-12], yardstick=True)
    for method, scipy_name, equations, smallest in ways:
        points = []
        for t in (t for t in TOLERANCES if t >= smallest):
            place, count, failure = by_scipy(scipy_name, equations, t)
            if failure:
                points.append(point(f"rtol {t:.0e}", t, failure=failure))
                continue
            own = point(f"rtol {t:.0e}", t, error=np.linalg.norm(place - truth), operations=count)
            timers.append(([own], lambda n=scipy_name, e=equations, t=t: timed(
                lambda: by_scipy(n, e, t))))
            points.append(own)
        add(method, points, yardstick=True)
    take_times(timers, repetitions)

    default = next(p for p in all_series[0]["points"] if p["default"])
    worst = max((p["error"] for s in all_series[1:] for p in s["points"] if not p["failure"]))
    return chart(
        name, title, scene=scene, error="distance from the exact place after 10 s / 1 m",
        reference="elliptic functions, 30 digits", operations="evaluations of the accelerations",
        unit="run of 10 s", series=all_series,
        lesson=f"At its default tolerance boxbeam is off by {default['error']:.0e} after "
               f"{default['operations']:.0f} evaluations; its best is "
               f"{smallest_error(all_series[0]):.0e}. Loose tolerances cost others up to "
               f"{worst:.0e}.")


def charts(library, repetitions=REPETITIONS):
    by_hand, index = "one angle, by hand", "x and y, index 1, not projected"
    pendulum = chart_of(
        library, "peers-pendulum", "A pendulum in other programs",
        "pendulum A01 of the IFToMM library, 10 s", "pendulum", pendulum_truth(),
        [(f"scipy RK45, {by_hand}", "RK45", pendulum_by_hand(), 1e-10),
         (f"scipy DOP853, {by_hand}", "DOP853", pendulum_by_hand(), 1e-13),
         (f"scipy Radau, {by_hand}", "Radau", pendulum_by_hand(), 1e-8),
         (f"scipy DOP853, {index}", "DOP853", pendulum_index_1(), 1e-13)], repetitions)
    index = "15 coordinates, index 1, not projected"
    four_bars = chart_of(
        library, "peers-four-bars", "Three cranks through their singular position, in other programs",
        "N-four-bar A02 of the IFToMM library, N = 2, 10 s, ten times through the flat position",
        "four-bars", four_bars_truth(),
        [(f"scipy DOP853, {by_hand}", "DOP853", four_bars_by_hand(), 1e-13),
         (f"scipy DOP853, {index}", "DOP853", four_bars_index_1(), 1e-12),
         (f"scipy Radau, {index}", "Radau", four_bars_index_1(), 1e-7)], repetitions)
    return [pendulum, four_bars]
