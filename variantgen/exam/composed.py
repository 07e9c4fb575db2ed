"""Composed families, accepted like those of the catalogue and with a worked case."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from msgspec.structs import replace

from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.solution_figures import solution_figure_faults
from variantgen.exam.work.wanted_work import Span
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.quantities import Quantity, motion_order
from variantgen.families.reading.files import CASES
from variantgen.figure.build import statement_figure
from variantgen.figure.inspection.faults import figure_faults
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.verification.verify import recompute
from variantgen.methods.hand.work import work_of
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.natural_answers import natural_answers
from variantgen.synthesis.compose import MOST_TRIES, compose
from variantgen.synthesis.statement_text import composed_languages
from variantgen.synthesis.structures import Structure, moving_links
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.language import Language, load_language
from variantgen.wording.solution.explain import explain
from variantgen.wording.statement import statement

_LOOKED_AT = 3  # variants whose figures are drawn
_COUNTED = 9  # variants whose work is counted where it matters
_ROUGHLY = 1.25  # one variant tells the work so well
_TRIES = 4  # layouts of a structure whose work matters
_LINE, _MOST_LINES = 64, {3: 8, 4: 8, 5: 8, 6: 9, 7: 10}  # characters of a line beside a figure; lines by moving links
_KEY = ("compose", 0)  # in the place of student and problem


def _drawn(family: Family, count: int) -> list[Variant]:
    keys = [(str(seed), *_KEY) for seed in range(count)]
    return draw(replace(family, name="composed"), None, keys, screening=AnswerTolerances())


class _Examination:
    """Says what is wrong with a family; ``calculations`` is what a variant of the last one takes."""

    def __init__(self, links: int, spans: Mapping[int, Span]) -> None:
        self._most_lines, self._spans, self.calculations = _MOST_LINES[links], spans, 0

    def __call__(self, family: Family) -> str:
        """The work, figures of the statement, figures of the solution; nothing where all is well."""
        variants = _drawn(family, _LOOKED_AT)
        asked = read_ask(variants[0].form)
        motion = solve_variants(variants, 2)
        self.calculations = _calculations(variants, motion, asked)
        if self._spans and not self._is_outside(asked, _ROUGHLY):
            more = draw(replace(family, name="composed"), None, [(str(i), "work", 0) for i in range(_COUNTED)])
            self.calculations = _calculations(more, solve_variants(more, 2), asked)
        if self._is_outside(asked, 1.0):
            return f"it takes {self.calculations} calculations"
        return next(_faults(variants, motion, asked), "")

    def unfit(self, variant: Variant, asked: Sequence[Quantity]) -> str:
        """Whether the statement of one variant is too long, or its work far from what is wanted."""
        if any(_lines(variant, asked, load_language(name)) > self._most_lines for name in composed_languages()):
            return "the statement is too long"
        if not self._spans:
            return ""
        self.calculations = _calculations([variant], solve_variants([variant], 2), asked)
        return f"it takes about {self.calculations} calculations" if self._is_outside(asked, _ROUGHLY) else ""

    def _is_outside(self, asked: Sequence[Quantity], factor: float) -> bool:
        if not self._spans:
            return False
        if (order := max(1, motion_order(asked))) not in self._spans:
            return True
        least, most = self._spans[order]
        return not least / factor <= self.calculations <= most * factor


def _lines(variant: Variant, asked: Sequence[Quantity], language: Language) -> int:
    text = statement(variant, asked, language).text
    return -(-len("".join(part if isinstance(part, str) else to_plain(part) for part in text)) // _LINE)


def _calculations(variants: Sequence[Variant], motion: Motion, asked: Sequence[Quantity]) -> int:
    """What the middle one of some variants takes."""
    works = [work_of(natural_answers(task_of(v, motion, i, asked)).values()) for i, v in enumerate(variants)]
    return sorted(work.calculations for work in works)[len(works) // 2]


def _faults(variants: Sequence[Variant], motion: Motion, asked: Sequence[Quantity]) -> Iterator[str]:
    """What is wrong with figures of the statement or of the solution. Raises InputError for a bad statement."""
    for name in composed_languages():
        language = load_language(name)
        statement(variants[0], asked, language)
        for place, variant in enumerate(variants):
            yield from map(str, figure_faults(statement_figure(variant, motion, place, asked, language)))
        for variant in variants:
            alone = solve_variants([variant], 2)
            text = explain(variant, alone, 0, asked, language)
            yield from solution_figure_faults(variant, alone, asked, language, text)


def _case(family: Family) -> str:
    """``cases.toml`` with the first variant, worked out by the independent computation."""
    variant = _drawn(family, 1)[0]
    form = variant.form
    motion = replace(variant, sense=1, turns=0).motion()
    again = recompute(motion)
    own = replace(
        motion,
        v={**motion.v, **again.v}, a={**motion.a, **again.a},
        omega={**motion.omega, **again.omega}, epsilon={**motion.epsilon, **again.epsilon},
    )  # fmt: skip
    exact = []
    for quantity in read_ask(form):
        value = quantity.unit(family.length_unit).from_si(float(quantity.value(own)[0]))
        exact.append(f"{quantity.name} = {value:.9f}")
    given = [
        f'{n} = "{variant.word(n)}"' if p.unit is None else f"{n} = {variant.printed[n]}"
        for n, p in form.parameters.items()
    ]
    return "\n".join(
        [
            "# Worked out by moving the closed chain through small steps of time and differentiating its positions:",
            "# no construction, no velocity equation of the solver. Put results of your own calculation beside it.",
            "[[case]]",
            'id = "moved-1"',
            'source = "the chain moved in time and differentiated numerically"',
            f"set = {{ {', '.join(given)} }}",
            f"exact = {{ {', '.join(exact)} }}",
            "",
        ]
    )


def write(
    structure: Structure,
    seed: object,
    folder: Path,
    spans: Mapping[int, Span] | None = None,
    with_case: bool = True,
) -> int:
    """Write a composed family to a folder that is not there yet, complete or not at all; returns its calculations.

    ``spans``: how many calculations a variant of it takes where accelerations are asked (2) and where velocities alone
    are (1), which are asked if that meets it. ``with_case``: with a worked case, whose last digits may differ between
    machines. Raises InputError.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    examination = _Examination(moving_links(structure), spans or {})
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as scratch:
        made = Path(scratch) / folder.name
        made.mkdir()
        orders, tries = (tuple(spans), _TRIES) if spans else ((2,), MOST_TRIES)
        found = compose(
            structure, seed, AnswerTolerances(), made, examination, examination.unfit, orders, tries, bool(spans)
        )
        files = found.files | ({CASES: _case(found.family)} if with_case else {})
        for name, text in files.items():
            (made / name).write_text(text, "utf-8")
        made.rename(folder)
    return examination.calculations
