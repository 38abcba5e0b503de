#!/usr/bin/env python3
"""Independent calculation of the sledge rig, compared with what boxbeam says about it.

    python3 independent_sledge_rig.py PROGRAM PROJECT_ROOT

It calculates from the rig's data as written below (only the program reads the case file) and
shares no code or method with the program: no constraint equations, Jacobian, iteration or system
of equations of motion. Positions: circle intersections in closed form. Derivatives: exact
second-order jets. Forces: Newton-Euler body by body. Cut forces: equilibrium of the part above,
exact integrals of the line mass. Extremes: golden section from a time grid. Shear lag: a strip of
each flange left out, by the length between zero moments. Factors: yield strength / largest stress
and fatigue strength / stress range, of edge fibres and web ends; hole edges with their stress
concentration are not calculated. Equivalent mass: by definition, driver force projected on the
acceleration of the driven point.

World: origin at the pivot, x to the right, y up, angles anticlockwise; a vector is the complex
number x + iy. Beam: station s from its lower end C (0) to B (6.2 m), side - or + of a joint or
step, z along the left normal of the axis. sigma = N/A + M z/I. SI units.
"""
import cmath
import json
import math
import re
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

CASE = "sections/sledge-rig/rig.toml"
INSTANT = 1.071

GRAVITY = -9.815j
FREQUENCY = 0.7
OMEGA, PERIOD = 2 * math.pi * FREQUENCY, 1 / FREQUENCY
BLADE_MEAN, BLADE_AMPLITUDE, BLADE_HEIGHT, RAIL_HEIGHT = 0.5, 0.25, 3.0, -3.2
LENGTH, PIVOT = 6.2, 3.2
UPPER_ROD, UPPER_ROD_MASS = 0.5, 119.0
LOWER_ROD, LOWER_ROD_MASS = 0.685, 153.0
SLEDGE_MASS, WANTED_MASS = 18627.0, 20000.0

DENSITY = 7800.0
BOX_WIDTH, BOX_PLATE = 0.4, 0.05
TUBE_WIDTH, TUBE_HEIGHT, TUBE_WALL = 0.29, 0.49, 0.056
HUB_HOLE, BOLT_HOLE, BOLT_LEVEL = 0.145, 0.018, 0.1  # in both webs at the pivot
# Start, end, box height at start and end (0: no box), tube.
SEGMENTS = ((0.0, 1.5, 0.6, 0.6, False), (1.5, 3.2, 0.6, 1.0, False), (3.2, 4.2, 1.0, 0.6, False),
            (4.2, 4.7, 0.6, 0.6, False), (4.7, 5.2, 0.6, 0.6, True), (5.2, 6.2, 0.0, 0.0, True))
FIBRE_STATIONS = ((1.5, ""), (3.2, "-"), (3.2, "+"), (4.2, ""), (4.7, "-"), (4.7, "+"),
                  (5.2, "-"), (5.2, "+"))

YIELD_STRENGTH = 335e6  # S355, 40 to 63 mm thick (EN 10025-2)
# Category 100 at 2e6 cycles; slope 3 to 5e6 cycles, then slope 5 to 1e8 cycles (EN 1993-1-9).
FATIGUE_STRENGTH = 100e6 * (2e6 / 5e6) ** (1 / 3) * (5e6 / 1e8) ** (1 / 5)
# Shear: category 100, slope 5 all the way (clause 7, figure 7.2).
SHEAR_FATIGUE_STRENGTH = 100e6 * (2e6 / 1e8) ** (1 / 5)


class Jet:
    """A real or complex function of time at one instant: value, velocity and acceleration."""

    def __init__(self, v, d=0.0, dd=0.0):
        self.v, self.d, self.dd = v, d, dd

    def __add__(self, other):
        other = other if isinstance(other, Jet) else Jet(other)
        return Jet(self.v + other.v, self.d + other.d, self.dd + other.dd)

    def __sub__(self, other):
        return self + other * -1

    def __mul__(self, other):
        other = other if isinstance(other, Jet) else Jet(other)
        return Jet(self.v * other.v, self.d * other.v + self.v * other.d,
                   self.dd * other.v + 2 * self.d * other.d + self.v * other.dd)

    def __pow__(self, n):
        first, second = n * self.v ** (n - 1), n * (n - 1) * self.v ** (n - 2)
        return Jet(self.v**n, first * self.d, second * self.d**2 + first * self.dd)

    def imag(self):
        return Jet(self.v.imag, self.d.imag, self.dd.imag)


def cross(a, b):
    return (a.conjugate() * b).imag


