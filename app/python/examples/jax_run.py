"""A run as a function of JAX: jax_run.run(model, of, by)(values) -> array of signals.

    jax.config.update("jax_enable_x64", True)
    f = run("models/bouncing_ball.xml", ["ball.z@0.6"], ["h0", "e"])
    jax.grad(lambda p: f(p).sum())(jax.numpy.array([1.0, 0.5]))
"""

import dynamy
import jax
import numpy as np


def run(model, of, by):
    """A function of the parameters `by`, an array, that gives the signals `of` ("ball.z@0.6")."""
    shapes = (
        jax.ShapeDtypeStruct((len(of),), np.float64),
        jax.ShapeDtypeStruct((len(of), len(by)), np.float64),
    )

    def computed(values):
        found = dynamy.gradient(str(model), of=list(of), by=list(by), **dict(zip(by, map(float, values))))
        if found["refused"]:
            raise ValueError(f"no derivative: {found['refused']}")
        return found["value"], found["d"]

    @jax.custom_vjp
    def f(values):
        return jax.pure_callback(computed, shapes, values)[0]

    def forward(values):
        return jax.pure_callback(computed, shapes, values)

    f.defvjp(forward, lambda d, upstream: (upstream @ d,))
    return f
