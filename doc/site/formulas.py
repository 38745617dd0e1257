"""Indices and exponents of formulas, in running text and in blocks that are set in: prox_C, γ_N^E, s^(2/3). The columns of
a block stay aligned: the width that an index saves is given back at the next gap of its line.
"""

import html
import re

from docutils import nodes

LATIN = r"(?<![\w^])(?:prox|dist|max|min|sup|inf|lim|argmin|d?[A-Za-z])"
BASE = "((?:" + LATIN + r"|(?<![_^{])[Α-Ωα-ω])[\u0300-\u036f]?[⁺⁻ᵀ]?)"
INNER = r"(\{[^}]{1,12}\}|\([^()]{1,8}\)|[A-Za-zΑ-Ωα-ω0-9∞]{1,6})"
MARK = re.compile(BASE + r"(?:_(?!\()" + INNER + r"(?:\^" + INNER + r")?|\^" + INNER + r")(?![A-Za-zΑ-Ωα-ω0-9_])")
NUMBER = re.compile(r"\d[\d.]*e-\d+")  # not broken at its hyphen
SIZE = 0.75  # of the letters of an index, as static/site.css has it
KEPT = (nodes.literal, nodes.literal_block, nodes.raw, nodes.math, nodes.comment)


def marks(found):
    """Kind and text of the marks of a base."""
    for kind, mark in zip("_^^", found.groups()[1:]):
        if mark:
            yield kind, (mark[1:-1] if mark[0] in "{(" else mark).replace("_", "")


def pieces(text):
    """Nodes for the text, or None if it has no index or exponent."""
    made, at = [], 0
    for found in re.finditer(f"{MARK.pattern}|{NUMBER.pattern}", text):
        made.append(nodes.Text(text[at:found.start()] + (found.group(1) or "")))
        if found.group(1):
            made += [(nodes.subscript if kind == "_" else nodes.superscript)("", mark) for kind, mark in marks(found)]
        else:
            made.append(nodes.inline("", found.group(), classes=["short"]))
        at = found.end()
    return made + [nodes.Text(text[at:])] if made else None


def line_of_block(line):
    """HTML of a line whose later columns stay where they are."""
    made, at, saved = "", 0, 0.0

    def plain(text):
        nonlocal saved
        gap = re.search(r" {2,}", text)
        if gap is None or not saved:
            return html.escape(text)
        space = f'<span style="display:inline-block;width:{saved:.2f}ch"></span>'
        saved = 0.0
        return html.escape(text[:gap.end()]) + space + html.escape(text[gap.end():])

    for found in MARK.finditer(line):
        made += plain(line[at:found.start()]) + html.escape(found.group(1))
        width = 0.0
        for kind, mark in marks(found):
            tag = "sub" if kind == "_" else "sup"
            made += f"<{tag}>{html.escape(mark)}</{tag}>"
            width += SIZE * len(mark)
        saved += len(found.group()) - len(found.group(1)) - width
        at = found.end()
    return made + plain(line[at:])


def set_blocks(document):
    for block in list(document.findall(nodes.literal_block)):
        if block.get("language") != "none" or not MARK.search(block.astext()):
            continue
        lines = "\n".join(line_of_block(line) for line in block.astext().rstrip("\n").split("\n"))
        made = nodes.raw("", f'<div class="highlight-none notranslate"><div class="highlight"><pre>{lines}\n</pre></div></div>',
                         format="html")
        block.parent.replace(block, made)


def set_marks(app, document):
    set_blocks(document)
    for text in list(document.findall(nodes.Text)):
        above = text.parent
        inside = False
        while above is not None:
            inside = inside or isinstance(above, KEPT)
            above = above.parent
        made = None if inside else pieces(text.astext())
        if made:
            text.parent.replace(text, made)


def setup(app):
    app.connect("doctree-read", set_marks, priority=300)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
