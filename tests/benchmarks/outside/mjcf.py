#!/usr/bin/env python3
"""MJCF models by chance, imported by `boxbeam init --from-mjcf` and beside MuJoCo (PyPI: mujoco), an outside program.

    python3 -m venv env && env/bin/pip install mujoco
    env/bin/python tests/benchmarks/outside/mjcf.py build/boxbeam [200 [FIRST_SEED]]

Trees of bodies on hinge, slide, ball and free joints, several in a body among them, with references, frames, classes, all
ways to say an orientation, shapes with density or mass, given inertias, springs and dampers; in every other one loops
that connect and weld close. Joints that do not follow loops are driven by polynomials of time. Compared at one instant:
places and rotations of all bodies from the same coordinates, and the forces of all drives with those of `mj_inverse`, in
which loops are open: accelerations of what follows them, and the multipliers that leave it without force, are solved for
here, by MuJoCo's Jacobians and their derivatives. Of loops also what MuJoCo has of the closing equations and of their rates
at the coordinates of boxbeam; angular velocities and accelerations of all bodies. A deviation is the largest difference over the largest value of its kind.
"""
import collections
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import mujoco
import numpy as np

TIME = 0.2


def text(values):
    return " ".join(f"{x:.17g}" for x in np.atleast_1d(values))


