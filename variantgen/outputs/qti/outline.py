"""Documents of XML that are written as they come, for manifests and tests of any number of students."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import IO
from xml.etree.ElementTree import Element
from xml.parsers import expat
from xml.sax.saxutils import XMLGenerator

from variantgen.outputs.qti.tree import clean


class Outline:
    """A document under way. Only the tags that are open are held."""

    def __init__(self, file: IO[bytes]) -> None:
        self._out = XMLGenerator(file, "utf-8", short_empty_elements=True)
        self._out.startDocument()

    @contextmanager
    def inside(self, tag: str, attributes: Mapping[str, str] | None = None) -> Iterator[None]:
        """What is written inside the block is inside this element."""
        self._start(tag, attributes or {})
        yield
        self._out.endElement(tag)

    def add(self, tree: Element) -> None:
        """Write a tree."""
        with self.inside(tree.tag, tree.attrib):
            self._out.characters(tree.text or "")
            for child in tree:
                self.add(child)
                self._out.characters(child.tail or "")

    def close(self) -> None:
        """Write out what is still held back."""
        self._out.endDocument()

    def _start(self, tag: str, attributes: Mapping[str, str]) -> None:
        self._out.startElement(tag, {name: clean(value) for name, value in attributes.items()})  # type: ignore[arg-type]  # any mapping will do


def check(file: IO[bytes]) -> None:
    """Read a document through. Raises ExpatError if it is not XML: a defect of the program."""
    expat.ParserCreate().ParseFile(file)
