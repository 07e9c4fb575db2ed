"""What there is to choose from in a family: forms, parameters with their values, all that can be asked, a problem."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from decimal import Decimal
from itertools import pairwise, permutations
from typing import Any

from variantgen.errors import InputError
from variantgen.exam.work.work_samples import usual_work
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.quantities import Quantity, split_name
from variantgen.wording.formula import to_plain
from variantgen.wording.language import Language

_POINTS = 10
# Names with points p, q, r and bodies b, c.
_PATTERNS = (
    "v_{p}_{q}", "a_{p}_{q}.x",
    "x_{p}", "y_{p}", "angle_{p}{q}", "angle_{p}.{q}.{r}", "distance_{p}.{q}", "v_{p}.along_{q}{r}",
    "v_{p}.across_{q}{r}", "a_{p}.t", "a_{p}.n", "rho_{p}", "ratio_{b}.{c}", "P_{b}.x", "Q_{b}.y",
    "v_rope.{p}.{q}", "max_v_{p}", "min_omega_{b}", "phi_max_x_{p}", "mean_v_{p}", "stroke_{p}", "swing_{b}",
    "time_ratio_{p}", "max_t_v_{p}", "t_max_v_{p}", "t_zero_v_{p}", "t_back_{p}", "way_{p}", "shift_{p}.x",
    "duration_{p}", "average_v_{p}", "turned_{b}",
)  # fmt: skip


def overview(family: Family, language: Language, named: str = "") -> dict[str, Any]:
    """A family as plain data (the document of ``list FAMILY --json``); numbers of parameters in their printed units.

    ``named`` is how an exam file names it, where that is not its name: a path.
    """
    return {
        "family": family.name,
        "title": family.title(language.name),
        "source": family.source,
        "length_unit": family.length_unit,
        "forms": [_form(family, form, language) for form in family.forms.values()],
        "problem": problem_table(family, named),
    }


def _form(family: Family, form: Form, language: Language) -> dict[str, Any]:
    return {
        "form": form.name,
        "work": usual_work(family, form),
        "parameters": {name: _parameter(p, form, language) for name, p in form.parameters.items()},
        "ask": list(form.ask),
        "can_be_asked": list(_askable(family, form, language)),
        "likewise": [_described(quantity, family, form, language) for quantity in _likewise(form)],
        "grid_size": form.grid_size,
    }


def _parameter(parameter: Parameter, form: Form, language: Language) -> dict[str, Any]:
    """A range with its step, a list of values, or the words of a choice."""
    if parameter.unit is None:
        return {"choices": list(parameter.words)}
    found: dict[str, Any] = {
        "symbol": to_plain(language.symbol(parameter.symbol, form.symbols)),
        "unit": parameter.unit.name,
    }
    if not parameter.given:
        found["printed"] = False
    step = _step(parameter.printed)
    if step is None:
        return {**found, "values": [float(value) for value in parameter.printed]}
    low, high = parameter.printed[0], parameter.printed[-1]
    return {**found, "from": float(low), "to": float(high), "step": float(step)}


def _step(values: Sequence[Decimal]) -> Decimal | None:
    """The step between values that follow each other evenly, at least three of them."""
    steps = {b - a for a, b in pairwise(values)}
    return steps.pop() if len(steps) == 1 and len(values) > 2 else None


def _askable(family: Family, form: Form, language: Language) -> Iterable[dict[str, str]]:
    """Every plain quantity that the form can be asked for, but for its data, and whatever it asks by itself."""
    given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
    asked = [quantity.name for quantity in read_ask(form)]
    for name in (*form.askable, *(name for name in asked if name not in form.askable)):
        if name.removesuffix(".abs").removesuffix(".sense") not in given:
            yield _described(split_name(name), family, form, language)


def _described(quantity: Quantity, family: Family, form: Form, language: Language) -> dict[str, str]:
    symbol = to_plain(language.quantity(quantity, form.symbols))
    return {"quantity": quantity.name, "symbol": symbol, "unit": quantity.unit(family.length_unit).name}


def _likewise(form: Form) -> Iterator[Quantity]:
    """One quantity of each kind of which there are too many to name all: made of others, or of positions alone."""
    points, bodies = list(form.points), list(form.bodies)
    asked = {quantity.whole for quantity in read_ask(form)}  # these are listed by themselves
    for pattern in _PATTERNS:
        found = (_quantity(form, name) for name in _filled(pattern, points, bodies))
        first = next((quantity for quantity in found if quantity is not None), None)
        if first is not None and first not in asked:
            yield first


def _filled(pattern: str, points: Sequence[str], bodies: Sequence[str]) -> Iterator[str]:
    """The names that a pattern stands for: with different points p, q, r and different bodies b, c."""
    needed = [letter for letter in "pqr" if f"{{{letter}}}" in pattern]
    pairs = [letter for letter in "bc" if f"{{{letter}}}" in pattern]
    for chosen in permutations(points, len(needed)):
        for others in permutations(bodies, len(pairs)):
            yield pattern.format(**dict(zip(needed, chosen, strict=True)), **dict(zip(pairs, others, strict=True)))


def _quantity(form: Form, name: str) -> Quantity | None:
    """The quantity of a name, if the form can be asked for it."""
    with suppress(InputError):
        return read_ask(form, [name])[0]
    return None


def _number(value: Decimal) -> str:
    return f"{value.normalize():f}"


def problem_table(family: Family, named: str = "") -> str:
    """A ``[[problem]]`` of an exam file with this family; what may be chosen besides stands in comments."""
    forms = [name for name in family.forms if name]
    first = next(iter(family.forms.values()))
    lines = ["[[problem]]", f'family = "{named or family.name}"']
    if forms:
        lines.append(f"# form = {_listed(forms)}")
    if len({form.ask for form in family.forms.values()}) == 1:
        lines.append(f"ask = {_listed(q.name for q in read_ask(first))}")
    else:
        lines += [f"# ask.{name} = {_listed(form.ask)}" for name, form in family.forms.items()]
    drawn = [
        p for p in first.parameters.values() if p.unit is not None and len(p.printed) > 1 and _is_common(family, p)
    ]
    for ranged in drawn[:1]:
        low, high = min(ranged.printed), max(ranged.printed)
        lines.append(f"# range = {{ {ranged.name} = [{_number(low)}, {_number(high)}] }}")
    for fixed in drawn[1:2]:
        lines.append(f"# set = {{ {fixed.name} = {_number(fixed.printed[len(fixed.printed) // 2])} }}")
    return "\n".join([*lines, f"points = {_POINTS}"])


def _is_common(family: Family, parameter: Parameter) -> bool:
    """Whether all forms draw the parameter from the same values."""
    others = (form.parameters.get(parameter.name) for form in family.forms.values())
    return all(other is not None and other.printed == parameter.printed for other in others)


def _listed(names: Iterable[str]) -> str:
    return json.dumps(list(names))
