"""Runs models with an installed wheel alone: wheel_runs.py BUILD_DIR, whose libraries must not be used."""

import sys

import dynamy
import dynamy_run

run = dynamy.load("woodpecker.xml", mu=0.3).run()
assert isinstance(run, dynamy_run.Run)
assert run.facts["state"] == "finished" and run["toy.y"].size == run.t.size > 100
assert "<html" in run.page()
dynamy.plugin("ski_skin")  # a plug-in that the wheel brings

with open("/proc/self/maps", encoding="utf-8") as maps:
    rows = [line.rstrip("\n").split(maxsplit=5) for line in maps]
libraries = {row[5] for row in rows if len(row) == 6 and ".so" in row[5]}
brought = {file for file in libraries if "/dynamy/" in file}
assert {file.rsplit("/", 1)[1] for file in brought} >= {"libdynamy_elements.so", "libski_skin.so"}
strange = [file for file in libraries if file.startswith(sys.argv[1] + "/lib/")]
assert not strange, strange
