"""SVG, standing alone: letters are outlines, so a figure looks the same in every browser and needs no font.

Ink is ``currentColor``; what is filled with paper or shade has the class ``variantgen-paper`` or ``variantgen-shade``,
so that the style of a page can take a figure into the dark, and a plain colour, because converters know no variables
of style sheets. Several figures may stand in one page: the only names are
those of title and description, made from the content, or given where the same figure may stand there twice.
"""

from __future__ import annotations

import hashlib
from xml.sax.saxutils import escape, quoteattr

from variantgen.figure.curves import AROUND, DASHES, Curve, curves
from variantgen.figure.drawing import LETTER, Drawing, Label
from variantgen.figure.letters.glyphs import Glyph
from variantgen.figure.letters.lettering import letters_of
from variantgen.outputs.figures import unit
from variantgen.wording.formula import Formula

SUFFIXES = (".svg",)
_FILLS = {
    "": "",
    "ink": ' fill="currentColor"',
    "paper": ' class="variantgen-paper" fill="#fff"',
    "shade": ' class="variantgen-shade" fill="#ebebeb"',
}


def render(drawing: Drawing, width_mm: float | None = None) -> bytes:
    """The figure as a file, on paper of its own: it is seen on a dark page too."""
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{svg(drawing, width_mm=width_mm, paper=True)}\n'.encode()


def svg(drawing: Drawing, title: str = "", width_mm: float | None = None, paper: bool = False, name: str = "") -> str:
    """The ``svg`` element, for a file or inside a page of HTML; with ``paper`` it has a background.

    ``name`` is part of the ids of title and description; without one they are made from the content.
    """
    height = drawing.height
    body = [_curve(curve, height) for curve in curves(drawing.lines)]
    body += [_paper(label, height) for label in drawing.labels]
    letters = [_letter(glyph, at, height) for label in drawing.labels for glyph, at in letters_of(label)]
    wide, tall = (_number(unit(drawing, width_mm) * side) for side in (drawing.width, height))
    sheet = f'<rect width="100%" height="100%"{_FILLS["paper"]}/>' if paper else ""
    ident = name or hashlib.sha256("".join((title, drawing.alt, *body, *letters)).encode()).hexdigest()[:10]
    labelled, words = _words(title, drawing.alt, ident)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide}mm" height="{tall}mm" '
        f'viewBox="0 0 {_number(drawing.width)} {_number(height)}" role="img"{labelled}>{words}{sheet}'
        f'<g fill="none" stroke="currentColor" stroke-linecap="round" stroke-linejoin="round">{"".join(body)}</g>'
        f'<g fill="currentColor">{"".join(letters)}</g></svg>'
    )


def _words(title: str, alt: str, ident: str) -> tuple[str, str]:
    """Title and description for readers who do not see, and the attribute that points to them."""
    parts = [(kind, text) for kind, text in (("title", title), ("desc", alt)) if text]
    if not parts:
        return "", ""
    names = " ".join(f"{kind[0]}{ident}" for kind, _ in parts)
    inner = "".join(f'<{kind} id="{kind[0]}{ident}">{escape(text)}</{kind}>' for kind, text in parts)
    return f" aria-labelledby={quoteattr(names)}", inner


def _letter(glyph: Glyph, at: complex, height: float) -> str:
    """One glyph with its origin at a place."""
    size = _number(LETTER * glyph.scale / 1000, 5)
    place = f"{_number(at.real)} {_number(height - at.imag)}"
    return f'<path transform="translate({place})scale({size} -{size})" d="{glyph.path}"/>'


def _paper(label: Label, height: float) -> str:
    """The paper behind a label, as in the other back ends."""
    width, tall = (side + 2 * AROUND for side in label.size)
    x, y = _number(label.at.real - 0.5 * width), _number(height - label.at.imag - 0.5 * tall)
    box = f'x="{x}" y="{y}" width="{_number(width)}" height="{_number(tall)}"'
    return f'<rect {box}{_FILLS[label.paper]} stroke="none"/>'


def path_data(curve: Curve, height: float = 0.0) -> str:
    """The steps of a curve as the ``d`` of a path; a place at ``height`` (u) is at the top."""
    return "".join(
        kind + " ".join(f"{_number(p.real)} {_number(height - p.imag)}" for p in points) for kind, points in curve.steps
    )


def lettering(formula: Formula) -> str:
    """The outlines of a formula as SVG, the middle of its ink at the origin."""
    return "".join(_letter(glyph, at, 0.0) for glyph, at in letters_of(Label(formula, 0j, (0.0, 0.0))))


def _curve(curve: Curve, height: float) -> str:
    steps = path_data(curve, height)
    pen = f' stroke-width="{_number(curve.weight)}"' if curve.weight else ' stroke="none"'
    dash = f' stroke-dasharray="{" ".join(map(_number, DASHES[curve.dash]))}"' if curve.dash else ""
    return f'<path d="{steps}"{pen}{_FILLS[curve.fill]}{dash}/>'


def _number(value: float, digits: int = 2) -> str:
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
