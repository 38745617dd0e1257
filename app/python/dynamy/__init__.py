"""dynamY: simulation of multibody systems with impacts and friction.

    import dynamy
    run = dynamy.load("models/woodpecker.xml", mu=0.3).run()
    run.t, run["toy.y"]          # recorded signals, numpy arrays
    run.events, run.ledger       # impacts and switches; energies and works
    run.frame()                  # a DataFrame of pandas
    run.plot("toy.y")            # curves with matplotlib
    run                          # the replay, in a notebook
    print(dynamy.describe("RigidBody"))

    runs = dynamy.sweep("models/woodpecker.xml", {"mu": [0.2, 0.3, 0.4]}, processes=2)

doc/python.md has the rest.
"""

try:
    from . import _core
except ModuleNotFoundError as error:
    if error.name != "dynamy._core":
        raise
    raise ImportError(
        f"{__path__[0]} holds no compiled module for this Python: configure with -DDYNAMY_PYTHON=ON, "
        "build, and name the folder lib/python3/dist-packages of the build in PYTHONPATH; the reader "
        "of run folders, dynamy_run, needs no build", name="dynamy._core") from error

from dynamy_run import STATES, Frames, RunError

from ._core import *  # noqa: F403
from ._core import __version__
from .runs import Run, run
from .sweeps import sweep

# Every name of the compiled module is a name of the package: `_core.pyi` declares its type.
__all__ = [name for name in dir(_core) if not name.startswith("_")]
__all__ += ["STATES", "Frames", "Run", "RunError", "__version__", "run", "sweep"]
