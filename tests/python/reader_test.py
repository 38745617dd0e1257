"""The reader of run folders against runs of the program: reader_test.py DYNAMY SOURCE_DIR"""

import csv
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("SKIPPED: no numpy")
    sys.exit(77)

DYNAMY, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCE / "app" / "python"))
import dynamy_run  # noqa: E402


class Reader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="dynamy_reader"))
        for name in ("bouncing_ball", "falling_box"):
            subprocess.run([DYNAMY, "run", SOURCE / "models" / f"{name}.xml", "--quiet",
                            "--out", cls.folder / name], check=True)
        cls.ball = dynamy_run.Run(cls.folder / "bouncing_ball")
        cls.box = dynamy_run.Run(cls.folder / "falling_box")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def copy(self, name):
        folder = Path(tempfile.mkdtemp(dir=self.folder))
        return Path(shutil.copytree(self.folder / name, folder / "run"))

    def test_signals_are_the_numbers_of_the_file(self):
        with open(self.folder / "bouncing_ball" / "signals.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(self.ball.signals), list(rows[0]))
        for name in rows[0]:  # bit for bit: the text reads back to the same double
            self.assertEqual(self.ball[name].tolist(), [float(row[name]) for row in rows])
        self.assertEqual(self.ball.units["ball.vz"], "m/s")
        self.assertEqual(self.ball.facts["state"], "finished")

    def test_packed_signals_are_the_same_numbers(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("no h5py")
        folder = self.folder / "packed"
        subprocess.run([DYNAMY, "run", SOURCE / "models" / "bouncing_ball.xml", "--quiet",
                        "--signals", "hdf5", "--out", folder], check=True)
        self.assertFalse((folder / "signals.csv").exists())
        packed = dynamy_run.Run(folder)
        self.assertEqual(list(packed.signals), list(self.ball.signals))
        for name in self.ball.signals:
            self.assertEqual(packed[name].tolist(), self.ball[name].tolist())
        with h5py.File(folder / "signals.h5", "r") as file:  # by itself, without dynamY
            self.assertEqual(file["signals/ball.vz"].attrs["unit"].decode(), "m/s")
            self.assertEqual(file.attrs["format"].decode(), "dynamy-signals")
            self.assertIn('"signals"', file["provenance/run.json"][()].decode())
            self.assertIn("<dynamy", file["provenance/model.xml"][()].decode())
        data = (folder / "signals.h5").read_bytes()
        (folder / "signals.h5").write_bytes(data[:len(data) // 2])
        with self.assertRaisesRegex(dynamy_run.RunError, "signals.h5: is damaged"):
            dynamy_run.Run(folder).signals

    def test_first_flight_is_a_parabola(self):
        # z = 1.1 − g t²/2 before the impact at √(2/g) = 0.4515 s; the midpoint rule is exact there,
        # up to the rounding of 4500 steps.
        flight = self.ball.t < 0.45
        z = 1.1 - 0.5 * 9.81 * self.ball.t[flight] ** 2
        self.assertLess(np.abs(self.ball["ball.z"][flight] - z).max(), 1e-11)

    def test_poses_agree_with_signals(self):
        z = np.interp(self.ball.frames.t, self.ball.t, self.ball["ball.z"])
        # Poses are single precision, 2^-24 of 1.1 m; rows are 2 ms apart and linear between: g/8 (2 ms)²
        # = 5e-6 m in flight, and at most v (1 + e)/4 · 2 ms = 3.3e-3 m at an impact.
        error = np.abs(self.ball.frames.r("ball")[:, 2] - z)
        self.assertLess(np.median(error), 5.1e-6)
        self.assertLess(error.max(), 3.4e-3)

    def test_rotations_are_rotations(self):
        A = self.box.frames.A(self.box.frames.names[0])
        eye = A @ A.transpose(0, 2, 1)
        self.assertLess(np.abs(eye - np.eye(3)).max(), 4e-7)  # quaternions: 2^-24 each, 6 terms
        self.assertGreater(np.abs(A[-1] - A[0]).max(), 1e-3)  # it turned

    def test_a_contact_carries_the_weight_in_the_end(self):
        contacts = self.box.frames.contacts[-1]
        # At rest the solver leaves a residual of 1e-10 or less; the file holds floats, 2^-24 each.
        self.assertLess(abs(contacts[:, 8].sum() / (2.0 * 9.81) - 1.0), 1e-6)

    def test_events_hold_the_first_impact(self):
        impact = next(e for e in self.ball.events if e["event"] == "impact")
        # It is noticed in the step of 0.1 ms after √(2 h0/g), at the speed −√(2 g h0).
        self.assertLess(abs(impact["t"] - math.sqrt(2 / 9.81)), 2e-4)
        self.assertLess(abs(impact["speed"] - math.sqrt(2 * 9.81)), 2e-4 * 9.81)

    def test_ledger_is_balanced(self):
        ledger = self.ball.ledger
        works = sum(ledger[n] for n in ("nonPotential", "friction", "normal", "joints",
                                        "boundaries", "discretisation"))
        balance = ledger["kinetic"] + ledger["potential"] - works
        # Sums of 16 000 steps over energies of 11 J.
        self.assertLess(np.ptp(balance), 1e-9)

    def test_a_cut_run_gives_what_is_whole(self):
        folder = self.copy("bouncing_ball")
        for name in ("signals.csv", "frames.bin"):
            data = (folder / name).read_bytes()
            (folder / name).write_bytes(data[:-10])
        run = dynamy_run.Run(folder)
        self.assertEqual(len(run.t), len(self.ball.t) - 1)
        self.assertLess(len(run.frames.t), len(self.ball.frames.t))

    def test_a_damaged_chunk_ends_the_pictures(self):
        folder = self.copy("bouncing_ball")
        data = bytearray((folder / "frames.bin").read_bytes())
        data[-1] ^= 1
        (folder / "frames.bin").write_bytes(data)
        self.assertLess(len(dynamy_run.Run(folder).frames.t), len(self.ball.frames.t))
        data[30] ^= 1
        (folder / "frames.bin").write_bytes(data)
        with self.assertRaisesRegex(dynamy_run.RunError, "frames.bin: its head is damaged"):
            _ = dynamy_run.Run(folder).frames

    def test_mistakes_are_told(self):
        with self.assertRaisesRegex(dynamy_run.RunError, "no run.json"):
            dynamy_run.Run(self.folder)
        with self.assertRaisesRegex(KeyError, "no signal .*there are t, ball.z"):
            _ = self.ball["ball.x"]
        with self.assertRaisesRegex(KeyError, "no frame"):
            self.ball.frames.r("bal")

    def test_it_runs_as_a_program(self):
        reader = SOURCE / "app" / "python" / "dynamy_run.py"
        done = subprocess.run([sys.executable, reader, self.folder / "bouncing_ball"],
                              capture_output=True, text=True, check=True)
        self.assertIn("ball.z [m]: 0.09", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
