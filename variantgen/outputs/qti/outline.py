"""Documents of XML that are written as they come, for manifests and tests of any number of students."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import IO
from xml.etree.ElementTree import Element
from xml.parsers import expat
from xml.sax.saxutils import XMLGenerator

from variantgen.outputs.platforms.text import storable


class Outline:
    """A document under way. Only the tags that are open are held; what is written is read again at once.

    Methods raise ExpatError if the document is not XML: a defect of the program.
    """

    def __init__(self, file: IO[bytes]) -> None:
        self._reader = expat.ParserCreate()
        self._out = XMLGenerator(_Read(file, self._reader), "utf-8", short_empty_elements=True)
        self._out.startDocument()

    @contextmanager
    def inside(self, tag: str, attributes: Mapping[str, str] | None = None) -> Iterator[None]:
        """What is written inside the block is inside this element."""
        found = {name: storable(value) for name, value in (attributes or {}).items()}
        self._out.startElement(tag, found)  # type: ignore[arg-type]  # any mapping will do
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
        self._reader.Parse(b"", True)


class _Read:
    """A file of which a reader gets what is written."""

    def __init__(self, file: IO[bytes], reader: expat.XMLParserType) -> None:
        self._file, self._reader = file, reader

    def write(self, content: bytes) -> int:
        self._reader.Parse(bytes(content), False)
        return self._file.write(content)
