#!/usr/bin/env python3
"""Runs that die by kill -9 at random instants: every folder can be read, every run that had a checkpoint goes on bit for
bit as a straight one, with its report and exit status, the others say that there is none.

  bench/trust/killed_runs.py [--count 1000] [--seed 1] [--program build/release/bin/dynamy] [--folder FOLDER]

Prints a line for each fault and one at the end; exit status 0: no fault. The same seed kills after the same times, which is not
the same instant of the run. One run in four is killed again while it is resumed.
"""
import argparse
import collections
import json
import os
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENE = """<dynamy version="1"><systems>
  <Ground name="world"><HalfSpace material="floor"/></Ground>
  <RigidBody name="a" position="0 0 0.3" velocity="1 0 0"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  <RigidBody name="b" position="0.35 0 0.3" velocity="-1 0 0.2"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  <RigidBody name="rod" position="2 0 1" mass="1" inertia="0.1 0.1 0.1"/></systems>
  <forces><Gravity/></forces>
  <elements><Contact between="ball floor"><UnilateralCoulomb epsilonN="0.5" mu="0.3"/></Contact>
  <Contact between="ball ball"><UnilateralCoulomb epsilonN="0.5" mu="0.3"/></Contact>
  <Spherical name="hook" between="world rod" at="2.3 0 1"/></elements>
  {simulation}
  <record signals="a.* rod.*" every="1ms"/></dynamy>"""
# Each takes some tenths of a second.
SCENES = {
    "fixed": '<simulation until="8" step="1ms"/>',
    "located": '<simulation until="60" tolerance="1e-8"/>',
    "midpoint": '<simulation until="20" step="1ms"><MoreauMidpoint/></simulation>',
}
TABLES = ["signals.csv", "events.csv", "ledger.csv"]


def film(path):
    """The frames of frames.bin, however they are cut into chunks; None: broken or cut off."""
    data = path.read_bytes()
    size, = struct.unpack_from("<I", data, 20)
    at, payload = 24 + size + 4, b""
    while at < len(data):
        if data[at:at + 4] != b"CHNK" or at + 40 > len(data):
            return None
        length, = struct.unpack_from("<Q", data, at + 8)
        payload += data[at + 40:at + 40 + length]
        at += 40 + length
    return payload if at == len(data) else None


def report_of(folder):
    """run.json without what the clock, the path of the model and the chunks of the film decide, and the work, which
    going on adds to."""
    report = json.loads((folder / "run.json").read_text(encoding="utf-8"))
    other = ("cpu_s", "wall_s", "model", "files", "effort", "evaluations")
    return {key: value for key, value in report.items() if key not in other}


class Campaign:
    def __init__(self, options):
        self.program = str(pathlib.Path(options.program).resolve())
        self.random = random.Random(options.seed)
        self.counts, self.faults, self.done = collections.Counter(), 0, 0
        self.statuses = {}  # of the straight runs

    def call(self, *words):
        return subprocess.run([self.program, *words], capture_output=True, text=True, check=False)

    def fault(self, number, text):
        self.faults += 1
        print(f"run {number}: FAULT: {text}", flush=True)

    def kill_in(self, words, longest):
        """Starts the program and kills it within `longest` seconds; False: it had ended before."""
        process = subprocess.Popen([self.program, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(self.random.uniform(0.0, longest))
        process.send_signal(signal.SIGKILL)
        return process.wait() == -signal.SIGKILL

    def one(self, number, name, straight, seconds):
        folder = pathlib.Path("killed")
        shutil.rmtree(folder, ignore_errors=True)
        words = ["run", f"{name}.xml", "--out", str(folder), "--quiet", "--checkpoint",
                 self.random.choice(["1ms", "10ms", "50ms", "10s"])]
        if not self.kill_in(words, seconds):
            self.counts["had ended before"] += 1
        if self.random.random() < 0.25 and (folder / "checkpoint").exists():
            self.kill_in(["resume", str(folder), "--quiet", "--checkpoint", "5ms"], seconds)
            self.counts["killed twice"] += 1
        if (folder / "run.json").exists():
            seen = self.call("verify", str(folder))
            missing = [f for f in TABLES + ["frames.bin"] if not (folder / f).exists()]
            if seen.returncode != 0 and not missing:
                self.fault(number, "verify: " + seen.stdout)
        if not folder.exists():
            self.counts["before their folder"] += 1
            return
        had = (folder / "checkpoint").exists()
        resumed = self.call("resume", str(folder), "--quiet")
        if not had:
            self.counts["without a checkpoint"] += 1
            if resumed.returncode != 2 or "holds no" not in resumed.stderr:
                self.fault(number, f"no checkpoint, but status {resumed.returncode}: {resumed.stderr}")
            return
        self.counts["resumed"] += 1
        if resumed.returncode != self.statuses[name]:
            self.fault(number, f"resume: status {resumed.returncode}: {resumed.stderr}")
            return
        for file in TABLES:
            if (folder / file).read_bytes() != (straight / file).read_bytes():
                self.fault(number, f"{name}: {file} differs")
        if film(folder / "frames.bin") != film(straight / "frames.bin"):
            self.fault(number, f"{name}: frames.bin differs")
        found, right = report_of(folder), report_of(straight)
        for key in sorted(found.keys() | right.keys()):
            if found.get(key) != right.get(key):
                self.fault(number, f"{name}: {key} of run.json differs: {found.get(key)}, not {right.get(key)}")

    def run(self, count):
        times = {}
        for name, simulation in SCENES.items():
            pathlib.Path(f"{name}.xml").write_text(SCENE.format(simulation=simulation), encoding="utf-8")
            begin = time.monotonic()
            answer = self.call("run", f"{name}.xml", "--out", f"straight_{name}", "--quiet")
            if answer.returncode not in (0, 3):
                sys.exit(f"{name}: {answer.stderr}")
            self.statuses[name] = answer.returncode
            times[name] = time.monotonic() - begin
        for number in range(count):
            name = self.random.choice(list(SCENES))
            self.one(number, name, pathlib.Path(f"straight_{name}"), times[name])
            self.done += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "bin" / "dynamy"))
    parser.add_argument("--folder", help="works there; default: a folder for temporary files")
    options = parser.parse_args()
    campaign = Campaign(options)
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        os.chdir(folder)
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        try:
            campaign.run(options.count)
        except KeyboardInterrupt:
            print("stopped early")
        os.chdir(ROOT)
    counts = ", ".join(f"{n} {what}" for what, n in sorted(campaign.counts.items()))
    print(f"{campaign.done} runs killed: {counts}; {campaign.faults} faults")
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())
