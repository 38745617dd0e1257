#!/usr/bin/env python3
"""Runs the models that doc/models.md names and keeps their replays, for the gallery of the site.
  make_replays.py PROGRAM OUT     writes OUT/NAME.html; a replay newer than model and program stays
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def names():
    with open(f"{ROOT}/doc/models.md", encoding="utf-8") as file:
        return re.findall(r"^\| `(\w+)` \|", file.read(), re.M)


def newest(*files):
    return max(os.path.getmtime(file) for file in files)


def main():
    program, out = sys.argv[1:]
    os.makedirs(out, exist_ok=True)
    failed = []
    for name in names():
        model, page = f"{ROOT}/models/{name}.xml", f"{out}/{name}.html"
        if os.path.exists(page) and os.path.getmtime(page) > newest(model, program):
            continue
        with tempfile.TemporaryDirectory() as folder:
            command = [program, "run", model, "--out", folder + "/run", "--quiet", "--no-checkpoint"]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode == 0:
                shutil.copyfile(folder + "/run/replay.html", page)
            else:
                failed.append(name)
                print(f"{model}: {done.stderr}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
