"""Which quantities may be asked of a form, by their names or by words for all of a kind."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.family import Family, Form
from variantgen.families.given_positions import given_position
from variantgen.families.quantities import Quantity, in_unit, parse_quantity, split_name, split_unit

# What a form asks by itself: the answers of one order (1: velocities are enough to know it), or all.
WORDS = {"velocities": (1,), "accelerations": (2,), "all": (0, 1, 2)}


class ByForm(Struct, frozen=True):
    """What is asked of each form, by its name; the others are asked what they ask by themselves."""

    forms: tuple[tuple[str, tuple[str, ...]], ...]


Ask = Sequence[str] | ByForm | None  # None: what each form asks by itself


def read_ask(form: Form, ask: Ask | str = None, key: str = "ask") -> list[Quantity]:
    """The asked quantities of a form, by names (``v_B``, or ``v_B in ft/s``) and by the ``WORDS``.

    Raises InputError with every unknown quantity, every one that is given, repetition, and an empty list.
    """
    if isinstance(ask, ByForm):
        own = dict(ask.forms).get(form.name)
        ask, key = own, f"{key}.{form.name}"
    names = _names(form.ask if ask is None else ask, key)
    known = form.remembered.get(("asked", names))
    if known is None:
        known = form.remembered["asked", names] = tuple(_read(form, names, key))
    return list(known)


def _names(ask: Any, key: str) -> tuple[str, ...]:
    """The names, one or several. Raises InputError for what is none."""
    names = (ask,) if isinstance(ask, str) or not isinstance(ask, Iterable) else tuple(ask)
    if wrong := [name for name in names if not isinstance(name, str)]:
        remedy = f"a list of names, such as v_B, or of {', '.join(WORDS)}"
        raise InputError(Problem("expected the name of a quantity", key=key, value=repr(wrong[0]), remedy=remedy))
    return names


def check_ask(family: Family, ask: Ask | str, whole: Family) -> None:
    """Raise InputError where a form cannot be asked for this; it names the forms of the ``whole`` family that can."""
    problems: list[Problem] = []
    for form in family.forms.values():
        try:
            read_ask(form, ask)
        except InputError as error:
            problems += [_placed(problem, form, whole) for problem in error.problems]
    if problems:
        raise InputError(dict.fromkeys(problems))


def _placed(problem: Problem, form: Form, whole: Family) -> Problem:
    """A problem with what is asked of a form, with the forms on which it is none."""
    able = [name for name, other in whole.forms.items() if name != form.name and _answers(other, problem.value)]
    if not able:
        return problem
    names = " or ".join(f'"{name}"' for name in able)
    remedy = f'choose  form = {names},  or ask each form by itself:  ask = {{ {able[0]} = ["{problem.value}"] }}'
    return replace(problem, message=f"{problem.message} in the form {form.name}", remedy=remedy)


def _answers(form: Form, text: str) -> bool:
    """Whether a form can be asked for a quantity, or for a kind of them."""
    try:
        return bool(text and read_ask(form, [text]))
    except InputError:
        return False


def _read(form: Form, names: Sequence[str], key: str) -> list[Quantity]:
    """The quantities of these names; raises InputError as :func:`read_ask` does."""
    problems: list[Problem] = []
    if not names:
        problems.append(Problem("expected at least one quantity", key=key, remedy='for example ["v_B"]'))
    if len({split_unit(name)[0] for name in names}) < len(names):
        problems.append(Problem("a quantity is asked twice", key=key, value=", ".join(names)))
    given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
    found: list[Quantity] = []
    for i, asked in enumerate(names):
        place = f"{key}[{i + 1}]"
        text, wanted = split_unit(asked)
        if text in WORDS:
            if wanted:
                problems.append(Problem("a unit goes with one quantity", key=place, value=asked, remedy="name them"))
            own = _of_order(form, text)
            if not own:
                problem = f"a problem like this asks for no {text} by itself"
                problems.append(Problem(problem, key=place, value=text, remedy="name the quantities"))
        elif text in given or text.removesuffix(".abs").removesuffix(".sense") in given:
            problems.append(Problem("is given, so it cannot be asked", key=place, value=text, remedy="remove it"))
            continue
        else:
            try:
                quantity = parse_quantity(text, form.sample, place, (*form.askable, *WORDS))
                problems += _not_asked(form, quantity, text, place)
                own = [in_unit(quantity, wanted, place) if wanted or asked.rstrip().endswith(" in") else quantity]
            except InputError as error:
                problems += error.problems
                continue
        found += [quantity for quantity in own if quantity not in found]  # a word may have named it
    if problems:
        raise InputError(problems)
    return found


def _not_asked(form: Form, quantity: Quantity, text: str, place: str) -> Iterator[Problem]:
    """Why a quantity that the scene knows is not asked of its form: the data do not lead to it, or state it."""
    stated = given_position(form, quantity) if quantity.group in ("position", "path", "centre") else ""
    if not stated and not form.may_be_asked(quantity):
        problem = "the data of this problem do not determine it"
        if quantity.group == "position":
            problem = "this position is not asked of the family: its may_ask does not name it"
        yield Problem(problem, key=place, value=text, remedy=_instead(form, quantity))
    elif text not in form.askable and (hidden := {*quantity.points(form.points)} & {*form.figure.hidden}):
        shown = ", ".join(sorted(name for name in form.points if name not in form.figure.hidden))
        problem = f"the figure does not show {', '.join(sorted(hidden))}"
        yield Problem(problem, key=place, value=text, remedy=f"use other points: {shown}")
    elif stated:
        yield Problem("is given, so it cannot be asked", key=place, value=text, remedy=stated)


def _instead(form: Form, quantity: Quantity) -> str:
    """What may be asked in place of a quantity that the data do not determine: those of its kind, or one of each."""
    plain = list(dict.fromkeys(name.partition(".")[0] for name in form.askable if not split_name(name).is_centre))
    alike = [name for name in plain if name.rpartition("_")[0] == quantity.kind]
    centres = [name for name in form.askable if split_name(name).is_centre]
    if alike:
        return f"may be asked: {', '.join(alike)}"
    return f"may be asked: {', '.join(plain)}" + (
        f", and distances from centres such as {centres[0]}" if centres else ""
    )


def _of_order(form: Form, word: str) -> list[Quantity]:
    """What a form asks by itself and the word means."""
    return [quantity for quantity in read_ask(form) if quantity.order in WORDS[word]]
