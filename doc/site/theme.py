"""What Debian's package of the theme furo leaves out: its script is not bundled with the one that it
imports, its style sheet imports a sheet by an address of the machine, and dark colours are missing
where the reader's system, not the button of the page, asks for them.
"""

import os
import re

NORMALIZE = "/usr/share/javascript/normalize.css/normalize.css"


def read(file):
    with open(file, encoding="utf-8") as opened:
        return opened.read()


def write(file, text):
    with open(file, "w", encoding="utf-8") as opened:
        opened.write(text)


def bundled(folder):
    script = read(f"{folder}/furo.js")
    first, _, rest = script.partition("\n")
    if first.startswith("import Gumshoe"):
        write(f"{folder}/furo.js", read(f"{folder}/gumshoe-patched.js") + rest)


def styled(file):
    sheet = read(file)
    if sheet.startswith("@import url(/"):
        sheet = sheet.split("\n", 1)[1]
        if os.path.exists(NORMALIZE):
            sheet = read(NORMALIZE) + sheet
    dark = re.search(r'body\[data-theme="dark"\] \{(\s*--color-problematic[^}]*)\}', sheet)
    if dark and "prefers-color-scheme" not in sheet:
        sheet += ('@media not print { @media (prefers-color-scheme: dark) { body[data-theme="auto"] {' + dark.group(1) +
                  "} } }\n")
    write(file, sheet)


def mend(app, failure):
    if failure is None and app.builder.name == "html":
        bundled(f"{app.outdir}/_static/scripts")
        styled(f"{app.outdir}/_static/styles/furo.css")


def setup(app):
    app.connect("build-finished", mend, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
