"""What the site makes of the repository's pages: addresses, anchors as GitHub writes them, and the
table of contents, which is read from the tables of doc/index.md.
"""

import os
import re
import shutil

from docutils import nodes

LINK = re.compile(r"\]\(([\w/.]+\.(?:md|bib))\)")


def address(uri):
    """The address of a page for the name of its file."""
    if re.match(r"[a-z]+:|//|#", uri):
        return uri
    file, sharp, anchor = uri.partition("#")
    return re.sub(r"\.(md|bib)$", ".html", file) + sharp + anchor


def companion(app, uri):
    """A file of the repository that is no page comes with the site, sources as text."""
    origin = os.path.normpath(os.path.join(app.srcdir, os.path.dirname(app.env.docname), uri))
    if re.match(r"[a-z]+:|//|#", uri) or uri.partition("#")[0].endswith((".md", ".bib", ".html")) or not os.path.isfile(origin):
        return uri
    suffix = "" if uri.endswith((".svg", ".png", ".csv", ".json")) else ".txt"
    copy = os.path.join(app.outdir, os.path.relpath(origin, app.srcdir)) + suffix
    os.makedirs(os.path.dirname(copy), exist_ok=True)
    shutil.copyfile(origin, copy)
    return uri + suffix


def slug(title, taken):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-")
    count = taken.get(text, 0)
    taken[text] = count + 1
    return f"{text}-{count}" if count else text


def contents(app, name, source):
    """The hidden tables of contents from which the sidebar is made."""
    if name == "README":
        source[0] += "\n".join(toctree(title, pages) for title, pages in chapters(app.srcdir))
    elif name == "doc/reference/index":
        source[0] += toctree("", unique(re.findall(r"\]\((\w+)\.md\)", source[0])))
    elif name.endswith("/README"):
        below = nearest(os.path.dirname(name), app.env.found_docs)
        source[0] += toctree("", below) if below else ""


def nearest(folder, names):
    """The READMEs below a folder that have no other README above them but its own."""
    inside = sorted(name[len(folder) + 1:] for name in names
                    if name.startswith(folder + "/") and name.endswith("/README") and name != folder + "/README")
    return [name for name in inside
            if not any(name.startswith(os.path.dirname(other) + "/") for other in inside if other != name)]



def chapters(root):
    """(title, pages) of each part of doc/index.md."""
    with open(f"{root}/doc/index.md", encoding="utf-8") as file:
        parts = re.split(r"^##+ (.*)\n", file.read(), flags=re.M)
    yield "First steps", ["doc/index"] + [f"doc/{page[:-3]}" for page in LINK.findall(parts[0]) if "faq" not in page]
    for title, text in zip(parts[1::2], parts[2::2]):
        rows = [row for row in text.splitlines() if row.startswith("|")]
        pages = [f"doc/{os.path.splitext(page)[0]}" for row in rows for page in LINK.findall(row.split("|")[1])]
        if pages:
            yield title, [page for page in pages if page != "doc/concepts"]
    yield "The sources", ["CHANGELOG", "CONTRIBUTING", "framework/dynamy/README", "elements/dynamy_elements/README",
                          "app/README", "doc/site/README"]


def unique(names):
    return list(dict.fromkeys(names))


def toctree(title, pages):
    caption = f":caption: {title}\n" if title else ""
    return "\n\n```{toctree}\n:hidden:\n:maxdepth: 1\n" + caption + "\n" + "\n".join(unique(pages)) + "\n```\n"


def anchors_and_links(app, document):
    taken = {}
    for section in document.findall(nodes.section):
        anchor = slug(section[0].astext(), taken)
        section["ids"] = [anchor] + [known for known in section["ids"] if known != anchor]
    for literal in document.findall(nodes.literal):
        if len(literal.astext()) <= 40:  # not broken at a hyphen: 1e-6
            literal["classes"].append("short")
    for block in document.findall(nodes.literal_block):
        if "language" not in block:  # set in, not fenced
            block["language"] = "none"
    for reference in document.findall(nodes.reference):
        if "refuri" in reference:
            reference["refuri"] = address(companion(app, reference["refuri"]))
            reference["classes"] = [kind for kind in reference["classes"] if kind != "external"]


def entrance(app, failure):
    """The address of the site itself opens README."""
    if failure is None and app.builder.name == "html":
        shutil.copyfile(f"{app.outdir}/README.html", f"{app.outdir}/index.html")


def setup(app):
    app.connect("source-read", contents)
    app.connect("doctree-read", anchors_and_links, priority=100)  # before the sidebar is collected
    app.connect("build-finished", entrance)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
