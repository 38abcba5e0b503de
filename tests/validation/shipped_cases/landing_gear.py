"""The retracting landing gear: what shipped_cases.py compares of its two cases, in space.

No angular velocity, Euler equation or recursion over bodies: a point of the leg or wheel stands at

    Rx(alpha) ((0, u, 0) + Rz(psi) (B + Ry(beta) p)),   p = C + Rx(theta) q in the wheel,

and its acceleration is the second derivative of that. Every body is its mass, centre and second
moments, int p p' dm; gyroscopic moments come out of d'Alembert's forces on its points. Cut forces
are those of the free part below the cut. Leg axes x''' y''' z''': the leg goes along -z'''. Beam:
x = -z''', y = y''', z = x'''. SI units.

Shear stress: torsion by Bredt, with the torsion constant from finite differences, for the walls are
a tenth of their box thick; and what the force of the part of the section between two places of
symmetry gains along the beam.
"""
import math
from functools import lru_cache

from hand_calculation import direct_damage, fatigue_factor, golden, rainflow, shear_damage

LENGTH, OUT, TYRE = 1.1, 0.35, 0.33  # leg; axle, along -x'''; radius of the tyre
HINGE = (2.1, 0.0, 1.3)
CENTRE = (-OUT, 0.0, -LENGTH)
CONTACT = (-OUT, 0.0, -LENGTH - TYRE)
AXLE_MASS, WHEEL_MASS, WHEEL_INERTIA = 18.0, 62.0, (2.6, 1.5, 1.5)
DRAG, GRAVITY = 250.0, (0.0, 0.0, -9.81)
DENSITY, WALL, YIELD = 7850.0, 0.01, 355e6
FLIGHTS, CATEGORY, CATEGORY_AT_FOOT, CATEGORY_OF_SHEAR = 20000, 100, 71, 100
NAMES = ("N", "V_y", "V_z", "T", "M_y", "M_z")
N, V_Y, V_Z, T, M_Y, M_Z = range(6)
STATIONS = ((0.0, "+"), (LENGTH, "-"))


# Vectors and 3 x 3 matrices, rows of rows.

