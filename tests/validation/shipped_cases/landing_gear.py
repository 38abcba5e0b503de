"""The retracting landing gear: what shipped_cases.py compares of its two cases, in space.

Motion and cut forces: landing_gear_loads.py. Shear stress: torsion by Bredt, with the torsion
constant from finite differences, for the walls are a tenth of their box thick; and what the force
of the part of the section between two places of symmetry gains along the beam. SI units.
"""
import math
from functools import lru_cache

from hand_calculation import direct_damage, fatigue_factor, golden, rainflow, shear_damage
from landing_gear_loads import (CENTRE, HINGE, LENGTH, M_Y, M_Z, N, T, V_Y, V_Z, WALL, add, area,
                                flight, height, instant, of, product, second_moment, times, total,
                                transposed, width)

YIELD, FLIGHTS = 355e6, 20000
CATEGORY, CATEGORY_AT_FOOT, CATEGORY_OF_SHEAR = 100, 71, 100
CATEGORY_AT_HEAD = 80  # diaphragm of 10 mm welded in (table 8.4/7, up to 12 mm)
NAMES = ("N", "V_y", "V_z", "T", "M_y", "M_z")
STATIONS = ((0.0, "+"), (LENGTH, "-"))


# Torsion.

def stress_function(b, h, step, source, inside):
    """Prandtl's stress function in a quarter of a box: source on the wall, 0 outside, a constant in
    the hollow; its integral, and its flux through a contour in the wall and the area in that."""
    n, nx, ny = round(WALL / step), round(b / 2 / step), round(h / 2 / step)
    u = [[inside if i <= nx - n and j <= ny - n else 0.0 for j in range(ny + 1)]
         for i in range(nx + 1)]
    wall = [(i, j) for i in range(nx) for j in range(ny) if i > nx - n or j > ny - n]
    change = 1.0
    while change > 1e-12 * (inside + source * WALL**2):
        change = 0.0
        for i, j in wall:  # over-relaxation; the axes of symmetry mirror
            mean = (u[abs(i - 1)][j] + u[i + 1][j] + u[i][abs(j - 1)] + u[i][j + 1]
                    + source * step**2) / 4
            change = max(change, abs(mean - u[i][j]))
            u[i][j] += 1.6 * (mean - u[i][j])
    x, y = nx - n // 2, ny - n // 2
    half = [0.5] + [1.0] * max(nx, ny)
    flux = sum(half[j] * (u[x + 1][j] - u[x][j]) for j in range(y + 1))
    flux += sum(half[i] * (u[i][y + 1] - u[i][y]) for i in range(x + 1))
    integral = sum(half[i] * half[j] * u[i][j] for i in range(nx) for j in range(ny)) * step**2
    return integral, flux, (x + 0.5) * (y + 0.5) * step**2


@lru_cache(maxsize=None)
def torsion_constant(b, h):
    """2 int phi dA, the slope of phi around a contour being twice the area in it: no gap. The error
    falls with step^(4/3) at the hollow's corners."""
    def at(step):
        integral, flux, enclosed = stress_function(b, h, step, 2.0, 0.0)
        integral_1, flux_1, _ = stress_function(b, h, step, 0.0, 1.0)
        return 8 * (integral - (2 * enclosed + flux) / flux_1 * integral_1)

    coarse, fine = at(WALL / 10), at(WALL / 20)
    return fine + (fine - coarse) / (2 ** (4 / 3) - 1)


# Shear lag.

class Zone:
    """A stretch between zero moments: EN 1993-1-5, 3.2.1."""

    def __init__(self, start, end, cantilever):
        self.start, self.end, self.cantilever = start, end, cantilever
        self.length = (end - start) * (2 if cantilever else 1)

    def idle(self, between_webs):
        """What it takes of a plate's width between the middles of its supports."""
        kappa = between_webs / 2 / self.length
        if kappa < 1 / 50:
            return 0.0
        assert kappa <= 0.7
        more = 6.4 * kappa**2
        if self.cantilever:
            more = 6 * (kappa - 1 / (2500 * kappa)) + 1.6 * kappa**2
        return between_webs * (1 - 1 / (1 + more))