def hollow(width, height, wall):
    """Area and second moment of a hollow rectangle."""
    inner_width, inner_height = width - 2 * wall, height - 2 * wall
    return (width * height - inner_width * inner_height,
            (width * height**3 - inner_width * inner_height**3) / 12)


def section(s, side, holes=True, lag=None):
    """Area, second moment and half height at s; `lag`: length between zero moments, for the section
    without what shear lag leaves idle."""
    start, end, first, last, tube = next(
        g for g in SEGMENTS if (g[0] < s <= g[1] if side == "-" else g[0] <= s < g[1]))
    height = first + (last - first) * (s - start) / (end - start)
    area, inertia = hollow(BOX_WIDTH, height, BOX_PLATE) if height else (0.0, 0.0)
    if tube:
        tube_area, tube_inertia = hollow(TUBE_WIDTH, TUBE_HEIGHT, TUBE_WALL)
        area, inertia = area + tube_area, inertia + tube_inertia
    if holes and s == PIVOT:
        for diameter, level in ((HUB_HOLE, 0.0), (BOLT_HOLE, BOLT_LEVEL), (BOLT_HOLE, -BOLT_LEVEL)):
            area -= 2 * BOX_PLATE * diameter
            inertia -= 2 * BOX_PLATE * (diameter**3 / 12 + diameter * level**2)
    if lag:
        width, plate = (BOX_WIDTH, BOX_PLATE) if height else (TUBE_WIDTH, TUBE_WALL)
        idle, depth = idle_width(width - plate, lag), height or TUBE_HEIGHT
        area -= 2 * idle * plate
        inertia -= idle * (depth**3 - (depth - 2 * plate) ** 3) / 12
    return area, inertia, (height or TUBE_HEIGHT) / 2


def idle_width(between_webs, length):
    """What shear lag takes of a flange's width, in its middle: EN 1993-1-5, 3.1(1) and table 3.1 for
    a bending moment with the peak of a support's force. Plates without stiffeners."""
    kappa = between_webs / 2 / length
    if kappa < 1 / 50:
        return 0.0
    return between_webs * (1 - 1 / (1 + 6 * (kappa - 1 / (2500 * kappa)) + 1.6 * kappa**2))


@lru_cache(maxsize=None)
def mass_moment(order, s):
    """Integral of (q - PIVOT)^order dm over the beam from s to its upper end."""
    total = 0.0
    for start, end, *_ in SEGMENTS:  # line mass in the segment: constant + slope (q - PIVOT)
        first = DENSITY * section(start, "+", holes=False)[0]
        slope = (DENSITY * section(end, "-", holes=False)[0] - first) / (end - start)
        constant = first - slope * (start - PIVOT)
        low, high = max(start, s) - PIVOT, max(end, s) - PIVOT
        for power, factor in ((order + 1, constant), (order + 2, slope)):
            total += factor * (high**power - low**power) / power
    return total


BEAM_MASS = mass_moment(0, 0.0)
BEAM_CENTRE = mass_moment(1, 0.0) / BEAM_MASS  # from the pivot towards B


@lru_cache(maxsize=None)
def motion(time, lower_sign=1):
    """Jets of the axis (unit vector from C to B) and of A, B, C, E.

    B lies left of the line from the pivot to A; E lies right (+1) or left (-1) of C."""
    swing = BLADE_AMPLITUDE * cmath.exp(1j * OMEGA * time)
    blade = Jet(BLADE_MEAN + swing.imag, OMEGA * swing.real, -(OMEGA**2) * swing.imag)
    a, arm = blade + 1j * BLADE_HEIGHT, LENGTH - PIVOT
    inverse_square = (blade**2 + BLADE_HEIGHT**2) ** -1  # of the distance from the pivot to A
    along = inverse_square * ((arm**2 - UPPER_ROD**2) / 2) + 0.5
    b = a * (along + (inverse_square * arm**2 - along**2) ** 0.5 * 1j)
    axis = b * (1 / arm)
    c = axis * -PIVOT
    drop = c.imag() - RAIL_HEIGHT
    reach = (drop**2 * -1 + LOWER_ROD**2) ** 0.5
    return axis, a, b, c, c + reach * lower_sign - drop * 1j


def rod_moment(start, end, mass, about):
    """The moment about a point that the joint forces on a uniform rod must have."""
    rod, centre = end - start, (start + end) * 0.5
    return mass * (cross(rod.v, rod.dd) / 12 + cross(centre.v - about, centre.dd - GRAVITY))


