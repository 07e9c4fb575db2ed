"""Sheets of an exam without a whole build."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from msgspec.structs import replace

from variantgen.builder.build_spec import BuildSpec, preloaded
from variantgen.builder.draw_stage import draw_all
from variantgen.builder.stored import StoredSheets
from variantgen.builder.unfinished import unfinished
from variantgen.builder.workers import InlineWorkers
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.typst.typesetter import typesetter


def drawn_sheets(exam: Exam, students: Sequence[Student]) -> tuple[Sheet, ...]:
    """The sheets of some students as a build draws them, without any output."""
    spec = BuildSpec.of(exam)
    with (
        tempfile.TemporaryDirectory() as name,
        typesetter() as engine,
        unfinished(Path(name) / "out", {}, False, ()) as parts,
        preloaded(spec, exam, engine),
    ):
        draw_all(exam, students, spec, parts, InlineWorkers(), lambda stage, done, total: None)
        # Their problems are read when they are asked for, and here the parts are gone at the end.
        return tuple(replace(sheet, items=tuple(sheet.items)) for sheet in StoredSheets(exam, students, parts))
