#!/usr/bin/env python3
"""Closed spatial mechanisms by chance, solved by `boxbeam motion` and by Pinocchio (PyPI: pin), an outside program.

    python3 -m venv env && env/bin/pip install pin
    env/bin/python tests/benchmarks/outside/closed_loops.py build/boxbeam [500 [FIRST_SEED]]

Two chains of eight revolute and prismatic joints, the second from a body of the first, are closed by two joints of any
kind; as many coordinates as these have equations are free, all others driven. Pinocchio gives kinematics, Jacobians and
inverse dynamics of the open tree; the closing equations, their second derivatives and what they bear are written here as
scalar products of vectors that its frames carry. The loops are followed by Newton's method from t = 0 in steps of 4 ms,
and where that differs from boxbeam, or goes on where boxbeam does not, in steps of 0.4 and 0.1 ms.
Compared at two instants: rotations, angular velocities and accelerations of all bodies, coordinates and rates, drives,
forces and moments of all joints. A deviation is the largest difference over the largest value of its kind.
"""
import collections
import json
import math
import subprocess
import sys
import tempfile

import numpy as np
import pinocchio as pin

CHAIN = 8
STEPS = (4e-3, 4e-4, 1e-4)  # [s]; the finer ones where the two differ, for plain Newton may take another branch
TIMES = (0.1, 0.36)
FREQUENCY = 0.5
# Equations of each kind.
KINDS = {"fixed": 6, "revolute": 5, "prismatic": 5, "cylindrical": 4, "universal": 4, "spherical": 3, "planar": 3,
         "slot": 2, "distance": 1, "screw": 5}
LEAD = 0.4


def cross(a, b):
    """Of two vectors, ten times as fast as numpy's."""
    (x, y, z), (u, v, w) = a, b
    return np.array((y * w - z * v, z * u - x * w, x * v - y * u))


def direction(random):
    while True:
        v = random.uniform(-1, 1, 3)
        if 0.1 < np.linalg.norm(v) <= 1.0:
            return v / np.linalg.norm(v)


def square_to(u):
    """Two unit vectors e, f with e x f = u."""
    e = cross(u, np.eye(3)[np.argmin(abs(u))])
    e /= np.linalg.norm(e)
    return e, cross(u, e)


class Joint:
    """Carries body `index` from body `parent`, -1 for the ground."""

    def __init__(self, random, index):
        self.parent = index - 1 if index != CHAIN else 1
        self.turns = random.random() < 0.7 or index == 0
        self.axis = direction(random)
        self.turn = pin.exp3(random.uniform(-1.7, 1.7, 3))
        self.at = random.uniform(-1, 1, 3)
        self.mean = random.uniform(-2, 2) if self.turns else random.uniform(-0.5, 0.5)
        self.amplitude = random.uniform(0.02, 0.08) * random.choice([-1, 1])
        self.free = False

    def drive(self, t):
        """Value, rate, acceleration."""
        omega = 2 * math.pi * FREQUENCY
        s, c = math.sin(omega * t), math.cos(omega * t)
        return self.mean + self.amplitude * s, self.amplitude * omega * c, -self.amplitude * omega ** 2 * s


class Closing:
    """Joins a place of body a, -1 for the ground, to one of body b; axes of a, but `second` of b."""

    def __init__(self, kind, a, b, p_a, p_b, turn, axis_b, second, length):
        self.kind, self.a, self.b, self.p_a, self.p_b = kind, a, b, p_a, p_b
        self.turn, self.axis_b, self.second, self.length = turn, axis_b, second, length
        self.axis = turn @ axis_b