@lru_cache(maxsize=None)
def joint_forces(state, sledge_mass=SLEDGE_MASS):
    """Forces on the beam at C, O and B, and the driver's force on the massless blade."""
    axis, a, b, c, e = state
    # Lower rod: the sledge takes the force along the rail, the moment about C gives the other.
    along_rail = -sledge_mass * e.dd.real
    moment, rod = rod_moment(c, e, LOWER_ROD_MASS, c.v), e.v - c.v
    on_rod_at_e = along_rail + 1j * (moment + rod.imag * along_rail) / rod.real
    at_c = on_rod_at_e - LOWER_ROD_MASS * ((c.dd + e.dd) / 2 - GRAVITY)
    # Beam about the pivot and upper rod about A: two moments of the force at B.
    about_pivot = (mass_moment(2, 0.0) * cross(axis.v, axis.dd) - cross(c.v, at_c)
                   - mass_moment(1, 0.0) * cross(axis.v, GRAVITY))
    about_a = -rod_moment(a, b, UPPER_ROD_MASS, a.v)
    at_b = (about_pivot * (b.v - a.v) - about_a * b.v) / cross(b.v, b.v - a.v)
    at_o = BEAM_MASS * (BEAM_CENTRE * axis.dd - GRAVITY) - at_b - at_c
    driver = (at_b + UPPER_ROD_MASS * ((a.dd + b.dd) / 2 - GRAVITY)).real
    return at_c, at_o, at_b, driver


def equivalent_mass(sledge_mass):
    """Driver force projected on the acceleration of the driven point, which is one harmonic."""
    states = [motion(PERIOD * i / 64) for i in range(64)]
    accelerations = [a.dd.real for _, a, *_ in states]
    products = [joint_forces(s, sledge_mass)[3] * acc for s, acc in zip(states, accelerations)]
    return sum(products) / sum(acc**2 for acc in accelerations)


def cut_forces(time, s, side):
    """N, V, M as the part of the beam above s exerts them on the part below."""
    axis, lever = motion(time)[0], s - PIVOT
    mass, first, second = (mass_moment(order, s) for order in range(3))
    force = mass * GRAVITY - first * axis.dd
    moment = ((first - lever * mass) * cross(axis.v, GRAVITY)
              - (second - lever * first) * cross(axis.v, axis.dd))
    for station, load in zip((0.0, PIVOT, LENGTH), joint_forces(motion(time))):
        if station > s or (station == s and side == "-"):
            force += load
            moment += (station - s) * cross(axis.v, load)
    local = force * axis.v.conjugate()
    return local.real, local.imag, -moment


def minimum(function):
    """The smallest value over a period: the four deepest valleys of a grid, refined."""
    count, step, golden = 240, PERIOD / 240, (math.sqrt(5) - 1) / 2
    grid = [function(i * step) for i in range(count)]
    valleys = [i for i in range(count) if grid[i - 1] >= grid[i] <= grid[(i + 1) % count]]
    found = min(grid)
    for i in sorted(valleys, key=grid.__getitem__)[:4]:
        low, high = (i - 1) * step, (i + 1) * step
        while high - low > 1e-8:
            left, right = high - golden * (high - low), low + golden * (high - low)
            low, high = (low, right) if function(left) < function(right) else (left, high)
        found = min(found, function((low + high) / 2))
    return found


def extremes(function):
    return minimum(function), -minimum(lambda time: -function(time))


def length_between_zero_moments():
    """At the instant of the largest moment, which stands at the pivot: the beam's ends are pins, and
    here no other zero lies between them."""
    at = max((PERIOD * i / 1440 for i in range(1440)),
             key=lambda time: abs(cut_forces(time, PIVOT, "-")[2]))
    moments = [cut_forces(at, LENGTH * i / 200, "-")[2] for i in range(1, 200)]
    assert min(moments) > 0 or max(moments) < 0
    return LENGTH


def fibre_factors(s, side, lag):
    """Safety factors of both edge fibres at s, named as the program's checks."""
    area, inertia, half_height = section(s, side, lag=lag)
    factors = {}
    for sign, z in (("+", half_height), ("-", -half_height)):
        def stress(time, z=z):
            normal, _, bending = cut_forces(time, s, side)
            return normal / area + bending * z / inertia
        low, high = extremes(stress)
        factors[f"yield/{s:.4g}{side}/fibre{sign}z"] = YIELD_STRENGTH / max(-low, high)
        factors[f"fatigue/{s:.4g}{side}/fibre{sign}z"] = FATIGUE_STRENGTH / (high - low)
    return factors


