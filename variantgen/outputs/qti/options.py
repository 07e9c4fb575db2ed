"""What an exam file may say of a package for a learning platform."""

from __future__ import annotations

from dataclasses import dataclass

from variantgen.outputs.qti.figures import FORMS
from variantgen.tables import Table


@dataclass(frozen=True)
class Options:
    """``figures``: the form of pictures; ``drawn``: one test that draws a sheet for each student, not a test for each.

    ``names``: titles have the names of students.
    """

    figures: str = FORMS[0]
    drawn: bool = True
    names: bool = False


def read_options(table: Table, key: str, drawn: str, own: str, usual: str) -> Options:
    """The options of a format, of which ``key`` says ``drawn`` or ``own``: one test for all, or one for each student;
    ``usual`` if the file does not say.

    Mistakes are noted in the table, which may have more keys.
    """
    figures = table.choice("figures", FORMS, FORMS[0])
    chosen = table.choice(key, (drawn, own), usual)
    names = table.take("names", bool, False)
    if names and chosen != own:
        remedy = f'{key} = "{own}" makes one for each student'
        table.problem("students would read the names of others", "names", names, remedy)
    return Options(figures, chosen == drawn, names)
