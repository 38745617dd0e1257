"""The module of Python: module_test.py FOLDER_OF_THE_MODULE SOURCE_DIR"""

import html
import importlib.util
import math
import pickle
import re
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

try:
    import numpy as np
except ImportError:
    print("SKIPPED: no numpy")
    sys.exit(77)

SOURCE = Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import dynamy  # noqa: E402
import dynamy_run  # noqa: E402

SLIDE = """<dynamy version="1">
  <parameter name="mu" value="0.3"/>
  <systems>
    <RigidBody name="block" position="0 0 0.1" velocity="2 0 0">
      <Sphere radius="0.1" mass="1" material="wood"/>
    </RigidBody>
    <Ground><HalfSpace material="floor"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -10"/></forces>
  <elements><Contact between="wood floor">LAW</Contact></elements>
  <simulation until="0.2" step="1e-3"/>
  <record signals="block.x block.vx" every="10ms"/>
</dynamy>"""


class Disc:
    """Coulomb's disc by its support function S_B(y) = mu |y|."""

    def __init__(self, mu):
        self.mu = mu

    def support(self, y):
        n = np.linalg.norm(y)
        if n == 0.0:
            return 0.0, np.zeros_like(y), np.zeros((y.size, y.size))
        e = y / n
        return self.mu * n, self.mu * e, self.mu / n * (np.eye(y.size) - np.outer(e, e))


class ProxDisc:
    """The same law by its projection (rows of one r)."""

    def __init__(self, mu):
        self.mu = mu

    def prox(self, z, r, dt):
        N = max(0.0, z[0])
        T = np.linalg.norm(z[1:])
        return [N, *(z[1:] * min(1.0, self.mu * N / T) if T > 0.0 else z[1:])]


