"""The structure of a tagged PDF (ISO 32000-1, 14.7), joined of those of its parts.

It has one document element with what is in those of all parts, in their order.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import pikepdf
from msgspec import Struct

from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.writer import ObjectWriter

_TABLES = ("/RoleMap", "/ClassMap")


class SharedObjects(Struct, frozen=True):
    """The numbers of the root, of the document element and, by what they say, of the namespaces of all parts."""

    root: int
    document: int
    namespaces: Mapping[bytes, int]

    @staticmethod
    def of(first: PageCopier, writer: ObjectWriter) -> SharedObjects:
        """Those of a whole that begins with a part; its namespaces are written."""
        return SharedObjects(
            writer.reserve(), writer.reserve(), _namespaces(first, first.source.Root.StructTreeRoot, writer, {})
        )


class PartsOfStructure(Struct, frozen=True):
    """What the structures of some parts give to the whole: entries of the document element but for its place and
    children, children, leaves of the tree of parents and of that of names, tables, further namespaces.
    """

    entries: bytes
    children: list[bytes]
    parents: int | None
    names: int | None
    tables: dict[str, dict[str, bytes]]
    namespaces: list[int]


class StructureReader:
    """Takes the structures of parts, the first of which is the one at ``place``."""

    def __init__(self, writer: ObjectWriter, shared: SharedObjects, place: int, first_key: int) -> None:
        self._writer, self._shared, self._place = writer, shared, place
        self._entries: bytes | None = None
        self._children: list[bytes] = []
        self._parents: list[tuple[int, bytes]] = []
        self._names: dict[bytes, bytes] = {}
        self._tables: dict[str, dict[str, bytes]] = {}
        self._namespaces = dict(shared.namespaces)
        self.next_key = first_key

    def add(self, part: PageCopier) -> None:
        """Take the structure of a part; its pages have been taken before.

        Raises ValueError for a structure that the typesetting engine does not write.
        """
        root = part.source.Root.StructTreeRoot
        (document,) = root.K if isinstance(root.K, pikepdf.Array) else (root.K,)
        if document.S != "/Document":
            raise ValueError(f"expected a document as the root of the structure, found {document.S}")
        part.new[root.objgen[0]], part.new[document.objgen[0]] = self._shared.root, self._shared.document
        self._namespaces = _namespaces(part, root, self._writer, self._namespaces)
        self._rename(root)
        if self._entries is None:
            own = pikepdf.Dictionary({key: value for key, value in document.items() if key not in {"/K", "/P"}})
            self._entries = part.text(own).strip().removeprefix(b"<<").removesuffix(b">>")
        children = document.K if isinstance(document.K, pikepdf.Array) else [document.K]
        self._children += [part.text(child) for child in children]
        self._parents += [
            (int(key) + self.next_key, part.text(value)) for key, value in _leaves(root.ParentTree, "/Nums")
        ]
        self._names.update((bytes(name), part.text(value)) for name, value in self._named(root))
        for table in _TABLES:
            _add(self._tables, table, {name: part.text(value) for name, value in root.get(table, {}).items()})
        self.next_key += int(root.ParentTreeNextKey)
        self._place += 1

    def finish(self) -> PartsOfStructure:
        """Write the leaves of trees."""
        return PartsOfStructure(
            self._entries or b"",
            self._children,
            self._leaf(b"Nums", [(b"%d" % key, value) for key, value in self._parents]),
            self._leaf(b"Names", [(_string(name), self._names[name]) for name in sorted(self._names)]),
            self._tables,
            [number for said, number in self._namespaces.items() if said not in self._shared.namespaces],
        )

    def _leaf(self, key: bytes, pairs: Sequence[tuple[bytes, bytes]]) -> int | None:
        """A leaf of a tree of names or numbers, of pairs in their order; its number, if there are any."""
        if not pairs:
            return None
        listed = b" ".join(b"%s %s" % pair for pair in pairs)
        return self._writer.add(b"<</Limits[%s %s]/%s[%s]>>" % (pairs[0][0], pairs[-1][0], key, listed))

    def _rename(self, root: Any) -> None:
        """Make the identifiers of header cells, which other cells of the same table name, distinct between parts."""
        tables = {}
        for _, element in self._named(root):
            table = element
            while table.S != "/Table":
                table = table.P
            tables[table.objgen] = table
        for table in tables.values():
            self._rename_in(table)

    def _rename_in(self, element: Any) -> None:
        if "/ID" in element:
            element.ID = self._renamed(element.ID)
        attributes = element.get("/A", [])
        for owned in [attributes] if isinstance(attributes, pikepdf.Dictionary) else attributes:
            if isinstance(owned, pikepdf.Dictionary) and "/Headers" in owned:
                owned.Headers = pikepdf.Array([self._renamed(name) for name in owned.Headers])
        inside = element.get("/K", [])
        for child in inside if isinstance(inside, pikepdf.Array) else [inside]:
            if isinstance(child, pikepdf.Dictionary) and "/S" in child:
                self._rename_in(child)

    def _renamed(self, name: Any) -> pikepdf.String:
        """A name of this part: behind those of the parts before it in the order of bytes, which the tree has."""
        return pikepdf.String(b"%07d." % self._place + bytes(name))

    @staticmethod
    def _named(root: Any) -> Iterator[tuple[Any, Any]]:
        """The elements that have an identifier, with it."""
        if "/IDTree" in root:
            yield from ((element.ID, element) for _, element in _leaves(root.IDTree, "/Names"))


def write_structure(
    writer: ObjectWriter, shared: SharedObjects, found: Sequence[PartsOfStructure], next_key: int
) -> int:
    """Write the root and the document element of the whole, of all parts; the number of the root."""
    children = b" ".join(child for one in found for child in one.children)
    writer.put(shared.document, b"<<%s/P %d 0 R/K[%s]>>" % (found[0].entries, shared.root, children))
    parents = writer.add(b"<</Kids[%s]>>" % _references(one.parents for one in found if one.parents))
    entries = b"/Type/StructTreeRoot/K %d 0 R" % shared.document
    entries += b"/ParentTree %d 0 R/ParentTreeNextKey %d" % (parents, next_key)
    if names := _references(one.names for one in found if one.names):
        entries += b"/IDTree %d 0 R" % writer.add(b"<</Kids[%s]>>" % names)
    tables: dict[str, dict[str, bytes]] = {}
    for one in found:
        for table, rows in one.tables.items():
            _add(tables, table, rows)
    for table, rows in tables.items():
        body = b"".join(pikepdf.Name(name).unparse() + b" " + value for name, value in rows.items())
        entries += b"%s<<%s>>" % (table.encode(), body)
    namespaces = [*shared.namespaces.values(), *(number for one in found for number in one.namespaces)]
    if namespaces:
        entries += b"/Namespaces[%s]" % _references(namespaces)
    writer.put(shared.root, b"<<%s>>" % entries)
    return shared.root


def _namespaces(part: PageCopier, root: Any, writer: ObjectWriter, known: Mapping[bytes, int]) -> dict[bytes, int]:
    """The namespaces that are known, by what they say, and those of a part, which uses one object for each."""
    found = dict(known)
    for space in root.get("/Namespaces", []):
        said = part.content(space)
        if said not in found:
            found[said] = writer.add(said)
        part.new[space.objgen[0]] = found[said]
    return found


def _add(tables: dict[str, dict[str, bytes]], table: str, rows: Mapping[str, bytes]) -> None:
    """Add rows to one of some tables. Raises ValueError where it has another value for a name."""
    for name, value in rows.items():
        if tables.setdefault(table, {}).setdefault(name, value) != value:
            raise ValueError(f"the parts disagree about {table} {name}")


def _references(numbers: Iterable[int]) -> bytes:
    return b" ".join(b"%d 0 R" % number for number in numbers)


def _string(text: bytes) -> bytes:
    found: bytes = pikepdf.String(text).unparse()
    return found


def _leaves(tree: Any, key: str) -> Iterator[tuple[Any, Any]]:
    """The pairs of a tree of names or numbers."""
    for kid in tree.get("/Kids", []):
        yield from _leaves(kid, key)
    flat = list(tree.get(key, []))
    yield from zip(flat[::2], flat[1::2], strict=True)
