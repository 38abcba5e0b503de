#!/usr/bin/env python3
"""Independent calculation of the shipped cases, compared with what boxbeam says about them.

    python3 shipped_cases.py PROGRAM PROJECT_ROOT [--values]

Every mechanism from its data as written below (the program alone reads the case files; the time
tables are read by both): positions from circles and the law of cosines, forces body by body.
Edge fibres and web ends of all beams and the hole of the press are calculated, with and without
shear lag; other points are not. The landing gear, which moves in space: landing_gear.py.
"""
import cmath
import importlib.util
import json
import math
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

sys.dont_write_bytecode = True

import landing_gear  # noqa: E402
from hand_calculation import (GRAVITY, Beam, PeriodicLines, PeriodicSpline,  # noqa: E402
                              bar_moment, circles, cross, direct_damage, fatigue_factor, fixed, moving, rainflow,
                              shear_damage, turning_values)

G = 9.81


class Press:
    """Crank r = 0.2 m, rod 1.6 m, slide on the vertical through the crank's shaft."""

    case, instant, period = "sections/slider-crank-press/press.toml", 0.53, 1.2
    beam = Beam([(0, 0.42), (0.25, 0.42), (1.35, 0.32), (1.6, 0.32)], 0.26, 0.04, 0.03, 7850,
                hole=(0.8, 0.04))
    fatigue = {"cycles": 2e7, "gamma_Mf": 1.35}
    yield_strength = web_yield_strength = 345e6
    stations = [0.25, 0.8, 1.35]
    category = staticmethod(lambda s: 71 if s in (0.25, 1.35) else 100)

    def __init__(self, root):
        self.force = PeriodicLines(root / "sections/slider-crank-press/press-force.csv", 1e3)

    def solve(self, time):
        omega, length = 2 * math.pi / 1.2, 1.6
        angle = math.pi / 2 + omega * time
        a = moving(lambda q: cmath.rect(0.2, q), angle, omega)
        slide = moving(lambda q: 1j * (0.2 * math.sin(q)
                                       - math.sqrt(length**2 - (0.2 * math.cos(q)) ** 2)),
                       angle, omega)
        u = (slide - a) * (1 / length)
        # The slide gives the force along its guide, the rod's moment about A the one across it.
        along = -(2500 * (slide.dd.imag + G) - self.force(time))
        mass, first, second, _ = self.beam.beyond(0.0)
        rest = first * cross(u.v, GRAVITY - a.dd) - second * cross(u.v, u.dd)
        across = (length * u.v.real * along + rest) / (length * u.v.imag)
        at_p = across + 1j * along
        at_a = mass * (a.dd - GRAVITY) + first * u.dd - at_p
        reactions = {"A": ("rod", at_a), "P": ("rod", at_p), "motor": ("crank", cross(a.v, at_a))}
        return (u, a, [(0.0, at_a, 0.0), (1.6, at_p, 0.0)]), reactions

    def hole_edge(self, state, degrees):
        """Kirsch with the finite width of the web: 40 mm in 290 mm, on the neutral axis."""
        N, V, M = self.beam.cut(state, 0.8, "")
        a, theta = 0.04 / 0.29, math.radians(degrees)
        b = 1 - a
        K_g = (2 + 0.284 * b - 0.6 * b**2 + 1.32 * b**3) / b
        I = self.beam.inertia(0.8)
        Q = 0.26 * 0.04 * 0.165 + 0.06 * 0.145**2 / 2
        net = self.beam.working(0.8)[1] - 0.06 * 0.04**3 / 12  # what shear lag leaves
        return (K_g / 3 * N / self.beam.area(0.8) * (1 - 2 * math.cos(2 * theta))
                + M * 0.02 / net * (math.sin(theta) - math.sin(3 * theta))
                - 4 / b * V * Q / (I * 0.06) * math.sin(2 * theta))


class FourBar:
    """A beam that rocks about a fixed point and is driven through a coupler."""

    def four_bar(self, time):
        """Jets of crank pin A and driven point B, and of the beam's axis."""
        angle = self.start + self.omega * time
        a = moving(lambda q: self.shaft + cmath.rect(self.crank, q), angle, self.omega)
        b = moving(lambda q: circles(self.shaft + cmath.rect(self.crank, q), self.coupler,
                                     self.pivot, self.arm, self.side), angle, self.omega)
        return a, b

    def coupler_force(self, a, b, about_pivot):
        """The coupler's force on the beam at B, from the moment that it must have about the pivot
        and the coupler's own about A."""
        lever, bar = b.v - self.pivot, b.v - a.v
        about_a = -bar_moment(a, b, self.coupler_mass, a.v)
        return (about_pivot * bar - about_a * lever) / cross(lever, bar)

    def on_crank(self, a, b, at_b):
        """The coupler's force on the crank."""
        return -(self.coupler_mass * ((a.dd + b.dd) / 2 - GRAVITY) + at_b)