class Model:
    """The text of a model, and which pairs of bodies loops may connect."""

    def __init__(self, seed, loops):
        self.random = random = np.random.default_rng(seed)
        self.degrees = random.random() < 0.5
        self.sequence = "".join(random.permutation(list("xyz")))
        if random.random() < 0.5:
            self.sequence = "".join(random.choice([c, c.upper()]) for c in random.choice(list("xyz"), 3))
        self.count, self.bodies, self.freedoms, self.parents = 0, [], [], []
        inside = "".join(self.body(-1, 0) for _ in range(1 + random.integers(2)))
        closing = self.closing() if loops else ""
        gravity = random.uniform(-10, 10, 3)
        self.text = f"""<mujoco model="by chance">
  <compiler angle="{'degree' if self.degrees else 'radian'}" eulerseq="{self.sequence}"/>
  <option gravity="{text(gravity)}"><flag constraint="disable"/></option>
  <default><geom density="{random.uniform(500, 3000):.17g}"/><joint damping="{random.uniform(0, 3):.17g}"/>
    <default class="stiff"><joint stiffness="{random.uniform(1, 30):.17g}" springref="{text(self.angle(0.3))}"/></default>
    <default class="smooth"><joint damping="0"/></default></default>
  <worldbody>
    <body name="arm" pos="50 0 0"><inertial pos="0.5 0 0" mass="1" diaginertia="0.01 0.1 0.1"/></body>
{inside}  </worldbody>
{closing}</mujoco>
"""

    def angle(self, radians):
        return radians * 180 / math.pi if self.degrees else radians

    def direction(self):
        v = self.random.normal(size=3)
        return v / np.linalg.norm(v) * self.random.uniform(0.5, 2)

    def pose(self):
        kind, random = self.random.integers(6), self.random
        turned = ["", f'quat="{text(random.normal(size=4))}"',
                  f'axisangle="{text(self.direction())} {text(self.angle(random.uniform(-2, 2)))}"',
                  f'euler="{text(self.angle(1.0) * random.uniform(-2, 2, 3))}"', f'zaxis="{text(self.direction())}"',
                  f'xyaxes="{text(self.direction())} {text(self.direction())}"'][kind]
        return f'pos="{text(random.uniform(-1, 1, 3))}" {turned}'

    def joint(self, kind, name):
        random = self.random
        if kind == "free":
            return f'<freejoint name="{name}"/>'
        place = f'pos="{text(random.uniform(-0.5, 0.5, 3))}"' if random.random() < 0.5 else ""
        if kind == "ball":
            return f'<joint class="smooth" name="{name}" type="ball" {place}/>'
        of = f' axis="{text(self.direction())}"'
        if random.random() < 0.5:
            ref = random.uniform(-1, 1)
            of += f' ref="{text(self.angle(ref) if kind == "hinge" else ref)}"'
        if kind == "hinge" and random.random() < 0.5:
            of += ' class="stiff"'
        return f'<joint name="{name}" type="{kind}" {place}{of}/>'

    def shapes(self):
        random = self.random
        if random.random() < 0.4:
            masses = random.uniform(-0.5, 0.5, (20, 3))
            m = random.uniform(0.5, 4)
            I = sum(m / 20 * (p @ p * np.eye(3) - np.outer(p, p)) for p in masses)
            if random.random() < 0.5:
                full = (I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2])
                return f'<inertial pos="{text(random.uniform(-0.3, 0.3, 3))}" mass="{m:.17g}" fullinertia="{text(full)}"/>'
            return f'<inertial {self.pose()} mass="{m:.17g}" diaginertia="{text(np.linalg.eigvalsh(I))}"/>'
        parts = []
        for _ in range(1 + random.integers(3)):
            kind = str(random.choice(["sphere", "capsule", "cylinder", "box", "ellipsoid"]))
            size = random.uniform(0.05, 0.3, {"sphere": 1, "capsule": 2, "cylinder": 2}.get(kind, 3))
            where = self.pose()
            if kind != "sphere" and random.random() < 0.4:
                where, size = f'fromto="{text(random.uniform(-0.5, 0.5, 6))}"', size[:1]
            mass = f' mass="{random.uniform(0.1, 3):.17g}"' if random.random() < 0.3 else ""
            part = f'<geom type="{kind}" size="{text(size)}" {where}{mass}/>'
            parts.append(part if random.random() < 0.8 else f"<frame {self.pose()}>{part}</frame>")
        return "".join(parts)

    def body(self, parent, depth):
        random, index = self.random, self.count
        self.count += 1
        self.bodies.append(f"b{index}")
        self.parents.append(parent)
        chance = random.random()
        if parent < 0 and chance < 0.2:
            kinds = ["free"]
        elif chance < 0.1 and depth > 0:
            kinds = []
        elif chance < 0.3:
            kinds = ["ball"]
        else:
            kinds = [str(random.choice(["hinge", "slide"], p=[0.7, 0.3])) for _ in range(random.choice([1, 1, 1, 2, 3]))]
        self.freedoms.append(sum({"free": 6, "ball": 3}.get(kind, 1) for kind in kinds))
        joints = "".join(self.joint(kind, f"j{index}-{k}") for k, kind in enumerate(kinds))
        wide = random.integers(1, 3) if depth < 4 else 0
        shapes, where = self.shapes(), self.pose()
        inside = "".join(self.body(index, depth + 1) for _ in range(wide)) if depth < 3 or parent >= 0 else ""
        return f'{"  " * depth}    <body name="b{index}" {where}>{joints}{shapes}\n{inside}{"  " * depth}    </body>\n'

    def way(self, index):
        ways = []
        while index >= 0:
            ways.append(index)
            index = self.parents[index]
        return ways

    def closing(self):
        random, found = self.random, []
        taken = set()
        for _ in range(20):
            kind = str(random.choice(["connect", "weld"]))
            a, b = random.integers(-1, self.count), random.integers(self.count)
            between = set(self.way(a)) ^ set(self.way(b))
            if between & taken or sum(self.freedoms[i] for i in between) < (4 if kind == "connect" else 7):
                continue
            taken |= between
            first = f'body1="{"world" if a < 0 else f"b{a}"}" body2="b{b}"'
            found.append(f'    <{kind} name="c{len(found)}" {first} anchor="{text(random.uniform(-0.5, 0.5, 3))}"/>\n')
            if len(found) == 2:
                break
        return f"  <equality>\n{''.join(found)}  </equality>\n" if found else ""


def driven(case, random):
    """The case with polynomials of time instead of drivers that stand still, and the second derivatives by joint."""
    seconds = {}

    def replaced(match):
        joint, (value, unit) = match.group(1), match.group(2).split()
        more = random.uniform(-0.3, 0.3, 2)
        seconds[joint] = 2 * more[1]
        return (f'joint = "{joint}"\nkind = "polynomial"\ncoefficients = ["{value} {unit}", "{more[0]:.17g} {unit}/s", '
                f'"{more[1]:.17g} {unit}/s^2"]')
    case = re.sub(r'joint = "(.*)"\nkind = "hold"\nvalue = "(.*)"', replaced, case)
    return case.replace('duration = "1 s"', f'duration = "{TIME} s"'), seconds


def quaternion(R):
    q = np.zeros(4)
    mujoco.mju_mat2Quat(q, R.flatten())
    return q


