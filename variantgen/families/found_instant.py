"""The instant of a problem that is found, not given: when a law of time, or a quantity, first has a value.

``instant = "v_B = 2 m/s"`` in the table of laws: everything that is asked holds at the first such instant after the
beginning of the interval of time.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.course import FoundInstant
from variantgen.families.family import Form
from variantgen.families.parameters.units import Unit, parse_value, unit
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.solving.solve import solve

_KEY = "laws.instant"
_HOW = 'write it like "v_B = 2 m/s" or, with a law phi, "phi = 120 deg"'
_STEPS = 20_000  # of the interval, between which a law is followed
_HALVINGS = 80


def read_found_instant(form: Form, text: Any, length: str) -> FoundInstant:
    """By what the instant is found. Raises InputError for what is no name and value, or has no interval of time."""
    match = re.fullmatch(r"\s*([^=]+?)\s*=\s*([^=]+?)\s*", text) if isinstance(text, str) else None
    if match is None:
        raise InputError(Problem("expected a quantity or a law and its value", key=_KEY, value=str(text), remedy=_HOW))
    if form.interval is None:
        remedy = "state the interval of time in which it comes, such as  interval = [0, 5]"
        raise InputError(Problem("an instant is found in an interval of time", key=_KEY, value=text, remedy=remedy))
    name, value = match.groups()
    own = _unit_of(form, name, length)
    written = value.rpartition(" ")[2] if " " in value else own.name
    return FoundInstant(name, parse_value(value, shown := unit(written), _KEY), _checked(shown, own, text).name)


def _unit_of(form: Form, name: str, length: str) -> Unit:
    """The unit in which a value is meant that has none."""
    if name in form.laws:
        return unit(form.laws[name].plain_unit or (length if form.laws[name].is_length else "deg"))
    try:
        quantity = parse_quantity(name, form.sample, _KEY)
    except InputError:
        known = ", ".join(form.laws)
        raise InputError(
            Problem("neither a law nor a quantity", key=_KEY, value=name, remedy=nearest(name, form.laws) or known)
        ) from None
    if not quantity.is_of_instant:
        remedy = "take a quantity of an instant, such as v_B, omega_AB, x_B, angle_O.A.B, or a law"
        raise InputError(Problem("has no value at an instant", key=_KEY, value=name, remedy=remedy))
    return quantity.own_unit(length)


def _checked(written: Unit, own: Unit, text: str) -> Unit:
    if written.measures != own.measures:
        message = f"{written.name} measures {written.measures}, {own.measures} is due"
        raise InputError(Problem(message, key=_KEY, value=text, remedy=f"use {own.name} or another unit of it"))
    return written


def with_found_instant(form: Form) -> Form:
    """The form with the instant found; as it is where it is given.

    Raises InputError where anything else varies, and where it does not come.
    """
    event = form.found_instant
    if event is None or form.interval is None:
        return form
    if form.grid_size > 1:
        varied = ", ".join(name for name in form.free_names if len(form.parameters[name].printed) > 1)
        remedy = "give each of them one value, or state the time as a parameter"
        raise InputError(Problem("is found only where nothing varies", key=_KEY, value=varied, remedy=remedy))
    found = _found(form, event)
    if not np.isfinite(found):
        said = f"{event.name} = {event.value} {event.unit}"
        remedy = "take a longer interval, or a value that is reached in it"
        raise InputError(Problem("does not come in the interval of time", key=_KEY, value=said, remedy=remedy))
    time = form.interval.time
    parameter = replace(form.parameters[time], printed=(Decimal(f"{found:.12g}"),))
    return replace(form, parameters={**form.parameters, time: parameter})


def _found(form: Form, event: FoundInstant) -> float:
    """The first instant (s) after the beginning, or infinity."""
    from variantgen.mechanism.turn.timed_motion import timed_motion  # few forms have one
    from variantgen.mechanism.turn.timed_values import first_zero

    value = unit(event.unit).to_si(event.value)
    scene = form.sample
    assert scene.course is not None and form.interval is not None, "there is an interval"
    if event.name in form.laws:
        return _of_law(form, event.name, value, float(scene.course.start), float(scene.course.end))
    quantity = parse_quantity(event.name, scene)
    motion = solve(scene, quantity.order, form.plan)

    def off(at: Motion, _: NDArray[np.intp]) -> Field:
        gap = quantity.value(at) - value
        return np.asarray(2 * np.sin(0.5 * gap) if quantity.is_angle else gap)

    with np.errstate(all="ignore"):
        return float(first_zero(timed_motion(motion, quantity.order), off)[0])


def _of_law(form: Form, law: str, value: float, start: float, end: float) -> float:
    """The first instant at which a law crosses a value: between close instants, then by halving."""
    assert form.interval is not None, "there is an interval"
    fixed: Mapping[str, Any] = {name: float(p.si[0]) for name, p in form.parameters.items()}

    def off(times: Any) -> Any:
        return form.values({**fixed, form.interval.time: times})[law] - value  # type: ignore[union-attr]

    times = np.linspace(start, end, _STEPS + 1)[1:]
    gaps = np.asarray(off(times))
    crossed = np.flatnonzero((gaps[:-1] * gaps[1:] < 0) | (gaps[1:] == 0))
    if not crossed.size:
        return float(times[0]) if gaps[0] == 0 else float("inf")
    low, high = times[crossed[0]], times[crossed[0] + 1]
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if off(low) * off(middle) <= 0 else (middle, high)
    return float(high)


def watched(form: Form) -> Quantity | None:
    """The quantity that is watched for the instant; None where a law is, or the instant is given."""
    event = form.found_instant
    return None if event is None or event.name in form.laws else parse_quantity(event.name, form.sample)
