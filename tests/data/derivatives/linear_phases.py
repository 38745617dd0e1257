"""Motions with unilateral contacts and friction whose phases are linear, from event to event, with mpmath.

    M u' = -K q + F + Σ W_N λ_N + W_T λ_T,   gaps W_N^T q + gap,   q' = u

While every contact is "open", sticks ("stick") or slips ("plus", "minus": the sign of its speed), forces are
linear in (q, u): x = (q, u, 1) obeys x' = A x, so that x(t) = exp(A t) x. An event is a root of a guard on this
curve. After it, the contacts that stay closed are decided by trying all of their states: exactly one has to
satisfy the laws. Impacts: Newton's law with e_N, Coulomb's law for impulses. Nothing here uses dynamY.
"""
from itertools import product
from mpmath import expm, findroot, lu_solve, matrix, mpf

TINY = mpf(10) ** -20  # speeds, accelerations and forces below count as zero
LOOK = mpf(1) / 4000   # guards are looked at in such steps [s]
SIGN = {"plus": 1, "minus": -1}


class LinearPhases:
    """n coordinates, m contacts. M, K: n × n; F: n; W_N, W_T: n × m; gap, e_N: m numbers; mu: one."""

    def __init__(self, M, K, F, W_N, gap, W_T, e_N, mu):
        self.K, self.F, self.gap, self.e_N, self.mu = K, F, gap, e_N, mu
        self.n, self.m, self.inverse = M.rows, len(gap), M ** -1
        self.W_N = [W_N[:, i] for i in range(self.m)]
        self.W_T = [W_T[:, i] for i in range(self.m)]

    def g(self, i, x):
        return (self.W_N[i].T * x[:self.n, 0])[0] + self.gap[i]

    def gamma_N(self, i, x):
        return (self.W_N[i].T * x[self.n:2 * self.n, 0])[0]

    def gamma_T(self, i, x):
        return (self.W_T[i].T * x[self.n:2 * self.n, 0])[0]

    def rows(self, mode):
        """(contact, direction of force, direction that is held) of all forces; two where it sticks."""
        out = []
        for i, state in enumerate(mode):
            if state == "open":
                continue
            out.append((i, self.W_N[i] - SIGN.get(state, 0) * self.mu * self.W_T[i], self.W_N[i]))
            if state == "stick":
                out.append((i, self.W_T[i], self.W_T[i]))
        return out

    def forces(self, rows, right):
        """Forces with held^T M⁻¹ Σ direction force = right; a column of `right` at a time."""
        G = matrix(len(rows), len(rows))
        for i, (_, _, held) in enumerate(rows):
            for j, (_, direction, _) in enumerate(rows):
                G[i, j] = (held.T * self.inverse * direction)[0]
        out = matrix(len(rows), right.cols)
        for j in range(right.cols):
            column = lu_solve(G, right[:, j])
            for i in range(len(rows)):
                out[i, j] = column[i]
        return out

    def phase(self, mode):
        """u', and λ_N and λ_T of each contact, as rows over (q, u, 1)."""
        size = 2 * self.n + 1
        u_dot, still = matrix(self.n, size), self.inverse * self.K
        for i in range(self.n):
            for j in range(self.n):
                u_dot[i, j] = -still[i, j]
            u_dot[i, size - 1] = (self.inverse * self.F)[i]
        l_N, l_T = ([matrix(1, size) for _ in range(self.m)] for _ in range(2))
        rows = self.rows(mode)
        if not rows:
            return u_dot, l_N, l_T
        right = matrix(len(rows), size)
        for k, (_, _, held) in enumerate(rows):
            right[k, :] = -(held.T * u_dot)
        forces = self.forces(rows, right)
        seen = set()
        for k, (i, direction, _) in enumerate(rows):
            u_dot += self.inverse * direction * forces[k, :]
            if i in seen:
                l_T[i] = forces[k, :]
            else:
                l_N[i], l_T[i] = forces[k, :], -SIGN.get(mode[i], 0) * self.mu * forces[k, :]
            seen.add(i)
        return u_dot, l_N, l_T

    def flow(self, u_dot):
        """A of x' = A x."""
        A = matrix(2 * self.n + 1, 2 * self.n + 1)
        for i in range(self.n):
            A[i, self.n + i] = 1
            A[self.n + i, :] = u_dot[i, :]
        return A

    def modes(self, x, closed, any_slip):
        """All states of the closed contacts; a contact that slips already keeps its direction."""
        options = []
        for i in range(self.m):
            slip = self.gamma_T(i, x)
            if i not in closed:
                options.append(["open"])
            elif any_slip or abs(slip) <= TINY:
                options.append(["open", "stick", "plus", "minus"])
            else:
                options.append(["open", "plus" if slip > 0 else "minus"])
        return product(*options)

    def allowed(self, i, state, x, u_dot, l_N, l_T):
        """Does contact i satisfy the laws of accelerations in this state?"""
        if state == "open":
            return (self.W_N[i].T * u_dot * x)[0] > TINY
        normal = (l_N[i] * x)[0]
        if normal <= TINY:
            return False
        if state == "stick":
            return abs((l_T[i] * x)[0]) < self.mu * normal
        begins = abs(self.gamma_T(i, x)) <= TINY
        return not begins or SIGN[state] * (self.W_T[i].T * u_dot * x)[0] > TINY

    def decide(self, x, closed):
        """The state of each contact after an event at x."""
        found = []
        for mode in self.modes(x, closed, any_slip=False):
            try:
                phase = self.phase(mode)
            except ZeroDivisionError:  # forces that hold the same twice
                continue
            if all(self.allowed(i, mode[i], x, *phase) for i in closed):
                found.append(mode)
        assert len(found) == 1, (found, closed)
        return found[0]

    def impact(self, x, closed):
        """x after an impact of the contacts that are closed."""
        found = []
        for mode in self.modes(x, closed, any_slip=True):
            rows = self.rows(mode)
            right, seen = matrix(max(len(rows), 1), 1), set()
            for k, (i, _, _) in enumerate(rows):
                right[k] = -self.gamma_T(i, x) if i in seen else -(1 + self.e_N[i]) * self.gamma_N(i, x)
                seen.add(i)
            try:
                impulses = self.forces(rows, right) if rows else []
            except ZeroDivisionError:
                continue
            after = x.copy()
            for k, (_, direction, _) in enumerate(rows):
                jump = self.inverse * direction * impulses[k]
                for j in range(self.n):
                    after[self.n + j] += jump[j]
            if self.lawful(mode, closed, rows, impulses, x, after):
                found.append(after)
        assert len(found) == 1, len(found)
        return found[0]

    def lawful(self, mode, closed, rows, impulses, x, after):
        of = {i: [impulses[k] for k, row in enumerate(rows) if row[0] == i] for i in closed}
        for i in closed:
            if mode[i] == "open":
                good = self.gamma_N(i, after) + self.e_N[i] * self.gamma_N(i, x) > -TINY
            elif mode[i] == "stick":
                good = of[i][0] > TINY and abs(of[i][1]) < self.mu * of[i][0]
            else:
                good = of[i][0] > TINY and SIGN[mode[i]] * self.gamma_T(i, after) > TINY
            if not good:
                return False
        return True

    def guards(self, mode, l_N, l_T):
        """(contact, event, function of x that falls through zero there)."""
        out = []
        for i, state in enumerate(mode):
            if state == "open":
                out.append((i, "hit", lambda x, i=i: self.g(i, x)))
                continue
            out.append((i, "release", lambda x, i=i: (l_N[i] * x)[0]))
            if state == "stick":
                out += [(i, "minus", lambda x, i=i: ((self.mu * l_N[i] - l_T[i]) * x)[0]),
                        (i, "plus", lambda x, i=i: ((self.mu * l_N[i] + l_T[i]) * x)[0])]
            else:
                out.append((i, "still", lambda x, i=i, s=SIGN[state]: s * self.gamma_T(i, x)))
        return out

    def after(self, x, mode, contact, event):
        """x and the states of the contacts right after an event."""
        closed = [i for i in range(self.m) if mode[i] != "open"]
        if event == "hit":
            x = self.impact(x, closed + [contact])
            return x, self.decide(x, [i for i in closed + [contact] if abs(self.gamma_N(i, x)) < TINY])
        if event == "still":
            return x, self.decide(x, closed)
        state = "open" if event == "release" else event
        return x, tuple(state if i == contact else old for i, old in enumerate(mode))

    def fly(self, t, x, mode, end):
        """To the first event, at most to `end`: time, x, and (contact, event) or None."""
        u_dot, l_N, l_T = self.phase(mode)
        A, guards = self.flow(u_dot), self.guards(mode, l_N, l_T)
        E = expm(A * LOOK)
        # A guard that begins at zero is armed once it has risen.
        armed = {(i, event) for i, event, f in guards if f(x) > TINY}
        while t < end:
            d = min(LOOK, end - t)
            y = (E if d == LOOK else expm(A * d)) * x
            first, found = d, None
            for i, event, f in guards:
                if (i, event) not in armed:
                    if f(y) > TINY:
                        armed.add((i, event))
                elif f(y) < 0:
                    s = findroot(lambda s, f=f: f(expm(A * s) * x), (d * f(x) / (f(x) - f(y)), d / 2),
                                 tol=mpf(10) ** -60, verify=False)
                    if 0 <= s < first:
                        first, found = s, (i, event)
            if found:
                return t + first, expm(A * first) * x, found
            t, x = (end if d < LOOK else t + d), y
        return t, x, None

    def run(self, q, u, ends):
        """States x at the times `ends`, and all events (t, contact, event), from t = 0."""
        x = matrix(list(q) + list(u) + [1])
        mode = self.decide(x, [i for i in range(self.m)
                               if abs(self.g(i, x)) < TINY and abs(self.gamma_N(i, x)) < TINY])
        t, states, events = mpf(0), [], []
        for end in ends:
            while t < end:
                t, x, found = self.fly(t, x, mode, end)
                if found:
                    events.append((t, *found))
                    x, mode = self.after(x, mode, *found)
            states.append(x.copy())
        return states, events