def turning(values, rates, seconds):
    """Of turns about z, y and x, one after the other: rotation, local rate and acceleration, axes in the body."""
    (a, b, c), e = values, np.eye(3)

    def about(axis, x):
        q, R = np.zeros(4), np.zeros(9)
        mujoco.mju_axisAngle2Quat(q, e[axis], x)
        mujoco.mju_quat2Mat(R, q)
        return R.reshape(3, 3)
    R_c = about(0, c)
    y, z = R_c.T @ e[1], (about(1, b) @ R_c).T @ e[2]
    later = e[0] * rates[2]
    both = later + y * rates[1]
    omega = both + z * rates[0]
    alpha = (e[0] * seconds[2] + y * seconds[1] + z * seconds[0] - np.cross(later, y) * rates[1]
             - np.cross(both, z) * rates[0])
    return about(2, a) @ about(1, b) @ R_c, omega, alpha, (z, y, e[0])


def compare(model, ours, seconds, worst):
    data = mujoco.MjData(model)
    joints, bodies = ours["joints"], ours["bodies"]
    tau_of = []  # name, kind of the value and its row of mj_inverse's forces

    def of_joint(name, what):
        return seconds.get(name, 0.0) if what == "acceleration" else joints[name][what]
    for j in range(model.njnt):
        name, at, dof = model.joint(j).name, model.jnt_qposadr[j], model.jnt_dofadr[j]
        kind = int(model.jnt_type[j])

        def of(index, what):
            return of_joint(f"{name}.{index}", what)
        if kind in (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE)):
            data.qpos[at], data.qvel[dof], data.qacc[dof] = (of_joint(name, k) for k in ("coordinate", "rate", "acceleration"))
            tau_of.append((name, np.eye(model.nv)[dof]))
            continue
        free = kind == int(mujoco.mjtJoint.mjJNT_FREE)
        first = 4 if free else 1
        R, omega, alpha, axes = turning(*([of(first + k, what) for k in range(3)]
                                          for what in ("coordinate", "rate", "acceleration")))
        if free:
            start = np.zeros(9)
            mujoco.mju_quat2Mat(start, model.qpos0[at + 3:at + 7])
            start = start.reshape(3, 3)
            for target, what in ((data.qvel, "rate"), (data.qacc, "acceleration")):
                target[dof:dof + 3] = start @ [of(k, what) for k in (1, 2, 3)]
            data.qpos[at:at + 3] = model.qpos0[at:at + 3] + start @ [of(k, "coordinate") for k in (1, 2, 3)]
            for k in range(3):
                row = np.zeros(model.nv)
                row[dof:dof + 3] = start[:, k]
                tau_of.append((f"{name}.{k + 1}", row))
            R, at, dof = start @ R, at + 3, dof + 3
        data.qpos[at:at + 4] = quaternion(R)
        data.qvel[dof:dof + 3], data.qacc[dof:dof + 3] = omega, alpha
        for k in range(3):
            row = np.zeros(model.nv)
            row[dof:dof + 3] = axes[k]
            tau_of.append((f"{name}.{first + k}", row))
    mujoco.mj_inverse(model, data)
    found, size = collections.Counter(), collections.Counter()

    def note(kind, a, b):
        found[kind] = max(found[kind], np.max(abs(np.asarray(a) - b)))
        size[kind] = max(size[kind], np.max(abs(np.asarray(b))), 1e-9)
    for i in range(1, model.nbody):
        name = model.body(i).name
        note("place", bodies[name]["position"], data.xpos[i])
        note("rotation", bodies[name]["rotation"], data.xmat[i].reshape(3, 3))
    rows, open_yet, scale = [], [], max(1.0, np.max(abs(data.qvel)))
    for k in range(model.neq):
        one, two = model.eq_obj1id[k], model.eq_obj2id[k]
        weld = int(model.eq_type[k]) == int(mujoco.mjtEq.mjEQ_WELD)
        own = model.eq_data[k]
        # eq_data: of connect the places on both bodies; of weld that on the second, then on the first, and how it turns.
        p1, p2 = (own[3:6], own[0:3]) if weld else (own[0:3], own[3:6])
        places, J, second = [], [], []
        for body, p in ((one, p1), (two, p2)):
            R = data.xmat[body].reshape(3, 3)
            place = data.xpos[body] + R @ p
            jacobians = [np.zeros((3, model.nv)) for _ in range(4)]
            mujoco.mj_jac(model, data, jacobians[0], jacobians[1], place, body)
            mujoco.mj_jacDot(model, data, jacobians[2], jacobians[3], place, body)
            places.append((place, R))
            J.append(np.vstack(jacobians[:2]))
            second.append(np.concatenate([J_ @ data.qacc + D @ data.qvel for J_, D in zip(jacobians[:2], jacobians[2:])]))
        gap = places[1][0] - places[0][0]
        count = 6 if weld else 3
        note("loops", gap, np.zeros(3))
        if weld:
            between = np.zeros(9)
            mujoco.mju_quat2Mat(between, own[6:10])
            note("loops", places[0][1] @ between.reshape(3, 3), places[1][1])
        size["loops"] = 1.0
        rows.append((J[1] - J[0])[:count])
        note("loops' rates", rows[-1] @ data.qvel / scale, np.zeros(count))
        size["loops' rates"] = 1.0
        open_yet.append((second[1] - second[0])[:count])
    free = np.array([row for name, row in tau_of if joints[name]["drive"] is None])
    if len(free):
        J = np.vstack(rows)
        data.qacc[:] += free.T @ np.linalg.lstsq(J @ free.T, -np.concatenate(open_yet), rcond=1e-10)[0]
        mujoco.mj_inverse(model, data)
    for i in range(1, model.nbody):
        J, D = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_jac(model, data, np.zeros((3, model.nv)), J, data.xpos[i], i)
        mujoco.mj_jacDot(model, data, np.zeros((3, model.nv)), D, data.xpos[i], i)
        note("omega", bodies[model.body(i).name]["omega"], J @ data.qvel)
        note("alpha", bodies[model.body(i).name]["alpha"], J @ data.qacc + D @ data.qvel)
    tau = data.qfrc_inverse.copy()
    if len(free):
        J = np.vstack(rows)
        lambdas = np.linalg.lstsq(free @ J.T, free @ tau, rcond=1e-10)[0]
        tau = tau - J.T @ lambdas
        note("undriven", free @ tau / max(1.0, np.max(abs(data.qfrc_inverse))), np.zeros(len(free)))
        size["undriven"] = 1.0
    for name, row in tau_of:
        if joints[name]["drive"] is not None:
            note("drives", joints[name]["drive"], row @ tau)
    for kind in found:
        worst[kind].append(found[kind] / size[kind])
    return max(found[kind] / size[kind] for kind in found)


