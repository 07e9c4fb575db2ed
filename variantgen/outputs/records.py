"""Files for machines: the key as CSV and the manifest as JSON."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from variantgen.exam.blueprint import Exam
from variantgen.exam.record import SCHEMA, made_with
from variantgen.exam.sheets import Item, Sheet
from variantgen.version import VERSION

# Where a spreadsheet would begin a formula: at the start of a cell, be there blanks or not. Where the decimal mark is a
# comma, spreadsheets part cells at semicolons, and some do at tabs, whatever the quotes are.
_FORMULA = re.compile("(^|[;\t\r\n])(?=[\\s\u200b\u2060\ufeff]*[=+\\-@＝＋－＠]|[\t\r])")


def key_csv(sheets: Sequence[Sheet]) -> str:
    """The key with one row per answer; text that a spreadsheet would run as a formula gets an apostrophe.

    Commas part the cells and numbers have points, in every language: it is a file for programs. A spreadsheet that
    guesses what cells are takes ids like ``007`` and ``1E5`` for numbers.
    """
    out = io.StringIO(newline="")
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(
        ["id", "name", "group", "code", "problem", "family", "quantity", "value", "unit", "tolerance", "unnoticed"]
    )
    for sheet in sheets:
        who = [_safe(text) for text in (sheet.student.id, sheet.student.name, sheet.student.group)]
        for item in sheet.items:
            for answer in item.answers:
                writer.writerow(
                    [
                        *who,
                        sheet.code,
                        item.task.number,
                        item.variant.family.name,
                        answer.quantity.name,
                        repr(answer.value),
                        answer.unit.name,
                        repr(answer.tolerance),
                        "; ".join(answer.unnoticed),
                    ]
                )
    return out.getvalue()


def _safe(text: str) -> str:
    return _FORMULA.sub(r"\1'", text)


def manifest(exam: Exam, sheets: Sequence[Sheet], seed: str, redrawn: Sequence[str], files: Mapping[str, str]) -> str:
    """Everything that is needed to make each sheet again, as JSON.

    ``made_with`` says what a sheet depends on besides this file; ``files`` has the SHA-256 of the other files.
    """
    content = {
        "schema": SCHEMA,
        "program": {"name": "variantgen", "version": VERSION},
        "made_with": made_with(exam),
        "exam": {
            "title": exam.title,
            "id": exam.build_id(seed),
            "hash": exam.hash,
            "text": exam.text,
            "language": exam.language,
            "tolerance": exam.tolerance.floor,
            "tolerance_ceiling": exam.tolerance.ceiling,
            "mistakes_screened": exam.tolerance.mistakes,
        },
        "solutions": asdict(exam.solutions) if exam.solutions.wanted else None,
        "notation": asdict(exam.notation),
        "formats": list(exam.formats),
        "seed": seed,
        "redrawn": list(redrawn),
        "students": [
            {
                "id": sheet.student.id,
                "name": sheet.student.name,
                "group": sheet.student.group,
                "code": sheet.code,
                "problems": [_problem(exam, item) for item in sheet.items],
            }
            for sheet in sheets
        ],
        "files": dict(files),
    }
    return json.dumps(content, ensure_ascii=False, indent=1) + "\n"


def _problem(exam: Exam, item: Item) -> dict[str, Any]:
    variant = item.variant
    return {
        "problem": item.task.number,
        "family": variant.family.name,
        "form": variant.form.name,
        **({"nice": True} if item.task.nice else {}),
        "pose": {"mirrored": variant.sense < 0, "quarter_turns": variant.turns},
        "attempt": variant.attempt,
        "methods": list(item.task.methods or variant.family.solution) if exam.solutions.wanted else [],
        "parameters": {
            name: {"value": str(value), "unit": parameter.unit.name}
            if parameter.unit
            else {"value": variant.word(name)}
            for name, value in variant.printed.items()
            for parameter in (variant.form.parameters[name],)
        },
        "answers": [
            {
                "quantity": a.quantity.name,
                "value": a.value,
                "unit": a.unit.name,
                "tolerance": a.tolerance,
                "relative_tolerance": round(a.margin, 6),
                **({"unnoticed": list(a.unnoticed)} if a.unnoticed else {}),
            }
            for a in item.answers
        ],
    }
