"""Whether answers can be computed, marked and explained: what ``solve``, ``--explain`` and ``build`` would do."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from variantgen.errors import VariantgenError
from variantgen.families.quantities import Quantity
from variantgen.figure.build import statement_figure
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.single import asked_quantities, one_variant, solution_document
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import languages, load_language
from variantgen.wording.solution.explain import UnexplainedError, explain


def scene_faults(name_or_path: str, folders: tuple[Path, ...] = ()) -> Iterator[str]:
    """What is wrong with a scene in which nothing varies. Raises InputError for a scene that cannot be read."""
    variant = one_variant(name_or_path, folders=folders)
    document = solution_document(variant)
    outcome = Outcome[document["outcome"].upper()]
    if outcome is not Outcome.SOLVED:
        yield outcome.text
        return
    asked = asked_quantities(variant)
    motion = solve_variants([variant], max(quantity.order for quantity in asked))
    yield from explanation_faults(variant, motion, 0, asked)
    try:
        statement_figure(variant, motion, 0, asked, load_language(languages()[0]))
    except VariantgenError as error:
        yield f"the figure cannot be drawn: {error}"


def explanation_faults(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity]) -> Iterator[str]:
    """Why a variant of a solved batch has no worked solution, if it has none."""
    for language in languages():
        try:
            explain(variant, motion, index, asked, load_language(language))
        except UnexplainedError as error:
            yield str(error)
            return
        except VariantgenError as error:
            yield f"the worked solution ({language}): {error}"
