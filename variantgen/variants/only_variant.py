"""The one variant of a form whose grid has one point: with nothing to draw, its values are taken without screens."""

from __future__ import annotations

from itertools import combinations

from variantgen.errors import InputError, Problem
from variantgen.families.family import Family, Form
from variantgen.families.reading.soundness import demands
from variantgen.variants.variant import Variant, solve_variants

_ONE_PLACE = 1e-9  # of the size of the mechanism: points nearer than that are one but for rounding


def only_variant(family: Family, form: Form, where: str) -> Variant:
    """The variant of a form of the family whose grid has one point, laid on paper as it is written.

    Raises InputError, with the file ``where``, for values that leave an expression without a meaning and for two points
    of a body in one place. Whether it is solved is not looked at.
    """
    printed = {name: p.printed[0] for name, p in form.parameters.items()}
    if form.ties:
        printed |= zip(form.ties.names, form.ties.rows[0], strict=True)
    variant = Variant(family, form, printed)
    try:
        _check_values(variant)
        _check_places(variant)
    except InputError as error:
        raise error.located(where) from None
    return variant


def _check_values(variant: Variant) -> None:
    """Raise InputError where a fixed value leaves an expression without a meaning."""
    form = variant.form
    values = form.values({name: variant.si(name) for name in variant.printed})
    wrong = [demand for demand in demands(form) if not demand.met(values)]
    if wrong:
        raise InputError([Problem(f"expected {d.expects}", key=d.key, value=d.expression.text) for d in wrong])


def _check_places(variant: Variant) -> None:
    """Raise InputError where two points of a body lie in one place: a line through them has no direction."""
    motion = solve_variants([variant], 0)
    if not motion.solved[0]:
        return
    size = float(motion.length_scale()[0])
    problems = [
        Problem(
            f"the points {first} and {second} of this body lie in one place: two names for one point",
            key=f"bodies.{body}",
            value=", ".join(members),
            remedy=f"use one of the names everywhere (a point of two bodies is a hinge), place {second} elsewhere, or"
            f' say that it is so:  {second} = "{first}"  in [points]',
        )
        for body, members in variant.form.bodies.items()
        for first, second in combinations(members, 2)
        if variant.form.points[first] is not variant.form.points[second]  # told to be in one place
        and abs(complex(motion.z[first][0] - motion.z[second][0])) <= _ONE_PLACE * size
    ]
    if problems:
        raise InputError(problems)
