#!/usr/bin/env python3
"""Mechanisms with steps of a fixed length: joints as constraints, as coordinates, and as chosen.

    bench/scenes/mechanisms.py [PROGRAM] random [--step 1e-3] [--until 1] [--seeds 1 60]
    bench/scenes/mechanisms.py [PROGRAM] chains [--step 1e-3] [--steps 3000]

random: mechanisms of one to six bodies as those of tests/property/mechanisms_test.cpp (hinges, sliders,
ball, universal, cylindrical and rigid joints, friction, stops, springs, bars that close loops). Prints
CPU in all, runs that are told inaccurate, and errors of places and velocities at the end beside a run to
a tolerance of 1e-10, over those of constraints. chains: CPU of chains of n links over that of constraints.
"""
import argparse
import csv
import json
import math
import random
import statistics
import subprocess
import tempfile

WAYS = ("absolute", "minimal", "auto")


def text(v):
    return " ".join(f"{x:.17g}" for x in v)


class Mechanism:
    """A random mechanism on the ground, in a plane or in space."""

    def __init__(self, seed):
        self.r = random.Random(seed)
        self.planar = self.r.random() < 0.5
        self.bodies = self.forces = self.elements = self.signals = ""
        self.places = [(0, 0, 0)]
        n = 1 + self.r.randrange(6)
        if self.r.random() < 0.67:
            self.forces = "<Gravity/>"
        for i in range(n):
            self.add_body(i)
        r = self.r
        if n > 2 and r.random() < 0.4:
            self.forces += (f'<SpringDamper between="b0 b{n - 1}" stiffness="{10**r.uniform(1, 3)}" '
                            f'length="{r.uniform(0.1, 0.6)}" damping="{r.randrange(2)}"/>')
        if n > 2 and r.random() < 0.3:
            a = (r.uniform(-0.5, 0.5), self.across(), 0.7)
            self.elements += (f'<Distance between="world b{1 + r.randrange(n - 1)}" pointA="{text(a)}" '
                              f'pointB="{text((0.1, 0, r.uniform(-0.1, 0.1)))}"/>')

    def across(self):
        return 0 if self.planar else self.r.uniform(-0.5, 0.5)

    def direction(self):
        r = self.r
        if self.planar:
            angle = r.uniform(0, 6.28)
            return math.cos(angle), 0, math.sin(angle)
        v = (r.uniform(-1, 1), r.uniform(-1, 1), r.uniform(0.1, 1))
        return tuple(x / math.hypot(*v) for x in v)

    def add_body(self, i):
        r = self.r
        parent = i - 1 if r.random() < 0.75 else r.randrange(i + 1) - 1
        base = self.places[parent + 1]
        step = (r.uniform(-0.5, 0.5), self.across(), r.uniform(-0.5, 0.5))
        self.places.append([b + s for b, s in zip(base, step)])
        m = 10**r.uniform(-1, 1)
        J = m * r.uniform(0.01, 0.05)
        head = f'name="b{i}" mass="{m}" position="{text(self.places[-1])}" inertia="'
        if self.planar:
            self.bodies += f'<PlanarBody {head}{J}" angularVelocity="{r.uniform(-5, 5)}"/>'
        else:
            moments = text((J, J * r.uniform(1, 1.5), J * r.uniform(1, 1.5)))
            turn = text((r.uniform(-5, 5), r.uniform(-5, 5), r.uniform(-20, 20)))
            self.bodies += f'<RigidBody {head}{moments}" angularVelocity="{turn}"/>'
        self.add_joint(i, "world" if parent < 0 else f"b{parent}",
                       [b + 0.5 * s for b, s in zip(base, step)])
        self.signals += " ".join(f"b{i}.{k}" for k in ("x", "z", "vx", "vz")) + " "

    def add_joint(self, i, on, at):
        r = self.r
        between = f' between="{on} b{i}" at="{text(at)}"'
        kinds = ("Revolute", "Prismatic", "Revolute", "Spherical", "Universal", "Cylindrical", "Fixed")
        kind = kinds[r.randrange(3 if self.planar else 6 if i == 0 else 7)]  # the first one moves
        axis = self.direction()
        none = kind in ("Spherical", "Fixed") or (self.planar and kind == "Revolute")
        along = "" if none else f' axis="{text(axis)}"'
        second = ""
        if kind == "Universal":  # across the first axis
            length = math.hypot(axis[1], axis[2])
            second = f' axisB="{text((0, axis[2] / length, -axis[1] / length))}"'
        self.elements += f"<{kind}{between}{along}{second}/>"
        if kind not in ("Revolute", "Prismatic"):
            return
        of = between + along + f' coordinate="{"angle" if kind == "Revolute" else "displacement"}"'
        what = r.random()
        if what < 0.3:
            self.elements += (f'<JointFriction{of}><GivenFriction force="{10**r.uniform(-1, 1)}"/>'
                              "</JointFriction>")
        elif what < 0.5:
            self.elements += (f'<JointStop{of} lower="{-r.uniform(0.05, 1)}" '
                              f'upper="{r.uniform(0.05, 1)}"><Unilateral epsilonN="0.5"/></JointStop>')
        elif what < 0.7:
            self.forces += f'<JointSpring{of} stiffness="{10**r.uniform(0, 3)}" damping="{r.randrange(2)}"/>'

    def model(self, until, method):
        return (f'<dynamy version="1"><systems><Ground name="world"/>{self.bodies}</systems><forces>'
                f'{self.forces}</forces><elements>{self.elements}</elements><simulation until="{until}" '
                f'{method}/><record signals="{self.signals}" every="{until}" frames="0"/></dynamy>')


