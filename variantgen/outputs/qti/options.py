"""What an exam file may say of a package for a learning platform."""

from __future__ import annotations

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.figure.drawing import Drawing
from variantgen.outputs.html.fragments import notices_html
from variantgen.outputs.html.writing import HtmlWriting, in_text
from variantgen.outputs.platforms.figure_files import UsedFigures
from variantgen.outputs.qti.package_images import FORMS
from variantgen.tables import Table
from variantgen.wording.mathml import to_mathml

MATHML, HTML = "mathml", "html"


class PackageOptions(Struct, frozen=True):
    """``figures``: the form of pictures; ``formulas``: how those of solutions are written.

    ``drawn``: one test that draws a sheet for each student, not a test for each. ``names``: titles have the names of
    students.
    """

    figures: str = FORMS[0]
    formulas: str = MATHML
    drawn: bool = True
    names: bool = False

    def writing(self, figures: UsedFigures) -> HtmlWriting:
        """How solutions are written."""
        return HtmlWriting(to_mathml if self.formulas == MATHML else in_text, figures.image)


def introduction(exam: Exam) -> str:
    """What the exam says to everybody, as HTML with formulas that every platform shows."""
    return notices_html(exam, HtmlWriting(in_text, _no_figure))


def _no_figure(drawing: Drawing, millimetres: float, caption: str) -> str:
    raise AssertionError("an introduction has no figures")


def read_options(table: Table, key: str, words: tuple[str, str], usual: PackageOptions) -> PackageOptions:
    """The options of a format; the first of the ``words`` of ``key`` is one test for all, the other one for each.

    Mistakes are noted in the table, which may have more keys.
    """
    drawn, own = words
    figures = table.choice("figures", FORMS, FORMS[0])
    formulas = table.choice("formulas", (MATHML, HTML), usual.formulas)
    chosen = table.choice(key, words, drawn if usual.drawn else own)
    names = table.take("names", bool, False)
    if names and chosen != own:
        remedy = f'{key} = "{own}" makes one for each student'
        table.problem("students would read the names of others", "names", names, remedy)
    return PackageOptions(figures, formulas, chosen == drawn, names)
