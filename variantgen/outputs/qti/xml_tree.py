"""Trees of XML. Tags are written as they are, a namespace is the attribute ``xmlns`` of the element it begins with."""

from __future__ import annotations

from collections.abc import Mapping
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from variantgen.outputs.platforms.text import storable
from variantgen.wording.mathml import NAMESPACE as MATHML


def element(tag: str, attributes: Mapping[str, str] | None = None, *content: str | Element) -> Element:
    """An element with text and elements in it."""
    made = Element(tag, {name: storable(value) for name, value in (attributes or {}).items()})
    for part in content:
        if isinstance(part, Element):
            made.append(part)
        elif len(made):
            made[-1].tail = (made[-1].tail or "") + storable(part)
        else:
            made.text = (made.text or "") + storable(part)
    return made


def fragment(html: str) -> list[Element]:
    """The elements of a fragment of HTML that is XML too; formulas have the namespace of MathML."""
    root = ElementTree.fromstring(f"<div>{storable(html)}</div>")  # noqa: S314  (written by this program)
    for found in root.iter():
        found.tag = found.tag.rpartition("}")[2]
        if found.tag == "math":
            _declare(found)
    return list(root)


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


def document(root: Element) -> bytes:
    """A file of XML, which has been read again. Raises ParseError if it is none: a defect of the program."""
    written: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    ElementTree.fromstring(written)  # noqa: S314  (written by this program)
    return written