def web_end_factors(s, side, sign, lag):
    """Factors where the webs meet a flange: yield, direct and shear fatigue, both together. The shear
    is that of the flange's own balance: what its force N A_f/A + M S_f/I gains between two sections,
    M rising by V, passes into both webs. In a taper this is far less than V S_f/I. The whole flange
    takes part in it."""
    step = 1e-5

    def flange_force(station, normal, bending):
        area, inertia, half_height = section(station, side, holes=False)
        flange = BOX_WIDTH * BOX_PLATE
        return flange * (normal / area + bending * sign * (half_height - BOX_PLATE / 2) / inertia)

    @lru_cache(maxsize=None)
    def stresses(time):
        normal, shear, bending = cut_forces(time, s, side)
        area, inertia, half_height = section(s, side, holes=False, lag=lag)
        # To one side only: the taper may begin here.
        forces = [flange_force(s + k * step, normal, bending + k * step * shear) for k in range(3)]
        flow = (-1.5 * forces[0] + 2 * forces[1] - 0.5 * forces[2]) / step
        direct = normal / area + bending * sign * (half_height - BOX_PLATE) / inertia
        return direct, flow / (2 * BOX_PLATE)

    def range_of(kind):
        low, high = extremes(lambda time: stresses(time)[kind])
        return high - low

    direct, shear = FATIGUE_STRENGTH / range_of(0), SHEAR_FATIGUE_STRENGTH / range_of(1)
    largest = -minimum(lambda time: -math.hypot(stresses(time)[0], math.sqrt(3) * stresses(time)[1]))
    # At 1e8 cycles, the end of both lines, a range does all the damage or none.
    return {"yield": YIELD_STRENGTH / largest, "fatigue": direct, "shear fatigue": shear,
            "combined fatigue": min(direct, shear)}


# Comparison. A group is a title, rows (name, program's value, value here), the deviation allowed
# and what it is relative to: a number, or None for each value here itself.

def motion_groups(title, document, lower_sign):
    state, program_state = motion(INSTANT, lower_sign), document["states"][0]
    axis, a, b, c, e = state
    rows = []
    for name, centre, along in (
            ("beam", axis * BEAM_CENTRE, axis), ("upper_rod", (a + b) * 0.5, a - b),
            ("blade", a, Jet(1.0)), ("lower_rod", (c + e) * 0.5, e - c), ("sledge", e, Jet(1.0))):
        body, length = program_state["bodies"][name], abs(along.v)
        rows += [(f"{name} position", complex(body["x"], body["y"]), centre.v),
                 (f"{name} velocity", complex(body["vx"], body["vy"]), centre.d),
                 (f"{name} acceleration", complex(body["ax"], body["ay"]), centre.dd),
                 (f"{name} direction", cmath.rect(1.0, body["angle"]), along.v / length),
                 (f"{name} omega", body["omega"], cross(along.v, along.d) / length**2),
                 (f"{name} alpha", body["alpha"], cross(along.v, along.dd) / length**2)]
    yield f"{title}, motion", rows, 1e-9, 1.0

    *on_beam, driver = joint_forces(state)
    rows = [("driver", program_state["reactions"]["exciter"]["fx"], driver)]
    for joint, force in zip("COB", on_beam):
        reaction = program_state["reactions"][joint]
        sign = 1 if reaction["on"] == "beam" else -1
        rows += [(f"{joint}, x", sign * reaction["fx"], force.real),
                 (f"{joint}, y", sign * reaction["fy"], force.imag)]
    yield f"{title}, forces", rows, 1e-9, None


def verification_groups(results):
    beam = results["beam"]
    rows = [("mass", beam["mass"], BEAM_MASS),
            ("centre", beam["centre_of_mass"], PIVOT + BEAM_CENTRE)]
    yield "beam mass and centre of mass", rows, 1e-9, None

    for index, kind in enumerate("NVM"):
        rows = []
        for station in beam["stations"]:
            s, side = station["s"], station["side"].strip("0")
            low, high = extremes(lambda time: cut_forces(time, s, side)[index])
            rows += [(f"smallest at {s:.4g}{side}", station[kind][0], low),
                     (f"largest at {s:.4g}{side}", station[kind][1], high)]
        yield f"cut force {kind}", rows, 1e-9, max(abs(value) for _, _, value in rows)

    remark = re.search(r"the mechanism feels like (\d+) kg at A; for (\d+) kg there the sledge "
                       r"would have to be (\d+) kg", "\n".join(results["remarks"]))
    stated = map(int, remark.groups()) if remark else [math.inf] * 3
    empty, felt = equivalent_mass(0.0), equivalent_mass(SLEDGE_MASS)
    needed = (WANTED_MASS - empty) / (felt - empty) * SLEDGE_MASS
    rows = list(zip(("felt", "wanted", "needed"), stated,
                    (round(felt), round(WANTED_MASS), round(needed))))
    yield "equivalent mass, to the kilogram", rows, 0.0, 1.0


