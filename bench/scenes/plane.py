#!/usr/bin/env python3
"""Cost of scenes in space whose motion stays in a plane: kept in space, found, written with PlanarBody.

    bench/scenes/plane.py [--program build/release/bin/dynamy] [--rounds 7] [--heaps 30]

Twelve boxes or balls tumble on a floor for 12 s; random heaps (8 to 30 bodies of six shapes between two walls, 2 s) are
run both ways. All ways take turns; CPU time of a run without recording, medians, as in theory 39.10.
"""
import argparse
import pathlib
import random
import resource
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESTITUTION = '<UnilateralCoulomb mu="{mu}" epsilonN="{e}"/>'


def model(ground, bodies, law, simulation):
    return (f'<dynamy version="1"><systems><Ground>{ground}</Ground>{bodies}</systems><forces><Gravity/></forces><elements>'
            f'<Contact between="m m">{law}</Contact></elements><simulation {simulation}/>'
            '<record signals="b0.x" frames="2"/></dynamy>')


def tumbling(shape, simulation, planar):
    r, bodies = random.Random(3), ""
    for i in range(12):
        z, angle, spin = 0.6 + 0.5 * r.random(), r.random(), 2 * r.random()
        start = f'name="b{i}" position="{1.2 * i} 0 {z}" velocity="1 0 0" '
        if planar:
            bodies += f'<PlanarBody {start} angle="{-angle}" angularVelocity="{-spin}">{shape}</PlanarBody>'
        else:
            bodies += f'<RigidBody {start} euler="0 {angle} 0" angularVelocity="0 {spin} 0">{shape}</RigidBody>'
    return model('<HalfSpace material="m"/>', bodies, RESTITUTION.format(mu=0.4, e=0.3), 'until="12" ' + simulation)


def heap(seed, simulation):
    r = random.Random(seed)
    count, bodies = r.randint(8, 30), ""
    for i in range(count):
        u = r.uniform
        shape = r.choice([
            f'<Box size="{u(.2, .5)} 0.3 {u(.2, .5)}"', f'<Sphere radius="{u(.1, .25)}"',
            f'<Cylinder radius="{u(.1, .25)}" length="0.3" euler="90deg 0 0"',
            f'<Cylinder radius="{u(.1, .2)}" length="{u(.2, .5)}"', f'<Capsule radius="{u(.08, .15)}" length="{u(.1, .3)}"',
            f'<Ellipsoid semiAxes="{u(.1, .2)} 0.15 {u(.1, .25)}"'])
        bodies += (f'<RigidBody name="b{i}" position="{-1 + (i % 3) + u(-.2, .2)} 0 {0.5 + 0.55 * (i // 3) + u(0, .1)}" '
                   f'euler="0 {u(-3, 3)} 0" velocity="{u(-1, 1)} 0 {u(-1, 0)}" angularVelocity="0 {u(-3, 3)} 0">'
                   f'{shape} density="500" material="m"/></RigidBody>')
    walls = ('<HalfSpace material="m"/><HalfSpace position="-1.5 0 0" euler="0 90deg 0" material="m"/>'
             '<HalfSpace position="1.5 0 0" euler="0 -90deg 0" material="m"/>')
    law = RESTITUTION.format(mu=r.choice([0, 0.2, 0.5, 0.9]), e=r.choice([0, 0, 0.3]))
    return model(walls, bodies, law, 'until="2" ' + simulation)


def cpu(program, text, folder):
    """CPU seconds of a run, and its exit status."""
    file = pathlib.Path(folder) / "m.xml"
    file.write_text(text)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    status = subprocess.run([program, "run", file, "--quiet", "--out", pathlib.Path(folder) / "r"],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, status


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=ROOT / "build/release/bin/dynamy")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--heaps", type=int, default=30)
    given = parser.parse_args()
    space = ' coordinates="absolute"'
    with tempfile.TemporaryDirectory() as folder:
        for name, shape in (("boxes", '<Box size="0.4 0.3 0.3" mass="10" material="m"/>'),
                            ("balls", '<Sphere radius="0.2" mass="10" material="m"/>')):
            for how in ('step="1e-3"', 'tolerance="1e-8"'):
                texts = {"in space": tumbling(shape, how + space, False), "found": tumbling(shape, how, False),
                         "PlanarBody": tumbling(shape, how, True)}
                times = {way: [] for way in texts}
                for _ in range(given.rounds):
                    for way, text in texts.items():
                        times[way].append(cpu(given.program, text, folder)[0])
                print(f"{name}, {how}: " + ", ".join(f"{w} {statistics.median(t):.2f} s" for w, t in times.items()))
        for how in ('step="2e-3"', 'tolerance="1e-5"'):
            pairs = [(cpu(given.program, heap(seed, how + space), folder), cpu(given.program, heap(seed, how), folder))
                     for seed in range(given.heaps)]
            if not pairs:
                continue
            print(f"heaps, {how}: found over in space {statistics.median(f[0] / s[0] for s, f in pairs):.2f} of the CPU; "
                  f"{sum(s[0] for s, _ in pairs):.1f} and {sum(f[0] for _, f in pairs):.1f} s in all; without a warning "
                  f"{sum(s[1] == 0 for s, _ in pairs)} and {sum(f[1] == 0 for _, f in pairs)} of {len(pairs)}")


if __name__ == "__main__":
    main()
