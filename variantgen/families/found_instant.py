"""The instant of a problem that is found, not given: when a law of time, or a quantity, first has a value.

``instant = "v_B = 2 m/s"`` in the table of laws: everything that is asked holds at the first such instant after the
beginning of the interval of time.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any

import numpy as np
from msgspec.structs import replace
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
_LATER = 1e-6  # of the interval: so long after its beginning an instant is another one
_SAME = 1e-9  # relative: a value that is the same
_TOUCHES = 1e-12  # of the largest gap: rounding


def read_found_instant(form: Form, text: Any, length: str) -> FoundInstant:
    """By what the instant is found. Raises InputError for what is no name and value, or has no interval of time."""
    match = re.fullmatch(r"\s*([^=\s][^=]*?)\s*=\s*([^=\s][^=]*?)\s*", text) if isinstance(text, str) else None
    if match is None:
        raise InputError(Problem("expected a quantity or a law and its value", key=_KEY, value=str(text), remedy=_HOW))
    if form.interval is None:
        remedy = "state the interval of time in which it comes, such as  interval = [0, 5]"
        raise InputError(Problem("an instant is found in an interval of time", key=_KEY, value=text, remedy=remedy))
    name, value = match.groups()
    own = _unit_of(form, name, length)
    written = value.rpartition(" ")[2] if " " in value else own.name
    return FoundInstant(name, parse_value(value, shown := unit(written, _KEY), _KEY), _checked(shown, own, text).name)


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
    if not quantity.is_of_instant or quantity.component == "sense":
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
    """The first instant (s) after the beginning, or infinity. Raises InputError where it cannot be looked for."""
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
        timed = timed_motion(motion, quantity.order)
        found = float(first_zero(timed, off)[0])
        if not timed.complete[0]:
            said = (
                "cannot be found: the mechanism does not move all through the interval, or makes too many turns in it"
            )
            raise InputError(Problem(said, key=_KEY, value=event.name, remedy="take a shorter interval"))
        if np.isfinite(found):
            one, begun = np.zeros(1, dtype=np.intp), float(timed.start[0])
            before = off(timed.at(one, np.array([0.5 * (begun + found)])), one)
            if abs(float(before[0])) <= _SAME * max(abs(value), 1e-3):
                said = "is so from the beginning on, not at one instant"
                remedy = "take a quantity that comes to its value, or another value"
                raise InputError(
                    Problem(said, key=_KEY, value=f"{event.name} = {event.value} {event.unit}", remedy=remedy)
                )
        return found


def _of_law(form: Form, law: str, value: float, start: float, end: float) -> float:
    """The first instant (s) at which a law crosses a value, or only touches it and turns back; infinity without one.

    It is looked for between close instants, then by halving: where the law crosses, by its gap, where it touches, by
    its rate.
    """
    assert form.interval is not None, "there is an interval"
    time = form.interval.time
    fixed: Mapping[str, Any] = {name: float(p.si[0]) for name, p in form.parameters.items()}

    def off(at: Any) -> Any:
        return form.values({**fixed, time: at})[law] - value

    def rate(at: Any) -> Any:
        return form.values({**fixed, time: at})[f"{law}_dot"]

    times = np.linspace(start, end, _STEPS + 1)
    times[0] += _LATER * (end - start)
    known = np.broadcast_to(form.derived[law].defined(form.values({**fixed, time: times})), times.shape)
    times = times[: int(np.argmin(known))] if not np.all(known) else times
    gaps, rates = (np.broadcast_to(np.asarray(of(times), dtype=float), times.shape) for of in (off, rate))
    if not gaps.size or np.ptp(gaps) == 0:
        return float("inf")
    found = float("inf")
    for i in np.flatnonzero((gaps[:-1] * gaps[1:] < 0) | (gaps[1:] == 0)).tolist():
        at = _halved(off, times[i], times[i + 1])
        if abs(off(at)) <= abs(gaps[i]):  # more at a pole
            found = at
            break
    small = np.minimum(np.abs(gaps[:-1]), np.abs(gaps[1:])) <= np.abs(np.diff(rates)) * np.diff(times)
    for i in np.flatnonzero((rates[:-1] * rates[1:] < 0) & small & (times[:-1] < found)).tolist():
        at = _halved(rate, times[i], times[i + 1])
        if abs(off(at)) <= _TOUCHES * np.max(np.abs(gaps)):
            return min(at, found)
    return found


def _halved(of: Callable[[Any], Any], low: float, high: float) -> float:
    """Where a function changes its sign between two instants."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if of(low) * of(middle) <= 0 else (middle, high)
    return float(high)


def watched(form: Form) -> Quantity | None:
    """The quantity that is watched for the instant; None where a law is, or the instant is given."""
    event = form.found_instant
    return None if event is None or event.name in form.laws else parse_quantity(event.name, form.sample)