class Mechanism:
    def __init__(self, seed):
        self.random = random = np.random.default_rng(seed)
        self.gravity = random.uniform(-10, 10, 3)
        self.joints = [Joint(random, i) for i in range(2 * CHAIN)]
        self.model = pin.Model()
        self.model.gravity.linear = self.gravity
        for i, joint in enumerate(self.joints):
            kind = pin.JointModelRevoluteUnaligned if joint.turns else pin.JointModelPrismaticUnaligned
            parent = joint.parent + 1
            self.model.addJoint(parent, kind(joint.axis), pin.SE3(joint.turn, joint.at), f"joint-{i}")
            joint.mass = random.uniform(0.5, 3.5)
            joint.centre = random.uniform(-0.4, 0.4, 3)
            masses = random.uniform(-0.5, 0.5, (20, 3))
            joint.inertia = sum(joint.mass / 20 * (p @ p * np.eye(3) - np.outer(p, p)) for p in masses)
            self.model.appendBodyToJoint(i + 1, pin.Inertia(joint.mass, joint.centre, joint.inertia), pin.SE3.Identity())
        self.load = (2 * CHAIN - 1, random.uniform(-0.5, 0.5, 3), 20 * direction(random))  # body, place, world
        self.data = self.model.createData()
        q = np.array([joint.mean for joint in self.joints])
        pin.forwardKinematics(self.model, self.data, q)
        self.closing = [self.close(first) for first in (0, CHAIN)]
        self.free = [i for i, joint in enumerate(self.joints) if joint.free]

    def pose(self, body):
        return self.data.oMi[body + 1] if body >= 0 else pin.SE3.Identity()

    def close(self, first):
        random = self.random
        kind = str(random.choice(list(KINDS)))
        a, b = (-1 if first == 0 else 3), first + CHAIN - 1
        A, B = self.pose(a), self.pose(b)
        p_b = random.uniform(-0.5, 0.5, 3)
        place = B.act(p_b)
        axis = direction(random)
        length = 0.0
        if kind == "distance":
            away = 1.5 * random.uniform(0.3, 1.0) * direction(random)
            place, length = place + away, np.linalg.norm(away)
        for i in random.permutation(CHAIN)[:KINDS[kind]]:
            self.joints[first + int(i)].free = True
        return Closing(kind, a, b, A.actInv(place), p_b, A.rotation.T @ B.rotation, axis, square_to(axis)[0], length)

    def text(self):
        """The case. A beam, which a case of boxbeam has, stands by itself."""
        def vector(v, unit=""):
            return "[" + ", ".join(f'"{x:.17g} {unit}"' if unit else f"{x:.17g}" for x in v) + "]"

        def turn(R):
            v = pin.log3(R)
            angle = np.linalg.norm(v)
            return f'[[{vector(v / angle)}, "{angle:.17g} rad"]]' if angle > 0 else '[["x", "0 rad"]]'

        # Of each body its places, by name.
        places = collections.defaultdict(dict)
        for i, joint in enumerate(self.joints):
            places[i]["O"] = np.zeros(3)
            if joint.parent >= 0:
                places[joint.parent][f"to-{i}"] = joint.at
        for k, closing in enumerate(self.closing):
            places[closing.b][f"closing-{k}"] = closing.p_b
            if closing.a >= 0:
                places[closing.a][f"closing-{k}"] = closing.p_a
        places[self.load[0]]["load"] = self.load[1]
        lines = ['[case]', 'name = "loops"', 'kind = "spatial"', '[motion]', f'duration = "{TIMES[-1]} s"', '[mechanism]', f'gravity = {vector(self.gravity, "m/s^2")}',
                 '[bodies.arm]', 'points = { O = ["0 m", "0 m", "0 m"] }', '[joints.arm]', 'kind = "fixed"',
                 'connect = ["ground", "arm.O"]', 'at = ["0 m", "0 m", "0 m"]']
        for i, joint in enumerate(self.joints):
            points = ", ".join(f'{name} = {vector(p, "m")}' for name, p in places[i].items())
            tensor = ", ".join(vector(row, "kg m^2") for row in joint.inertia)
            unit = "rad" if joint.turns else "m"
            on = "ground" if joint.parent < 0 else f"b{joint.parent}.to-{i}"
            lines += [f"[bodies.b{i}]", f'mass = "{joint.mass:.17g} kg"', f'centre = {vector(joint.centre, "m")}',
                      f"inertia = [{tensor}]", f"points = {{ {points} }}", f"[joints.j{i}]",
                      f'kind = "{"revolute" if joint.turns else "prismatic"}"', f'connect = ["{on}", "b{i}.O"]',
                      f"turn = {turn(joint.turn)}", f"axis = {vector(joint.axis)}"]
            if joint.parent < 0:
                lines += [f'at = {vector(joint.at, "m")}']
            if joint.free:
                lines += [f'start = "{joint.mean:.17g} {unit}"']
            else:
                lines += [f"[drivers.j{i}]", f'joint = "j{i}"', 'kind = "harmonic"', f'mean = "{joint.mean:.17g} {unit}"',
                          f'amplitude = "{joint.amplitude:.17g} {unit}"', f'frequency = "{FREQUENCY} Hz"']
        for k, closing in enumerate(self.closing):
            on = "ground" if closing.a < 0 else f"b{closing.a}.closing-{k}"
            lines += [f"[joints.c{k}]", f'kind = "{closing.kind}"', f'connect = ["{on}", "b{closing.b}.closing-{k}"]']
            if closing.a < 0:
                lines += [f'at = {vector(closing.p_a, "m")}']
            if closing.kind == "distance":
                lines += [f'length = "{closing.length:.17g} m"']
            elif closing.kind == "slot":
                lines += [f"axis = {vector(closing.axis)}"]
            else:
                lines += [f"turn = {turn(closing.turn)}", "closes = true"]
                if closing.kind not in ("fixed", "spherical"):
                    lines += [f"axis = {vector(closing.axis_b)}"]
                if closing.kind == "universal":
                    lines += [f"second_axis = {vector(closing.second)}"]
                if closing.kind == "screw":
                    lines += [f'lead = "{LEAD} m"']
        body, _, force = self.load
        size = np.linalg.norm(force)
        lines += ["[forces.load]", 'kind = "force"', f'point = "b{body}.load"', f"direction = {vector(force / size)}",
                  f'size = "{size:.17g} N"', '[sections.box]', 'kind = "box"', 'width = "0.1 m"', 'height = "0.1 m"',
                  'flange = "10 mm"', 'web = "10 mm"', '[beam]', 'body = "arm"', 'start = "O"', 'axis = "x"', 'z = "z"',
                  'density = "7850 kg/m^3"', '[[beam.segments]]', 'length = "1 m"', 'section = "box"', '[material]',
                  'steel = "S355"', '[strength]', 'required = 1.5']
        return "\n".join(lines) + "\n"

    def frame(self, body):
        """Of a body: pose, velocity and acceleration of its origin, omega and alpha, all in the world."""
        if body < 0:
            return pin.SE3.Identity(), np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
        R, i = self.data.oMi[body + 1].rotation, body + 1
        v, a = self.data.v[i], self.data.a[i]
        linear = R @ (a.linear + cross(v.angular, v.linear))
        return self.data.oMi[i], R @ v.linear, linear, R @ v.angular, R @ a.angular

    def equations(self, closing):
        """Each as value, what of its second derivative is, and its gradient (f_a, m_a, f_b, m_b) by the velocities of
        the places and the turns of the two bodies."""
        A, v_A, a_A, w_a, al_a = self.frame(closing.a)
        B, v_B, a_B, w_b, al_b = self.frame(closing.b)
        r_a, r_b = A.rotation @ closing.p_a, B.rotation @ closing.p_b
        v_a, v_b = v_A + cross(w_a, r_a), v_B + cross(w_b, r_b)
        c_a = a_A + cross(al_a, r_a) + cross(w_a, cross(w_a, r_a))
        c_b = a_B + cross(al_b, r_b) + cross(w_b, cross(w_b, r_b))
        d, d1, d2 = B.act(closing.p_b) - A.act(closing.p_a), v_b - v_a, c_b - c_a
        zero = np.zeros(3)

        def turned(R, w, al, e):
            x = R @ e
            return x, cross(w, x), cross(al, x) + cross(w, cross(w, x))

        def of_a(e):
            return turned(A.rotation, w_a, al_a, e)

        def of_b(e):
            return turned(B.rotation, w_b, al_b, e)

        def along(e):  # e of a, times d
            x, x1, x2 = of_a(e)
            return x @ d, x2 @ d + 2 * x1 @ d1 + x @ d2, (-x, cross(x, d), x, zero)

        def square(e, f):  # e of a, f of b
            x, x1, x2 = of_a(e)
            y, y1, y2 = of_b(f)
            return x @ y, x2 @ y + 2 * x1 @ y1 + x @ y2, (zero, cross(x, y), zero, cross(y, x))

        u_a, u_b, kind = closing.axis, closing.axis_b, closing.kind
        e_a, f_a = square_to(u_a)
        e_b, f_b = square_to(u_b)
        everywhere = [along(e) for e in np.eye(3)]
        across = [along(e_a), along(f_a)]
        parallel = [square(u_a, e_b), square(u_a, f_b)]
        T = closing.turn  # its columns: the axes of b as it is closed, in those of a
        no_turn = [square(T[:, 0], np.eye(3)[1]), square(T[:, 1], np.eye(3)[2]), square(T[:, 2], np.eye(3)[0])]
        if kind == "fixed":
            return everywhere + no_turn
        if kind == "revolute":
            return everywhere + parallel
        if kind == "prismatic":
            return across + no_turn
        if kind == "cylindrical":
            return across + parallel
        if kind == "universal":
            return everywhere + [square(u_a, closing.second)]
        if kind == "spherical":
            return everywhere
        if kind == "planar":
            return [along(u_a)] + parallel
        if kind == "slot":
            return across
        if kind == "distance":
            L = closing.length
            return [((d @ d - L * L) / (2 * L), (d1 @ d1 + d @ d2) / L, (-d / L, zero, d / L, zero))]
        # A screw: it advances as it turns, from where it is closed.
        e, f = T @ e_b, T @ f_b
        c, s = square(e, e_b)[0], square(f, e_b)[0]
        u, u1, _ = of_a(u_a)
        h = LEAD / (2 * math.pi)
        value, second, (f1, m1, f2, m2) = along(u_a)
        turn = (zero, -u, zero, u)
        turning = u @ (al_b - al_a) + u1 @ (w_b - w_a)
        return across + parallel + [(value - h * math.atan2(s, c), second - h * turning,
                                     tuple(g - h * k for g, k in zip((f1, m1, f2, m2), turn)))]

    def system(self):
        """Values, second derivatives and the gradient by all coordinates, of all equations."""
        values, seconds, rows, gradients = [], [], [], []
        for closing in self.closing:
            jacobians = []
            for body, p in ((closing.a, closing.p_a), (closing.b, closing.p_b)):
                if body < 0:
                    jacobians += [np.zeros((3, self.model.nv))] * 2
                    continue
                J = pin.getJointJacobian(self.model, self.data, body + 1, pin.LOCAL_WORLD_ALIGNED)
                r = self.data.oMi[body + 1].rotation @ p
                jacobians += [J[:3] - pin.skew(r) @ J[3:], J[3:]]
            for value, second, gradient in self.equations(closing):
                values.append(value)
                seconds.append(second)
                rows.append(sum(g @ J for g, J in zip(gradient, jacobians)))
                gradients.append((closing, gradient))
        return np.array(values), np.array(seconds), np.array(rows), gradients

    def follow(self, times, step_size):
        """The states at these times, as far as Newton's method comes, and the condition of its last equations, None
        where it does not come to the end."""
        q = np.array([joint.mean for joint in self.joints])
        free, n = self.free, self.model.nv
        v = a = np.zeros(n)
        states, steps = [], int(round(times[-1] / step_size))
        wanted = {int(round(t / step_size)): t for t in times}
        for step in range(steps + 1):
            t = step * step_size
            q = q + step_size * v + 0.5 * step_size ** 2 * a if step else q
            driven = np.array([joint.drive(t) for joint in self.joints])
            for i, joint in enumerate(self.joints):
                if not joint.free:
                    q[i] = driven[i, 0]
            for iteration in range(12):
                pin.computeJointJacobians(self.model, self.data, q)
                pin.forwardKinematics(self.model, self.data, q, np.zeros(n), np.zeros(n))
                values, _, rows, _ = self.system()
                try:
                    correction = -np.linalg.solve(rows[:, free], values)
                except np.linalg.LinAlgError:
                    return states, None
                q[free] += correction
                if np.max(abs(correction)) < 1e-14:
                    break
            if not np.max(abs(correction)) < 1e-10:
                return states, None
            v, a = driven[:, 1].copy(), driven[:, 2].copy()
            v[free] = a[free] = 0.0
            pin.computeJointJacobians(self.model, self.data, q)
            J = self.system()[2]
            v[free] = np.linalg.solve(J[:, free], -J @ v)
            pin.forwardKinematics(self.model, self.data, q, v, a)
            _, seconds, J, _ = self.system()
            a[free] = np.linalg.solve(J[:, free], -seconds)
            if step in wanted:
                states.append(self.state(wanted[step], q, v, a))
        return states, np.linalg.cond(J[:, free])

    def state(self, time, q, v, a):
        """All that is compared, as boxbeam names it."""
        pin.forwardKinematics(self.model, self.data, q, v, a)
        pin.computeJointJacobians(self.model, self.data, q)
        _, _, J, gradients = self.system()
        frames = [self.frame(i) for i in range(2 * CHAIN)]
        external = [pin.Force.Zero() for _ in range(2 * CHAIN + 1)]

        def press(body, place, force, moment):  # place in its axes, the rest in the world
            if body < 0:
                return
            R = frames[body][0].rotation
            external[body + 1] += pin.Force(R.T @ force, R.T @ moment + cross(place, R.T @ force))

        body, place, force = self.load
        press(body, place, force, np.zeros(3))
        tau = pin.rnea(self.model, self.data, q, v, a, external)
        carried = np.linalg.solve(J[:, self.free].T, tau[self.free])
        closing = [[np.zeros(3), np.zeros(3)] for _ in self.closing]
        for size, (of, (f_a, m_a, f_b, m_b)) in zip(carried, gradients):
            press(of.a, of.p_a, size * f_a, size * m_a)
            press(of.b, of.p_b, size * f_b, size * m_b)
            closing[self.closing.index(of)][0] += size * f_b
            closing[self.closing.index(of)][1] += size * m_b
        tau = pin.rnea(self.model, self.data, q, v, a, external)
        joints = {}
        for i in range(2 * CHAIN):
            R, f = frames[i][0].rotation, self.data.f[i + 1]
            joints[f"j{i}"] = {"force": R @ f.linear, "moment": R @ f.angular, "coordinate": q[i], "rate": v[i],
                               "drive": None if self.joints[i].free else tau[i]}
        for k, (force, moment) in enumerate(closing):
            joints[f"c{k}"] = {"force": force, "moment": moment}
        bodies = {f"b{i}": {"rotation": f[0].rotation.copy(), "omega": f[3], "alpha": f[4]} for i, f in enumerate(frames)}
        return {"time": time, "bodies": bodies, "joints": joints}


