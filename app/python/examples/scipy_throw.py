"""From which height does the ball rebound to 0.3 m at 0.6 s? By scipy.optimize with exact derivatives.

    python3 scipy_throw.py models/bouncing_ball.xml
"""

import sys

import dynamy
from scipy.optimize import least_squares


def height(model, wanted, at=0.6, start=1.0):
    """h0 for which ball.z at the instant `at` [s] is `wanted` [m]."""
    of = [f"ball.z@{at}"]

    def miss(p):
        return dynamy.gradient(model, of=of, by=["h0"], h0=float(p[0]))["value"] - wanted

    def slope(p):
        return dynamy.gradient(model, of=of, by=["h0"], h0=float(p[0]))["d"]

    return least_squares(miss, [start], jac=slope, xtol=1e-14, ftol=1e-14, gtol=1e-14).x[0]


if __name__ == "__main__":
    print(height(sys.argv[1], 0.3))
