"""Motions with unilateral contacts and friction whose phases are linear, with mpmath and without dynamY."""
from itertools import product
from mpmath import expm, findroot, lu_solve, matrix, mpf

TINY = mpf(10) ** -20


def linear_motion(M, K, F, WN, gap, WT, eN, mu, q, u, ends):
    """M ü = -K q + F + W_N λ_N + W_T λ_T with gaps W_N^T q + gap and Coulomb friction, from event to
    event: each phase is linear, x(t) = exp(A t) x in x = (q, u, 1). Impacts keep Newton's law and
    Coulomb's law of impulses. States at the times `ends`, and events (t, contact, kind)."""
    n, m = M.rows, len(gap)
    inverse = M ** -1
    col = lambda W, i: W[:, i]

    def solve(rows, right):
        """Forces of rows (pairs of a force direction and a constraint direction) that satisfy them."""
        G = matrix(len(rows), len(rows))
        for i, (_, c) in enumerate(rows):
            for j, (f, _) in enumerate(rows):
                G[i, j] = (c.T * inverse * f)[0]
        return lu_solve(G, right) if rows else matrix(0, 1)

    def phase(mode):
        """Matrix A of (q, u, 1) and rows of λ_N, λ_T over (q, u, 1)."""
        rows, owner = [], []
        for i, state in enumerate(mode):
            if state == "open":
                continue
            slip = {"plus": -1, "minus": 1, "stick": 0}[state]
            rows.append((col(WN, i) + slip * mu * col(WT, i), col(WN, i)))
            owner.append((i, slip))
            if state == "stick":
                rows.append((col(WT, i), col(WT, i)))
                owner.append((i, None))
        free = matrix(n, 2 * n + 1)
        minusMK, MF = -(inverse * K), inverse * F
        for i in range(n):
            for j in range(n):
                free[i, j] = minusMK[i, j]
            free[i, 2 * n] = MF[i]
        lN, lT = [matrix(1, 2 * n + 1) for _ in range(m)], [matrix(1, 2 * n + 1) for _ in range(m)]
        acc = free.copy()
        if rows:
            right = matrix(len(rows), 2 * n + 1)
            for k, (_, c) in enumerate(rows):
                r = -(c.T * free)
                for j in range(2 * n + 1):
                    right[k, j] = r[j]
            forces = matrix(len(rows), 2 * n + 1)
            for j in range(2 * n + 1):
                f = solve(rows, right[:, j])
                for k in range(len(rows)):
                    forces[k, j] = f[k]
            for k, (f, _) in enumerate(rows):
                acc += inverse * f * forces[k, :]
                i, slip = owner[k]
                if slip is None:
                    lT[i] = forces[k, :]
                else:
                    lN[i] = forces[k, :]
                    if slip:
                        lT[i] = slip * mu * forces[k, :]
        A = matrix(2 * n + 1, 2 * n + 1)
        for i in range(n):
            A[i, n + i] = 1
            for j in range(2 * n + 1):
                A[n + i, j] = acc[i, j]
        return A, acc, lN, lT

    split = lambda x: (x[:n, 0], x[n:2 * n, 0])
    dot = lambda r, x: (r * x)[0]
    g = lambda i, x: (col(WN, i).T * x[:n, 0])[0] + gap[i]
    slipping = lambda i, x: (col(WT, i).T * x[n:2 * n, 0])[0]
    closing = lambda i, x: (col(WN, i).T * x[n:2 * n, 0])[0]

    def decide(x, closed):
        """Modes that the accelerations permit, for contacts that are closed."""
        found = []
        options = []
        for i in range(m):
            if i not in closed:
                options.append(["open"])
            elif abs(slipping(i, x)) > TINY:
                options.append(["open", "plus" if slipping(i, x) > 0 else "minus"])
            else:
                options.append(["open", "stick", "plus", "minus"])
        for mode in product(*options):
            try:
                A, acc, lN, lT = phase(mode)
            except ZeroDivisionError:
                continue
            good = True
            for i in closed:
                aN, aT = (col(WN, i).T * acc * x)[0], (col(WT, i).T * acc * x)[0]
                if mode[i] == "open":
                    good = good and aN > TINY
                    continue
                good = good and dot(lN[i], x) > TINY
                if mode[i] == "stick":
                    good = good and abs(dot(lT[i], x)) < mu * dot(lN[i], x)
                elif abs(slipping(i, x)) <= TINY:
                    good = good and aT * (1 if mode[i] == "plus" else -1) > TINY
            if good:
                found.append(mode)
        assert len(found) == 1, (found, closed, [mp.nstr(v, 8) for v in x])
        return found[0]

    def impact(x, closed):
        found = []
        for mode in product(*(["open", "stick", "plus", "minus"] if i in closed else ["open"] for i in range(m))):
            rows, right, owner = [], [], []
            for i in closed:
                if mode[i] == "open":
                    continue
                slip = {"plus": -1, "minus": 1, "stick": 0}[mode[i]]
                rows.append((col(WN, i) + slip * mu * col(WT, i), col(WN, i)))
                right.append(-(1 + eN[i]) * closing(i, x))
                owner.append(i)
                if mode[i] == "stick":
                    rows.append((col(WT, i), col(WT, i)))
                    right.append(-slipping(i, x))
                    owner.append(i)
            try:
                L = solve(rows, matrix(right)) if rows else []
            except ZeroDivisionError:
                continue
            after = x.copy()
            for k, (f, _) in enumerate(rows):
                d = inverse * f * L[k]
                for j in range(n):
                    after[n + j] += d[j]
            good, k = True, 0
            for i in closed:
                vN, vT = closing(i, after), slipping(i, after)
                if mode[i] == "open":
                    good = good and vN + eN[i] * closing(i, x) > -TINY
                    continue
                N = L[k]
                good = good and N > TINY
                if mode[i] == "stick":
                    good = good and abs(L[k + 1]) < mu * N
                    k += 1
                else:
                    good = good and vT * (1 if mode[i] == "plus" else -1) > TINY
                k += 1
            if good:
                found.append(after)
        assert len(found) == 1, len(found)
        return found[0]

    def guards(mode, lN, lT):
        out = []
        for i, state in enumerate(mode):
            if state == "open":
                out.append((i, "hit", lambda x, i=i: g(i, x)))
                continue
            out.append((i, "release", lambda x, i=i: dot(lN[i], x)))
            if state == "stick":
                out.append((i, "minus", lambda x, i=i: mu * dot(lN[i], x) - dot(lT[i], x)))
                out.append((i, "plus", lambda x, i=i: mu * dot(lN[i], x) + dot(lT[i], x)))
            else:
                s = 1 if state == "plus" else -1
                out.append((i, "still", lambda x, i=i, s=s: s * slipping(i, x)))
        return out

    x = matrix(2 * n + 1, 1)
    for i in range(n):
        x[i], x[n + i] = q[i], u[i]
    x[2 * n] = 1
    closed = [i for i in range(m) if abs(g(i, x)) < TINY and abs(closing(i, x)) < TINY]
    mode, t, states, events = decide(x, closed), mpf(0), [], []
    h = mpf(1) / 4000
    for end in ends:
        while t < end:
            A, acc, lN, lT = phase(mode)
            all_, E = guards(mode, lN, lT), expm(A * h)
            event = None
            started = {(i, kind) for i, kind, f in all_ if f(x) <= TINY}
            while t < end and event is None:
                d = min(h, end - t)
                y = (E if d == h else expm(A * d)) * x
                first = d
                for i, kind, f in all_:
                    if (i, kind) in started:
                        if f(y) > TINY:
                            started.discard((i, kind))
                        else:
                            assert kind == "hit" or f(y) > -TINY, (i, kind, mode)
                        continue
                    if f(y) < 0:
                        s = findroot(lambda s: f(expm(A * s) * x), (d * f(x) / (f(x) - f(y)), d / 2),
                                     tol=mpf(10) ** -60, verify=False)
                        if 0 <= s < first:
                            first, event = s, (i, kind)
                x = y if event is None else expm(A * first) * x
                t = t + first if event or d != h else t + d
                if event is None and d < h:
                    t = end
            if event is None:
                continue
            i, kind = event
            closed = [k for k in range(m) if mode[k] != "open"]
            events.append((t, i, kind))
            if kind == "hit":
                x = impact(x, closed + [i])
                closed = [k for k in closed + [i] if abs(closing(k, x)) < TINY]
                mode = decide(x, closed)
            elif kind == "release":
                mode = tuple("open" if k == i else s for k, s in enumerate(mode))
            elif kind == "still":
                mode = decide(x, closed)
            else:
                mode = tuple(kind if k == i else s for k, s in enumerate(mode))
        states.append(x.copy())
    return states, events