class Rocker(FourBar):
    case, instant, period = "sections/four-bar-rocker/rocker.toml", 0.3, 60 / 54
    beam = Beam([(0, 0.3), (1.2, 0.48), (3.0, 0.08)], 0.16, 0.012, 0.012, 7850, rotary=True)
    fatigue = {"cycles": 2e7, "gamma_Mf": 1.35}
    yield_strength = web_yield_strength = 355e6
    stations = [1.1, 1.2, 1.3]
    category = staticmethod(lambda s: 71 if 1.1 <= s <= 1.3 else 80)
    start, omega, shaft, crank = 0.0, 2 * math.pi * 54 / 60, 0j, 0.25
    coupler, coupler_mass, pivot, arm, side = 1.5, 80, 1.5 - 1.2j, 1.2, 1

    def __init__(self, root):
        pass

    def solve(self, time):
        a, b = self.four_bar(time)
        u = (b - fixed(self.pivot)) * (1 / 1.2)
        centre = fixed(self.pivot) + u * 3.15
        at_d = -460 * (centre.dd - GRAVITY)
        couple = -16 * cross(u.v, u.dd) + 0.15 * cross(u.v, at_d)
        about_pivot = -(3 * cross(u.v, at_d) + couple + self.beam.free_moment(u))
        at_b = self.coupler_force(a, b, about_pivot)
        mass, first, _, _ = self.beam.beyond(0.0)
        at_c = first * u.dd - mass * GRAVITY - at_b - at_d
        torque = -(cross(a.v, self.on_crank(a, b, at_b)) + 60 * cross(a.v / 2, GRAVITY))
        reactions = {"B": ("rocker", at_b), "C": ("rocker", at_c), "D": ("rocker", at_d),
                     "motor": ("crank", torque)}
        loads = [(0.0, at_c, 0.0), (1.2, at_b, 0.0), (3.0, at_d, couple)]
        return (u, fixed(self.pivot), loads), reactions


class PumpJack(FourBar):
    case, instant, period = "sections/pump-jack/beam.toml", 4.5, 7.5
    beam = Beam([(0, 0.45), (2.1, 0.8), (2.9, 0.8), (4.9, 0.4), (5.6, 0.4)], 0.3, 0.025, 0.014,
                7850)
    fatigue = {"cycles": 4.2e7, "gamma_Mf": 1.35}
    yield_strength, web_yield_strength = 225e6, 235e6  # of 25 and of 14 mm
    stations = [2.2, 2.5, 2.8, 3.9, 4.0]
    start, omega, shaft, crank = -math.pi / 2, 2 * math.pi * 8 / 60, -2.5 - 2.6j, 0.8
    coupler, coupler_mass, pivot, arm, side = 2.6, 420, 0j, 2.5, 1

    def __init__(self, root):
        pass

    @staticmethod
    def category(s):
        return 50 if 2.2 <= s <= 2.8 else 56 if 3.9 <= s <= 4.0 else 100

    def solve(self, time):
        a, b = self.four_bar(time)
        u = b * (-1 / 2.5)
        phase = self.omega * time
        rod = (52e3 - 22e3 * math.sin(phase) + 4e3 * math.sin(2 * phase)
               - 5e3 * math.sin(3 * phase))
        centre = u * (3.2 - 0.15j)
        head = 780 * (GRAVITY - centre.dd)
        at_h = head - 1j * u.v * rod
        couple = (-260 * cross(u.v, u.dd) + cross((0.1 - 0.15j) * u.v, head) - 0.3 * rod)
        mass, first, second, _ = self.beam.beyond(0.0)
        about_s = (first - 2.5 * mass) * cross(u.v, GRAVITY)
        about_s -= (second - 5 * first + 6.25 * mass) * cross(u.v, u.dd)
        at_t = self.coupler_force(a, b, -(3.1 * cross(u.v, at_h) + couple + about_s))
        at_s = (first - 2.5 * mass) * u.dd - mass * GRAVITY - at_t - at_h
        arm = a.v - self.shaft
        torque = -(cross(arm, self.on_crank(a, b, at_t))
                   + 6400 * cross(arm * 1.05 / 0.8, GRAVITY))
        reactions = {"T": ("beam", at_t), "S": ("beam", at_s), "H": ("beam", at_h),
                     "gearbox": ("crank", torque)}
        loads = [(0.0, at_t, 0.0), (2.5, at_s, 0.0), (5.6, at_h, couple)]
        return (u, b, loads), reactions