def add(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def times(factor, vector):
    return [factor * part for part in vector]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def of(matrix, vector):
    return [sum(m * v for m, v in zip(row, vector)) for row in matrix]


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def total(*weighted):
    return [[sum(w * m[i][j] for w, m in weighted) for j in range(3)] for i in range(3)]


class Turn:
    """A rotation matrix and its two derivatives in time."""

    def __init__(self, v, d, dd):
        self.v, self.d, self.dd = v, d, dd

    @staticmethod
    def about(axis, coordinate):
        """By an angle given with its two derivatives."""
        q, rate, acceleration = coordinate
        j, k = (axis + 1) % 3, (axis + 2) % 3

        def matrix(cos, sin, one):
            m = [[0.0] * 3 for _ in range(3)]
            m[axis][axis], m[j][j], m[k][k], m[k][j], m[j][k] = one, cos, cos, sin, -sin
            return m

        c, s = math.cos(q), math.sin(q)
        first, second = matrix(-s, c, 0.0), matrix(-c, -s, 0.0)
        return Turn(matrix(c, s, 1.0), total((rate, first)),
                    total((acceleration, first), (rate**2, second)))

    def __mul__(self, other):
        return Turn(product(self.v, other.v),
                    total((1, product(self.d, other.v)), (1, product(self.v, other.d))),
                    total((1, product(self.dd, other.v)), (2, product(self.d, other.d)),
                          (1, product(self.v, other.dd))))


# The leg: boxes whose width (y) and height (z) change linearly.

def width(s):
    return 0.12 - 0.02 * s / LENGTH


def height(s):
    return 0.14 - 0.04 * s / LENGTH


def area(s):
    return width(s) * height(s) - (width(s) - 2 * WALL) * (height(s) - 2 * WALL)


def second_moment(b, h, t):
    """Of a hollow box about the axis along b."""
    return (b * h**3 - (b - 2 * t) * (h - 2 * t) ** 3) / 12


GAUSS = [(-math.sqrt(5 + k * 2 * math.sqrt(10 / 7)) / 3, (322 - k * 13 * math.sqrt(70)) / 900)
         for k in (1, -1)]
GAUSS += [(0.0, 128 / 225)] + [(-x, w) for x, w in GAUSS]


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


class Lump:
    """Mass, centre and second moments about it, along the leg's axes."""

    def __init__(self, mass, centre, moments):
        self.mass, self.centre, self.moments = mass, centre, moments


AXLE = Lump(AXLE_MASS, (-OUT / 2, 0.0, -LENGTH), (AXLE_MASS * OUT**2 / 12, 0.0, 0.0))
WHEEL_MOMENTS = [sum(WHEEL_INERTIA) / 2 - about for about in WHEEL_INERTIA]


@lru_cache(maxsize=None)
def leg_beyond(s, rotary):
    """With or without what the mass beside the axis adds to the second moments."""
    mass = first = second = across_x = across_y = 0.0
    for x, w in GAUSS:
        at, weight = s + (LENGTH - s) * (1 + x) / 2, DENSITY * w * (LENGTH - s) / 2
        mass += weight * area(at)
        first += weight * area(at) * at
        second += weight * area(at) * at**2
        if rotary:
            across_x += weight * second_moment(width(at), height(at), WALL)
            across_y += weight * second_moment(height(at), width(at), WALL)
    centre = first / mass if mass else s
    return Lump(mass, (0.0, 0.0, -centre), (across_x, across_y, second - first * centre))


# Situations: coordinates with two derivatives, and the tyre's force, as functions of time.

def polynomial(c0, c1, c2):
    return lambda t: (c0 + c1 * t + c2 * t**2, c1 + 2 * c2 * t, 2 * c2)


def step(begin, end, duration):
    def at(t):
        u, rise = t / duration, end - begin
        return (begin + rise * (10 * u**3 - 15 * u**4 + 6 * u**5),
                rise / duration * (30 * u**2 - 60 * u**3 + 30 * u**4),
                rise / duration**2 * (60 * u - 180 * u**2 + 120 * u**3))
    return at


REST = polynomial(0.0, 0.0, 0.0)


class Situation:
    def __init__(self, **parts):
        self.duration, self.alpha = parts["duration"], parts.get("alpha", 0.1)
        self.path = parts.get("path", polynomial(0.0, 75.0, 1.25))
        self.yaw = parts.get("yaw", polynomial(0.0, 0.05, 0.01))
        self.hinge, self.spin = parts["hinge"], parts.get("spin", REST)
        self.tyre = parts.get("tyre", lambda t: ())
        self.rotary = parts.get("rotary", False)
        self.states = {}

    def at(self, t):
        if t not in self.states:
            self.states[t] = State(self, t)
        return self.states[t]

    def cut(self, t, s):
        return self.at(t).cut(s)


class State:
    """An instant. The force on a point p of the leg is mass (field + spread p), leg axes."""

    def __init__(self, situation, t):
        self.aircraft = Turn.about(2, situation.yaw(t))
        self.leg = self.aircraft * Turn.about(1, situation.hinge(t))
        self.spin = Turn.about(0, situation.spin(t))
        self.wheel = self.leg * self.spin
        self.climb = Turn.about(0, (situation.alpha, 0.0, 0.0)).v
        self.path = situation.path(t)
        self.rotary = situation.rotary
        to_leg = transposed(self.leg.v)
        to_climb = transposed(self.climb)
        hinge = add((0.0, self.path[2], 0.0), of(self.aircraft.dd, HINGE))
        self.field = of(to_leg, add(of(to_climb, GRAVITY), times(-1, hinge)))
        self.spread = total((-1, product(to_leg, self.leg.dd)))
        self.drag = of(to_leg, (0.0, -DRAG, 0.0))
        self.tyre = [(of(to_leg, of(to_climb, force)), at) for force, at in situation.tyre(t)]
        # The wheel's points move in the leg: Q q, and their acceleration is that of R_leg Q q.
        columns = zip(WHEEL_MOMENTS, transposed(self.spin.v),
                      transposed(product(to_leg, self.wheel.dd)))
        self.wheel_couple = add(*(times(-moment, cross(q, dd)) for moment, q, dd in columns))
        self.cuts = {}

    def force_of(self, lump):
        return times(lump.mass, add(self.field, of(self.spread, lump.centre)))

    def couple_of(self, lump):
        columns = transposed(self.spread)
        units = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return add(*(times(moment, cross(unit, column))
                     for moment, unit, column in zip(lump.moments, units, columns)))

    def cut(self, s):
        """N, V_y, V_z, T, M_y, M_z: the force of the part beyond s on the cut, just before a load
        at the foot."""
        if s in self.cuts:
            return self.cuts[s]
        forces, moment = [], list(self.wheel_couple)
        at = (0.0, 0.0, -s)

        def take(force, place):
            forces.append(force)
            moment[:] = add(moment, cross(add(place, times(-1, at)), force))

        for lump in (leg_beyond(s, self.rotary), AXLE):
            take(self.force_of(lump), lump.centre)
            moment[:] = add(moment, self.couple_of(lump))
        take(self.force_of(Lump(WHEEL_MASS, CENTRE, None)), CENTRE)
        take(times(LENGTH - s, self.drag), (0.0, 0.0, -(LENGTH + s) / 2))
        for force, at_tyre in self.tyre:
            take(force, at_tyre)
        force = add(*forces)
        self.cuts[s] = (-force[2], force[1], force[0], -moment[2], moment[1], moment[0])
        return self.cuts[s]

    def in_world(self, vector):
        return of(self.climb, vector)


def instant():
    """gear.toml: rates of one instant."""
    return Situation(duration=0.5, hinge=polynomial(0.4, 0.6, 0.15), spin=polynomial(0, -60, 4))


def flight(side=8e3, brake=True, rotary=False):
    """retraction.toml, in the order of a flight. Without a brake the ground's drag passes through
    the axle alone: no couple at the wheel."""
    quarter = math.pi / 2

    def tyre(t):
        pulse = (1 - math.cos(2 * math.pi * t / 0.2)) / 2
        return (((0.0, -12e3 * pulse, 0.0), CONTACT if brake else CENTRE),
                ((side * pulse, 0.0, 45e3 * pulse), CONTACT))

    return {"landing": Situation(duration=0.2, alpha=0.0, path=polynomial(0.0, 75.0, 0.0),
                                 yaw=REST, hinge=REST, tyre=tyre, rotary=rotary),
            "retraction": Situation(duration=6.0, hinge=step(0.0, quarter, 6.0),
                                    spin=polynomial(0.0, -60.0, 5.0), rotary=rotary),
            "extension": Situation(duration=6.0, hinge=step(quarter, 0.0, 6.0),
                                   rotary=rotary)}


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
        category = CATEGORY_AT_FOOT if s == LENGTH else CATEGORY
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


def groups(run, verified):
    """Rows of program and own values, as report() in shipped_cases.py takes them. `run` and
    `verified` call the program."""
    for t in (0.0, 0.35):
        state = instant().at(t)
        program = run("motion", "sections/landing-gear/gear.toml", "--at", str(t))["states"][0]
        yield (f"landing gear: wheel and joints at {t} s", list(motion_rows(state, program)),
               1e-11, 1e3)
    case = "sections/landing-gear/retraction.toml"
    for name, rotary, lag, settings in (
            ("as shipped", False, True, ()),
            ("rotary inertia, no shear lag", True, False,
             ("beam.rotary_inertia=true", "strength.shear_lag=false"))):
        flown = Verified(flight(rotary=rotary), lag)
        results = verified(case, *settings)
        rows = []
        for station in results["beam"]["stations"]:
            s, side = station["s"], station["side"]
            if (s, side) in ((0.0, "-"), (LENGTH, "+")):
                continue
            for which, force in enumerate(NAMES):
                for end, theirs, here in zip(("least", "largest"), station[force],
                                             flown.envelope(s, which)):
                    rows.append((f"{force}, {end}, at {s:g}{side}", theirs, here))
        yield f"landing gear, {name}: extremes of the cut forces", rows, 1e-9, 1e4
        theirs = {check["id"]: check["safety_factor"] for check in results["checks"]}
        factors = {}
        for s, side in STATIONS:
            factors.update(flown.factors(s, side))
        for corner, allowed in ((True, 1e-9), (False, 1e-4)):
            rows = [(check, theirs.get(check, math.inf), factor)
                    for check, factor in factors.items() if ("/corner" in check) == corner]
            yield (f"landing gear, {name}: factors of {'corners' if corner else 'other points'}",
                   rows, allowed, None)
        theirs = {check["id"]: check["safety_factor"] for check in results["governing"].values()}
        rows = []
        for criterion in ("yield", "fatigue"):
            least = min((c for c in factors if c.startswith(criterion + "/")), key=factors.get)
            rows.append((least, theirs.get(least, math.inf), factors[least]))
        yield f"landing gear, {name}: governing factors", rows, 1e-4, None