def chain(n, space, heavy, step, steps, coordinates):
    """Links of 0.1 kg and 0.1 m, let go taut from 45 degrees; heavy: 100 kg at the end."""
    s = math.sqrt(0.5)
    bodies = elements = ""
    for i in range(n):
        last = heavy and i == n - 1
        inertia = ("0.4 0.4 0.4" if last else "5e-6 8.3e-5 8.3e-5") if space else (
            "0.4" if last else "8.3e-5")
        kind = 'RigidBody euler="0 45deg 0"' if space else "PlanarBody"
        x = s * 0.1 * (i + 0.5)
        bodies += (f'<{kind} name="b{i}" position="{x} 0 {-x}" mass="{100 if last else 0.1}" '
                   f'inertia="{inertia}"/>')
        elements += (f'<{"Spherical" if space else "Revolute"} between="{f"b{i - 1}" if i else "world"} '
                     f'b{i}" at="{s * 0.1 * i} 0 {-s * 0.1 * i}"/>')
    return (f'<dynamy version="1"><systems><Ground name="world"/>{bodies}</systems><forces><Gravity/>'
            f'</forces><elements>{elements}</elements><simulation until="{steps * step:g}" '
            f'step="{step}" coordinates="{coordinates}"/></dynamy>')


def run(program, folder, model):
    """Exit status, last row of the signals, and run.json."""
    path = f"{folder}/m.xml"
    with open(path, "w", encoding="utf-8") as f:
        f.write(model)
    done = subprocess.run([program, "run", path, "--no-checkpoint", "--quiet", "--out", f"{folder}/o"],
                          capture_output=True, check=False)
    with open(f"{folder}/o/run.json", encoding="utf-8") as f:
        report = json.load(f)
    with open(f"{folder}/o/signals.csv", encoding="utf-8") as f:
        last = list(csv.reader(f))[-1]
    return done.returncode, [float(x) for x in last], report


def compare_random(given, folder):
    rows = {way: [] for way in WAYS}
    for seed in range(given.seeds[0], given.seeds[1]):
        m = Mechanism(seed)
        code, truth, _ = run(given.program, folder, m.model(given.until, 'tolerance="1e-10"'))
        if code != 0:
            continue
        for way in WAYS:
            method = f'step="{given.step}" coordinates="{way}"'
            code, last, report = run(given.program, folder, m.model(given.until, method))
            off = max(abs(a - b) / (1 + abs(b)) for a, b in zip(last, truth))
            rows[way].append((report["cpu_s"], code != 0, off + 1e-12))
    base = rows["absolute"]
    print(f"{len(base)} mechanisms, {given.until} s in steps of {given.step} s")
    for way, found in rows.items():
        cpu = sum(x[0] for x in found)
        print(f"{way:9} CPU {cpu:6.2f} s, {cpu / sum(x[0] for x in base):.2f} of constraints, median "
              f"{statistics.median(x[0] / y[0] for x, y in zip(found, base)):.2f}; told inaccurate "
              f"{sum(x[1] for x in found)}; error {statistics.median(x[2] / y[2] for x, y in zip(found, base)):.2f}, "
              f"worse by 3: {sum(x[2] > 3 * y[2] + 1e-9 for x, y in zip(found, base))}, "
              f"better by 3: {sum(y[2] > 3 * x[2] + 1e-9 for x, y in zip(found, base))}")


def compare_chains(given, folder):
    for name, space, heavy in (("hinges", False, False), ("ball joints", True, False),
                               ("ball joints, heavy end", True, True)):
        found = []
        for n in (2, 4, 8, 12, 20):
            cpu = [run(given.program, folder,
                       chain(n, space, heavy, given.step, given.steps, way))[2]["cpu_s"]
                   for way in ("absolute", "minimal")]
            found.append(f"{n}: {1e6 * cpu[1] / given.steps:.0f} µs, {cpu[1] / cpu[0]:.2f}")
        print(f"{name}: {'; '.join(found)}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", nargs="?", default="build/release/bin/dynamy")
    parser.add_argument("what", choices=("random", "chains"))
    parser.add_argument("--step", type=float, default=1e-3)
    parser.add_argument("--until", type=float, default=1.0)
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--seeds", type=int, nargs=2, default=(1, 60), metavar=("FIRST", "END"))
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        (compare_random if given.what == "random" else compare_chains)(given, folder)


if __name__ == "__main__":
    main()
