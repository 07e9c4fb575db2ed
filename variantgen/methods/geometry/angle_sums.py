"""Angles between directions as sums of given angles and of corners of triangles.

A direction is worked out from others; taken apart, it is a sum of given angles, of corners (arc functions of sides) and
of a number of degrees. In the difference of two directions what both are counted from cancels, so that the angle
between them is written as what it is: ``phi``, ``90 deg - phi``, ``phi + psi``.
"""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Expression, Ratio, Times, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angles import AngleForm, between, tidy

_SAME = 1e-6  # degrees within which a difference of two directions is the angle between them
_SHORT = 2  # parts of a sum that is written out where it stands


def angle_sum(angle: Value) -> AngleForm:
    """A direction or angle taken apart; one that is no sum is its own part, but a given right angle is a number.

    A direction that only the drawing shows and an angle that the sheet prints have nothing but their number.
    """
    noted = angle.noted
    if noted is None or noted[0] is not angle.expression or noted[1] != angle.exact:
        return _note(angle, _taken_apart(angle))
    found: AngleForm = noted[2]
    return found


def _note(angle: Value, form: AngleForm) -> AngleForm:
    """Note what an angle was taken apart into, as long as it has this expression and this number."""
    angle.noted = angle.expression, angle.exact, form
    return form


def _taken_apart(angle: Value) -> AngleForm:
    kind = "" if angle.name is None else angle.name.kind
    if kind == "parameter":
        return AngleForm(((angle, 1.0),)) if angle.exact % 90.0 else AngleForm((), angle.exact)
    if angle.expression is None:
        is_number = kind in ("", "direction", "angle")
        return AngleForm((), tidy(angle.exact)) if is_number else AngleForm(((angle, 1.0),))
    is_drawn = isinstance(angle.expression, Constant) and kind in ("direction", "angle")
    found = None if is_drawn else _sum(angle.expression)
    if found is None:
        return AngleForm(((angle, 1.0),))
    turns = round((angle.exact - _number(found)) / 360.0)
    return found.turned(360.0 * turns) if turns else found


def _sum(item: Expression) -> AngleForm | None:
    """An expression as a sum of angles; None for another one."""
    match item:
        case Value():
            return angle_sum(item)
        case Constant(value):
            return AngleForm((), float(value))
        case Total(terms):
            found: AngleForm | None = None
            for sign, term in terms:
                if isinstance(term, Constant) and found is not None:
                    found = found.turned(sign * term.value)
                    continue
                part = angle_sum(term) if isinstance(term, Value) else _sum(term)
                if part is None:
                    return None
                found = (part if sign > 0 else part.times(-1.0)) if found is None else found.plus(part, sign)
            return found or AngleForm()
        case Ratio(above, Constant(count)):
            return None if (part := _sum(above)) is None else part.times(1.0 / count)
        case Times((Constant(count), factor)):
            return None if (part := _sum(factor)) is None else part.times(count)
    return None


def _number(form: AngleForm) -> float:
    number = form.constant
    for atom, count in form.parts:
        if isinstance(atom, Value):
            number += count * atom.exact
    return number


def written(form: AngleForm) -> Expression:
    """A sum of angles as an expression, what is positive first."""
    parts: list[tuple[int, Expression]] = []
    for atom, count in form.parts:
        assert isinstance(atom, Value), "a direction that was taken apart is made of values"
        size = abs(count)
        part = atom if size == 1 else Ratio(atom, Constant(2.0)) if size == 0.5 else Constant(size) * atom
        parts.append((1 if count > 0 else -1, part))
    constant = tidy(form.constant)
    if constant or not parts:
        own = (1 if constant >= 0 else -1, Constant(abs(constant), "angle"))
        parts = [own, *parts] if own[0] > 0 else [*parts, own]
    if len(parts) == 1 and parts[0][0] > 0:
        return parts[0][1]
    return Total(tuple([part for part in parts if part[0] > 0] + [part for part in parts if part[0] < 0]))


def is_short(form: AngleForm) -> bool:
    """Whether a sum is written out where it stands, not worked out before."""
    return len(form.parts) + bool(tidy(form.constant)) <= _SHORT


def is_single(form: AngleForm) -> bool:
    """Whether it is one angle or a number."""
    return len(form.parts) + bool(tidy(form.constant)) <= 1


def valued(name: Name | None, form: AngleForm) -> Value:
    """A sum of angles as a value; without a name a single angle stands for itself."""
    expression = written(form)
    if name is None and isinstance(expression, Value):
        return expression
    number = expression.number(True)
    return Value(name, "angle", number, None if isinstance(expression, Constant) else expression)


def _valued(name: Name | None, form: AngleForm) -> Value:
    """The same of a sum whose parts were taken apart: so is the value."""
    value = valued(name, form)
    if value.noted is None and value.expression is not None:
        _note(value, AngleForm(form.parts, tidy(form.constant)))
    return value


def difference(name: Name | None, first: Value, second: Value) -> Value:
    """The angle between two directions, 0 to 180 degrees, as their difference.

    Raises ArithmeticError where it is no difference of the two: a defect of the caller.
    """
    return _valued(name, _matched(angle_sum(first).minus(angle_sum(second)), between(first.exact, second.exact), 360.0))


def acute(first: Value, second: Value, size: float) -> tuple[str, Value]:
    """The acute angle ``size`` between two lines for a cosine, or the angle to 90 degrees for a sine if that is
    the simpler one.
    """
    form = _matched(angle_sum(first).minus(angle_sum(second)), size, 180.0)
    is_square = form.parts and abs(abs(form.constant) - 90.0) < _SAME  # else there is nothing to turn
    for sign in (-1.0, 1.0) if is_square else ():
        if not tidy(sign * form.constant + 90.0) and any(sign * count > 0 for _, count in form.parts):
            return "sin", _valued(None, form.times(sign).turned(90.0))
    return "cos", _valued(None, form)


def supplement(angle: Value) -> Value | None:
    """The single angle that this one is 180 degrees less: ``cos(180 deg - phi) = -cos phi``; None for other ones."""
    form = angle_sum(angle)
    if not form.parts or len(form.parts) + bool(tidy(180.0 - form.constant)) > 1:
        return None
    return _valued(None, form.times(-1.0).turned(180.0))


def _matched(form: AngleForm, size: float, period: float) -> AngleForm:
    """A difference with the sign and the turns that make it an angle of this size."""
    number = _number(form)
    for sign in (1.0, -1.0):
        turns = round((size - sign * number) / period)
        if abs(size - sign * number - period * turns) < _SAME:
            parts = form.parts if sign > 0 else form.times(sign).parts
            return AngleForm(parts, tidy(sign * form.constant + period * turns))
    raise ArithmeticError("an angle between two directions is not their difference")
