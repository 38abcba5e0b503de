"""What the shipped cases' calculations have in common: a beam of boxes, cut forces from the free
part of it, shear lag, stresses, extremes over a period, rainflow and Miner's rule.

Shares no code or method with the program: derivatives are central differences of closed-form
positions, mass integrals Simpson's rule, extremes a fine grid with golden sections, the fatigue
factor a bisection. Vectors are complex numbers x + iy; moments anticlockwise. SI units.
"""
import bisect
import csv
import math
from functools import lru_cache

GRAVITY = -9.81j


def cross(a, b):
    return (a.conjugate() * b).imag


class Moving:
    """A point or unit vector: position, velocity, acceleration."""

    def __init__(self, v, d, dd):
        self.v, self.d, self.dd = v, d, dd

    def __add__(self, other):
        return Moving(self.v + other.v, self.d + other.d, self.dd + other.dd)

    def __mul__(self, factor):
        return Moving(self.v * factor, self.d * factor, self.dd * factor)

    def __sub__(self, other):
        return self + other * -1


def fixed(p):
    return Moving(p, 0.0, 0.0)


def moving(position, q, rate=1.0, acceleration=0.0, step=0.02):
    """A position as function of a coordinate q that has these time derivatives; eighth order."""
    p = [position(q + k * step) for k in range(-4, 5)]
    first = sum(c * (p[4 + k] - p[4 - k]) for k, c in ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105),
                                                       (4, -1 / 280))) / step
    second = (sum(c * (p[4 + k] + p[4 - k]) for k, c in ((1, 8 / 5), (2, -1 / 5), (3, 8 / 315),
                                                         (4, -1 / 560))) - 205 / 72 * p[4])
    return Moving(p[4], first * rate, second / step**2 * rate**2 + first * acceleration)


def circles(a, radius_a, b, radius_b, side):
    """The point at given distances from a and b, to the left (+1) or right of a -> b."""
    line = b - a
    along = (abs(line) ** 2 + radius_a**2 - radius_b**2) / (2 * abs(line))
    return a + line / abs(line) * (along + side * 1j * math.sqrt(radius_a**2 - along**2))


def bar_moment(start, end, mass, about):
    """The moment about a point that the joint forces on a uniform bar must have."""
    bar, centre = end - start, (start + end) * 0.5
    return mass * (cross(bar.v, bar.dd) / 12 + cross(centre.v - about, centre.dd - GRAVITY))


