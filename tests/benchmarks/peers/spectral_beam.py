"""A reference for beams: Timoshenko's beam by two spectral elements, which meet where the load acts.

Polynomials through Gauss-Lobatto points, whose error falls exponentially with the degree; long
double, since a slender beam's stiffness against shear costs the digits that separate it from that
against bending.
"""
import numpy as np

Real = np.longdouble


def legendre(degree, x):
    """P_n, P_(n-1) and P_n' at x, inside (-1, 1)."""
    before, now = np.ones_like(x), x
    for n in range(2, degree + 1):
        before, now = now, ((2 * n - 1) * x * now - (n - 1) * before) / n
    return now, before, degree * (before - x * now) / (1 - x * x)


def gauss(count):
    """Points and weights of Gauss's quadrature, brought to long double by Newton's method."""
    x = np.polynomial.legendre.leggauss(count)[0].astype(Real)
    for _ in range(3):
        p, _, slope = legendre(count, x)
        x = x - p / slope
    slope = legendre(count, x)[2]
    return x, 2 / ((1 - x * x) * slope**2)


def lobatto(degree):
    """Points of Gauss and Lobatto: the ends and the roots of P'."""
    x = np.polynomial.legendre.Legendre.basis(degree).deriv().roots().real.astype(Real)
    x.sort()
    for _ in range(3):
        p, _, slope = legendre(degree, x)
        second = (2 * x * slope - degree * (degree + 1) * p) / (1 - x * x)
        x = x - slope / second
    return np.concatenate([[Real(-1)], x, [Real(1)]])


def lagrange(nodes, x):
    """Values and slopes at x of the polynomials that are one at their node, zero at the others.
    Source: Berrut, Trefethen, SIAM Review 46 (2004)."""
    gaps = nodes[:, None] - nodes[None, :]
    np.fill_diagonal(gaps, 1)
    weights = 1 / gaps.prod(axis=1)
    shares = weights / (x[:, None] - nodes)
    values = shares / shares.sum(axis=1)[:, None]
    at_nodes = weights[None, :] / weights[:, None] / gaps
    np.fill_diagonal(at_nodes, 0)
    np.fill_diagonal(at_nodes, -at_nodes.sum(axis=1))
    return values, values @ at_nodes


class Factors:
    """Gaussian elimination of a symmetric matrix in long double, which numpy leaves to double."""

    def __init__(self, matrix):
        self.lu = matrix.copy()
        self.order = np.arange(len(matrix))
        for k in range(len(matrix) - 1):
            pivot = k + np.abs(self.lu[k:, k]).argmax()
            self.lu[[k, pivot]] = self.lu[[pivot, k]]
            self.order[[k, pivot]] = self.order[[pivot, k]]
            self.lu[k + 1:, k] /= self.lu[k, k]
            self.lu[k + 1:, k + 1:] -= np.outer(self.lu[k + 1:, k], self.lu[k, k + 1:])

    def solve(self, right):
        x = right[self.order].copy()
        for k in range(1, len(x)):
            x[k] -= self.lu[k, :k] @ x[:k]
        for k in range(len(x) - 1, -1, -1):
            x[k] = (x[k] - self.lu[k, k + 1:] @ x[k + 1:]) / self.lu[k, k]
        return x


class SpectralBeam:
    """Clamped at its start, held across at its end where it is propped. `sections(x)`: EI, GA (with
    the shear area), mass per length and rotary inertia."""

    def __init__(self, length, middle, sections, propped, degree=14):
        x, weights = gauss(2 * degree)
        values, slopes = lagrange(lobatto(degree), x)
        count = 2 * degree + 1
        K, M = np.zeros((2, 2 * count, 2 * count), dtype=Real)
        for element, (low, high) in enumerate(((0, middle), (middle, length))):
            half = Real(high - low) / 2
            EI, GA, mass, rotary = sections(low + half * (x + 1))
            at = np.arange(element * degree, element * degree + degree + 1)
            w, phi = 2 * at, 2 * at + 1

            def product(a, b, factor):
                return a.T @ ((weights * factor * half)[:, None] * b)

            slope = slopes / half
            K[np.ix_(w, w)] += product(slope, slope, GA)
            K[np.ix_(w, phi)] -= product(slope, values, GA)
            K[np.ix_(phi, w)] -= product(values, slope, GA)
            K[np.ix_(phi, phi)] += product(values, values, GA) + product(slope, slope, EI)
            M[np.ix_(w, w)] += product(values, values, mass)
            M[np.ix_(phi, phi)] += product(values, values, rotary)
        self.K, self.M = K, M
        self.load_at, self.end = 2 * degree, 2 * count - 2
        held = {0, 1} | ({self.end} if propped else set())
        self.free = np.array([i for i in range(2 * count) if i not in held])

    def frequency(self):
        """The lowest [Hz], by inverse iteration."""
        part = np.ix_(self.free, self.free)
        K, M = self.K[part], self.M[part]
        factors = Factors(K)
        shape = np.ones(len(K), dtype=Real)
        for _ in range(60):
            shape = factors.solve(M @ shape)
            shape /= np.sqrt(shape @ M @ shape)
        # Not K's quotient, in which the stiffness against shear would drown it.
        back = factors.solve(M @ shape)
        return float(1 / np.sqrt(shape @ M @ back) / (2 * Real(np.pi)))

    def prop_force(self, frequency):
        """What the prop does to the beam under a unit force across at the place of the load."""
        D = self.K - (2 * Real(np.pi) * frequency)**2 * self.M
        load = np.zeros(len(D), dtype=Real)
        load[self.load_at] = 1
        motion = np.zeros(len(D), dtype=Real)
        motion[self.free] = Factors(D[np.ix_(self.free, self.free)]).solve(load[self.free])
        return float((D @ motion - load)[self.end])
