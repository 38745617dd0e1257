#!/usr/bin/env python3
"""Derivatives of motions with respect to parameters and initial values, with 30 digits.

    ./make_reference.py > reference.csv          (needs mpmath; some minutes)

Nothing here uses dynamY. A motion is a closed form, or is integrated by Gragg's method with extrapolation of
order 24 from event to event, each event located to 1e-30; phases that are linear have exponentials
(linear_phases.py). Derivatives are central differences of fourth order of such motions with a part of 1e-7
of the parameter: their error is about 1e-24.
"""
from linear_phases import LinearPhases
from mpmath import mp, matrix, mpf, sin, cos, sqrt, pi, findroot, atan2

mp.dps = 36
G = mpf("9.81")
PAIRS = range(1, 13)


def step(f, t, x, h):
    """One step of Gragg's method, extrapolated."""
    rows = []
    for j in PAIRS:
        n = 2 * j
        k = h / n
        a, b = x, [p + k * q for p, q in zip(x, f(t, x))]
        for i in range(1, n):
            a, b = b, [p + 2 * k * q for p, q in zip(a, f(t + i * k, b))]
        row = [[(p + q + k * r) / 2 for p, q, r in zip(a, b, f(t + h, b))]]
        for m, before in enumerate(rows[-1] if rows else []):
            part = 1 / ((mpf(j) / (j - m - 1)) ** 2 - 1)
            row.append([p + (p - q) * part for p, q in zip(row[m], before)])
        rows.append(row)
    return rows[-1][-1]


def fly(f, t, x, end, guard=None, h=mpf(1) / 40):
    """Integrates to `end`, or until guard(t, x) falls through zero. Returns t, x and whether it did."""
    armed = False
    while t < end:
        d = min(h, end - t)
        y = step(f, t, x, d)
        if guard is not None:
            before, after = guard(t, x), guard(t + d, y)
            armed = armed or after > 0
            if armed and after <= 0 and before > mpf(10) ** -25:
                at = lambda s: guard(t + s, step(f, t, x, s))
                s = findroot(at, (d * before / (before - after), d * mpf("0.999") * before / (before - after)),
                             tol=mpf(10) ** -58)
                return t + s, step(f, t, x, s), True
        t, x = t + d, y
    return t, x, False


# Each case: values of parameters, and a function from them to the values that are wanted.

def ball(p):
    """N01: falls from h, bounces."""
    h, e, g, v = p["h0"], p["e"], p["g"], p["ball.vz"]
    out = {}
    for t in ("0.6", "1", "1.3"):
        at, now, up = mpf(t), (v + sqrt(v * v + 2 * g * h)) / g, sqrt(v * v + 2 * g * h) * e
        while now + 2 * up / g < at:
            now, up = now + 2 * up / g, up * e
        out["ball.z@" + t] = mpf("0.1") + up * (at - now) - g / 2 * (at - now) ** 2
        out["ball.vz@" + t] = up - g * (at - now)
    return out


def table(p):
    """N02: bounces on a table A sin(w t + phase), starts on it."""
    A, e, w, phase, v = p["A"], p["e"], p["w"], p["phase"], p["ball.y_dot"]
    t, y = mpf(0), A * sin(phase)
    for n in range(5):
        gap = lambda s: y + v * (s - t) - G / 2 * (s - t) ** 2 - A * sin(w * s + phase)
        hit = findroot(gap, t + mpf(1) / 10, tol=mpf(10) ** -60)
        down, wall = v - G * (hit - t), A * w * cos(w * hit + phase)
        y, v, t = A * sin(w * hit + phase), wall - e * (down - wall), hit
    s = mpf("0.55") - t
    return {"ball.y@0.55": y + v * s - G / 2 * s * s, "ball.y_dot@0.55": v - G * s, "t:table=impact#5": t}


def slope(p):
    """N04: a block goes up a slope and slides back."""
    mu, v, a = p["mu"], p["v0"], p["alpha"]
    up, back = G * (sin(a) + mu * cos(a)), G * (sin(a) - mu * cos(a))
    s = 2 - v / up
    return {"block.x@2": (v * v / (2 * up) - back / 2 * s * s) * cos(a) - mpf("0.05") * sin(a),
            "block.vx@2": -back * s * cos(a)}


def belt(p):
    """N05: sticks to a belt, slips, sticks."""
    Fs, Fk, vb, x0 = p["Fs"], p["Fk"], p["vb"], p["block.x"]
    leave = (Fs - x0) / vb
    angle = 2 * (pi - atan2(Fs - Fk, vb))  # until x_dot = vb again: x − Fk changes its sign
    x = lambda s: Fk + (Fs - Fk) * cos(s) + vb * sin(s)
    back = leave + angle
    return {"block.x@8": x(8 - leave), "block.x@10": x(angle) + vb * (10 - back),
            "t:friction=slip": leave, "t:friction=stick": back}