class Lift:
    case, instant, period = "sections/scissor-lift/lift.toml", 14.2, 60.0
    beam = Beam([(0, 0.1), (0.9, 0.17), (1.5, 0.17), (2.4, 0.1)], 0.08, 0.008, 0.006, 7850,
                hole=(1.2, 0.05))
    fatigue = {"cycles": 2e5, "gamma_Mf": 1.35}
    yield_strength = web_yield_strength = 355e6
    stations = [0.95, 1.05, 1.15, 1.2]
    category = staticmethod(lambda s: 56 if 0.95 <= s <= 1.15 else 90)

    def __init__(self, root):
        folder = root / "sections/scissor-lift"
        self.cylinder = PeriodicSpline(folder / "cylinder-length.csv", 1e-3)
        self.payload = PeriodicLines(folder / "payload.csv", 1e3)

    def solve(self, time):
        foot, lug = 0.9 - 0.4j, 1.05 - 0.12j

        def arm_angle(length):  # law of cosines in the triangle pivot, foot, lug
            cosine = (abs(lug) ** 2 + abs(foot) ** 2 - length**2) / (2 * abs(lug) * abs(foot))
            return cmath.phase(foot) + math.acos(cosine) - cmath.phase(lug)

        q = self.cylinder(time)
        u = moving(lambda length: cmath.rect(1.0, arm_angle(length)), *q, step=0.005)
        e = moving(lambda length: 2.4j * math.sin(arm_angle(length)), *q, step=0.005)
        cosine, W = u.v.real, self.payload(time)
        lift = 350 * (e.dd.imag + G)
        roller = (1.2 * lift + 1.5 * W) / (2.4 * cosine)  # of arm C on the platform, upwards
        at_e = 1j * (lift + W - roller)  # of the other arm on the platform
        # The other arm about its middle pin: inertia, roller on the base, platform.
        half = (e.v - 2.4 * cosine) / 2
        alpha = -cross(u.v, u.dd)
        base = (62 * 2.4**2 / 12 * alpha + cross(half, at_e)) / cross(-half, 1j)
        on_other = 62 * (1.2 * u.dd - GRAVITY) + at_e - 1j * base
        # The arm about its fixed pin gives the cylinder.
        push = lug * u.v - foot
        push /= abs(push)
        moment = (1.2 * cross(u.v, -on_other) + 2.4 * cross(u.v, -1j * roller)
                  + self.beam.free_moment(u))
        at_p = -moment / cross(lug * u.v, push) * push
        mass, first, _, _ = self.beam.beyond(0.0)
        at_a = first * u.dd - mass * GRAVITY + on_other + 1j * roller - at_p
        reactions = {"A": ("arm", at_a), "M": ("arm", -on_other), "upper_roller": ("arm",
                     -1j * roller), "lower_roller": ("other_arm", 1j * base),
                     "E": ("platform", at_e), "cylinder": ("arm", at_p)}
        loads = [(0.0, at_a, 0.0), (1.05, at_p, cross(-0.12j * u.v, at_p)), (1.2, -on_other, 0.0),
                 (2.4, -1j * roller, 0.0)]
        return (u, fixed(0j), loads), reactions


def side_of(check):
    return check["side"].strip("0")


def largest(case, state, stress):
    """The largest amount of a stress over the period."""
    values = turning_values(lambda t: stress(state(t)), case.period, case.count)
    return max(map(abs, values))


