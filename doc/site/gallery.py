"""The page of models on the site: its pictures open the replays themselves, which
doc/site/make_replays.py wrote below replays/.
"""

import os

from docutils import nodes

PAGE = "doc/models"


def replay_of(app, literal):
    """Address of the replay of a model, or None where it was not made."""
    name = literal.astext()
    return f"../replays/{name}.html" if os.path.exists(f"{app.outdir}/replays/{name}.html") else None


def linked(literal, uri):
    link = nodes.reference("", "", literal.deepcopy(), refuri=uri, classes=["replay"])
    literal.parent.replace(literal, link)


def cards(table, app):
    """The pictures at the head of the page, one card each."""
    box = nodes.container(classes=["gallery"])
    for entry in table.findall(nodes.entry):
        image, name = next(entry.findall(nodes.image), None), next(entry.findall(nodes.literal), None)
        if image is None or name is None:
            continue
        uri = replay_of(app, name)
        picture = image.deepcopy()
        if os.path.exists(f"{app.srcdir}/doc/figures/models/{name.astext()}.png"):
            picture["uri"] = f"figures/models/{name.astext()}.png"  # without the page around it
        inside = [picture, nodes.inline("", image["alt"]), name.deepcopy()]
        if uri:
            card = nodes.reference("", "", *inside, refuri=uri, classes=["card", "replay"])
        else:
            card = nodes.inline("", "", *inside, classes=["card"])
        box += nodes.paragraph("", "", card)
    return box


def show(app, document):
    if app.env.docname != PAGE:
        return
    app.env.metadata[PAGE]["hide-toc"] = True
    tables = list(document.findall(nodes.table))
    for table in tables[1:]:
        for row in table.findall(nodes.row):
            literal = next(row[0].findall(nodes.literal), None)
            uri = literal is not None and replay_of(app, literal)
            if uri:
                image = next(row.findall(nodes.image), None)
                if image is not None:
                    image.parent.replace(image, nodes.reference("", "", image.deepcopy(), refuri=uri, classes=["replay"]))
                linked(literal, uri)
    tables[0].parent.replace(tables[0], cards(tables[0], app))


def setup(app):
    app.connect("doctree-read", show, priority=200)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