def dry(p):
    """N05c: an oscillator with dry friction rests after 13 half swings."""
    out = {"block.x@6": -(p["x0"] - 26 * p["mu"] * G / p["k"])}
    half = pi / sqrt(p["k"])
    n, left = 3, p["x0"] - 6 * p["mu"] * G / p["k"]
    slip = p["mu"] * G / p["k"]
    out["block.x@1"] = -((left - slip) * cos((1 - n * half) * sqrt(p["k"])) + slip)
    return out


def stribeck(p):
    """N05e: as N05, with friction that falls with the speed of slip."""
    vb, x0 = p["vb"], p["block.x"]
    leave = (1 - x0) / vb
    f = lambda t, x: [x[1], -x[0] + 1 / (1 + 3 * (vb - x[1]))]
    out = {"block.x@8": fly(f, leave, [mpf(1), vb], mpf(8))[1][0]}
    back, x, hit = fly(f, leave, [mpf(1), vb], mpf(10), lambda t, x: vb - x[1])
    assert hit
    out["block.x@11"] = x[0] + vb * (11 - back)
    out["t:friction=stick"] = back
    return out


def roll(p):
    """N06: a ball slides until it rolls."""
    t, v, mu = mpf("0.45"), p["v0"], p["mu"]
    r = 2 * v / (7 * mu * G)
    return {"ball.x@0.45": v * r - mu * G / 2 * r * r + 5 * v / 7 * (t - r), "ball.vx@0.45": 5 * v / 7}


def oscillator(p):
    """N07: driven, no damping, a wall at 0; starts at the wall."""
    F, e, w, phase, v = p["F"], p["e"], p["w"], p["phase"], p["mass.x_dot"]
    A, t, x = F / (1 - w * w), mpf(0), mpf(0)
    forced = lambda s: A * cos(w * s + phase)
    rate = lambda s: -A * w * sin(w * s + phase)
    where = lambda s: forced(s) + (x - forced(t)) * cos(s - t) + (v - rate(t)) * sin(s - t)
    speed = lambda s: rate(s) - (x - forced(t)) * sin(s - t) + (v - rate(t)) * cos(s - t)
    for n in range(4):
        hit = findroot(where, t + 2 * pi / w, tol=mpf(10) ** -60)
        t, x, v = hit, mpf(0), -e * speed(hit)
    return {"mass.x@13": where(mpf(13)), "mass.x_dot@13": speed(mpf(13)), "t:wall=impact#4": t}


def rocking(p):
    """N08: a block rocks from corner to corner."""
    b, h = p["b"], p["h"]
    alpha, R = atan2(b, h), sqrt(b * b + h * h)
    start = mpf("0.6") * alpha  # in the model it follows from b and h
    f = lambda t, x: [x[1], -3 * G / (4 * R) * sin(alpha - x[0])]
    t, x, side, out = mpf(0), [start, mpf(0)], -1, {}
    # Before the first impact, and after the second.
    for end in (mpf("0.3"), mpf(1), mpf("1.3")):
        while True:
            t, x, hit = fly(f, t, x, end, lambda t, x: x[0])
            if not hit:
                break
            x, side = [mpf(0), -x[1] * (1 - mpf(3) / 2 * sin(alpha) ** 2)], -side
        out["block.phi@" + mp.nstr(end, 3).rstrip("0").rstrip(".")] = side * x[0]
    return out


def bead(p):
    """N19: a bead chatters across a slot; 0.1 friction, 0.5 restitution; starts at the upper wall."""
    a, play = p["slope"], p["play"]
    mu, e = mpf("0.1"), mpf("0.5")
    out = {}
    for end in (mpf("0.13"), mpf("0.5")):
        t, s, v = mpf(0), mpf(0), mpf(0)
        n, w, g = play, mpf(0), G * cos(a)
        while True:
            d = (w + sqrt(w * w + 2 * g * n)) / g  # to the lower wall; the upper is not met again
            if t + d > end or d < mpf(10) ** -34:
                break
            s, v = s + v * d + G * sin(a) / 2 * d * d, v + G * sin(a) * d
            hit = g * d - w
            v -= mu * (1 + e) * hit
            t, n, w = t + d, mpf(0), e * hit
        d = end - t
        if end < mpf("0.145"):
            s, z = s + v * d + G * sin(a) / 2 * d * d, n + w * d - g / 2 * d * d
        else:
            s, z = s + v * d + G * (sin(a) - mu * cos(a)) / 2 * d * d, mpf(0)
        # From the middle of the slot: down the slope and away from the lower wall.
        out["bead.x@" + mp.nstr(end, 3)] = s * cos(a) + (z - play / 2) * sin(a)
        out["bead.z@" + mp.nstr(end, 3)] = -s * sin(a) + (z - play / 2) * cos(a)
    return out