def zones_of(situations, which):
    """Of M_y or M_z, at the instant when it is largest. No force acts on the leg between its ends,
    so that no moment has a peak there."""
    def moment(s):
        return situation.cut(t, s)[which]

    stations = [LENGTH * i / 40 for i in range(41)]
    _, situation, t = max(((abs(running.cut(t, s)[which]), running, t)
                           for running in situations.values() for t in instants_of(running, 96)
                           for s in stations), key=lambda found: found[0])
    borders = [0.0]
    for low, high in zip(stations, stations[1:]):
        if moment(low) * moment(high) >= 0:
            continue
        rising = moment(low) < 0
        for _ in range(50):
            middle = (low + high) / 2
            low, high = (middle, high) if (moment(middle) < 0) == rising else (low, middle)
        borders.append(high)
    borders.append(LENGTH)
    zones = []
    for start, end in zip(borders, borders[1:]):
        largest = max(stations, key=lambda s: abs(moment(s)) if start <= s <= end else -1)
        zones.append(Zone(start, end, largest in (0.0, LENGTH)))
    return zones


# Stresses.

class Leg:
    """The sections with or without shear lag, and their stress."""

    def __init__(self, situations, shear_lag):
        self.zones = {M_Y: [], M_Z: []}
        if shear_lag:
            self.zones = {which: zones_of(situations, which) for which in self.zones}

    def idle(self, which, s):
        """Of each flange (M_y) or web (M_z)."""
        between = (width(s) if which == M_Y else height(s)) - WALL
        return next((zone.idle(between) for zone in self.zones[which]
                     if zone.start <= s <= zone.end), 0.0)

    @lru_cache(maxsize=None)
    def working(self, s):
        """Area and second moments about y and z without what shear lag leaves idle."""
        b, h = width(s), height(s)
        flanges, webs = self.idle(M_Y, s), self.idle(M_Z, s)
        return (area(s) - 2 * (flanges + webs) * WALL,
                second_moment(b, h, WALL) - flanges * (h**3 - (h - 2 * WALL) ** 3) / 12
                - 2 * WALL * webs**3 / 12,
                second_moment(h, b, WALL) - webs * (b**3 - (b - 2 * WALL) ** 3) / 12
                - 2 * WALL * flanges**3 / 12)

    def direct(self, s, y, z, cut):
        A, I_y, I_z = self.working(s)
        return cut[N] / A + cut[M_Y] * z / I_y - cut[M_Z] * y / I_z

    def points(self, s):
        """Name, place and shear stress of the points of a section."""
        b, h = width(s) / 2, height(s) / 2
        for z, z_name in ((1, "+z"), (-1, "-z")):
            for y, y_name in ((1, "+y"), (-1, "-y")):
                yield f"corner{y_name}{z_name}", y * b, z * h, None
                yield f"web-end{y_name}{z_name}", y * b, z * (h - WALL), self.web_end(s, y, z)
            yield f"fibre{z_name}", 0.0, z * h, self.flange_shear(s, 0.0, z)
        for y, y_name in ((1, "+y"), (-1, "-y")):
            yield f"fibre{y_name}", y * b, 0.0, self.web_middle(s, y)

    @staticmethod
    @lru_cache(maxsize=None)
    def torsion(s):
        """Shear flow and what the outer face adds to its shear, per torque."""
        b, h = width(s) - WALL, height(s) - WALL
        constant = torsion_constant(width(s), height(s))
        return (1 - 2 * (b + h) * WALL**3 / 3 / constant) / (2 * b * h), WALL / constant

    @staticmethod
    def gain(s, share):
        """What a part of the section's force, the sum of share(s, k) times cut force k, gains per
        length: M_y grows by V_z and M_z by -V_y. Factors of the cut forces."""
        step, factors = 1e-5 * (-1 if s > LENGTH / 2 else 1), [0.0] * 6
        for k in (N, M_Y, M_Z):
            factors[k] = (-1.5 * share(s, k) + 2 * share(s + step, k)
                          - 0.5 * share(s + 2 * step, k)) / step
        factors[V_Z], factors[V_Y] = share(s, M_Y), -share(s, M_Z)
        return factors

    @staticmethod
    def half_flange(s, k):
        """Force of the half y > 0 of the top flange per cut force."""
        b, h = width(s), height(s)
        plate = b / 2 * WALL
        return {N: plate / area(s), M_Y: plate * (h - WALL) / 2 / second_moment(b, h, WALL),
                M_Z: -plate * b / 4 / second_moment(h, b, WALL)}[k]

    @staticmethod
    def half_web(s, k):
        """Likewise of the half z > 0 of the web at y > 0."""
        b, h = width(s), height(s)
        inside = h / 2 - WALL
        plate = inside * WALL
        return {N: plate / area(s), M_Y: plate * inside / 2 / second_moment(b, h, WALL),
                M_Z: -plate * (b - WALL) / 2 / second_moment(h, b, WALL)}[k]

    @staticmethod
    def quarter(s, k):
        """Both together."""
        return Leg.half_flange(s, k) + Leg.half_web(s, k)

    def web_end(self, s, y, z):
        """Up a web: from the middle of the flange for N and M_y, of the web for M_z, where their
        flows vanish."""
        from_flange, from_web = self.gain(s, self.half_flange), self.gain(s, self.half_web)
        flow, face = self.torsion(s)

        def shear(cut):
            up = (z * from_flange[N] * cut[N] + from_flange[M_Y] * cut[M_Y]
                  + from_flange[V_Z] * cut[V_Z]
                  - z * y * (from_web[M_Z] * cut[M_Z] + from_web[V_Y] * cut[V_Y]))
            return (up + y * flow * cut[T]) / WALL + y * face * cut[T]
        return shear

    def web_middle(self, s, y):
        """Up a web, where only V_z and M_y leave a flow."""
        factors = self.gain(s, self.quarter)
        flow, face = self.torsion(s)

        def shear(cut):
            up = factors[V_Z] * cut[V_Z] + factors[M_Y] * cut[M_Y]
            return (up + y * flow * cut[T]) / WALL + y * face * cut[T]
        return shear

    def flange_shear(self, s, part, z):
        """Along a flange, towards +y, at a part of half its width: what comes from the middle of
        the web less what the strip between there and the middle of the flange takes; its edge
        moves in proportion to the mid-line."""
        def strip(at, k):
            y = part * width(s) / 2 * (width(at) - WALL) / (width(s) - WALL)
            sign = z if k == M_Y else 1
            plate = y * WALL
            return sign * {N: plate / area(at),
                           M_Y: (plate * (height(at) - WALL) / 2
                                 / second_moment(width(at), height(at), WALL)),
                           M_Z: -plate * y / 2 / second_moment(height(at), width(at), WALL)}[k]

        comes, taken = self.gain(s, self.quarter), self.gain(s, strip)
        flow, face = self.torsion(s)

        def shear(cut):
            along = comes[V_Y] * cut[V_Y] + comes[M_Z] * cut[M_Z]
            along -= sum(factor * force for factor, force in zip(taken, cut))
            return (along - z * flow * cut[T]) / WALL - z * face * cut[T]
        return shear


