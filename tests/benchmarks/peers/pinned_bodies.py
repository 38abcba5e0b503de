"""Rigid bodies in the plane joined by pins, in numpy: the equations as any textbook has them, three
coordinates to a body (x and y of the centre of mass, angle)."""
import numpy as np


class PinnedBodies:
    """`masses`: mass and inertia of each body. `pins`: (a, p_a, b, p_b), the point p_a in the axes
    of body a lies on p_b of body b; b = -1 is the ground. `fixed`: coordinates with values of their
    own. Rows of the equations: two for each pin, then one for each fixed coordinate."""

    def __init__(self, masses, pins, fixed, gravity):
        self.size = 3 * len(masses)
        self.rows = 2 * len(pins) + len(fixed)
        self.mass = np.array([entry for m, j in masses for entry in (m, m, j)])
        self.weight = np.array([entry for m, _ in masses for entry in (0.0, m * gravity, 0.0)])
        self.fixed = np.array(fixed, dtype=int)
        count = len(pins)
        on_ground = len(masses)  # a body behind the last
        a = np.array([pin[0] for pin in pins])
        b = np.array([pin[2] if pin[2] >= 0 else on_ground for pin in pins])
        self.ends = np.concatenate([a, b])
        self.points = np.array([pin[1] for pin in pins] + [pin[3] for pin in pins], dtype=float)
        self.sign = np.repeat([1.0, -1.0], count)
        self.count = count
        self.extended = np.zeros(self.size + 3)

        # The entries that never change, and where the others go.
        self.constant = np.zeros((self.rows, self.size + 3))
        row = np.concatenate([np.arange(count), np.arange(count)]) * 2
        self.constant[row, 3 * self.ends] = self.sign
        self.constant[row + 1, 3 * self.ends + 1] = self.sign
        self.constant[2 * count + np.arange(len(fixed)), self.fixed] = 1.0
        self.row_x, self.row_y, self.column = row, row + 1, 3 * self.ends + 2

    def _turned(self, q):
        """Bodies' coordinates with the ground's, and the points turned into world axes."""
        self.extended[:self.size] = q
        bodies = self.extended.reshape(-1, 3)[self.ends]
        c, s = np.cos(bodies[:, 2]), np.sin(bodies[:, 2])
        p = self.points
        return bodies, c * p[:, 0] - s * p[:, 1], s * p[:, 0] + c * p[:, 1]

    def equations(self, q, values):
        bodies, x, y = self._turned(q)
        phi = np.empty(self.rows)
        n = self.count
        phi[0:2 * n:2] = (bodies[:n, 0] + x[:n]) - (bodies[n:, 0] + x[n:])
        phi[1:2 * n:2] = (bodies[:n, 1] + y[:n]) - (bodies[n:, 1] + y[n:])
        phi[2 * n:] = np.asarray(q)[self.fixed] - values
        return phi

    def jacobian(self, q):
        _, x, y = self._turned(q)
        jacobian = self.constant.copy()
        jacobian[self.row_x, self.column] = -self.sign * y
        jacobian[self.row_y, self.column] = self.sign * x
        return jacobian[:, :self.size]

    def acceleration_side(self, q, v, accelerations):
        """Right side of J a = gamma; `accelerations` of the fixed coordinates."""
        _, x, y = self._turned(q)
        self.extended[:self.size] = v
        square = self.extended.reshape(-1, 3)[self.ends, 2]**2
        self.extended[self.size:] = 0.0
        n = self.count
        gamma = np.empty(self.rows)
        gamma[0:2 * n:2] = square[:n] * x[:n] - square[n:] * x[n:]
        gamma[1:2 * n:2] = square[:n] * y[:n] - square[n:] * y[n:]
        gamma[2 * n:] = accelerations
        return gamma

    def place(self, q, body, p):
        c, s = np.cos(q[3 * body + 2]), np.sin(q[3 * body + 2])
        return np.array([q[3 * body] + c * p[0] - s * p[1], q[3 * body + 1] + s * p[0] + c * p[1]])