def groups(case, program, root):
    motion = run(program, root, "motion", case.case, "--at", str(case.instant))
    title = case.case.split("/")[1]

    # Forces at an instant.
    rows = []
    scale = 0.0
    for joint, (on, value) in case.solve(case.instant)[1].items():
        theirs = motion["states"][0]["reactions"][joint]
        sign = 1 if theirs["on"] == on else -1
        if isinstance(value, float):
            rows.append((f"{joint}, moment", sign * theirs["moment"], value))
        else:
            scale = max(scale, abs(value))
            rows += [(f"{joint}, x", sign * theirs["fx"], value.real),
                     (f"{joint}, y", sign * theirs["fy"], value.imag)]
    yield f"{title}: joint forces at {case.instant} s", rows, 1e-8, scale
    case.count = 1440
    state = lru_cache(maxsize=None)(lambda t: case.solve(t)[0])
    yield from factor_groups(f"{title}, no shear lag", case, state,
                             verified(program, root, case.case, "strength.shear_lag=false"))
    case.beam.find_zones([state(case.period * i / 240) for i in range(240)])
    results = verified(program, root, case.case)
    yield from factor_groups(f"{title}, shear lag", case, state, results)

    rows = [("mass", results["beam"]["mass"], case.beam.mass)]
    yield f"{title}: mass of the beam", rows, 1e-12, None


def factor_groups(title, case, state, results):
    # At the end of a flange the web's shear comes to the fibre's stress: the worst of the places
    # that are looked at here.
    theirs = min((check for check in results["checks"] if check["criterion"] == "yield"
                  and ("hole" in check["point"] or check["point"].startswith("fibre"))),
                 key=lambda check: check["safety_factor"])

    def stress(at):
        if "hole" in theirs["point"]:
            return max((case.hole_edge(at, d) for d in range(0, 360, 3)), key=abs)
        sign = 1 if "+z" in theirs["point"] else -1
        return case.beam.edge(at, theirs["station"], side_of(theirs), sign)

    factor = case.yield_strength / largest(case, state, stress)
    yield f"{title}: governing yield factor", [(theirs["id"], theirs["safety_factor"],
                                                factor)], 1e-6, None

    # Both edge fibres and web ends wherever the program shows them, and the governing place.
    rows, at_webs = [], []
    for check in results["checks"]:
        s, sign = round(check["station"], 9), 1 if "+z" in check["point"] else -1
        place = (s, side_of(check), sign)
        if check["criterion"] == "fatigue" and check["point"].startswith("fibre"):
            rows.append((check["id"], check["safety_factor"], factor_at(case, state, *place)))
        if check["point"].startswith("web end") and s != case.beam.hole[0]:
            here = web_end_factor(case, state, place, check["criterion"])
            if here:
                at_webs.append((check["id"], check["safety_factor"], here))
    yield f"{title}: fatigue factors of the edge fibres", rows, 1e-6, None
    yield f"{title}: factors of the web ends", at_webs, 1e-6, None

    theirs = results["governing"]["fatigue"]
    if "hole" in theirs["point"]:
        here = min(fatigue_of(case, state, lambda s, d=d: case.hole_edge(s, d), 100)
                   for d in range(0, 360, 3))
    else:
        here = min(row[2] for row in rows)
        count, case.count = case.count, 180
        for i in range(1, 120):
            s = case.beam.length * i / 120
            for sign in (1, -1):
                for side in ("-", "+"):
                    here = min(here, factor_at(case, state, s, side, sign, False))
        case.count = count
    yield f"{title}: no place is worse", [(theirs["id"], theirs["safety_factor"], here)], 1e-6, None


def factor_at(case, state, s, side, sign, fine=True):
    return fatigue_of(case, state, lambda t: case.beam.edge(t, s, side, sign), case.category(s),
                      fine)


def fatigue_of(case, state, stress, category, fine=True):
    return fatigue_factor([(ranges_of(case, state, stress, fine), direct_damage(category))],
                          **case.fatigue)


def ranges_of(case, state, stress, fine=True):
    return rainflow(turning_values(lambda t: stress(state(t)), case.period, case.count, fine))


def web_end_factor(case, state, place, criterion):
    """A factor where the webs meet a flange; None for criteria that are not calculated."""
    def direct(at):
        return case.beam.web_end(at, *place)[0]

    def shear(at):
        return case.beam.web_end(at, *place)[1]

    if criterion == "yield":
        return case.web_yield_strength / largest(
            case, state, lambda at: math.hypot(direct(at), math.sqrt(3) * shear(at)))
    channels = []
    if criterion in ("fatigue", "combined fatigue"):
        channels.append((ranges_of(case, state, direct), direct_damage(case.category(place[0]))))
    if criterion in ("shear fatigue", "combined fatigue"):
        channels.append((ranges_of(case, state, shear), shear_damage(100)))
    return fatigue_factor(channels, **case.fatigue) if channels else None