def main():
    program, wanted = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    worst, refused, failed = collections.defaultdict(list), collections.Counter(), []
    compared, looped, bodies = 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        xml, case = Path(folder) / "model.xml", Path(folder) / "case.toml"
        while compared < wanted:
            seed += 1
            of = Model(seed, seed % 2 == 1)
            xml.write_text(of.text, encoding="utf-8")
            model = mujoco.MjModel.from_xml_string(of.text)
            init = subprocess.run([program, "init", "spatial", "-", "--from-mjcf", xml, "--beam", "arm"],
                                  capture_output=True, text=True)
            if init.returncode != 0:
                failed.append(f"seed {seed}: {init.stderr}")
                compared += 1
                continue
            moving, seconds = driven(init.stdout, of.random)
            case.write_text(moving, encoding="utf-8")
            run = subprocess.run([program, "motion", case, "--at", repr(TIME), "--json", "-"], capture_output=True, text=True)
            if run.returncode != 0:
                refused[run.stderr.strip().splitlines()[0 if run.returncode == 2 else 1].strip().split(":")[0][:90]] += 1
                if model.neq == 0 or run.returncode == 2:
                    failed.append(f"seed {seed}: {run.stderr}")
                if sum(refused.values()) > 3 * wanted:
                    break
                continue
            compared += 1
            looped += model.neq > 0
            bodies += model.nbody - 1
            largest = compare(model, json.loads(run.stdout)["states"][0], seconds, worst)
            if not largest < 1e-8:
                failed.append(f"seed {seed}: {largest:.1e}")
    print(f"{compared} models compared, {looped} of them with loops, {bodies / max(1, compared):.0f} bodies on average")
    for words, count in refused.items():
        print(f"{count} more boxbeam refuses: {words}")
    print("deviation               median    largest")
    for kind, of in worst.items():
        print(f"{kind:<20}  {np.median(of):9.1e}  {max(of):9.1e}")
    for of in failed:
        print("DIFFERS: " + of)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
