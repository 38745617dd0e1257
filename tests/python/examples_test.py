"""The examples of app/python/examples: examples_test.py FOLDER_OF_THE_MODULE SOURCE_DIR"""

import importlib.util
import math
import sys
import unittest
from pathlib import Path

SOURCE = Path(sys.argv[2])
MODEL = str(SOURCE / "models/bouncing_ball.xml")
sys.dont_write_bytecode = True
sys.path[:0] = [sys.argv[1], str(SOURCE / "app/python/examples")]
if importlib.util.find_spec("numpy") is None:
    print("SKIPPED: no numpy")
    sys.exit(77)


def without(package):
    return importlib.util.find_spec(package) is None


def ball(h0, e, t, g=9.81):
    """Height after the first impact, and its derivatives by h0 and e: a ball that falls h0."""
    fall = math.sqrt(2 * h0 / g)
    v, s = e * g * fall, t - fall
    by_fall = e * g * s - v + g * s
    return v * s - g * s * s / 2, by_fall * fall / (2 * h0), g * fall * s


class Examples(unittest.TestCase):
    # Derivatives are stated to 1e-9 by `dynamy gradient`; see theory 53.
    def values(self):
        import dynamy

        found = dynamy.gradient(MODEL, of=["ball.z@0.6"], by=["h0", "e"], h0=1.0, e=0.5)
        return found["value"][0], found["d"][0]

    @unittest.skipIf(without("torch"), "no torch")
    def test_a_run_is_a_function_of_torch(self):
        import torch
        import torch_run

        h0 = torch.tensor(1.0, dtype=torch.float64, requires_grad=True)
        e = torch.tensor(0.5, dtype=torch.float64, requires_grad=True)
        out = torch_run.run(MODEL, ["ball.z@0.6"], h0=h0, e=e)
        (out**2).sum().backward()
        z, d = self.values()
        self.assertEqual(out.item(), z)
        self.assertAlmostEqual(h0.grad.item(), 2 * z * d[0], delta=1e-14)
        self.assertAlmostEqual(e.grad.item(), 2 * z * d[1], delta=1e-14)
        self.assertAlmostEqual(d[1], ball(1.0, 0.5, 0.6)[2], delta=1e-8)

    @unittest.skipIf(without("jax"), "no jax")
    def test_a_run_is_a_function_of_jax(self):
        import jax
        import jax_run

        jax.config.update("jax_enable_x64", True)
        f = jax_run.run(MODEL, ["ball.z@0.6"], ["h0", "e"])
        got = jax.grad(lambda p: (f(p) ** 2).sum())(jax.numpy.array([1.0, 0.5]))
        z, d = self.values()
        for i in range(2):
            self.assertAlmostEqual(float(got[i]), 2 * z * d[i], delta=1e-13)

    @unittest.skipIf(without("scipy"), "no scipy")
    def test_scipy_finds_the_height(self):
        import dynamy
        import scipy_throw

        h0 = scipy_throw.height(MODEL, 0.3)
        z = dynamy.gradient(MODEL, of=["ball.z@0.6"], by=["h0"], h0=h0)["value"][0]
        self.assertAlmostEqual(z, 0.3, delta=1e-9)  # the tolerance of the runs


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