def friction_groups(program, root):
    """The sledge rig of ../independent_sledge_rig.py with friction in the rail: the sledge's own
    equations and the lower rod's moment about C, solved for the force along the rail."""
    spec = importlib.util.spec_from_file_location(
        "rig", Path(__file__).resolve().parent.parent / "independent_sledge_rig.py")
    rig = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(rig)
    without = rig.joint_forces

    @lru_cache(maxsize=None)
    def joint_forces(state):
        _, a, b, c, e = state
        rod, moment = e.v - c.v, rig.rod_moment(c, e, rig.LOWER_ROD_MASS, c.v)
        share = 0.05 * e.d.real / math.hypot(e.d.real, 0.01)  # N > 0: the sledge never lifts
        along = (-rig.SLEDGE_MASS * e.dd.real
                 - share * (rig.SLEDGE_MASS * 9.815 + moment / rod.real))
        along /= 1 + share * rod.imag / rod.real
        assert rig.SLEDGE_MASS * 9.815 + (moment + rod.imag * along) / rod.real > 0
        # The same as a sledge whose mass, at this instant, makes the frictionless force as large.
        return without(state, -along / e.dd.real)

    rig.joint_forces = joint_forces
    case = "sections/sledge-rig/friction.toml"
    instant = 0.4
    motion = run(program, root, "motion", case, "--at", str(instant))["states"][0]["reactions"]
    forces = dict(zip(("C", "O", "B", "exciter"), joint_forces(rig.motion(instant))))
    rows = []
    for joint, value in forces.items():
        sign = 1 if motion[joint]["on"] in ("beam", "blade") else -1
        rows.append((f"{joint}, x", sign * motion[joint]["fx"], value.real))
        if joint != "exciter":
            rows.append((f"{joint}, y", sign * motion[joint]["fy"], value.imag))
    yield f"sledge-rig friction: joint forces at {instant} s", rows, 1e-9, None
    lag = rig.length_between_zero_moments()
    for name, length, more in (("shear lag", lag, ()),
                               ("no shear lag", None, ("strength.shear_lag=false",))):
        results = verified(program, root, case, *more)
        factors = {}
        for s, side in (*rig.FIBRE_STATIONS, (4.0, ""), (4.4, "")):
            factors.update(rig.fibre_factors(s, side, length))
        rows = []
        for criterion in ("yield", "fatigue"):
            lowest = min((n for n in factors if n.startswith(criterion)), key=factors.get)
            at_fibres = min(check["safety_factor"] for check in results["checks"]
                            if check["criterion"] == criterion
                            and check["point"].startswith("fibre"))
            rows.append((lowest, at_fibres, factors[lowest]))
        yield f"sledge-rig friction, {name}: governing factors", rows, 1e-6, None


def verified(program, root, case, *settings):
    with tempfile.TemporaryDirectory() as folder:
        more = [word for setting in settings for word in ("--set", setting)]
        return run(program, root, "verify", case, "--no-plots", "--no-pdf", "--out", folder, *more)


def report(title, rows, allowed, scale):
    """Prints a group; returns whether program and calculation agree."""
    deviations = [abs(theirs - here) / (scale or abs(here)) for _, theirs, here in rows]
    wrong = [row for row, deviation in zip(rows, deviations) if not deviation <= allowed]
    print(f"{'FAIL' if wrong else 'ok  '} {title}: {len(rows)} values, largest deviation "
          f"{max(deviations):.1e}, allowed {allowed:.0e}")
    for name, theirs, here in wrong:
        print(f"       {name}: program {theirs}, here {here}")
    if "--values" in sys.argv:
        for name, _, here in rows:
            print(f"       {name}: {here:.12g}")
    return not wrong


def run(program, root, *arguments):
    command = [program, *arguments, "--json", "-"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, timeout=60,
                          check=False)
    if done.returncode not in (0, 1):  # 1: the verified beam fails a check
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)


def main():
    if len(sys.argv) < 3:
        sys.exit("usage: shipped_cases.py PROGRAM PROJECT_ROOT [--values]")
    program, root = (Path(argument).resolve() for argument in sys.argv[1:3])
    good = True
    for kind in (Press, Rocker, Lift, PumpJack):
        for group in groups(kind(root), str(program), root):
            good = report(*group) and good
    for group in friction_groups(str(program), root):
        good = report(*group) and good
    for group in landing_gear.groups(lambda *words: run(str(program), root, *words),
                                     lambda *words: verified(str(program), root, *words)):
        good = report(*group) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
