"""One variant of a family, solved: for the commands ``solve`` and ``show`` and for the Python API."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from variantgen.errors import InputError, Problem
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import Answer, answer_variants
from variantgen.families.asking import check_ask, read_ask
from variantgen.families.quantities import Quantity, motion_order
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.centres import velocity_centre
from variantgen.mechanism.doubts import doubts
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.variants.draw import draw
from variantgen.variants.only_variant import only_variant
from variantgen.variants.screening import verification
from variantgen.variants.variant import Variant, solve_variants

# What stands in the place of student and problem in the key of a draw for one variant.
SINGLE = ("single", 0)


def one_variant(
    family_or_file: str,
    fixed: Mapping[str, Any] | None = None,
    seed: str = "0",
    form: str = "",
    ask: Sequence[str] = (),
    folders: tuple[Path, ...] = (),
    nice: bool = False,
    units: str = "",
    ranges: Mapping[str, Any] | None = None,
) -> Variant:
    """A variant of a family (or the scene of a file) with some parameters fixed and the others drawn.

    Fixed values may lie beyond the range of the family. Which single quantities are asked changes no data, only whether
    accelerations are (:mod:`variantgen.variants.examined`). When nothing is left to draw, the values are taken as they
    are, without screens. ``nice``: a hand-friendly variant. ``units``: the unit of length of data and answers, if it is
    not that of the family. ``ranges`` are lowest and highest values, or words of choices. Raises InputError, also where
    ``nice`` leaves nothing to choose.
    """
    family = restrict(load_family(family_or_file, folders), fixed, ranges, (form,) if form else (), nice, True, units)
    only = next(iter(family.forms.values()))
    if nice and only.parameters.keys() <= (fixed or {}).keys():
        problem = "no value is drawn, so there are no hand-friendly ones to choose"
        raise InputError(Problem(problem, family_or_file, "nice", remedy="leave nice out"))
    if len(family.forms) == 1 and only.grid_size == 1:
        return only_variant(family, only, family_or_file)
    if ask:
        check_ask(family, tuple(ask), load_family(family_or_file, folders))
    return draw(family, tuple(ask) or None, [(seed, *SINGLE)], screening=AnswerTolerances())[0]


def answers(variant: Variant, ask: Sequence[str] = ()) -> tuple[Answer, ...]:
    """The answers of a variant in printed units."""
    return answer_variants([variant], [tuple(ask) or None], [Tolerance()])[0]


def asked_quantities(variant: Variant, ask: Sequence[str] = ()) -> list[Quantity]:
    """The asked quantities of a variant: those named, or those of its form."""
    return read_ask(variant.form, tuple(ask) or None)


def variant_doubts(variant: Variant) -> list[Problem]:
    """What can be solved and is hardly meant (:mod:`variantgen.mechanism.doubts`); nothing where it is not solved."""
    motion = solve_variants([variant], 0)
    return doubts(motion) if motion.solved[0] else []


def solution_document(variant: Variant, ask: Sequence[str] = ()) -> dict[str, Any]:
    """The solved variant as plain data (the document of ``solve --json``); what was not computed is absent.

    Points and bodies in SI and radians, answers in their printed units. Raises InputError for numbers beyond all
    bounds.
    """
    return document_and_answers(variant, ask)[0]


def document_and_answers(variant: Variant, ask: Sequence[str] = ()) -> tuple[dict[str, Any], tuple[Answer, ...]]:
    """The document of :func:`solution_document` and the answers that it holds; none of a variant without a solution.

    Raises InputError as that.
    """
    asked = asked_quantities(variant, ask)
    motion = solve_variants([variant], motion_order(asked))
    outcome = Outcome(int(motion.outcome[0]))
    document: dict[str, Any] = {
        "family": variant.family.name,
        "form": variant.form.name,
        "parameters": {name: _parameter(variant, name) for name in variant.printed},
        "outcome": outcome.name.lower(),
    }
    if outcome is not Outcome.SOLVED:
        return document, ()
    if not verification(motion, motion_order(asked))[0]:
        raise InputError(
            Problem(
                "an independent computation gives another motion: the joints or drivers contradict each other",
                key="joints",
                value=variant.family.name,
                remedy="is each fixed point at rest, does each wheel turn about its centre, do gears keep apart?",
            )
        )
    document["points"] = {name: _point(motion, name) for name in motion.z}
    document["bodies"] = {body: _body(motion, body) for body in motion.scene.bodies}
    relative = {point: _relative(motion, point, body) for point, body in sliding_points(motion.scene).items()}
    if relative:
        document["relative"] = relative
    found = answers(variant, ask)
    document["answers"] = [
        {
            "quantity": a.quantity.name,
            "value": a.value if isfinite(a.value) else None,
            "unit": a.unit.name,
            "tolerance": a.tolerance if isfinite(a.value) else None,
        }
        for a in found
    ]
    return document, found


def _parameter(variant: Variant, name: str) -> dict[str, Any]:
    unit = variant.form.parameters[name].unit
    if unit is None:
        return {"value": variant.word(name), "unit": None, "si": float(variant.printed[name])}
    return {"value": float(variant.printed[name]), "unit": unit.name, "si": variant.si(name)}


def _xy(values: Any) -> list[float]:
    z = complex(np.asarray(values)[0])
    return [z.real + 0.0, z.imag + 0.0]


def _point(motion: Motion, name: str) -> dict[str, Any]:
    found = {"position": _xy(motion.z[name])}
    if name in motion.v:
        found["velocity"] = _xy(motion.v[name])
    if name in motion.a:
        found["acceleration"] = _xy(motion.a[name])
    return found


def _body(motion: Motion, body: str) -> dict[str, Any]:
    centre = velocity_centre(motion, body)
    found: dict[str, Any] = {"omega": float(motion.omega[body][0])}
    if motion.epsilon:
        found["epsilon"] = float(motion.epsilon[body][0])
    found["velocity_centre"] = _xy(centre.z) if centre.finite[0] else None
    return found


def _relative(motion: Motion, point: str, body: str) -> dict[str, Any]:
    parts = relative_motion(motion, point, body)
    found: dict[str, Any] = {"body": body, "velocity": _xy(parts.velocity)}
    if parts.acceleration is not None and parts.coriolis is not None:
        found["acceleration"] = _xy(parts.acceleration)
        found["coriolis"] = _xy(parts.coriolis)
    return found
