"""Which quantities may be asked of a form."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, parse_quantity


def read_ask(form: Form, ask: Sequence[str] | None = None, key: str = "ask") -> list[Quantity]:
    """The asked quantities by name (None: those of the form).

    Raises InputError with every unknown quantity, every one that is given, repetition, and an empty list.
    """
    names = tuple(form.ask if ask is None else ask)
    known = form.remembered.get(("asked", names))
    if known is None:
        known = form.remembered["asked", names] = tuple(_read(form, names, key))
    return list(known)


def _read(form: Form, names: Sequence[str], key: str) -> list[Quantity]:
    """The quantities of these names; raises InputError as :func:`read_ask` does."""
    problems: list[Problem] = []
    if not names:
        problems.append(Problem("expected at least one quantity", key=key, remedy='for example ["v_B"]'))
    if len(set(names)) < len(names):
        problems.append(Problem("a quantity is asked twice", key=key, value=", ".join(names)))
    given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
    found = []
    for i, text in enumerate(names):
        place = f"{key}[{i + 1}]"
        if text in given or text.removesuffix(".abs").removesuffix(".sense") in given:
            problems.append(Problem("is given, so it cannot be asked", key=place, value=text, remedy="remove it"))
            continue
        try:
            quantity = parse_quantity(text, form.sample, place, form.askable)
            if text not in form.askable:
                problem = "the data of this problem do not determine it"
                problems.append(Problem(problem, key=place, value=text, remedy=nearest(text, form.askable)))
            found.append(quantity)
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems)
    return found