class Module(unittest.TestCase):
    def test_a_file_runs_as_in_the_program(self):
        model = dynamy.load(str(SOURCE / "models" / "bouncing_ball.xml"), e=0.5)
        signals, figures = dynamy.run(model)
        self.assertEqual(figures["state"], "finished")
        self.assertTrue(figures["checks_passed"])
        self.assertFalse(figures["qualified"])
        self.assertEqual(figures["warnings"], [])
        flight = signals["t"] < 0.45
        z = 1.1 - 0.5 * 9.81 * signals["t"][flight] ** 2
        self.assertLess(np.abs(signals["ball.z"][flight] - z).max(), 1e-11)  # 4500 roundings

    def test_a_model_is_built_element_by_element(self):
        model = dynamy.Model()
        ball = dynamy.element("Sphere", radius=0.1, mass=1, material="rubber")
        model.add(dynamy.element("RigidBody", "ball", [ball], position=(0, 0, 1.1)))
        model.add(dynamy.element("Ground", "world", [dynamy.element("HalfSpace", material="floor")]))
        model.add(dynamy.element("Gravity", acceleration=(0, 0, -10)))
        law = dynamy.element("Unilateral", epsilonN=0.5)
        model.add(dynamy.element("Contact", children=[law], between="rubber floor"))
        model.until, model.step = 0.8, 1e-4
        model.record = ["ball.z"]
        model.build()
        signals, figures = dynamy.run(model)
        # Impact at √0.2 s with √20 m/s; peak 0.1 + 0.25 · 1 m at 0.2^½ (1 + 0.5) = 0.67 s. The impact
        # is seen up to a step late: 4.5 m/s · 1.5 · 1e-4 s = 0.7 mm.
        self.assertLess(abs(signals["ball.z"][signals["t"] > 0.5].max() - 0.35), 0.7e-3)
        self.assertEqual(figures["impacts"], 1)
        with self.assertRaisesRegex(dynamy.ModelError, "part of a model already"):
            model.add(ball)

    def test_a_run_takes_its_settings_and_a_text_names_signals(self):
        model = dynamy.load(str(SOURCE / "models" / "woodpecker.xml"))
        model.record = "toy.y toy.phiM"
        self.assertEqual(model.record, ["toy.y", "toy.phiM"])
        self.assertRegex(repr(model), r"^<dynamy\.Model.*: \d+ systems, \d+ forces")
        run = model.run(until=0.1, tolerance=1e-6)
        self.assertEqual((model.until, model.tolerance), (0.1, 1e-6))
        self.assertLess(abs(run.t[-1] - 0.1), 1e-12)

    def test_a_tolerance_takes_the_place_of_a_step(self):
        model = dynamy.load(str(SOURCE / "models" / "woodpecker.xml"))
        self.assertEqual((model.scheme, model.tolerance), ("LocatedDormandPrince", 1e-6))
        model.until = 0.033
        simulation = dynamy.Simulation(model)
        steps = 0
        while simulation.state.t < model.until:
            self.assertTrue(simulation.step()["solved"])
            steps += 1
        self.assertLess(steps, 20)
        with self.assertRaisesRegex(dynamy.ModelError, "the run ended at t = "):
            simulation.step()
        # The sleeve sticks where a closed form says; ten tolerances of some 0.1 m.
        self.assertAlmostEqual(simulation.state.q[0], -4.403947088e-3, delta=1e-6)
        model.step = 1e-5
        _, figures = dynamy.run(model)
        self.assertEqual((model.scheme, figures["steps"]), ("EnergyMomentum", 3300))
        model.tolerance = 1e-8
        signals, _ = dynamy.run(model)
        self.assertAlmostEqual(signals["toy.y"][-1], -4.403947088e-3, delta=1e-9)

    def test_steps_are_those_of_a_run(self):
        model = dynamy.load(str(SOURCE / "models" / "woodpecker_expressions.xml"))
        last = []
        dynamy.run(model, each=lambda x: last.append((x.t, x.q.copy())) or len(last) < 300)
        simulation = dynamy.Simulation(model)
        for t, q in last:
            self.assertTrue(simulation.step()["solved"])
            self.assertAlmostEqual(simulation.state.t, t, delta=1e-12)
            # The run counts t = i Δt, steps add it up: rounding of t, 1e-17 s, times speeds of 10/s.
            self.assertLess(np.abs(simulation.state.q - q).max(), 1e-14)
        self.assertEqual(len(last), 300)

    def test_a_state_is_written_between_steps(self):
        model = dynamy.model(SLIDE.replace("LAW", '<UnilateralCoulomb mu="{mu}"/>'), mu=0)
        simulation = dynamy.Simulation(model)
        simulation.state.u[0] = 5.0
        before = simulation.energy
        simulation.step(1e-3)
        self.assertAlmostEqual(simulation.state.u[0], 5.0, delta=1e-14)
        self.assertAlmostEqual(simulation.energy, before, delta=1e-12)
        (contact,) = simulation.contacts
        self.assertAlmostEqual(contact["Lambda"][0], 1e-3 * 10.0, delta=1e-12)  # m g Δt
        with self.assertRaises(ValueError):
            simulation.state.q = [1.0]

    CART = """<dynamy version="1">
      <systems><PointMass name="cart" position="0.3 0 0" velocity="1 0 0" mass="2"/></systems>
      <forces>FORCES<ForceInput on="cart" force="IN.out; 0; 0"/></forces>
      <simulation until="3" SIMULATION</simulation></dynamy>"""
    SIMULATIONS = ('tolerance="1e-6">', 'tolerance="1e-3">', 'step="3ms">', 'step="20ms">',
                   'step="3ms"><MoreauMidpoint/>', 'step="1ms"><GeneralizedAlpha/>')

    def test_a_controller_in_python_is_one_of_blocks(self):
        pid = """<Pid name="pid" error="1 - cart.x" kp="40" ki="20" kd="15" period="10ms" lower="-20"
                 upper="20"/>"""
        for how in self.SIMULATIONS:
            text = self.CART.replace("SIMULATION", how)
            blocks = dynamy.Simulation(
                dynamy.model(text.replace("FORCES", pid).replace("IN", "pid")))
            blocks.advance(3.0)
            simulation = dynamy.Simulation(
                dynamy.model(text.replace("FORCES", '<Input name="in"/>').replace("IN", "in")))
            T, integral, before = 0.01, 0.0, 1 - 0.3
            for _ in range(300):
                e = 1 - simulation["cart.x"]
                rest, step = 40 * e + 15 * (e - before) / T, 20 * T * e
                if not (rest + integral + step > 20 and step > 0) and not (
                        rest + integral + step < -20 and step < 0):
                    integral += step
                simulation["in"] = max(-20.0, min(20.0, rest + integral))
                before = e
                simulation.advance(T)
            # Both are exact under held forces; 300 times the rounding of t, times gains of 15/T.
            self.assertAlmostEqual(simulation["cart.x"], blocks["cart.x"], delta=1e-9)
            self.assertAlmostEqual(simulation["cart.vx"], blocks["cart.vx"], delta=1e-9)
            self.assertEqual(simulation["in"], simulation["in.out"])

    def test_velocities_are_set_by_name_whatever_the_coordinates(self):
        text = """<dynamy version="1"><systems><Ground name="world"/>
          <PlanarBody name="rod" mass="1" inertia="0.1" position="0.5 0 0"/></systems>
          <elements><Revolute between="world rod"/></elements>
          <simulation until="1" COORDINATES/></dynamy>""".replace('between="world rod"', 'between="world rod" at="0 0 0"')
        for how in ('tolerance="1e-8"', 'tolerance="1e-8" coordinates="absolute"'):
            simulation = dynamy.Simulation(dynamy.model(text.replace("COORDINATES", how)))
            simulation["rod.omega"] = 2.0
            simulation.advance(0.25)
            # Nothing turns it: the hinge holds, and 2 rad/s last. In coordinates of the body the
            # joint takes its part first: J ω = 0.1 · 2 = (0.1 + 0.25) ω.
            omega = 2.0 if "absolute" not in how else 0.2 / 0.35
            self.assertAlmostEqual(simulation["rod.omega"], omega, delta=1e-9)
            self.assertAlmostEqual(simulation["rod.phi"] % (2 * math.pi), 0.25 * omega, delta=1e-8)
        simulation = dynamy.Simulation(dynamy.model(text.replace("COORDINATES", 'tolerance="1e-8"')))
        simulation["rod.vz"] = 1.0  # of its centre, 0.5 m from the hinge
        self.assertAlmostEqual(simulation["rod.omega"], 2.0, delta=1e-12)
        simulation["rod.joint.angle"] = 0.5
        self.assertAlmostEqual(simulation["rod.phi"], 0.5, delta=1e-12)
        for name, message in (("rod.x", "carried by joints"), ("rod.vx", "do not let"),
                              ("rod.vy", "no coordinate or velocity")):
            with self.assertRaisesRegex(dynamy.ModelError, message):
                dynamy.Simulation(dynamy.model(text.replace("COORDINATES", 'tolerance="1e-8"')))[name] = 1.0

    def test_a_run_reads_signals_and_sets_inputs(self):
        model = dynamy.model(self.CART.replace("SIMULATION", 'step="10ms"><MoreauMidpoint/>')
                             .replace("FORCES", '<Input name="in" value="2"/>').replace("IN", "in"))

        def each(now):
            if now.t > 0.495:
                now["in"] = -2.0
            return now["cart.vx"] > 0

        signals, figures = dynamy.run(model, each=each)
        # 1 m/s + 0.5 s · 1 m/s², then −1 m/s² until 0: 1.5 s later, up to a step and rounding.
        self.assertAlmostEqual(figures["t"], 2.0, delta=0.011)
        with self.assertRaisesRegex(dynamy.ModelError, "no input named"):
            dynamy.run(model, each=lambda now: now.__setitem__("motor", 1.0))

    def test_a_function_is_called_by_its_own_clock(self):
        for how in ('tolerance="1e-6">', 'step="30ms"><MoreauMidpoint/>'):
            model = dynamy.model(self.CART.replace("SIMULATION", how).replace("FORCES", '<Input name="in"/>')
                                 .replace("IN", "in"))
            model.until, seen = 1.0, []

            def each(now):
                seen.append((now.t, now["cart.vx"]))
                now["in"] = 2.0
            run = model.run(each=each, every=0.25)
            self.assertEqual([t for t, _ in seen], [0.0, 0.25, 0.5, 0.75, 1.0])
            # The input of t = 0 acts from the start: 1 m/s + 2 N/2 kg t, exact but for rounding.
            for t, v in seen:
                self.assertAlmostEqual(v, 1.0 + t, delta=1e-12)
            self.assertEqual(len(run.facts["hash"]), 16)
            self.assertIn("nonPotential", run.facts["energy"])

    def test_messages_of_steps_and_clocks(self):
        model = dynamy.model(self.CART.replace("SIMULATION", 'step="10ms"><MoreauMidpoint/>')
                             .replace("FORCES", '<Input name="in"/>').replace("IN", "in"))
        with self.assertRaisesRegex(ValueError, 'the input "in" gets a number, not nan'):
            dynamy.Simulation(model)["in"] = math.nan
        with self.assertRaisesRegex(ValueError, 'the input "in" gets a number, not inf'):
            model.run(each=lambda now: now.__setitem__("in", math.inf))
        with self.assertRaisesRegex(TypeError, "such as dynamy.load"):
            dynamy.Simulation("ball.xml")
        with self.assertRaisesRegex(ValueError, "every is a time"):
            model.run(each=print, every=-1)
        with self.assertRaisesRegex(TypeError, "every is the time between"):
            model.run(every=1)
        with self.assertRaisesRegex(dynamy.ModelError, "model.until = "):
            dynamy.load(SOURCE / "models" / "bouncing_ball.xml", until=2)
        simulation = dynamy.Simulation(model)
        simulation.advance(0.25)
        self.assertEqual(simulation.t, 0.25)

    def test_a_written_velocity_counts_with_every_scheme(self):
        for how in self.SIMULATIONS:
            simulation = dynamy.Simulation(dynamy.model(
                self.CART.replace("SIMULATION", how)
                .replace("FORCES", '<Input name="in"/>').replace("IN", "in")))
            simulation.advance(0.1)
            simulation.state.u[0] = 5.0
            simulation.advance(0.1)
            # Free flight with 1 m/s, then 5 m/s.
            self.assertAlmostEqual(simulation["cart.x"], 0.3 + 0.1 + 0.5, delta=1e-12)

    def test_laws_in_python_agree_with_coulombs(self):
        dynamy.register_law("PythonDisc", Disc, {"mu": None})
        dynamy.register_law("PythonProxDisc", ProxDisc, {"mu": 0.3})
        runs = [dynamy.run(dynamy.model(SLIDE.replace("LAW", law)))[0]
                for law in ('<UnilateralCoulomb mu="{mu}"/>', '<PythonDisc mu="{mu}"/>',
                            '<PythonProxDisc/>')]
        # v = 2 − μ g t while it slides (it rolls at 2/7 of 2/(μ g) = 0.19 s): the exact step.
        slides = runs[0]["t"] < 0.18
        for run in runs:
            v = 2.0 - 0.3 * 10.0 * run["t"][slides]
            # Rounding in 180 steps, 2e-16 each, and the solver's tolerance, 1e-10 of m g Δt/m a step.
            self.assertLess(np.abs(run["block.vx"][slides] - v).max(), 180 * 1e-12)
            self.assertLess(np.abs(run["block.x"] - runs[0]["block.x"]).max(), 180 * 1e-12 * 0.2)

    def test_a_run_goes_into_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            model = dynamy.model(SLIDE.replace("LAW", '<UnilateralCoulomb mu="{mu}"/>'))
            signals, figures = dynamy.run(model, out=folder + "/run")
            run = dynamy_run.Run(folder + "/run")
            self.assertEqual(run.facts["steps"], figures["steps"])
            self.assertEqual(run.units["block.x"], "m")
            self.assertEqual(len(run.t), 21)
            self.assertEqual(signals["block.x"].tolist(), run["block.x"].tolist())
            self.assertTrue((Path(folder) / "run" / "replay.html").is_file())

    def test_a_run_holds_what_its_folder_would(self):
        model = dynamy.load(SOURCE / "models" / "bouncing_ball.xml", e=0.5)
        run = model.run()
        with tempfile.TemporaryDirectory() as folder:
            own = f"{folder}/{model.title}"  # the page has the name of its folder
            model.run(out=own)
            written = dynamy_run.Run(own)
            run.save(folder + "/saved")
            for other in (written, dynamy_run.Run(folder + "/saved"), dynamy.Run(own)):
                for name in run.signals:  # texts read back to the same doubles
                    self.assertEqual(run[name].tolist(), other[name].tolist())
                self.assertEqual(run.events, other.events)
                self.assertEqual(run.ledger["normal"].tolist(), other.ledger["normal"].tolist())
                self.assertEqual(run.frames.pose.tolist(), other.frames.pose.tolist())
                self.assertFalse(other.qualified)
            wall = re.compile(r"(wall|cpu)_s[^,}]*")  # the figures of a run that are others each time
            self.assertEqual(wall.sub("", written.page()), wall.sub("", run.page()))
        self.assertEqual(run.figures["state"], run.facts["state"])
        self.assertIn("ball.z", run)
        self.assertNotIn("ball.zz", run)

    def test_a_run_is_kept_after_its_files_are_gone(self):
        run = dynamy.load(SOURCE / "models" / "bouncing_ball.xml").run()
        self.assertFalse(run.folder.exists())
        again = pickle.loads(pickle.dumps(run))
        self.assertEqual(run["ball.z"].tolist(), again["ball.z"].tolist())
        self.assertEqual(run.events, again.events)

    def test_a_notebook_shows_the_replay(self):
        run = dynamy.load(SOURCE / "models" / "bouncing_ball.xml").run()
        shown = run._repr_html_()
        page = html.unescape(shown[shown.index('srcdoc="') + 8:shown.index('" sandbox')])
        self.assertEqual(page, run.page())
        self.assertTrue(page.lstrip().lower().startswith("<!doctype html>"))

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "no pandas")
    def test_tables_are_frames_of_pandas(self):
        run = dynamy.load(SOURCE / "models" / "bouncing_ball.xml").run()
        table = run.frame()
        self.assertEqual(table.index.tolist(), run.t.tolist())
        self.assertEqual(table["ball.z"].tolist(), run["ball.z"].tolist())
        model = dynamy.load(SOURCE / "models" / "bouncing_ball.xml")
        model.tolerance = 1e-6
        run = model.run()
        self.assertFalse(run.frame().index.is_unique)  # rows before and after an impact
        after = run.frame(unique=True)
        self.assertTrue(after.index.is_unique)
        self.assertGreater(after["ball.vz"][run.events[0]["t"]], 0)
        self.assertEqual(table.attrs["units"]["ball.z"], "m")
        self.assertEqual(len(run.frame("events")), len(run.events))
        self.assertEqual(run.frame("ledger").index.name, "t")
        with self.assertRaisesRegex(ValueError, "no table"):
            run.frame("event")

    def test_a_package_that_is_missing_is_named(self):
        run = dynamy.load(SOURCE / "models" / "bouncing_ball.xml").run()
        with mock.patch.dict(sys.modules, {"pandas": None, "matplotlib.pyplot": None}):
            with self.assertRaisesRegex(ImportError, "tables need the package pandas"):
                run.frame()
            with self.assertRaisesRegex(ImportError, "plots need the package matplotlib"):
                run.plot()

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "no matplotlib")
    def test_signals_are_drawn(self):
        import matplotlib
        matplotlib.use("svg")
        run = dynamy.load(SOURCE / "models" / "bouncing_ball.xml").run()
        (curve,) = run.plot("ball.z").lines
        self.assertEqual(curve.get_ydata().tolist(), run["ball.z"].tolist())
        self.assertEqual(curve.get_label(), "ball.z [m]")

    def test_sweeps_over_processes_give_what_one_process_gives(self):
        model = SOURCE / "models" / "bouncing_ball.xml"
        points = {"e": [0.2, 0.5], "h0": (1.0, 2.0)}
        runs = dynamy.sweep(model, points, processes=2)
        self.assertEqual([r.parameters for r in runs], [
            {"e": 0.2, "h0": 1.0}, {"e": 0.2, "h0": 2.0}, {"e": 0.5, "h0": 1.0}, {"e": 0.5, "h0": 2.0}])
        alone = dynamy.sweep(model, points, processes=1)
        for a, b in zip(runs, alone):
            self.assertEqual(a["ball.z"].tolist(), b["ball.z"].tolist())
        least = dynamy.sweep(model, points, processes=2, values=lambda r: r["ball.z"].max())
        self.assertEqual(least, [r["ball.z"].max() for r in runs])

    def test_sweeps_tell_mistakes(self):
        model = SOURCE / "models" / "bouncing_ball.xml"
        for processes in (1, 2):
            with self.assertRaisesRegex(dynamy.ModelError, 'did you mean "h0"'):
                dynamy.sweep(model, {"h00": [1, 2]}, processes=processes)
        with self.assertRaisesRegex(ValueError, "1 or more"):
            dynamy.sweep(model, {"e": [0.2]}, processes=0)

    def test_elements_are_described(self):
        text = dynamy.describe("RigidBody")
        for attribute in ("position", "velocity", "mass"):
            self.assertIn(attribute, text)
        self.assertIn("RigidBody", dynamy.describe())
        with self.assertRaisesRegex(dynamy.ModelError, 'did you mean "RigidBody"'):
            dynamy.describe("RigidBdy")

    def test_mistakes_are_told(self):
        with self.assertRaisesRegex(dynamy.ModelError, 'did you mean "RigidBody"'):
            dynamy.element("RigidBdy")
        with self.assertRaisesRegex(dynamy.ModelError, 'did you mean "radius"'):
            dynamy.element("Sphere", raduis=1)
        with self.assertRaisesRegex(dynamy.ModelError, r"takes no solver"):
            dynamy.element("Sphere", "s", [dynamy.element("ProxGaussSeidel")], radius=1)
        with self.assertRaisesRegex(dynamy.ModelError, "model:2"):
            dynamy.model('<dynamy version="1">\n<sytems/></dynamy>')

    def test_wrong_arguments_are_named(self):
        model = str(SOURCE / "models" / "bouncing_ball.xml")
        with self.assertRaisesRegex(dynamy.ModelError, "e: a value is a number.*None"):
            dynamy.load(model, e=None)
        with self.assertRaisesRegex(dynamy.ModelError, r"dynamy\.model\(text\)"):
            dynamy.load(Path(model).read_text())
        with self.assertRaisesRegex(dynamy.ModelError, r"dynamy\.load"):
            dynamy.model("ball.xml")
        with self.assertRaisesRegex(TypeError, r"dynamy\.load\('ball.xml'\)"):
            dynamy.run("ball.xml")
        with self.assertRaisesRegex(TypeError, "each is a function"):
            dynamy.run(dynamy.load(model), each=3)
        with self.assertRaisesRegex(TypeError, "e: a list of values"):
            dynamy.sweep(model, {"e": 0.3})
        with self.assertRaisesRegex(dynamy.ModelError, "a class or a function"):
            dynamy.register_law("Nothing", 3)

    def test_what_the_callback_raises_is_raised(self):
        def each(state):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            dynamy.run(dynamy.load(str(SOURCE / "models" / "bouncing_ball.xml")), each=each)

    def test_a_moment_that_is_kept_says_that_it_is_over(self):
        kept = []
        dynamy.run(dynamy.load(str(SOURCE / "models" / "bouncing_ball.xml")), each=kept.append,
                   every=0.5)
        with self.assertRaisesRegex(RuntimeError, "this moment is over"):
            kept[0].t
        with self.assertRaisesRegex(RuntimeError, "this moment is over"):
            kept[0]["ball.z"]

    def test_false_of_numpy_ends_a_run_and_its_numbers_are_read_only(self):
        def each(now):
            with self.assertRaises(ValueError):
                now.u[:] = 0.0
            return np.bool_(now.t < 0.3)

        figures = dynamy.run(dynamy.model(SLIDE.replace("LAW", "<UnilateralCoulomb mu='0.1'/>")
                                          .replace('until="0.2"', 'until="1"')), each=each)[1]
        self.assertEqual(figures["state"], "stopped")

    def test_simulations_go_back(self):
        def made():
            return dynamy.Simulation(dynamy.model("""<dynamy version="1">
              <systems><PointMass name="cart" mass="2"/></systems>
              <forces><Sample name="s" of="cart.x" period="10ms"/><Input name="push" value="1"/>
              <ForceInput on="cart" force="push.out; 0; 0"/></forces>
              <simulation until="3" step="1e-3"/></dynamy>"""))

        simulation = made()
        simulation["push"] = 2.0
        simulation.advance(0.5)
        saved = simulation.save()
        simulation.advance(0.5)
        expected = simulation["cart.x"], simulation["s.out"]
        simulation.restore(saved)
        self.assertAlmostEqual(simulation.t, 0.5)
        simulation.advance(0.5)
        self.assertEqual((simulation["cart.x"], simulation["s.out"]), expected)
        with self.assertRaisesRegex(dynamy.ModelError, "another model|checkpoint"):
            simulation.restore(saved[:-8])
        # A time in the past: blocks sample anew, inputs stay.
        simulation.state.t = 0.0
        simulation["cart.x"], simulation["cart.vx"] = 5.0, 0.0
        simulation.advance(0.2)
        self.assertAlmostEqual(simulation["cart.x"], 5.0 + 0.5 * 0.2**2, 3)
        self.assertAlmostEqual(simulation["s.out"], simulation["cart.x"], 3)
        simulation.reset()
        self.assertEqual((simulation.t, simulation["cart.x"], simulation["s.out"]), (0.0, 0.0, 0.0))
        with self.assertRaisesRegex(ValueError, "length above 0"):
            simulation.step(-1.0)

    def test_a_broken_law_ends_the_run_and_says_why(self):
        class Broken:
            def prox(self, z, r, dt):
                return [0.0]

        dynamy.register_law("PythonBroken", Broken)
        figures = dynamy.run(dynamy.model(SLIDE.replace("LAW", "<PythonBroken/>")))[1]
        self.assertEqual(figures["state"], "failed")
        self.assertIn("prox has to return", figures["reason"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