def domino(p):
    """N21: falls about its lower edge, before it hits the next."""
    h, d, w = p["h"], p["d"], p["w0"]
    r2 = (h * h + d * d) / 4
    f = lambda t, x: [x[1], G * (h / 2 * sin(x[0]) - d / 2 * cos(x[0])) / (4 * r2 / 3)]
    out = {"first.Omega_y@0.14": fly(f, mpf(0), [mpf(0), w], mpf("0.14"), h=mpf(1) / 100)[1][1]}
    return out


def ladder(p):
    """N22: slides off a wall, then along the floor."""
    L, start = p["L"], p["theta0"]
    on = lambda t, x: [x[1], -3 * G / (2 * L) * cos(x[0])]
    # The force of the wall is that of the centre to the side.
    wall = lambda t, x: -(cos(x[0]) * x[1] ** 2 + sin(x[0]) * on(t, x)[1])
    t, x, hit = fly(on, mpf(0), [start, mpf(0)], mpf(1), wall, h=mpf(1) / 50)
    assert hit
    way, speed = L / 2 * cos(x[0]), -L / 2 * sin(x[0]) * x[1]

    def off(t, x):
        a, w = x
        k = L * L / 12 + L * L / 4 * cos(a) ** 2
        return [w, (-G * L / 2 * cos(a) + L * L / 4 * sin(a) * cos(a) * w * w) / k]
    left = t
    t, x, hit = fly(off, t, x, mpf("0.6"), h=mpf(1) / 50)
    return {"ladder.vx@0.6": speed, "ladder.x@0.6": way + speed * (mpf("0.6") - left),
            "ladder.phi@0.6": -x[0], "ladder.omega@0.6": -x[1]}


def pendulum(p):
    """S01."""
    f = lambda t, x: [x[1], -p["g"] / p["l"] * sin(x[0])]
    x = fly(f, mpf(0), [p["minimal.phi"], p["minimal.phi_dot"]], mpf(2))[1]
    return {"minimal.phi@2": x[0], "minimal.phi_dot@2": x[1]}


def free(p):
    """S06: turns near its middle axis."""
    def f(t, x):
        a, b, c, q0, q1, q2, q3 = x
        return [-b * c, c * a, -a * b / 3,
                (-q1 * a - q2 * b - q3 * c) / 2, (q0 * a + q2 * c - q3 * b) / 2,
                (q0 * b + q3 * a - q1 * c) / 2, (q0 * c + q1 * b - q2 * a) / 2]
    zero = [mpf(0)] * 3
    x = fly(f, mpf(0), [p["top.Omega_x"], p["top.Omega_y"], p["top.Omega_z"], mpf(1)] + zero, mpf(4))[1]
    return {"top.Omega_y@4": x[1], "top.qw@4": x[3], "top.qy@4": x[5]}


def heavy(p):
    """S07: phi and psi by the constant momenta."""
    I1, I3, m, spin, start = p["I1"], p["I3"], p["mgl"], p["spin"], p["top.theta"]
    b = I3 * spin
    a = b * cos(start)

    def f(t, x):
        c, s = cos(x[0]), sin(x[0])
        turn = (a - b * c) / (I1 * s * s)
        return [x[1], turn * (I1 * turn * c - b) * s / I1 + m / I1 * s, turn]
    x = fly(f, mpf(0), [start, mpf(0), mpf(0)], mpf(3), h=mpf(1) / 60)[1]
    return {"top.theta@3": x[0], "top.phi@3": x[2]}


def double(p):
    """S09."""
    def f(t, x):
        a, b, u, v = x
        c, s = cos(a - b), sin(a - b)
        k, l = -s * v * v - 2 * p["g"] * sin(a), s * u * u - p["g"] * sin(b)
        det = 2 - c * c
        return [u, v, (k - c * l) / det, (2 * l - c * k) / det]
    x = fly(f, mpf(0), [p["minimal.a"], p["minimal.b"], mpf(0), mpf(0)], mpf(2))[1]
    return {"minimal.a@2": x[0], "minimal.b_dot@2": x[3]}