# Time.

def instants_of(situation, count=48):
    return [situation.duration * i / count for i in range(count + 1)]


def extremes(situation, function):
    """The values at the beginning, at all turns, and at the end."""
    at = instants_of(situation)
    values = [function(t) for t in at]
    noise = 1e-9 * max(map(abs, values))
    found = [values[0]]
    for i in range(1, len(at) - 1):
        before, behind = values[i] - values[i - 1], values[i] - values[i + 1]
        if before * behind <= 0 or max(abs(before), abs(behind)) < noise:
            continue
        sign = 1 if before > 0 else -1
        turn = golden(lambda t, k=sign: -k * function(t), at[i - 1], at[i + 1], 1e-6)
        found.append(sign * max(sign * values[i], sign * function(turn)))
    return found + [values[-1]]


def turning_values(values):
    """Without those between their neighbours, of a history that begins again: from its highest
    point."""
    top, noise = values.index(max(values)), 1e-9 * max(map(abs, values))
    kept = []
    for value in values[top:] + values[:top + 1]:
        if kept and abs(value - kept[-1]) <= noise:
            continue
        if len(kept) > 1 and (kept[-1] - kept[-2]) * (value - kept[-1]) > 0:
            kept.pop()
        kept.append(value)
    return kept[:-1] if abs(kept[-1] - kept[0]) <= noise else kept


