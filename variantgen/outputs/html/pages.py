"""Pages of HTML from templates: self-contained, with everything from outside escaped by the template engine."""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from variantgen.outputs.html.environment import environment
from variantgen.resources import templates_dir

_STYLE = "style.css"
_PIECES = 100  # that are cleaned and written together
# What no page of HTML may hold: control characters and code points that are no characters. Titles may have them.
_NO_TEXT = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufdd0-\ufdef"
    + "".join(chr(plane + last) for plane in range(0, 0x110000, 0x10000) for last in (0xFFFE, 0xFFFF))
    + "]"
)

# What bytes that may belong to one of these look like: most pages have none, which is told much sooner.
_SUSPECT = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\xed\xef-\xf4]"), re.compile(rb"\xc2[\x80-\x9f]")


@cache
def _environment() -> jinja2.Environment:
    found = environment("html")
    found.filters["formulas"] = _formulas
    return found


def _formulas(found: Sequence[Markup]) -> Markup:
    """Formulas after each other; a browser does not break off the comma or the full stop after each."""
    signs = [*"," * (len(found) - 1), "."]
    held = (Markup('<span class="steady">{}{}</span>').format(*pair) for pair in zip(found, signs, strict=True))
    return Markup(" ").join(held)


@cache
def _style() -> tuple[Markup, str]:
    """The style of all pages, and its hash for the policy that lets no other style or script in."""
    style = (templates_dir() / "html" / _STYLE).read_text("utf-8")
    return Markup(style), base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()  # noqa: S704


def rendered(template: str, **data: Any) -> bytes:
    """What a template makes of data: strings are text, markup is what is marked as such."""
    return _clean(_environment().get_template(template).render(**data))


def fragment(template: str, **data: Any) -> str:
    """A part of a text, in one line as far as it has no listing of a program."""
    return _environment().get_template(template).render(**data).removesuffix("\n")


def write_page(path: Path, template: str, **data: Any) -> None:
    """Write a page piece by piece, as the template makes it; iterators in the data are read as the page grows."""
    style, known = _style()
    stream = _environment().get_template(template).stream(style=style, style_hash=known, **data)
    stream.enable_buffering(_PIECES)
    with path.open("wb") as file:
        for piece in stream:
            file.write(_clean(piece))


def pieces(paths: Sequence[Path]) -> Iterator[Markup]:
    """Markup that has been rendered before, a file at a time."""
    return (Markup(path.read_text("utf-8")) for path in paths)  # noqa: S704


def _clean(text: str) -> bytes:
    found = text.encode(errors="surrogatepass")
    if not any(pattern.search(found) for pattern in _SUSPECT):
        return found
    return _NO_TEXT.sub("\N{REPLACEMENT CHARACTER}", text).encode()