class PeriodicLines:
    """Straight lines through a table whose ends meet."""

    def __init__(self, path, factor):
        with open(path, encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
        self.t = [float(row[0]) for row in rows]
        self.y = [float(row[1]) * factor for row in rows]

    def __call__(self, time):
        """Value."""
        time %= self.t[-1]
        i = min(max(bisect.bisect_right(self.t, time) - 1, 0), len(self.t) - 2)
        b = (time - self.t[i]) / (self.t[i + 1] - self.t[i])
        return (1 - b) * self.y[i] + b * self.y[i + 1]


class PeriodicSpline(PeriodicLines):
    """Cubic spline through a table whose ends meet, from its second derivatives."""

    def __init__(self, path, factor):
        super().__init__(path, factor)
        n = len(self.t) - 1
        h = [self.t[i + 1] - self.t[i] for i in range(n)]
        rise = [(self.y[i + 1] - self.y[i]) / h[i] for i in range(n)]
        curvature = [0.0] * n
        for _ in range(200):  # Gauss-Seidel: diagonally dominant, error below a quarter each time
            for i in range(n):
                right = 6 * (rise[i] - rise[i - 1])
                curvature[i] = (right - h[i - 1] * curvature[i - 1]
                                - h[i] * curvature[(i + 1) % n]) / (2 * (h[i - 1] + h[i]))
        self.m = curvature + curvature[:1]

    def __call__(self, time):
        """Value and two derivatives."""
        time %= self.t[-1]
        i = min(max(bisect.bisect_right(self.t, time) - 1, 0), len(self.t) - 2)
        h = self.t[i + 1] - self.t[i]
        a, b = (self.t[i + 1] - time) / h, (time - self.t[i]) / h
        m, n = self.m[i], self.m[i + 1]
        return (a * self.y[i] + b * self.y[i + 1] + ((a**3 - a) * m + (b**3 - b) * n) * h**2 / 6,
                (self.y[i + 1] - self.y[i]) / h + ((3 * b**2 - 1) * n - (3 * a**2 - 1) * m) * h / 6,
                a * m + b * n)


class Beam:
    """Boxes of one width and plates, of a height linear between stations."""

    def __init__(self, heights, width, flange, web, density, rotary=False, hole=(None, 0.0)):
        self.hole = hole  # station and diameter, through both webs on the axis
        self.heights, self.width, self.flange, self.web = heights, width, flange, web
        self.density, self.rotary = density, rotary
        self.length = heights[-1][0]
        self.zones = []  # for shear lag: start, end, whether a force makes a peak of the moment

    def height(self, s):
        for (low, first), (high, last) in zip(self.heights, self.heights[1:]):
            if low <= s <= high * (1 + 1e-12):
                return first + (last - first) * (s - low) / (high - low)
        raise ValueError(s)

    def area(self, s):
        return 2 * (self.width * self.flange + (self.height(s) - 2 * self.flange) * self.web)

    def inertia(self, s):
        h = self.height(s)
        return (self.width * h**3
                - (self.width - 2 * self.web) * (h - 2 * self.flange) ** 3) / 12

    @lru_cache(maxsize=None)
    def beyond(self, s):
        """Mass, first and second moment about the start, rotary inertia of the part beyond s."""
        total = [0.0] * 4
        for (low, _), (high, _) in zip(self.heights, self.heights[1:]):
            low = max(low, s)
            if high <= low:
                continue
            for at, weight in ((low, 1), ((low + high) / 2, 4), (high, 1)):
                share = self.density * weight * (high - low) / 6
                for k in range(3):
                    total[k] += share * self.area(at) * at**k
                if self.rotary:
                    total[3] += share * self.inertia(at)
        return total

    @property
    def mass(self):
        return self.beyond(0.0)[0]

    def free_moment(self, u):
        """Moment of weight and inertia about the start where that stands still."""
        _, first, second, rotary = self.beyond(0.0)
        return first * cross(u.v, GRAVITY) - (second + rotary) * cross(u.v, u.dd)

    def cut(self, state, s, side):
        """N, V, M at s. State: axis, start, loads (station, force, moment about the axis)."""
        u, start, loads = state
        mass, first, second, rotary = self.beyond(s)
        field = GRAVITY - start.dd
        force = mass * field - first * u.dd
        moment = ((first - s * mass) * cross(u.v, field)
                  - (second - s * first + rotary) * cross(u.v, u.dd))
        for station, load, couple in loads:
            if station > s or (station == s and side == "-"):
                force += load
                moment += (station - s) * cross(u.v, load) + couple
        local = force * u.v.conjugate()
        return local.real, local.imag, -moment

    def find_zones(self, states):
        """The stretches between zero moments at the instant of the largest moment."""
        def moment(s):
            return self.cut(at, s, "-")[2]

        inner = [self.length * i / 400 for i in range(1, 400)]
        at = max(states, key=lambda state: max(abs(self.cut(state, s, "-")[2]) for s in inner))
        borders = [0.0]
        for low, high in zip(inner, inner[1:]):
            if moment(low) * moment(high) > 0:
                continue
            positive = moment(low) > 0
            for _ in range(60):  # a zero, or a couple that turns the sign
                middle = (low + high) / 2
                low, high = (middle, high) if (moment(middle) > 0) == positive else (low, middle)
            borders.append(high)
        borders.append(self.length)
        for start, end in zip(borders, borders[1:]):
            # None of these beams is clamped: moments at their ends are those of couples.
            largest = max(abs(moment(s)) for s in inner if start < s < end)
            assert max(abs(moment(1e-9)), abs(moment(self.length))) < largest or len(borders) > 2
            peak = any(start < station < end for station, *_ in at[2])
            self.zones.append((start, end, peak))

    def idle(self, s):
        """What shear lag takes of the flanges' width: EN 1993-1-5, 3.1(1) and table 3.1."""
        zone = next((z for z in self.zones if z[0] <= s <= z[1]), None)
        between_webs = self.width - self.web
        if zone is None or between_webs / 2 < (zone[1] - zone[0]) / 50:
            return 0.0
        kappa = between_webs / 2 / (zone[1] - zone[0])
        assert kappa <= 0.7
        more = 6.4 * kappa**2
        if zone[2]:
            more = 6 * (kappa - 1 / (2500 * kappa)) + 1.6 * kappa**2
        return between_webs * (1 - 1 / (1 + more))

    def working(self, s):
        """Area and second moment without what shear lag leaves idle."""
        idle, h = self.idle(s), self.height(s)
        return (self.area(s) - 2 * idle * self.flange,
                self.inertia(s) - idle * (h**3 - (h - 2 * self.flange) ** 3) / 12)

    def edge(self, state, s, side, sign):
        N, _, M = self.cut(state, s, side)
        d = self.hole[1] if s == self.hole[0] else 0.0
        area, inertia = self.working(s)
        return (N / (area - 2 * self.web * d)
                + sign * M * self.height(s) / 2 / (inertia - self.web * d**3 / 6))

    def web_end(self, state, s, side, sign):
        """Direct and shear stress where the webs meet a flange. The shear is what the force
        N A_f/A + M S_f/I of the flange gains along the beam, M rising by V; the whole flange takes
        part in it."""
        N, V, M = self.cut(state, s, side)
        step = -1e-5 if side == "-" else 1e-5
        plate = self.width * self.flange

        def flange_force(k):
            at = s + k * step
            return plate * (N / self.area(at) + (M + k * step * V) * sign
                            * (self.height(at) - self.flange) / 2 / self.inertia(at))

        flow = (-1.5 * flange_force(0) + 2 * flange_force(1) - 0.5 * flange_force(2)) / step
        area, inertia = self.working(s)
        return (N / area + sign * M * (self.height(s) / 2 - self.flange) / inertia,
                flow / (2 * self.web))


def golden(function, low, high, tolerance=1e-9):
    """Where a function is smallest between two times."""
    ratio = (math.sqrt(5) - 1) / 2
    while high - low > tolerance * max(abs(low), abs(high)):
        left, right = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (low, right) if function(left) < function(right) else (left, high)
    return (low + high) / 2


def turning_values(function, period, count, fine=True):
    """The extremes of a periodic function in order of time; ripples below 1e-9 are none."""
    step = period / count
    grid = [function(i * step) for i in range(count)]
    noise = 1e-9 * max(map(abs, grid))
    values = []
    for i in range(count):
        before, here, behind = grid[i - 1], grid[i], grid[(i + 1) % count]
        for sign in (1, -1):
            if sign * (here - before) >= 0 and sign * (here - behind) > 0:
                if fine:
                    at = golden(lambda t, k=sign: -k * function(t), (i - 1) * step, (i + 1) * step)
                    here = max(sign * here, sign * function(at)) * sign
                values.append(here)
    kept = []
    for value in values:
        if not kept or abs(value - kept[-1]) > noise:
            kept.append(value)
    return kept


def rainflow(values):
    """Ranges of the full cycles of a closed history: three-point rule from the highest point."""
    top = values.index(max(values))
    ranges, stack = [], []
    for value in values[top:] + values[:top + 1]:
        stack.append(value)
        while len(stack) > 3 and abs(stack[-1] - stack[-2]) >= abs(stack[-2] - stack[-3]):
            ranges.append(abs(stack[-2] - stack[-3]))
            del stack[-3:-1]
    while len(stack) > 1:  # the highest point, the lowest and back
        ranges.append(abs(stack[0] - stack[1]))
        del stack[:2]
    return ranges


def direct_damage(category):
    """Damage of 5e6 cycles of a range; EN 1993-1-9 7.1(3), slopes 3 and 5, cut-off at 1e8."""
    knee = category * 1e6 * 0.4 ** (1 / 3)
    cut_off = knee * 0.05**0.2

    def damage(acting):
        if acting < cut_off * (1 - 1e-15):
            return 0.0
        return (acting / knee) ** (3 if acting >= knee else 5)
    return damage


def shear_damage(category):
    """The same of shear stress: slope 5, cut-off at 1e8."""
    cut_off = category * 1e6 * 0.02**0.2
    return lambda acting: 0.0 if acting < cut_off * (1 - 1e-15) else 0.05 * (acting / cut_off) ** 5


def fatigue_factor(channels, cycles, gamma_Mf):
    """The largest factor with damage <= 1 of all channels: ranges and their damage."""
    def damage(factor):
        return sum(cycles / 5e6 * damage_of(factor * gamma_Mf * value)
                   for ranges, damage_of in channels for value in ranges)

    low, high = 0.0, 1e12 / max(max(ranges) for ranges, _ in channels)
    while high - low > 1e-13 * high:
        middle = (low + high) / 2
        low, high = (middle, high) if damage(middle) <= 1 else (low, middle)
    return low