def deviations(ours, other, worst):
    """Largest difference of each kind over its largest value."""
    difference, size = collections.Counter(), collections.Counter()
    for group in ("bodies", "joints"):
        for name, values in other[group].items():
            for kind, value in values.items():
                if value is None:
                    continue
                got = ours[group][name][kind]
                difference[kind] = max(difference[kind], np.max(abs(np.array(got) - value)))
                size[kind] = max(size[kind], np.max(abs(np.array(value))))
    for kind in difference:
        worst[kind].append(difference[kind] / max(size[kind], 1e-12))
    return max(difference[kind] / max(size[kind], 1e-12) for kind in difference)


def main():
    program, wanted = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 500
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    worst, compared, kinds = collections.defaultdict(list), 0, collections.Counter()
    refused, finer, failed = [], collections.Counter(), []
    while compared < wanted:
        mechanism = Mechanism(seed)
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as case:
            case.write(mechanism.text())
            case.flush()
            at = [word for t in TIMES for word in ("--at", repr(t))]
            run = subprocess.run([program, "motion", case.name, *at, "--json", "-"], capture_output=True, text=True)
        said = run.stderr.strip().splitlines()
        ours = json.loads(run.stdout)["states"] if run.returncode == 0 else None
        for step in STEPS:
            states, condition = mechanism.follow(TIMES, step)
            ended = condition is None or condition > 1e7
            largest, found = math.inf, collections.defaultdict(list)
            if ours and not ended:
                largest = max(deviations(our, other, found) for our, other in zip(ours, states))
            if largest < 1e-6 or (not ours and ended):
                break
        finer[step] += 1
        if ours:
            compared += 1
            kinds.update(closing.kind for closing in mechanism.closing)
            for kind, of in found.items():
                worst[kind] += of
            if not largest < 1e-6:
                failed.append(f"seed {seed} by {largest:.1e}, {[closing.kind for closing in mechanism.closing]}")
        else:
            refused.append(said[1].strip().split(";")[0].split(":")[0].split(" in joints")[0])
            if not ended:
                failed.append(f"seed {seed}, where boxbeam refuses and the script goes on: {' '.join(said)}")
        seed += 1
    print(f"{compared} mechanisms compared at {len(TIMES)} instants; closed by " +
          ", ".join(f"{kind} {count}" for kind, count in sorted(kinds.items())))
    for words, count in collections.Counter(refused).items():
        print(f"{count} more boxbeam refuses: {words}")
    print("steps of the script: " + ", ".join(f"{1e3 * step:g} ms {count}" for step, count in sorted(finer.items())))
    print("deviation          median    largest")
    for kind, of in worst.items():
        print(f"{kind:<14}  {np.median(of):9.1e}  {max(of):9.1e}")
    for of in failed:
        print("DIFFERS: " + of)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
