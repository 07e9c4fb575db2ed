"""The structure of a tagged PDF (ISO 32000-1, 14.7), joined of those of its parts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pikepdf

from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.writer import PdfWriter

_TABLES = ("/RoleMap", "/ClassMap")


class Structure:
    """One document element with what is in those of all parts, in their order."""

    def __init__(self, writer: PdfWriter) -> None:
        self._writer = writer
        self._root, self._document = writer.reserve(), writer.reserve()
        self._entries = b""  # those of the document element, but for its place
        self._children: list[bytes] = []
        self._parents: list[bytes] = []
        self._names: dict[bytes, bytes] = {}
        self._tables: dict[str, dict[str, bytes]] = {}
        self._namespaces: dict[bytes, int] = {}
        self._parts = 0
        self.next_key = 0

    def add(self, part: PageCopier) -> None:
        """Take the structure of a part; its pages have been taken before.

        Raises ValueError for a structure that the typesetting engine does not write.
        """
        root = part.source.Root.StructTreeRoot
        (document,) = root.K if isinstance(root.K, pikepdf.Array) else (root.K,)
        if document.S != "/Document":
            raise ValueError(f"expected a document as the root of the structure, found {document.S}")
        part.new[root.objgen[0]], part.new[document.objgen[0]] = self._root, self._document
        self._share_namespaces(part, root)
        self._rename(root)
        if not self._parts:
            own = pikepdf.Dictionary({key: value for key, value in document.items() if key not in {"/K", "/P"}})
            self._entries = part.text(own).strip().removeprefix(b"<<").removesuffix(b">>")
        children = document.K if isinstance(document.K, pikepdf.Array) else [document.K]
        self._children += [part.text(child) for child in children]
        self._parents += [
            b"%d %s" % (key + self.next_key, part.text(value)) for key, value in _leaves(root.ParentTree, "/Nums")
        ]
        self._names.update((bytes(name), part.text(value)) for name, value in self._named(root))
        for table in _TABLES:
            for name, value in root.get(table, {}).items():
                known = self._tables.setdefault(table, {}).setdefault(name, part.text(value))
                if known != part.text(value):
                    raise ValueError(f"the parts disagree about {table} {name}")
        self.next_key += int(root.ParentTreeNextKey)
        self._parts += 1

    def write(self) -> int:
        """Write the root and the document; the number of the root."""
        self._writer.put(
            self._document, b"<<%s/P %d 0 R/K[%s]>>" % (self._entries, self._root, b" ".join(self._children))
        )
        parents = self._writer.add(b"<</Nums[%s]>>" % b" ".join(self._parents))
        entries = b"/Type/StructTreeRoot/K %d 0 R" % self._document
        entries += b"/ParentTree %d 0 R/ParentTreeNextKey %d" % (parents, self.next_key)
        if self._names:
            pairs = (pikepdf.String(name).unparse() + b" " + value for name, value in sorted(self._names.items()))
            entries += b"/IDTree %d 0 R" % self._writer.add(b"<</Names[%s]>>" % b" ".join(pairs))
        for table, rows in self._tables.items():
            body = b"".join(pikepdf.Name(name).unparse() + b" " + value for name, value in rows.items())
            entries += b"%s<<%s>>" % (table.encode(), body)
        if self._namespaces:
            entries += b"/Namespaces[%s]" % b" ".join(b"%d 0 R" % number for number in self._namespaces.values())
        self._writer.put(self._root, b"<<%s>>" % entries)
        return self._root

    def _share_namespaces(self, part: PageCopier, root: Any) -> None:
        """Let all parts use one object for a namespace."""
        for space in root.get("/Namespaces", []):
            said = space.unparse(resolved=True)
            if said in self._namespaces:
                part.new[space.objgen[0]] = self._namespaces[said]
            else:
                part.text(pikepdf.Array([space]))
                self._namespaces[said] = part.new[space.objgen[0]]

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
        return pikepdf.String(b"%d." % self._parts + bytes(name))

    @staticmethod
    def _named(root: Any) -> Iterator[tuple[Any, Any]]:
        """The elements that have an identifier, with it."""
        if "/IDTree" in root:
            yield from ((element.ID, element) for _, element in _leaves(root.IDTree, "/Names"))


def _leaves(tree: Any, key: str) -> Iterator[tuple[Any, Any]]:
    """The pairs of a tree of names or numbers."""
    for kid in tree.get("/Kids", []):
        yield from _leaves(kid, key)
    flat = list(tree.get(key, []))
    yield from zip(flat[::2], flat[1::2], strict=True)
