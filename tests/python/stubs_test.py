"""The types that dynamy declares against the module: stubs_test.py FOLDER_OF_THE_PACKAGE"""

import ast
import importlib.util
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy  # noqa: F401
except ImportError:
    print("SKIPPED: no numpy")
    sys.exit(77)

FOLDER = Path(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import dynamy  # noqa: E402
from dynamy import _core  # noqa: E402

USER = '''
import dynamy

run = dynamy.load("model.xml", mu=0.3).run()
signals, figures = run
print(run["toy.y"].max(), run.t[-1], figures["state"], run.events[0]["t"])
model = dynamy.Model()
model.add(dynamy.element("Sphere", "s", radius=0.1))
model.step = 1e-3
simulation = dynamy.Simulation(model)
simulation.state.u[0] = 1.0
heights = dynamy.sweep("model.xml", {"mu": [0.1, 0.2]}, values=lambda r: r["toy.y"].max())
'''


def stub_names():
    """class -> its public names, and "" -> those of the module, as the stub declares them."""
    def names(body):
        out = set()
        for node in body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                out.add(node.name)
            elif isinstance(node, ast.AnnAssign):
                out.add(node.target.id)
        return {name for name in out if not name.startswith("_")}

    tree = ast.parse((FOLDER / "dynamy" / "_core.pyi").read_text(encoding="utf-8"))
    out = {node.name: names(node.body) for node in tree.body if isinstance(node, ast.ClassDef)}
    return {**out, "": names(tree.body)}


def module_names():
    def names(thing):
        return {name for name in vars(thing) if not name.startswith("_")}

    classes = {name: thing for name, thing in vars(_core).items() if isinstance(thing, type)}
    out = {name: names(thing) for name, thing in classes.items()}
    return {**out, "": names(_core)}


class Stubs(unittest.TestCase):
    def test_the_stub_declares_the_names_of_the_module(self):
        self.assertEqual(stub_names(), module_names())

    def test_every_name_of_the_module_is_one_of_the_package(self):
        for name in module_names()[""]:
            self.assertIn(name, dynamy.__all__)
            self.assertTrue(hasattr(dynamy, name))

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "no mypy")
    def test_a_type_checker_accepts_package_and_users(self):
        with tempfile.TemporaryDirectory() as folder:
            user = Path(folder, "user.py")
            user.write_text(USER, encoding="utf-8")
            # Without the stubs of numpy, which take a minute to read.
            done = subprocess.run(
                [sys.executable, "-m", "mypy", "--cache-dir", folder + "/cache",
                 "--ignore-missing-imports", "--no-site-packages", "-p", "dynamy", "-m", "user"],
                env={"MYPYPATH": f"{FOLDER}:{folder}", "PATH": "/usr/bin:/bin"}, cwd=folder,
                capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