class Verified:
    """The factors of a flight."""

    def __init__(self, situations, shear_lag=True):
        self.situations, self.leg = situations, Leg(situations, shear_lag)

    def envelope(self, s, which):
        values = [value for situation in self.situations.values()
                  for value in extremes(situation, lambda t, x=situation: x.cut(t, s)[which])]
        return min(values), max(values)

    def history(self, s, stress):
        """Extremes of a stress over the flight, one situation after the other."""
        return [value for situation in self.situations.values()
                for value in extremes(situation, lambda t, x=situation: stress(x.cut(t, s)))]

    def factors(self, s, side):
        """Of the checks of a section: points, and yield of the flanges between the webs."""
        place = f"{s:g}{side}"
        category = {0: CATEGORY_AT_HEAD, LENGTH: CATEGORY_AT_FOOT}.get(s, CATEGORY)
        found = {}
        for name, y, z, shear in self.leg.points(s):
            def direct(cut, y=y, z=z):
                return self.leg.direct(s, y, z, cut)

            history = self.history(s, direct)
            found[f"yield/{place}/{name}"] = YIELD / self.equivalent(s, y, z, shear)
            channels = [(rainflow(turning_values(history)), direct_damage(category))]
            found[f"fatigue/{place}/{name}"] = fatigue_factor(channels, FLIGHTS, 1.0)
            if shear is None:
                found[f"stress-range/{place}/{name}"] = (1.5 * YIELD
                                                         / (max(history) - min(history)))
                continue
            in_shear = (rainflow(turning_values(self.history(s, shear))),
                        shear_damage(CATEGORY_OF_SHEAR))
            found[f"shear-fatigue/{place}/{name}"] = fatigue_factor([in_shear], FLIGHTS, 1.0)
            channels.append(in_shear)
            found[f"combined-fatigue/{place}/{name}"] = fatigue_factor(channels, FLIGHTS, 1.0)
        for z, name in ((1, "top-flange"), (-1, "bottom-flange")):
            found[f"yield/{place}/{name}"] = YIELD / self.worst_of_flange(s, z)
        return found

    def equivalent(self, s, y, z, shear):
        """The largest, after von Mises: one peak."""
        def at(situation, t):
            cut = situation.cut(t, s)
            return math.hypot(self.leg.direct(s, y, z, cut),
                              math.sqrt(3) * shear(cut) if shear else 0.0)

        largest, situation, t = max(((at(situation, t), situation, t)
                                     for situation in self.situations.values()
                                     for t in instants_of(situation)), key=lambda found: found[0])
        if t in (0.0, situation.duration):
            return largest
        step = situation.duration / 48
        return at(situation, golden(lambda t: -at(situation, t), t - step, t + step, 1e-6))

    def worst_of_flange(self, s, z):
        def at(part):
            return self.equivalent(s, part * width(s) / 2, z * height(s) / 2,
                                   self.leg.flange_shear(s, part, z))

        end = 1 - 2 * WALL / width(s)
        grid = [end * k / 5 for k in range(-5, 6)]
        best = max(range(11), key=lambda k: at(grid[k]))
        if best in (0, 10):
            return at(grid[best])
        return at(golden(lambda part: -at(part), grid[best - 1], grid[best + 1], 1e-4))


# What is compared.