def woodpecker(p):
    """N10: at 0.1 and 0.2 s, a cycle takes 0.146 s; sleeve2 touches at the start and first sticks at 0.0216 s."""
    mM, mS, JM, JS, c = map(mpf, ("0.0003", "0.0045", "5e-9", "7e-7", "0.0056"))
    lM, lG, lS, hS, hM, rM, r0 = map(mpf, ("0.010", "0.015", "0.0201", "0.020", "0.0058", "0.0031", "0.0025"))
    M = matrix([[mS + mM, mS * lM, mS * lG], [mS * lM, JM + mS * lM ** 2, mS * lM * lG],
                [mS * lG, mS * lM * lG, JS + mS * lG ** 2]])
    K = matrix([[0, 0, 0], [0, c, -c], [0, -c, c]])
    F = -G * matrix([mS + mM, mS * lM, mS * lG])
    W_N = matrix([[0, 0, 0], [0, hM, -hM], [-hS, 0, 0]])
    W_T = matrix([[1, 1, 1], [lM, rM, rM], [lG - lS, 0, 0]])
    gaps, eN = [lM + lG - lS - r0, rM - r0, rM - r0], [p["eN1"], mpf(0), mpf(0)]
    q, u = [mpf(0), mpf("-0.6") / mpf("5.8"), p["toy.phiS"]], [p["toy.y_dot"], mpf(0), p["toy.phiS_dot"]]
    toy = LinearPhases(M, K, F, W_N, gaps, W_T, eN, p["mu"])
    states, events = toy.run(q, u, [mpf("0.1"), mpf("0.2")])
    stuck = next(t for t, contact, kind in events if (contact, kind) == (1, "still"))
    return {"toy.phiS@0.1": states[0][2], "toy.y@0.2": states[1][0], "toy.phiS@0.2": states[1][2],
            "t:sleeve2=stick": stuck}


CASES = [
    ("N01", "bouncing_ball", ball, {"h0": 1, "e": "0.5", "g": "9.81", "ball.vz": 0}),
    ("N02", "vibrating_table", table, {"A": "0.003230372637476834", "e": "0.5", "w": 20 * pi,
                                       "phase": "0.6342158689257742", "ball.y_dot": "0.4905"}),
    ("N04", "block_on_slope_slide", slope, {"mu": "0.3", "v0": 2, "alpha": pi / 9}),
    ("N05", "belt_oscillator", belt, {"Fs": 1, "Fk": "0.5", "vb": "0.2", "block.x": 0}),
    ("N05c", "coulomb_oscillator", dry, {"mu": "0.2", "k": 100, "x0": "0.5"}),
    ("N05e", "stribeck_oscillator", stribeck, {"vb": "0.2", "block.x": 0}),
    ("N06", "slide_to_roll", roll, {"mu": "0.3", "v0": 3}),
    ("N07", "wall_oscillator", oscillator, {"F": 1, "e": "0.8", "w": "2.2", "phase": "2.803786574972142",
                                            "mass.x_dot": "-1.5189989906490423"}),
    ("N08", "rocking_block", rocking, {"b": "0.1", "h": "0.5"}),
    ("N10", "woodpecker", woodpecker, {"mu": "0.3", "eN1": "0.5", "toy.phiS": "-0.2788", "toy.y_dot": "-0.3411",
                                       "toy.phiS_dot": "-7.4583"}),
    ("N19", "bead_in_slot", bead, {"slope": pi / 6, "play": "0.01"}),
    ("N21", "dominoes", domino, {"h": "0.05", "d": "0.008", "w0": "3.5"}),
    ("N22", "ladder", ladder, {"L": 2, "theta0": pi / 3}),
    ("S01", "pendulum", pendulum, {"g": "9.81", "l": 1, "minimal.phi": -pi / 2, "minimal.phi_dot": 0}),
    ("S06", "free_top", free, {"top.Omega_x": "0.01", "top.Omega_y": 5, "top.Omega_z": "0.01"}),
    ("S07", "heavy_top", heavy, {"I1": "0.5", "I3": 1, "mgl": "4.905", "spin": 10, "top.theta": pi / 6}),
    ("S09", "double_pendulum", double, {"g": "9.81", "minimal.a": pi / 2, "minimal.b": pi / 2}),
]


def main():
    import sys
    print("case,model,of,by,value,derivative,parameter")
    for case, model, motion, given in CASES:
        if len(sys.argv) > 1 and case not in sys.argv[1:]:
            continue
        given = {name: mpf(v) for name, v in given.items()}
        value = motion(dict(given))
        for name, v in given.items():
            d = mpf(10) ** -7 * (abs(v) if v else 1)
            at = {k: motion(dict(given, **{name: v + k * d})) for k in (-2, -1, 1, 2)}
            for of in value:
                slope_ = (8 * (at[1][of] - at[-1][of]) - (at[2][of] - at[-2][of])) / (12 * d)
                if abs(slope_) < mpf(10) ** -20:
                    slope_ = mpf(0)
                print(",".join([case, model, of, name, mp.nstr(value[of], 20), mp.nstr(slope_, 20),
                                mp.nstr(v, 20)]), flush=True)


if __name__ == "__main__":
    main()
