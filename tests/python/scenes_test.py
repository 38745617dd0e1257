"""Tests of bench/scenes: that other programs get the bodies of the model, and that a comparison runs.

    scenes_test.py DYNAMY BENCH_SCENES
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCENES))
import random_scenes as rs  # noqa: E402

SMALL = [rs.wall(9), rs.pour(20), rs.hopper(10), rs.dominoes(3), rs.pile(8)]


class Scenes(unittest.TestCase):
    def test_models_are_valid(self):
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "m.xml"
            for s in SMALL + [rs.random_scene(k, common=True) for k in range(1, 6)]:
                file.write_text(rs.model(s))
                done = subprocess.run([PROGRAM, "check", str(file)], capture_output=True, text=True,
                                      check=False)
                self.assertEqual(done.returncode, 0, f"{s['name']}: {done.stdout}{done.stderr}")

    def test_others_get_the_bodies_of_the_model(self):
        for s in SMALL + [rs.random_scene(7)]:
            model = ElementTree.fromstring(rs.model(s)).findall("systems/RigidBody")
            rows = [line.split() for line in rs.plain(s).splitlines()]
            bodies = [row for row in rows if row[0] == "body"]
            self.assertEqual(len(bodies), len(model))
            for row, element in zip(bodies, model):
                numbers = row[3 + int(row[2]):]
                self.assertEqual(row[1], element[0].tag)
                self.assertEqual(numbers[0], element.get("mass"))
                self.assertEqual(numbers[1:4], element.get("inertia").split())
                self.assertEqual(numbers[4:7], element.get("position").split())
                self.assertEqual(numbers[14:17], element.get("angularVelocity").split())

    def test_a_seed_gives_the_same_scene_again(self):
        self.assertEqual(rs.model(rs.random_scene(3)), rs.model(rs.random_scene(3)))
        self.assertNotEqual(rs.model(rs.random_scene(3)), rs.model(rs.random_scene(4)))

    def test_a_comparison_without_others_writes_its_files(self):
        with tempfile.TemporaryDirectory() as name:
            done = subprocess.run(
                [sys.executable, str(SCENES / "compare"), "--out", name, "--random", "1", "--quick",
                 "--programs", str(pathlib.Path(PROGRAM).parent), "--peers", name],
                capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(pathlib.Path(name) / "scenes.csv", encoding="utf-8") as f:
                rows = list(csv.DictReader(f))
            self.assertEqual([row["program"] for row in rows], ["dynamY"])
            # The exact default keeps bodies apart to the limit of its own marks, 1 % of the scene,
            # by far; sizes of these scenes lie between 0.01 and 3 m.
            self.assertLess(float(rows[0]["overlap_m"]), 0.03)
            ElementTree.parse(pathlib.Path(name) / "scenes.svg")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
