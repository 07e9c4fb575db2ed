"""Displays of a notebook: problems, solutions, motions and tables as HTML, curves as SVG; nothing has to be installed.

:func:`variantgen.notebook.display` finds the functions of this module by their names.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from html import escape
from typing import Any

import numpy as np
from markupsafe import Markup

from variantgen.arrays.batch import Batch
from variantgen.arrays.columns import motion_columns
from variantgen.arrays.turn import DriverTurn
from variantgen.errors import InputError
from variantgen.exam.content import Written, with_figures
from variantgen.families.asking import read_ask
from variantgen.figure.build import statement_figure
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.turn.sweep import SweepEnd
from variantgen.outputs.html.articles import page_writing
from variantgen.outputs.html.fragments import solution_html, statement_html
from variantgen.outputs.html.pages import fragment
from variantgen.outputs.html.writing import markup
from variantgen.outputs.single.chart import Abscissa, ChartCurve, chart
from variantgen.outputs.single.explanation import Explanation
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

_TEMPLATE = "notebook.html.j2"
_MILLIMETRES = 90.0  # width of the figure of a problem
_ROWS = 5  # of a batch
_NOTHING = 1e-12


def variant_html(variant: Variant) -> str:
    """The problem in English, for what its form asks, with its figure; of a variant that is not solved its data."""
    motion = solve_variants([variant], 2)
    if not motion.solved[0]:
        return _shown(repr(variant), remark=Outcome(int(motion.outcome[0])).text)
    language, asked = load_language("en"), read_ask(variant.form)
    writing = page_writing(_name(variant))
    figure = writing.figure(statement_figure(variant, motion, 0, asked, language))(1.0, _MILLIMETRES)
    parts = [figure]
    with suppress(InputError):  # there may be no statement in this language
        parts.insert(0, markup(statement_html(statement(variant, asked, language), language, writing)))
    return _shown(variant.family.title("en"), parts, remark=repr(variant)[1:-1])


def explanation_html(explanation: Explanation) -> str:
    """The worked solution in its language, with its figures."""
    variant, asked, language = explanation.variant, explanation.asked, explanation.language
    motion = solve_variants([variant], max(quantity.order for quantity in asked))
    title = variant.family.title(language.name)
    try:
        (solved,) = with_figures([Written(variant, asked, (motion, 0), explanation.text)], language)
    except InputError:  # there may be no statement in this language
        return _shown(title, [markup(f"<pre>{escape(str(explanation))}</pre>")])
    writing = page_writing(_name(variant, language.name, *explanation.options.methods))
    problem = statement_html(solved.statement, language, writing)
    return _shown(title, [markup(problem), markup(solution_html(solved, language, writing))])


def motion_html(motion: Motion) -> str:
    """The first variant of a motion in SI: positions, velocities, accelerations of points, rotations of bodies."""
    solved = int(np.count_nonzero(motion.solved))
    remark = f"the first of {motion.size}, {solved} of them solved" if motion.size > 1 else ""
    if not motion.solved[0]:
        return _shown("Motion", remark=f"{Outcome(int(motion.outcome[0])).text} {remark}".strip())
    columns, _ = motion_columns(motion.take(np.array([0])), "m")
    value = _rounded({name: float(column[0]) for name, column in columns.items()})
    patterns = {"x, m": "x_{}", "y, m": "y_{}"}
    for letter, unit in (("v", "m/s"), ("a", "m/s²")):
        patterns |= {f"{letter}.{part}, {unit}": f"{letter}_{{}}.{part}" for part in "xy"}
    rotations = {"ω, rad/s": "omega_{}", "ε, rad/s²": "epsilon_{}"}
    tables = [_by_name("point", motion.z, patterns, value), _by_name("body", motion.omega, rotations, value)]
    return _shown("Motion", tables=[table for table in tables if table["rows"]], remark=remark)


def batch_html(batch: Batch) -> str:
    """The first variants of a batch as a table, in printed units."""
    table = batch.table()
    heads = ["", *(f"{name}, {_unit(batch.units[name])}" if name in batch.units else name for name in table)]
    rows = [[str(i), *(_cell(column[i]) for column in table.values())] for i in range(min(_ROWS, len(batch)))]
    more = f"{len(rows)} of {len(batch)} variants" if len(batch) > len(rows) else ""
    return _shown(_title(batch), tables=[{"heads": heads, "rows": rows}], remark=more)


def turn_svg(turn: DriverTurn) -> str:
    """Curves of what the form asks over the way, as SVG, with a line at the instant of the problem."""
    length = turn.variant.family.length_unit
    found = []
    for quantity in dict.fromkeys(q.whole for q in read_ask(turn.variant.form) if q.is_vector or q.is_rotation):
        unit = quantity.unit(length)
        values = np.where(turn.clear, unit.from_si(quantity.value(turn.motion)), np.nan)
        found.append(ChartCurve(f"{quantity.name}, {_unit(unit.name)}", values))
    bounded = turn.ends[0] is not SweepEnd.TURN, turn.ends[1] is not SweepEnd.TURN
    title = f"{turn.name}, {_unit(turn.unit)}"
    return chart(Abscissa(turn.values, title, turn.instant, turn.unit == "deg", bounded), found, load_language("en"))


def _title(batch: Batch) -> str:
    form = f", {batch.form.name}" if batch.form.name else ""
    return f"{batch.family.title('en')} ({batch.family.name}{form})"


def _by_name(
    head: str, names: Iterable[str], patterns: Mapping[str, str], value: Mapping[str, str]
) -> dict[str, Sequence[Any]]:
    """A table with a row for each name and the columns of which anything is known."""
    listed = list(names)
    known = {title: p for title, p in patterns.items() if any(p.format(name) in value for name in listed)}
    rows = [[name, *(value.get(pattern.format(name), "") for pattern in known.values())] for name in listed]
    return {"heads": [head, *known], "rows": rows if known else []}


def _rounded(numbers: Mapping[str, float]) -> dict[str, str]:
    """Numbers with five digits; what is left of a zero by rounding is zero, beside the largest of its kind."""
    largest: dict[str, float] = {}
    for name, number in numbers.items():
        kind = name.partition("_")[0]
        largest[kind] = max(largest.get(kind, 0.0), abs(number))
    return {
        name: f"{0.0 if abs(number) < _NOTHING * largest[name.partition('_')[0]] else number:.5g}"
        for name, number in numbers.items()
    }


def _cell(value: Any) -> str:
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def _unit(name: str) -> str:
    return name.replace("^2", "²").replace("deg", "°")


def _name(variant: Variant, *parts: str) -> str:
    """A name for the ids of figures: the same display has the same ones, others have others."""
    return digest(repr(variant), variant.sense, variant.turns, *parts).hex()[:12]


def _shown(
    title: str,
    parts: Sequence[Markup] = (),
    tables: Sequence[Mapping[str, Any]] = (),
    remark: str = "",
) -> str:
    return fragment(_TEMPLATE, title=title, parts=parts, tables=tables, remark=remark)
