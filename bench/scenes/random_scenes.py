#!/usr/bin/env python3
"""Scenes of many bodies for dynamY and for other programs.

    bench/scenes/random_scenes.py random SEED        prints a model
    bench/scenes/random_scenes.py wall|pour|hopper|dominoes|pile [N]

A scene is a dictionary: bodies with one shape each, planes and boxes that stand still, joints and
springs between neighbours, one friction and one rebound. Mass and inertia are written out and lie
in the middle of the shape, so that every program moves the same bodies. model() writes it as a
model of dynamY, plain() as the text that bench/peers/scene.hpp reads.
"""
import math
import random
import sys

SHAPES = ("Sphere", "Box", "Capsule", "Cylinder", "Cone", "Polyhedron", "Ellipsoid", "Torus")
JOINTS = ("Revolute", "Spherical", "Fixed", "Prismatic")
MATERIAL = 'material="m"'
COMMON_SHAPES = {"Sphere", "Box", "Capsule", "Cylinder", "Cone", "Polyhedron"}  # Bullet's, too


def inertia_of(kind, size, mass):
    """Principal moments [kg m²]; of polyhedra and capsules those of the ellipsoid around them."""
    if kind == "Sphere":
        a = b = c = size[0]
    elif kind == "Box":
        return [mass * (size[1]**2 + size[2]**2) / 12, mass * (size[0]**2 + size[2]**2) / 12,
                mass * (size[0]**2 + size[1]**2) / 12]
    elif kind in ("Cylinder", "Cone"):
        across = mass * (3 * size[0]**2 + size[1]**2) / 12
        return [across, across, 0.5 * mass * size[0]**2]
    elif kind == "Capsule":
        a, b, c = size[0], size[0], 0.5 * size[1] + size[0]
    elif kind == "Torus":
        a, b, c = size[0] + size[1], size[0] + size[1], size[1]
    elif kind == "Ellipsoid":
        a, b, c = size
    else:
        a, b, c = (max(abs(x) for x in size[k::3]) for k in range(3))
    return [0.2 * mass * (b * b + c * c), 0.2 * mass * (a * a + c * c), 0.2 * mass * (a * a + b * b)]


def body(kind, size, mass, at, turn=(1, 0, 0, 0), v=(0, 0, 0), w=(0, 0, 0)):
    """`w` in the body's axes, `turn` a quaternion w x y z."""
    return dict(kind=kind, size=list(size), mass=mass, inertia=inertia_of(kind, size, mass),
                at=list(at), turn=list(turn), v=list(v), w=list(w))


def random_turn(r):
    q = [r.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(x * x for x in q))
    return [x / length for x in q]


def random_shape(r, kind, s):
    """Sizes of a shape that fits into a ball of radius s."""
    if kind == "Sphere":
        return [s]
    if kind == "Box":
        return [2 * s * r.uniform(0.25, 0.57) for _ in range(3)]
    if kind == "Capsule":
        return [0.4 * s, 1.1 * s]
    if kind in ("Cylinder", "Cone"):
        return [0.6 * s, 1.5 * s]
    if kind == "Ellipsoid":
        return [s * r.uniform(0.3, 1) for _ in range(3)]
    if kind == "Torus":
        return [0.7 * s, 0.25 * s]
    return [s * r.uniform(-0.57, 0.57) for _ in range(3 * r.randint(6, 12))]


def scene(name, bodies, step, steps, mu=0.5, e=0.0, g=9.81, planes=None, boxes=(), joints=(),
          springs=()):
    floor = [((0, 0, 0), (0, 0, 1))]
    return dict(name=name, bodies=bodies, step=step, steps=steps, mu=mu, e=e, g=g,
                planes=floor if planes is None else planes, boxes=list(boxes), joints=list(joints),
                springs=list(springs))