def stress_groups(title, results, lag):
    """Factors of fibres and web ends; `lag`: length between zero moments, None without shear lag."""
    theirs = {check["id"]: check["safety_factor"] for check in results["checks"]}
    # Where the outline has a kink a place has two sides; a fibre has the same stress on both.
    theirs |= {name.replace("-/fibre", "/fibre"): factor for name, factor in theirs.items()
               if "-/fibre" in name}
    factors = {}
    for s, side in FIBRE_STATIONS:
        factors.update(fibre_factors(s, side, lag))
    rows = [(name, theirs.get(name, math.inf), factor) for name, factor in factors.items()]
    yield f"{title}, factors of the edge fibres", rows, 1e-8, None

    rows = {}
    for check in results["checks"]:
        s, side, point = check["station"], check["side"].strip("0"), check["point"]
        if not point.startswith("web end") or s == PIVOT:
            continue
        if side == "-" or any(g[0] <= s < g[1] and g[4] for g in SEGMENTS):
            continue  # no section behind to look at, or two profiles
        factor = web_end_factors(s, side, 1 if point.endswith("+z") else -1, lag)
        if check["criterion"] in factor:
            rows.setdefault(check["criterion"], []).append(
                (check["id"], check["safety_factor"], factor[check["criterion"]]))
    for criterion in ("yield", "fatigue", "shear fatigue", "combined fatigue"):
        yield f"{title}, {criterion} of web ends, tapers among them", rows[criterion], 1e-8, None

    for start, end, *_ in SEGMENTS:
        for tenth in range(1, 10):
            factors.update(fibre_factors(start + (end - start) * tenth / 10, "", lag))
    rows = []
    for criterion in ("yield", "fatigue"):
        lowest = min((name for name in factors if name.startswith(criterion)), key=factors.get)
        # At the end of a flange the web's shear comes to the fibre's stress: that is not looked at here.
        at_fibres = min(check["safety_factor"] for check in results["checks"]
                        if check["criterion"] == criterion and check["point"].startswith("fibre"))
        rows.append((lowest, at_fibres, factors[lowest]))
    yield f"{title}, governing factors along the beam", rows, 1e-8, None


def report(title, rows, allowed, scale):
    """Prints a group; returns whether program and calculation agree."""
    deviations = [abs(theirs - here) / (scale or abs(here)) for _, theirs, here in rows]
    wrong = [row for row, deviation in zip(rows, deviations) if not deviation <= allowed]
    print(f"{'FAIL' if wrong else 'ok  '} {title}: {len(rows)} values, largest deviation "
          f"{max(deviations):.1e}, allowed {allowed:.0e}")
    for name, theirs, here in wrong:
        print(f"       {name}: program {'nothing' if theirs == math.inf else theirs}, here {here}")
    return not wrong


def run_program(program, root, *arguments):
    command = [program, *arguments, "--json", "-"]
    run = subprocess.run(command, cwd=root, capture_output=True, text=True, timeout=60, check=False)
    if run.returncode not in (0, 1):  # 1: the verified beam fails a check
        sys.exit(f"{' '.join(command)}: exit code {run.returncode}\n{run.stderr}")
    return json.loads(run.stdout)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: independent_sledge_rig.py PROGRAM PROJECT_ROOT")
    program, root = (str(Path(argument).resolve()) for argument in sys.argv[1:])
    moment = ("motion", CASE, "--at", str(INSTANT))
    drawn = run_program(program, root, *moment)
    flipped = run_program(program, root, *moment, "--set", 'loops.lower.sign="-"')
    with tempfile.TemporaryDirectory() as folder:
        verify = ("verify", CASE, "--no-plots", "--no-pdf", "--out", folder)
        results = run_program(program, root, *verify)
        plain = run_program(program, root, *verify, "--set", "strength.shear_lag=false")
    lag = length_between_zero_moments()
    groups = [*motion_groups("drawn branch", drawn, 1),
              *motion_groups("flipped branch", flipped, -1), *verification_groups(results),
              *stress_groups("shear lag", results, lag),
              *stress_groups("no shear lag", plain, None)]
    sys.exit(0 if all([report(*group) for group in groups]) else 1)


if __name__ == "__main__":
    main()
