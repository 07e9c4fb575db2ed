"""An exam as a package of QTI: an item for each problem of each student, tests of them, the manifest.

Either one test draws a sheet for each student, all its problems together, or there is a test for each student.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.outputs import formats
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.platforms.questions import questions
from variantgen.outputs.platforms.text import one_line
from variantgen.outputs.qti.dialect import Dialect
from variantgen.outputs.qti.item import QtiItems, identifier
from variantgen.outputs.qti.options import PackageOptions, introduction, read_options
from variantgen.outputs.qti.outline import Outline
from variantgen.outputs.qti.package import MANIFEST, Package, contents, indexes, pack, package
from variantgen.outputs.qti.package_images import files, package_figures
from variantgen.outputs.qti.xml_tree import document, element, images
from variantgen.tables import Table

_PACKAGE = "package"  # the target of the pieces
Sheet = dict[str, Any]  # of the index: its code, the name of the student, the items with their files


def read_table(table: Table) -> PackageOptions:
    """The table of a format of QTI."""
    found = read_options(table, "tests", ("draw", "students"), PackageOptions())
    table.finish()
    return found


def make(part: Chunk, dialect: Dialect) -> Iterator[Fragment]:
    """The items of a few students with their figures."""
    options: PackageOptions = formats.options(part.exam, dialect.name)
    figures = package_figures(part.engine, options.figures)
    items = QtiItems(dialect, part.exam, figures, options)
    documents: dict[str, bytes] = {}
    sheets: dict[str, Sheet] = {}
    for question in questions(part):
        item, name = items.item(question), identifier(question)
        documents[_file(name)] = document(item)
        student = question.sheet.student
        sheet = sheets.setdefault(question.sheet.code, {"code": question.sheet.code, "name": student.name, "items": []})
        sheet["items"].append({"name": name, "files": images(item)})
    yield Fragment(_PACKAGE, pack({**documents, **files(figures)}, list(sheets.values())), ".zip")


def finish(whole: WholeExam, dialect: Dialect) -> None:
    """The package."""
    options: PackageOptions = formats.options(whole.exam, dialect.name)
    writer = _Writer(dialect, whole.exam, whole.exam.build_id, options, whole.pieces[_PACKAGE])
    with package(whole.folder / f"{dialect.name}.zip") as made:
        writer.write(made)


class _Writer(Struct, frozen=True):
    """Writes tests and manifest from the indexes of the pieces."""

    dialect: Dialect
    exam: Exam
    build: str
    options: PackageOptions
    pieces: Sequence[Path]

    def write(self, made: Package) -> None:
        """Manifest, tests, items and figures."""
        with made.outline(MANIFEST) as outline:
            self._manifest(outline)
        for name, title, sheets in self._tests():
            with made.outline(_file(name)) as outline:
                self._test(outline, name, title, sheets)
        for file, content in contents(self.pieces):
            made.add(file, content)

    def _sheets(self) -> Iterable[Sheet]:
        return chain.from_iterable(indexes(self.pieces))

    def _tests(self) -> Iterator[tuple[str, str, Iterable[Sheet]]]:
        """Name, title and sheets of each test."""
        if self.options.drawn:
            yield f"t{self.build}", one_line(self.exam.title), self._sheets()
            return
        for sheet in self._sheets():
            named = f", {sheet['name']}" if self.options.names and sheet["name"] else ""
            yield (
                f"t{self.build}-{sheet['code']}",
                one_line(f"{self.exam.title}. {self._variant(sheet)}{named}"),
                [sheet],
            )

    def _variant(self, sheet: Sheet) -> str:
        return f"{self.exam.spoken.words('key')['variant']} {sheet['code']}"

    def _manifest(self, outline: Outline) -> None:
        schema, version = self.dialect.package
        with outline.inside("manifest", {**self.dialect.manifest(), "identifier": f"m{self.build}"}):
            outline.add(
                element(
                    "metadata",
                    {},
                    element("schema", {}, schema),
                    element("schemaversion", {}, version),
                    _about(one_line(self.exam.title), self.exam.language),
                )
            )
            outline.add(element("organizations"))
            with outline.inside("resources"):
                for name, _, sheets in self._tests():
                    self._test_resource(outline, name, sheets)
                for item in (item for sheet in self._sheets() for item in sheet["items"]):
                    outline.add(_resource(item["name"], self.dialect.item, _file(item["name"]), item["files"]))

    def _test_resource(self, outline: Outline, name: str, sheets: Iterable[Sheet]) -> None:
        file = _file(name)
        with outline.inside("resource", {"identifier": name, "type": self.dialect.test, "href": file}):
            outline.add(element("file", {"href": file}))
            for item in (item for sheet in sheets for item in sheet["items"]):
                outline.add(element("dependency", {"identifierref": item["name"]}))

    def _test(self, outline: Outline, name: str, title: str, sheets: Iterable[Sheet]) -> None:
        make, tag, attributes = self.dialect.element, self.dialect.tag, self.dialect.attributes
        explained = "true" if self.exam.solutions.wanted else "false"
        control = {"maxAttempts": "1", "showFeedback": explained, "allowReview": "true", "showSolution": "false"}
        part = {"identifier": "part", "navigationMode": "nonlinear", "submissionMode": "individual"}
        drawn = {"identifier": "sheets", "title": one_line(self.exam.title), "visible": "false"}
        with outline.inside(
            tag("assessmentTest"), {**self.dialect.root(), **attributes({"identifier": name, "title": title})}
        ):
            for outcome in ("SCORE", "MAXSCORE"):
                outline.add(self._outcome(outcome))
            with outline.inside(tag("testPart"), attributes(part)):
                outline.add(make("itemSessionControl", control))
                with outline.inside(tag("assessmentSection"), attributes(drawn)):
                    if self.options.drawn:
                        outline.add(make("selection", {"select": "1"}))
                    for sheet in sheets:
                        outline.add(self._section(sheet))
            outline.add(make("outcomeProcessing", {}, *(self._total(outcome) for outcome in ("SCORE", "MAXSCORE"))))

    def _section(self, sheet: Sheet) -> Element:
        """The problems of a sheet, which stay together and in order."""
        make = self.dialect.element
        own = {"identifier": f"s{sheet['code']}", "title": self._variant(sheet), "visible": "true"}
        refs = ({"identifier": item["name"], "href": _file(item["name"])} for item in sheet["items"])
        parts = [*self._introduction(), *(make("assessmentItemRef", ref) for ref in refs)]
        return make("assessmentSection", {**own, "keepTogether": "true"}, *parts)

    def _introduction(self) -> Iterator[Element]:
        """What the exam says to everybody, if it says anything."""
        if self.exam.notices:
            yield self.dialect.rubric(element("div", {}, *self.dialect.html(introduction(self.exam))))

    def _outcome(self, name: str) -> Element:
        make = self.dialect.element
        declared = {"identifier": name, "cardinality": "single", "baseType": "float"}
        return make("outcomeDeclaration", declared, make("defaultValue", {}, make("value", {}, "0")))

    def _total(self, name: str) -> Element:
        make = self.dialect.element
        own = make("testVariables", {"variableIdentifier": name})
        return make("setOutcomeValue", {"identifier": name}, make("sum", {}, own))


def _about(title: str, language: str) -> Element:
    """Title and language as learning object metadata."""
    named = element("imsmd:title", {}, element("imsmd:string", {"language": language}, title))
    return element("imsmd:lom", {}, element("imsmd:general", {}, named, element("imsmd:language", {}, language)))


def _resource(name: str, kind: str, file: str, more: Sequence[str]) -> Element:
    return element(
        "resource",
        {"identifier": name, "type": kind, "href": file},
        *(element("file", {"href": one}) for one in (file, *more)),
    )


def _file(name: str) -> str:
    """The file of an item or a test: in the root, so that no reference leads upwards, which some platforms refuse."""
    return f"{name}.xml"
