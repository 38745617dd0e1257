#!/usr/bin/env python3
"""Cost of n balls that bounce a metre apart, with laws between them, for 1 s to a tolerance.

    bench/scenes/bouncing_balls.py PROGRAM… [--n 10 30 100] [--tolerance 1e-8] [--repeat 3]
                                   [--clocks one islands]
    bench/scenes/bouncing_balls.py --model N      prints the model

PROGRAM is one build of dynamY or several, which take turns, each with all clocks. A row for each n:
CPU seconds (the least of the repetitions), and of the first of them evaluations a switch, looks at all contacts a
switch, and gaps a switch and ball (theory 50.3).
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import tempfile


def model(n, clocks="one"):
    r = random.Random(7)
    side = int(n ** 0.5) + 1
    bodies = "\n".join(
        f'<RigidBody name="b{i}" position="{i % side} {i // side} {0.3 + r.random():.6f}">'
        f'<Sphere radius="0.1" mass="1" material="ball"/></RigidBody>' for i in range(n))
    return f"""<dynamy version="1"><systems>
{bodies}
<Ground name="world"><HalfSpace material="floor"/></Ground></systems>
<forces><Gravity/></forces><elements>
<Contact between="ball floor"><UnilateralCoulomb mu="0.3" epsilonN="0.8"/></Contact>
<Contact between="ball ball"><UnilateralCoulomb mu="0.3" epsilonN="0.8"/></Contact></elements>
<record signals="b0.z" every="0.01" frames="0"/><simulation until="1" tolerance="1e-8"><LocatedDormandPrince
clocks="{clocks}"/></simulation></dynamy>
"""


def run(program, path, tolerance, out):
    subprocess.run([program, "run", path, "--tolerance", tolerance, "--out", out],
                   check=True, capture_output=True, text=True)
    return json.loads(next(pathlib.Path(out).rglob("run.json")).read_text())


def main():
    p = argparse.ArgumentParser(description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("program", nargs="*")
    p.add_argument("--n", type=int, nargs="+", default=[10, 30, 100])
    p.add_argument("--tolerance", default="1e-8")
    p.add_argument("--repeat", type=int, default=3)
    p.add_argument("--clocks", nargs="+", default=["one", "islands"], choices=["one", "islands"])
    p.add_argument("--model", type=int)
    a = p.parse_args()
    if a.model:
        print(model(a.model, a.clocks[0]), end="")
        return
    if not a.program:
        p.error("give a program, or --model N")
    kinds = [(program, clocks) for program in a.program for clocks in a.clocks]
    print(f"{'n':>6} " + " ".join(f"{clocks:>8}" for _, clocks in kinds)
          + "  evaluations/switch  looks/switch  gaps/(switch ball)  same bits")
    for n in a.n:
        with tempfile.TemporaryDirectory() as folder:
            path = {}
            for clocks in a.clocks:
                path[clocks] = os.path.join(folder, f"balls_{clocks}.xml")
                pathlib.Path(path[clocks]).write_text(model(n, clocks))
            cpu, facts = [[] for _ in kinds], [None] * len(kinds)
            for r in range(a.repeat):
                for k, (program, clocks) in enumerate(kinds):
                    facts[k] = run(program, path[clocks], a.tolerance,
                                   os.path.join(folder, f"o{k}_{r}"))
                    cpu[k].append(facts[k]["cpu_s"])
        first = facts[0]
        switches = max(1, first["switchesLocated"])
        same = len({f["hash"] for f in facts}) == 1
        print(f"{n:6} " + " ".join(f"{min(c):8.3f}" for c in cpu)
              + f"  {first['evaluations'] / switches:18.1f}"
              + f"  {first['effort']['looks'] / switches:12.1f}"
              + f"  {first['effort']['gaps'] / switches / n:18.1f}"
              + f"  {'yes' if same else 'no'}")


if __name__ == "__main__":
    main()
