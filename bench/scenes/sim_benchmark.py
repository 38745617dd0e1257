#!/usr/bin/env python3
"""Two scenes in the manner of SimBenchmark (leggedrobotics, 2018), whose motion has a closed form.

    bench/scenes/sim_benchmark.py PROGRAM      prints a table of errors and CPU times

Rolling: a plate of 10 kg lies on 25 balls of 1 kg and is drawn by 150 N at its lower face, along a
side or at 45 degrees, for 0.4 s, in which it goes 0.6 m, half of it over the balls. With mu = 2
nothing has to slip. A ball between plate and ground has half of the plate's acceleration a; from its
momentum and its angular momentum the plate drives it with 0.35 m a, so

    a = F/(M + 0.35 n m)

The error is the mean over 40 instants of the plate's and the balls' velocities against a t and
a t/2, over a t at the end. Bouncing: 49 balls with restitution 1 fall from 5 m for 20 s. The error
is the mean of |T + V - E| over E.
"""
import csv
import math
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 3
F, M, N, BALL, R, T_ROLL = 150.0, 10.0, 25, 1.0, 0.5, 0.4


def rolling(angle, settings):
    """The balls stand two metres apart; the plate is so large that none leaves it."""
    inertia = 0.4 * BALL * R * R
    balls = "".join(
        f'<RigidBody name="ball{k}" position="{2 * (k % 5) - 4} {2 * (k // 5) - 4} {R}" mass="{BALL}" '
        f'inertia="{inertia} {inertia} {inertia}"><Sphere radius="{R}" material="m"/></RigidBody>'
        for k in range(N))
    names = " ".join(f"ball{k}.vx ball{k}.vy" for k in range(N))
    return f"""<dynamy version="1"><systems>
<Ground name="w"><HalfSpace material="m"/></Ground>{balls}
<RigidBody name="plate" position="0 0 {2 * R + 0.5}" mass="{M}" inertia="1e5 1e5 1e5">
<Box size="300 300 1" material="m"/></RigidBody></systems>
<forces><Gravity/><ForceInput on="plate" point="0 0 -0.5" force="{F * math.cos(angle)!r}; {F * math.sin(angle)!r}; 0"/></forces>
<elements><Contact between="m m"><UnilateralCoulomb mu="2"/></Contact></elements>
<simulation until="{T_ROLL}" {settings}/>
<record signals="plate.vx plate.vy {names}" every="10ms" frames="0"/></dynamy>"""


def bouncing(settings):
    balls = "".join(
        f'<RigidBody name="ball{k}" position="{2 * (k % 7)} {2 * (k // 7)} 5.5" mass="1" '
        f'inertia="0.1 0.1 0.1"><Sphere radius="0.5" material="m"/></RigidBody>' for k in range(49))
    return f"""<dynamy version="1"><systems>
<Ground name="w"><HalfSpace material="m"/></Ground>{balls}</systems><forces><Gravity/></forces>
<elements><Contact between="m m"><UnilateralCoulomb mu="0.8" epsilonN="1"/></Contact></elements>
<simulation until="20" {settings}/>
<record signals="ball0.z" every="10ms" frames="0"/></dynamy>"""


def column(folder, file, name):
    with open(Path(folder) / file, encoding="utf-8") as f:
        rows = list(csv.reader(f))
    at = rows[0].index(name)
    return [float(r[at]) for r in rows[1:]]


def error_of_rolling(folder, angle):
    a = F / (M + 0.35 * N * BALL)
    t = column(folder, "signals.csv", "t")
    total = 0.0
    for name, share in [("plate", 1.0)] + [(f"ball{k}", 0.5) for k in range(N)]:
        vx, vy = column(folder, "signals.csv", name + ".vx"), column(folder, "signals.csv", name + ".vy")
        total += sum(math.hypot(x - share * a * s * math.cos(angle), y - share * a * s * math.sin(angle))
                     for s, x, y in zip(t, vx, vy)) / len(t)
    return total / (N + 1) / (a * T_ROLL)


def error_of_bouncing(folder):
    T, V = column(folder, "ledger.csv", "kinetic"), column(folder, "ledger.csv", "potential")
    floor = 49 * 9.81 * 0.5  # of balls that touch the ground
    E = T[0] + V[0]
    return sum(abs(x + y - E) for x, y in zip(T, V)) / len(T) / (E - floor)


def run(program, text, error):
    cpu = []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.xml"
        file.write_text(text, encoding="utf-8")
        for _ in range(ROUNDS):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([program, "run", file, "--quiet", "--out", Path(folder) / "run"], check=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            cpu.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        return error(Path(folder) / "run"), statistics.median(cpu)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = Path(sys.argv[1]).resolve()
    print("| scene | settings | mean error | CPU [s] |\n|---|---|---|---|")
    for settings in ('step="1ms"', 'step="10ms"', 'tolerance="1e-8"'):
        for angle, name in ((0.0, "rolling along a side"), (0.25 * math.pi, "rolling at 45 degrees")):
            e, cpu = run(program, rolling(angle, settings), lambda f, a=angle: error_of_rolling(f, a))
            print(f"| {name} | {settings} | {e:.1e} | {cpu:.2f} |")
    for settings in ('step="1ms"', 'step="10ms"', 'tolerance="1e-8"', 'tolerance="1e-12"'):
        e, cpu = run(program, bouncing(settings), error_of_bouncing)
        print(f"| bouncing | {settings} | {e:.1e} | {cpu:.2f} |")


if __name__ == "__main__":
    main()