def random_scene(seed, common=False):
    """3 to 30 bodies; `common`: with Bullet's shapes alone, without joints and springs."""
    r = random.Random(f"scene {seed}")
    n, size = r.randint(3, 30), 10 ** r.uniform(-2, 0.5)
    g = r.choice([9.81, 9.81, 9.81, 0.0, 100.0])
    decades = r.choice([0, 1, 3, 6])
    kinds = r.choice([SHAPES[:1], SHAPES[1:2], SHAPES[:3], SHAPES, SHAPES[3:7]])
    if common:
        kinds = [k for k in kinds if k in COMMON_SHAPES]
    speed, spin = size * r.choice([0, 0, 1, 10]), r.choice([0, 0, 5, 100])
    tower, side, pitch = r.random() < 0.2, math.ceil(n ** (1 / 3)), 2.5 * size
    bodies = []
    for i in range(n):
        kind, s = r.choice(kinds), size * r.uniform(0.4, 1)
        cell = (0, 0, i) if tower else (i % side, i // side % side, i // side**2)
        at = [pitch * c + size * r.uniform(-0.1, 0.1) for c in cell]
        at[2] = pitch * cell[2] + 1.3 * size
        bodies.append(body(kind, random_shape(r, kind, s), 10 ** (decades * r.uniform(-0.5, 0.5)),
                           at, random_turn(r) if r.random() < 0.7 else (1, 0, 0, 0),
                           [r.gauss(0, speed) for _ in range(3)],
                           [r.gauss(0, spin) for _ in range(3)]))
    planes = [((0, 0, 0), (0, 0, 1))]
    if r.random() < 0.4:
        far = side * pitch + 2 * size
        planes += [((-2 * size, 0, 0), (1, 0, 0)), ((far, 0, 0), (-1, 0, 0)),
                   ((0, -2 * size, 0), (0, 1, 0)), ((0, far, 0), (0, -1, 0))]
    joints, springs = [], []
    if not common and r.random() < 0.3:
        for a in sorted(r.sample(range(n - 1), r.randint(1, max(1, n // 4)))):
            at = [(x + y) / 2 for x, y in zip(bodies[a]["at"], bodies[a + 1]["at"])]
            joints.append((r.choice(JOINTS), a, a + 1, at,
                           r.choice([(1, 0, 0), (0, 1, 0), (0, 0, 1)])))
    for kind, a, b, _, _ in joints:  # a start that the joints allow
        for k in (a, b):
            bodies[k]["v"], bodies[k]["w"] = [0, 0, 0], [0, 0, 0]
    for a in range(n - 1) if not common and r.random() < 0.3 else ():
        springs.append((a, a + 1, 10 ** r.uniform(1, 8),
                        math.dist(bodies[a]["at"], bodies[a + 1]["at"])))
    T = math.sqrt(size / max(g, 1))
    return scene(f"random {seed}", bodies, T * r.choice([0.003, 0.01, 0.03]), r.choice([100, 200]),
                 r.choice([0, 0.5, r.uniform(0, 1.5)]), r.choice([0, 0, r.uniform(0, 0.9)]), g,
                 planes, (), joints, springs)


def wall(n=100, speed=10, steps=500):
    """Bricks in running bond, hit by a ball of 200 kg at 10 m/s or another speed."""
    rows = round(math.sqrt(n))
    bricks = [body("Box", (0.4, 0.2, 0.2), 16, (0.4 * k - 0.2 * (rows - 1) + 0.2 * (j % 2), 0,
                                                 0.1 + 0.2 * j))
              for j in range(rows) for k in range(rows)]
    ball = body("Sphere", [0.3], 200, (0, -1, 0.1 * rows), v=(0, speed, 0))
    name = f"wall {n}" + ("" if speed == 10 else f" at {speed:g}")
    return scene(name, bricks + [ball], 2e-3, steps)


def pour(n=1000):
    """Balls let fall into a box."""
    r, nx, pitch = random.Random("pour"), 10 if n <= 1000 else 20, 0.11
    W, m = 0.5 * pitch * nx, 1000 * 4 / 3 * math.pi * 0.05**3
    balls = [body("Sphere", [0.05], m, [x + r.uniform(-0.004, 0.004) for x in (
        -W + pitch * (0.5 + i % nx), -W + pitch * (0.5 + i // nx % nx),
        0.06 + pitch * (i // nx**2))]) for i in range(n)]
    sides = [((0, 0, 0), (0, 0, 1)), ((-W, 0, 0), (1, 0, 0)), ((W, 0, 0), (-1, 0, 0)),
             ((0, -W, 0), (0, 1, 0)), ((0, W, 0), (0, -1, 0))]
    return scene(f"pour {n}", balls, 5e-3, 200, planes=sides)


def hopper(n=150):
    """Balls between four slopes over an opening of four diameters."""
    r, radius, half = random.Random("hopper"), 0.05, math.radians(60) / 2
    balls = [body("Sphere", [radius], 1.3, [x + r.uniform(-0.003, 0.003) for x in (
        0.11 * (i % 5 - 2), 0.11 * (i // 5 % 5 - 2), 1.3 + 0.11 * (i // 25))]) for i in range(n)]
    c, s = math.cos(half), math.sin(half)
    reach = 0.2 + 0.5 * math.cos(math.radians(60))
    boxes = [((0.05, 1.6, 1), (reach, 0, 0.95), (c, 0, s, 0)),
             ((0.05, 1.6, 1), (-reach, 0, 0.95), (c, 0, -s, 0)),
             ((1.6, 0.05, 1), (0, reach, 0.95), (c, -s, 0, 0)),
             ((1.6, 0.05, 1), (0, -reach, 0.95), (c, s, 0, 0))]
    return scene(f"hopper {n}", balls, 2e-3, 500, mu=0.3, boxes=boxes)


def dominoes(n=20):
    """A row; the first starts with 3.5 rad/s about its lower edge."""
    row = [body("Box", (0.008, 0.024, 0.05), 15e-3, (0.028 * i, 0, 0.025)) for i in range(n)]
    row[0]["v"], row[0]["w"] = [0.0875, 0, 0.014], [0, 3.5, 0]
    return scene(f"dominoes {n}", row, 1e-3, 800)


def pile(n=30):
    """Boxes, balls, capsules and cylinders dropped on a heap."""
    r = random.Random("pile")
    bodies = []
    for i in range(n):
        kind = SHAPES[i % 4]
        at = [0.22 * (i % 3 - 1) + r.uniform(-0.02, 0.02),
              0.22 * (i // 3 % 3 - 1) + r.uniform(-0.02, 0.02), 0.15 + 0.22 * (i // 9)]
        bodies.append(body(kind, random_shape(r, kind, 0.1), 1, at, random_turn(r)))
    return scene(f"pile {n}", bodies, 2e-3, 500)


def numbers(values):
    return " ".join(f"{x:.17g}" for x in values)


def shape_xml(kind, size, more):
    names = {"Sphere": ("radius",), "Capsule": ("radius", "length"), "Cylinder": ("radius", "length"),
             "Cone": ("radius", "length"), "Torus": ("radius", "tube")}
    if kind in names:
        text = " ".join(f'{a}="{x:.17g}"' for a, x in zip(names[kind], size))
        if kind == "Cone":  # from its base circle; bodies are centred at half the height
            text += f' position="0 0 {-0.5 * size[1]:.17g}"'
    else:
        name = {"Box": "size", "Ellipsoid": "semiAxes", "Polyhedron": "points"}[kind]
        text = f'{name}="{numbers(size)}"'
    return f"<{kind} {text} {more}/>"


def model(s, poses=None, samples=5):
    """The scene as a model. With `poses` (13 numbers a body) it stands there, for its gaps alone."""
    out = ['<dynamy version="1">', "<systems>"]
    for i, b in enumerate(s["bodies"]):
        at, turn = (b["at"], b["turn"]) if poses is None else (poses[i][:3], poses[i][3:7])
        start = f' velocity="{numbers(b["v"])}" angularVelocity="{numbers(b["w"])}"'
        out.append(f'<RigidBody name="b{i}" position="{numbers(at)}" orientation="{numbers(turn)}"'
                   f'{start if poses is None else ""} mass="{b["mass"]:.17g}" '
                   f'inertia="{numbers(b["inertia"])}">'
                   f'{shape_xml(b["kind"], b["size"], MATERIAL)}'
                   "</RigidBody>")
    ground = [f'<HalfSpace position="{numbers(p)}" normal="{numbers(n)}" material="m"/>'
              for p, n in s["planes"]]
    ground += [f'<Box size="{numbers(d)}" position="{numbers(p)}" orientation="{numbers(q)}" '
               'material="m"/>' for d, p, q in s["boxes"]]
    out += ['<Ground name="world">', *ground, "</Ground>", "</systems>", "<forces>"]
    out.append(f'<Gravity acceleration="0 0 {-s["g"] if poses is None else 0:.17g}"/>')
    for j, (a, b, stiffness, length) in enumerate(s["springs"] if poses is None else ()):
        out.append(f'<SpringDamper name="s{j}" between="b{a} b{b}" stiffness="{stiffness:.17g}" '
                   f'length="{length:.17g}"/>')
    out += ["</forces>", "<elements>", '<Contact between="m m"><UnilateralCoulomb '
            f'mu="{s["mu"]:.17g}" epsilonN="{s["e"]:.17g}"/></Contact>']
    for kind, a, b, at, axis in s["joints"]:
        if poses is None:
            along = f' axis="{numbers(axis)}"' if kind in ("Revolute", "Prismatic") else ""
            out.append(f'<{kind} between="b{a} b{b}" at="{numbers(at)}"{along}/>')
    until = s["step"] * s["steps"]
    every, step = until / samples, s["step"]
    if poses is not None:
        until = every = step = 1e-9
    names = ("x y z qw qx qy qz vx vy vz Omega_x Omega_y Omega_z").split()
    signals = " ".join(f"b{i}.{x}" for i in range(len(s["bodies"])) for x in names)
    out += ["</elements>", f'<simulation until="{until:.17g}" step="{step:.17g}"/>',
            f'<record signals="{signals}" every="{every:.17g}" frames="0"/>', "</dynamy>"]
    return "\n".join(out) + "\n"


def plain(s, samples=5):
    """The scene as lines of a word and numbers; angular velocities in the body's axes."""
    out = [f"run {s['step']:.17g} {s['steps']} {samples}",
           f"law {s['g']:.17g} {s['mu']:.17g} {s['e']:.17g}"]
    out += [f"plane {numbers([*p, *n])}" for p, n in s["planes"]]
    out += [f"slab {numbers([*d, *p, *q])}" for d, p, q in s["boxes"]]
    for b in s["bodies"]:
        out.append(f"body {b['kind']} {len(b['size'])} " + numbers(
            [*b["size"], b["mass"], *b["inertia"], *b["at"], *b["turn"], *b["v"], *b["w"]]))
    out += [f"joint {kind} {a} {b} {numbers([*at, *axis])}" for kind, a, b, at, axis in s["joints"]]
    return "\n".join(out) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    makers = {"random": random_scene, "wall": wall, "pour": pour, "hopper": hopper,
              "dominoes": dominoes, "pile": pile}
    if sys.argv[1] not in makers:
        sys.exit(f"no scene {sys.argv[1]}: one of {', '.join(makers)}")
    number = sys.argv[2:3] or (["1"] if sys.argv[1] == "random" else [])
    sys.stdout.write(model(makers[sys.argv[1]](*map(int, number))))


if __name__ == "__main__":
    main()
