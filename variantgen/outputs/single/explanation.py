"""The worked solution of a variant at hand: printed as text, saved as a page (``variantgen.explain(variant)``)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import cast

from msgspec import Struct

from variantgen.families.asking import read_ask
from variantgen.families.quantities import Quantity, motion_order
from variantgen.methods.solution_options import Depth, SolutionOptions
from variantgen.notebook import display
from variantgen.outputs.single.solution_page import write_explained
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import Language, load_language
from variantgen.wording.notation import notation_of
from variantgen.wording.solution import explain as wording
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.plain import plain_solution


class Explanation(Struct, frozen=True):
    """A worked solution of a variant; ``text`` holds its parts."""

    variant: Variant
    asked: tuple[Quantity, ...]
    language: Language
    options: SolutionOptions
    text: SolutionText

    def __str__(self) -> str:
        return plain_solution(self.text, self.language)

    def __repr__(self) -> str:
        form = f"/{self.variant.form.name}" if self.variant.form.name else ""
        names = ", ".join(quantity.name for quantity in self.asked)
        return f"<Explanation of {self.variant.family.name}{form}: {names}; print it, or save it>"

    def _repr_html_(self) -> str:
        """What a notebook shows: the problem and its solution with figures."""
        return display("explanation_html", self)

    def save(self, path: str | Path, remark: str = "") -> None:
        """Write the problem with its solution and figures as a page: .pdf, .png or .svg. Raises InputError."""
        write_explained(self.variant, self.asked, self.language, self.options, Path(path), remark)


def explain(
    variant: Variant,
    language: str = "en",
    methods: Sequence[str] = (),
    depth: str = "full",
    ask: Sequence[str] = (),
    notation: Sequence[str] = (),
    true_scale: bool = False,
) -> Explanation:
    """The solution for the asked quantities (none: those of the form) by methods (none: the natural ones).

    ``depth`` is ``answers``, ``short`` or ``full``; ``notation`` are words like ``alpha`` (see
    :mod:`variantgen.wording.notation`); with ``true_scale`` no vector of a figure is lengthened to be seen. Raises
    InputError, and UnexplainedError where no method leads to what is asked.
    """
    asked = tuple(read_ask(variant.form, tuple(ask) or None))
    options = SolutionOptions(tuple(methods), cast(Depth, depth), true_scale)
    spoken = load_language(language, notation_of(notation))
    motion = solve_variants([variant], motion_order(asked))
    return Explanation(variant, asked, spoken, options, wording.explain(variant, motion, 0, asked, spoken, options))
