"""Trees of XML. Tags are written as they are, a namespace is the attribute ``xmlns`` of the element it begins with."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from variantgen.wording.mathml import NAMESPACE as MATHML

# What XML 1.0 has no way to write.
_FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def clean(text: str) -> str:
    """Text without the control characters that no XML document may hold."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text)


def line(text: str) -> str:
    """Text for an attribute or a title: clean, and in one line."""
    return " ".join(clean(text).split())


def element(tag: str, attributes: Mapping[str, str] | None = None, *content: str | Element) -> Element:
    """An element with text and elements in it."""
    made = Element(tag, {name: clean(value) for name, value in (attributes or {}).items()})
    for part in content:
        if isinstance(part, Element):
            made.append(part)
        elif len(made):
            made[-1].tail = (made[-1].tail or "") + clean(part)
        else:
            made.text = (made.text or "") + clean(part)
    return made


def fragment(html: str) -> list[Element]:
    """The elements of a fragment of HTML that is XML too.

    Formulas have the namespace of MathML; a figure that nothing is said of in words has those of its caption.
    """
    root = ElementTree.fromstring(f"<div>{clean(html)}</div>")  # noqa: S314  (written by this program)
    for found in root.iter():
        found.tag = found.tag.rpartition("}")[2]
        if found.tag == "math":
            _declare(found)
        elif found.tag == "figure":
            _tell(found)
    return list(root)


def _tell(figure: Element) -> None:
    """Words for readers who do not see."""
    image, caption = figure.find("img"), figure.find("figcaption")
    if image is not None and caption is not None and not image.get("alt"):
        image.set("alt", line("".join(caption.itertext())))


def _declare(math: Element) -> None:
    """Give a formula its namespace; MathML 2 knows full size as a style around the content only."""
    display = math.attrib.pop("displaystyle", "")
    math.set("xmlns", MATHML)
    if display:
        style = Element("mstyle", {"displaystyle": display})
        style.extend(list(math))
        math[:] = [style]


def html(tree: Element) -> str:
    """A tree as text of HTML."""
    return ElementTree.tostring(tree, encoding="unicode", method="html")


def images(tree: Element) -> list[str]:
    """The files of the images in a tree, each once, in order."""
    return list(dict.fromkeys(found.get("src", "") for found in tree.iter("img")))


def number(value: float | Decimal) -> str:
    """A number with a decimal point if it needs one and without an exponent, as every platform reads it."""
    exact = Decimal(repr(value)) if isinstance(value, float) else value
    return format(exact.normalize() if exact else Decimal(0), "f")


def document(root: Element) -> bytes:
    """A file of XML, which has been read again. Raises ParseError if it is none: a defect of the program."""
    written: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    ElementTree.fromstring(written)  # noqa: S314  (written by this program)
    return written
