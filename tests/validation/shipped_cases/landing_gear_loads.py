"""The leg of the retracting landing gear: its motion and cut forces. Used by landing_gear.py.

No angular velocity, Euler equation or recursion over bodies: a point of the leg or wheel stands at

    Rx(alpha) ((0, u, 0) + Rz(psi) (B + Ry(beta) p)),   p = C + Rx(theta) q in the wheel,

and its acceleration is the second derivative of that. Every body is its mass, centre and second
moments, int p p' dm; gyroscopic moments come out of d'Alembert's forces on its points. Cut forces
are those of the free part below the cut. Leg axes x''' y''' z''': the leg goes along -z'''. Beam:
x = -z''', y = y''', z = x'''. SI units.
"""
import math
from functools import lru_cache

LENGTH, OUT, TYRE = 1.1, 0.35, 0.33  # leg; axle, along -x'''; radius of the tyre
HINGE = (2.1, 0.0, 1.3)
CENTRE = (-OUT, 0.0, -LENGTH)
CONTACT = (-OUT, 0.0, -LENGTH - TYRE)
AXLE_MASS, WHEEL_MASS, WHEEL_INERTIA = 18.0, 62.0, (2.6, 1.5, 1.5)
DRAG, GRAVITY = 250.0, (0.0, 0.0, -9.81)
DENSITY, WALL = 7850.0, 0.01
N, V_Y, V_Z, T, M_Y, M_Z = range(6)


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
        """N, V_y, V_z, T, M_y, M_z: what the part beyond s does to the cut; axle and wheel are
        beyond the foot."""
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
