#!/usr/bin/env python3
"""Builds the documentation site: replays of the gallery, pages of classes, pages of documents, links.
  build.py --out DIR [--program FILE] [--version X.Y.Z]
DIR/index.html is its entrance; it needs no server. Without a program the gallery shows pictures alone.
Every warning of the tools and every link that leads nowhere is an error.
"""

import argparse
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
TOGGLE = '<script src="$relpath^doxygen-awesome-darkmode-toggle.js"></script>\n<script>DoxygenAwesomeDarkModeToggle.init()</script>\n'


def run(what, *command):
    print(f"{what} ...", flush=True)
    done = subprocess.run(command, cwd=ROOT)
    if done.returncode != 0:
        sys.exit(f"{what}: failed")


def header(folder):
    """Doxygen's own head of a page, with a way back and the button for light and dark."""
    os.makedirs(folder, exist_ok=True)
    subprocess.run(["doxygen", "-w", "html", "header.html", "footer.html", "style.css"], cwd=folder, check=True,
                   capture_output=True)
    with open(f"{folder}/header.html", encoding="utf-8") as file:
        text = file.read()
    name = '<div id="projectname">'
    text = text.replace(f"{name}$projectname", f'{name}<a href="$relpath^../index.html">$projectname</a>')
    with open(f"{folder}/header.html", "w", encoding="utf-8") as file:
        file.write(text.replace("</head>", TOGGLE + "</head>"))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--out", required=True)
    options.add_argument("--program", default="")
    options.add_argument("--version", default="")
    chosen = options.parse_args()
    for tool in ("doxygen", "sphinx-build"):
        if not shutil.which(tool):
            sys.exit(f"{tool} is missing: scripts/install-packages docs")
    site, work = os.path.abspath(chosen.out), os.path.abspath(chosen.out) + ".work"
    os.environ.update(DYNAMY_VERSION=chosen.version, DYNAMY_SITE=site, DYNAMY_DOXYGEN=work, PYTHONDONTWRITEBYTECODE="1")
    os.makedirs(site, exist_ok=True)
    if chosen.program:
        run("Replays", sys.executable, f"{HERE}/make_replays.py", os.path.abspath(chosen.program), f"{site}/replays")
    header(work)
    run("Classes", "doxygen", f"{HERE}/Doxyfile")
    run("Pages", "sphinx-build", "-q", "-E", "-a", "-W", "--keep-going", "-b", "html", "-c", HERE, "-d", f"{work}/doctrees", ROOT, site)
    run("Links", sys.executable, f"{HERE}/check_links.py", site)
    print(f"{site}/index.html")


if __name__ == "__main__":
    main()
