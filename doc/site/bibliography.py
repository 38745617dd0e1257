"""doc/references.bib as a page, and [keys] in pages as links to its entries."""

import re

from docutils import nodes
from docutils.parsers import Parser

ENTRY = re.compile(r"^@(\w+)\{(\w+),(.*?)^\}", re.M | re.S)
FIELD = re.compile(r"(\w+)\s*=\s*(?:\{((?:[^{}]|\{[^{}]*\})*)\}|(\d+))", re.S)
ACCENTS = {r"\"a": "ä", r"\"o": "ö", r"\"u": "ü", r"\'e": "é", r"\'a": "á", r"\`e": "è", r"\'c": "ć", r"\v{c}": "č"}
PAGE = "doc/references"


def entries(text):
    """(key, fields) of every entry, in the order of the file."""
    for _, key, body in ENTRY.findall(text):
        yield key, {name.lower(): plain(braced or number) for name, braced, number in FIELD.findall(body)}


def plain(value):
    for tex, letter in ACCENTS.items():
        value = value.replace("{" + tex + "}", letter).replace(tex, letter)
    return " ".join(value.replace("{", "").replace("}", "").replace("--", "–").replace("~", " ").split())


def place(fields):
    """Journal, book or school with volume and year."""
    where = fields.get("journal") or fields.get("booktitle") or fields.get("school") or fields.get("publisher")
    volume = " ".join(part for part in [
        fields.get("volume"), f"({fields['number']})" if "number" in fields else "",
        f"pp. {fields['pages']}" if "pages" in fields else ""] if part)
    note = fields.get("note") or fields.get("howpublished")
    return ", ".join(part for part in [where, volume, fields.get("year"), note] if part)


class BibliographyParser(Parser):
    """A .bib file as a list of what can be read and followed."""

    supported = ("bibtex",)

    def parse(self, inputstring, document):
        section = nodes.section(ids=["references"], names=["references"])
        section += nodes.title("", "References")
        for key, fields in sorted(entries(inputstring)):
            entry = nodes.paragraph(ids=[key], classes=["reference-entry"])
            entry += nodes.strong("", f"[{key}] ")
            authors = fields.get("author", fields.get("editor", "")).replace(" and ", "; ")
            entry += nodes.Text(f"{authors}: " if authors else "")
            entry += nodes.emphasis("", fields.get("title", ""))
            entry += nodes.Text(". " + place(fields) + ". ")
            address = "https://doi.org/" + fields["doi"] if "doi" in fields else fields.get("url")
            if address:
                entry += nodes.reference("", fields.get("doi", address), refuri=address)
            section += entry
        document += section


def link_keys(app, document):
    """[key] in running text becomes a link to the entry."""
    name = app.env.docname
    if name == PAGE:
        return
    keys = app.env.dynamy_keys
    up = "../" * name.count("/")
    for text in list(document.findall(nodes.Text)):
        if isinstance(text.parent, (nodes.literal, nodes.literal_block, nodes.reference, nodes.title, nodes.raw)):
            continue
        parts = re.split(r"\[(\w+)\]", text.astext())
        if len(parts) == 1 or not any(key in keys for key in parts[1::2]):
            continue
        made = []
        for i, part in enumerate(parts):
            if i % 2 == 0:
                made.append(nodes.Text(part))
            elif part in keys:
                made.append(nodes.reference("", f"[{part}]", refuri=f"{up}{PAGE}.html#{part}"))
            else:
                made.append(nodes.Text(f"[{part}]"))
        text.parent.replace(text, made)


def read_keys(app, env, names):
    with open(f"{app.srcdir}/{PAGE}.bib", encoding="utf-8") as file:
        env.dynamy_keys = {key for key, _ in entries(file.read())}


def setup(app):
    app.add_source_suffix(".bib", "bibtex")
    app.add_source_parser(BibliographyParser)
    app.connect("env-before-read-docs", read_keys)
    app.connect("doctree-read", link_keys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
