"""Strategies of Hypothesis: variants of families, textbook mechanisms, random chains of dyads.

Hypothesis is imported when a strategy is made; it comes with the extra ``testing``.
"""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from variantgen.arrays.batch import batch
from variantgen.errors import InputError, Problem, missing_package
from variantgen.families.family import Family
from variantgen.families.reading.load import load_family
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.dyads import chain
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, spool, wheel
from variantgen.variants.variant import Variant

if TYPE_CHECKING:
    from hypothesis.strategies import SearchStrategy

_LEAST_TRANSMISSION = 0.2  # away from dead points, where every solver loses its digits
_SEEDS = 2**32


def variants(family: str | PathLike[str] | Family, **options: Any) -> SearchStrategy[Variant]:
    """Valid variants of a family, of the catalogue or of your own, in all forms that have what the options name.

    ``options`` are those of :func:`variantgen.batch`: ``form``, ``ask``, ``set``, ``range``, ... (but ``n`` and
    ``seed``, which Hypothesis chooses). Raises InputError where no form has them, and ToolMissingError without
    Hypothesis.
    """
    st = _strategies()
    chosen_here = [name for name in ("n", "seed") if name in options]
    if chosen_here:
        message, remedy = "is chosen by Hypothesis, one variant after the other", "leave it out"
        raise InputError(Problem(message, key=name, value=repr(options[name]), remedy=remedy) for name in chosen_here)
    batch(family, 1, **options)  # a mistake is told here, and not for an example
    whole = family if isinstance(family, Family) else load_family(family, options.get("folders", ()))
    forms = [options["form"]] if options.get("form") else [form for form in whole.forms if _has(whole, form, options)]

    def drawn(draw: Any) -> Variant:
        chosen = {**options, "form": draw(st.sampled_from(forms))}
        return batch(whole, 1, draw(st.integers(0, _SEEDS - 1)), **chosen)[0]

    found: SearchStrategy[Variant] = st.composite(drawn)()
    return found


def _has(family: Family, form: str, options: dict[str, Any]) -> bool:
    """Whether there are variants of a form with these options."""
    try:
        batch(family, 1, **{**options, "form": form})
    except InputError:
        return False
    return True


def mechanisms() -> SearchStrategy[Scene]:
    """Textbook mechanisms of random size and motion, away from dead points.

    Four-bars, slider-cranks with a turned guide, a rod through a collar on the crank, wheels, spools with a thread over
    a pulley (:mod:`variantgen.testing.linkages`). Raises ToolMissingError without Hypothesis.
    """
    st = _strategies()
    rate, side = _rates(), st.sampled_from([1.0, -1.0])
    length, angle = st.floats(0.3, 1.2), st.floats(-3.1, 3.1)
    found: SearchStrategy[Scene] = st.one_of(
        st.builds(four_bar, st.floats(0.1, 0.6), length, length, length, angle, rate, rate, side),
        st.builds(
            slider_crank, st.floats(0.1, 0.4), st.floats(0.5, 1.2), st.floats(-0.2, 0.2), angle, rate, rate, angle
        ),
        st.builds(
            sleeve_on_crank, st.floats(0.3, 0.6), st.floats(0.1, 0.25), st.floats(0.4, 0.9), st.floats(0.1, 0.5),
            st.floats(0.3, 2.8), rate, rate,
        ),
        st.builds(wheel, st.floats(0.1, 2), rate, rate),
        st.builds(
            lambda r, v, a, own, x, y: spool(r, 0.5, v, a, own, Coordinates(x, y)),
            st.floats(0.1, 0.4), rate, rate, side, st.floats(1.5, 3), st.floats(0.2, 2.0),
        ),
    ).filter(_is_sound)  # fmt: skip
    return found


def scenes(dyads: int = 3) -> SearchStrategy[Scene]:
    """A crank with one to so many dyads after each other, each of a random kind, place and size.

    Dyads are two hinged rods (to a fixed pivot or to an earlier link), a rod with a slider on a fixed guide, or a
    rocker with a slot in which an earlier hinge slides (:mod:`variantgen.testing.dyads`). None is near a dead point.
    Raises ToolMissingError without Hypothesis.
    """
    st = _strategies()
    kinds = st.lists(st.tuples(*[st.floats(0, 1)] * 5), min_size=1, max_size=dyads)
    found: SearchStrategy[Scene] = st.builds(
        chain, st.floats(0.1, 0.5), st.floats(-3.1, 3.1), _rates(), st.floats(-8, 8), kinds
    )
    return found


def _rates() -> SearchStrategy[float]:
    """Velocities and accelerations that are not nearly zero."""
    found: SearchStrategy[float] = _strategies().floats(-8, 8).filter(lambda x: abs(x) > 0.1)
    return found


def _is_sound(scene: Scene) -> bool:
    motion = solve(scene, 1)
    return bool(np.all(motion.solved & (motion.transmission > _LEAST_TRANSMISSION)))


def _strategies() -> Any:
    """The strategies of Hypothesis. Raises ToolMissingError where it is not installed."""
    try:
        from hypothesis import strategies
    except ImportError:
        raise missing_package("random mechanisms need", "hypothesis", "testing") from None
    return strategies
