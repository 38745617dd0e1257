"""Indices and exponents of formulas in running text: prox_C, g_tol, γ^A, s^(2/3) are set as such. Blocks that are set
in stay as they are written, because their columns are aligned.
"""

import re

from docutils import nodes

BASE = r"(?<![\w^])((?:prox|dist|max|min|sup|inf|lim|argmin|[A-Za-zΑ-Ωα-ω][\u0300-\u036f]?)[⁺⁻ᵀ]?)"
MARK = re.compile(BASE + r"([_^])(\{[^}]{1,12}\}|\([^()]{1,8}\)|[A-Za-zΑ-Ωα-ω0-9∞]{1,6})(?!\w)")
KEPT = (nodes.literal, nodes.literal_block, nodes.raw, nodes.math, nodes.comment)


def pieces(text):
    """Nodes for the text, or None if it has no index or exponent."""
    made, at = [], 0
    for found in MARK.finditer(text):
        base, sign, mark = found.groups()
        if sign == "_" and mark.startswith("("):
            continue
        kind = nodes.subscript if sign == "_" else nodes.superscript
        inner = mark[1:-1] if mark[0] in "{(" else mark
        made += [nodes.Text(text[at:found.start()] + base), kind("", inner)]
        at = found.end()
    return made + [nodes.Text(text[at:])] if made else None


def set_marks(app, document):
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