def motion_rows(state, program):
    """The wheel and the forces on the leg and on the axle, world axes."""
    spin = total((1, product(state.wheel.d, transposed(state.wheel.v))))
    change = total((1, product(state.wheel.dd, transposed(state.wheel.v))),
                   (1, product(state.wheel.d, transposed(state.wheel.d))))
    mine = {}
    for name, skew, key in (("wheel, omega", spin, "omega"), ("wheel, alpha", change, "alpha")):
        mine[name] = ((skew[2][1], skew[0][2], skew[1][0]), program["bodies"]["wheel"][key])
    centre = program["points"]["C"]
    for order, (key, aircraft, leg) in enumerate((
            ("position", state.aircraft.v, state.leg.v),
            ("velocity", state.aircraft.d, state.leg.d),
            ("acceleration", state.aircraft.dd, state.leg.dd))):
        place = add((0.0, state.path[order], 0.0), of(aircraft, HINGE), of(leg, CENTRE))
        mine[f"C, {key}"] = place, centre[key]
    for joint, s in (("hinge", 0.0), ("foot", LENGTH)):
        cut, on = state.cut(s), program["joints"][joint]
        assert on["on"] == "leg"
        sign = 1 if joint == "foot" else -1  # by the part beyond, or against it
        mine[f"{joint}, force"] = (of(state.leg.v, times(sign, (cut[V_Z], cut[V_Y], -cut[N]))),
                                   on["force"])
        mine[f"{joint}, moment"] = (of(state.leg.v, times(sign, (cut[M_Z], cut[M_Y], -cut[T]))),
                                    on["moment"])
    for name, (here, theirs) in mine.items():
        here = of(state.climb, here)
        for axis in range(3):
            yield f"{name}, {'xyz'[axis]}", theirs[axis], here[axis]


def envelope_rows(flown, results):
    """Of all stations; outside the beam nothing is cut."""
    for station in results["beam"]["stations"]:
        s, side = station["s"], station["side"]
        outside = (s, side) in ((0.0, "-"), (LENGTH, "+"))
        for which, force in enumerate(NAMES):
            here = (0.0, 0.0) if outside else flown.envelope(s, which)
            for end, value, own in zip(("least", "largest"), station[force], here):
                yield f"{force}, {end}, at {s:g}{side}", value, own


def groups(run, verified):
    """Rows of program and own values, as report() in shipped_cases.py takes them. `run` and
    `verified` call the program."""
    for t in (0.0, 0.35):
        state = instant().at(t)
        program = run("motion", "sections/landing-gear/gear.toml", "--at", str(t))["states"][0]
        yield (f"landing gear: wheel and joints at {t} s", list(motion_rows(state, program)),
               1e-11, 1e3)
    yield ("landing gear: extremes of the cut forces",
           list(envelope_rows(Verified({"": instant()}, False),
                              verified("sections/landing-gear/gear.toml"))), 1e-9, 1e3)
    for name, settings, flown in (
            ("as shipped", (), Verified(flight())),
            ("rotary inertia, no shear lag",
             ("beam.rotary_inertia=true", "strength.shear_lag=false"),
             Verified(flight(rotary=True), shear_lag=False)),
            ("side force along -x, wheel not braked",
             ("forces.tyre_side.direction=-x", "forces.tyre_aft.point=axle.C"),
             Verified(flight(side=-8e3, brake=False)))):
        results = verified("sections/landing-gear/retraction.toml", *settings)
        rows = list(envelope_rows(flown, results))
        yield f"landing gear, {name}: extremes of the cut forces", rows, 1e-9, 1e4
        factors = {}
        for s, side in STATIONS:
            factors.update(flown.factors(s, side))
        theirs = {check["id"]: check["safety_factor"] for check in results["checks"]}
        for points, allowed in (("corners", 1e-9), ("other points", 1e-4)):
            rows = [(check, theirs.get(check, math.inf), factor)
                    for check, factor in factors.items()
                    if ("/corner" in check) == (points == "corners")]
            yield f"landing gear, {name}: factors of {points}", rows, allowed, None
        theirs = {check["id"]: check["safety_factor"] for check in results["governing"].values()}
        rows = []
        for criterion in ("yield", "fatigue"):
            least = min((c for c in factors if c.startswith(criterion + "/")), key=factors.get)
            rows.append((least, theirs.get(least, math.inf), factors[least]))
        yield f"landing gear, {name}: governing factors", rows, 1e-4, None
