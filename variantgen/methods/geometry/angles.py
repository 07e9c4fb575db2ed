"""Directions as sums of given angles, of directions worked out before, and of a number of degrees.

The direction of a segment follows from its construction: ``180 deg + phi + beta``. Kept as coefficients and a constant
such a sum is turned, reflected and compared without arithmetic on expressions, and its cosine can be reduced to that
of the given angle, ``cos(180 deg - phi) = -cos phi``.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TypeAlias

from msgspec import Struct

from variantgen.algebra.expression import Constant, Expression, Pi, Ratio, Value, Variable
from variantgen.algebra.linear import is_linear
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import simplified
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.methods.linkage.problem import Task
from variantgen.methods.linkage.time_laws import angle_law

# A given angle or a law of time by its name, the direction of the ray from one point to another, or a corner of a
# triangle.
Atom: TypeAlias = "str | tuple[str, str] | Value"

_SAME = 1e-9  # degrees
_ROUNDING = 1e-11  # degrees: some roundings of an angle in radians


class AngleForm(Struct, frozen=True):
    """``sum of coefficient * atom + constant`` in degrees; ``parts`` are sorted, without zeros."""

    parts: tuple[tuple[Atom, float], ...] = ()
    constant: float = 0.0

    def plus(self, other: AngleForm, factor: float = 1.0) -> AngleForm:
        """The sum with a multiple of another one."""
        constant = self.constant + factor * other.constant
        if not other.parts:
            return AngleForm(self.parts, constant)
        if not self.parts:
            return AngleForm(tuple([(atom, factor * c) for atom, c in other.parts]), constant)
        found = dict(self.parts)
        for atom, coefficient in other.parts:
            found[atom] = found.get(atom, 0.0) + factor * coefficient
        if len(found) == len(self.parts):  # in their order already
            return AngleForm(tuple([part for part in found.items() if part[1] != 0]), constant)
        return form_of(found.items(), constant)

    def minus(self, other: AngleForm) -> AngleForm:
        """The difference."""
        return self.plus(other, -1.0)

    def times(self, factor: float) -> AngleForm:
        """A multiple."""
        return AngleForm(tuple([(atom, factor * c) for atom, c in self.parts]), factor * self.constant)

    def turned(self, by: float) -> AngleForm:
        """The direction turned by an angle (degrees)."""
        return AngleForm(self.parts, self.constant + by)

    def is_along(self, other: AngleForm) -> bool:
        """Whether it is the direction of the same line, whatever the angles are."""
        rest = (self.constant - other.constant) % 180.0
        return self.parts == other.parts and min(rest, 180.0 - rest) < _SAME


def form_of(parts: Iterable[tuple[Atom, float]], constant: float) -> AngleForm:
    """A sum from coefficients by atom."""
    kept = [(atom, c) for atom, c in parts if c != 0]
    if len(kept) > 1:
        kept.sort(key=_order)
    return AngleForm(tuple(kept), constant)


def _order(part: tuple[Atom, float]) -> str:
    """The text of an atom, by which sums are sorted."""
    atom = part[0]
    return f"Value({_text_of(atom.name)}, {atom.exact:.6g})" if isinstance(atom, Value) else str(atom)


@lru_cache(maxsize=4096)
def _text_of(name: Name | None) -> str:
    return str(name)


class Angles:
    """The angles of a family's expressions as sums, in the frame of its scene or on paper."""

    def __init__(self, task: Task) -> None:
        self._task = task
        self._laws: dict[str, Value] = {}
        frame = task.scene.frame
        self.sense = round(float(frame.sense))
        self._turn = degrees(complex(frame.turn))

    def read(self, expression: FamilyExpression | None) -> AngleForm:
        """An angle of the scene; what is no sum of angles is a number of degrees, read off the figure."""
        if expression is None:
            return AngleForm()
        if isinstance(expression.tree, Variable) and self._is_angle(expression.tree.name):
            return AngleForm(((expression.tree.name, 1.0),))
        if not expression.names:
            return self._of_number(expression)
        signs = {name: sign for name in sorted(expression.names) if (sign := self._sign(name))}
        if signs and (expression.names - signs.keys()).isdisjoint(self._task.form.derived):
            base, slopes, always = self._linear(expression, tuple(signs))
            if always or self._is_sum(expression, base, slopes):
                return form_of([(name, slopes[name] * sign) for name, sign in signs.items()], tidy(math.degrees(base)))
        return AngleForm((), tidy(math.degrees(self._task.read(expression))))

    def _is_sum(self, expression: FamilyExpression, base: float, slopes: Mapping[str, float]) -> bool:
        """Whether an expression is its number at angles of zero and what grows with each of them, for this variant."""
        total = base + sum(slope * self._task.si[name] for name, slope in slopes.items())
        return abs(math.degrees(total - self._task.read(expression))) <= _SAME

    def _of_number(self, expression: FamilyExpression) -> AngleForm:
        """An angle that depends on no datum; the form remembers it."""
        known, key = self._task.form.remembered, ("angle", expression)
        if key not in known:
            known[key] = AngleForm((), tidy(math.degrees(self._task.read(expression))))
        found: AngleForm = known[key]
        return found

    def _linear(self, expression: FamilyExpression, angles: tuple[str, ...]) -> tuple[float, dict[str, float], bool]:
        """An expression at angles of zero, by how much it grows with each of these angles, whether it always does.

        The form remembers it where it depends on choices alone besides.
        """
        form, values = self._task.form, self._task.si
        others = sorted(expression.names - set(angles))
        key = ("linear", expression, angles, *[values[name] for name in others])
        known = form.remembered.get(key)
        if known is None:
            start = dict(values) | dict.fromkeys(angles, 0.0)
            base = float(expression.value(start))
            slopes = {name: tidy(float(expression.value(start | {name: 1.0})) - base) for name in angles}
            known = base, slopes, is_linear(expression.tree, angles)
            if all(form.parameters[name].unit is None for name in others):
                form.remembered[key] = known
        found: tuple[float, dict[str, float], bool] = known
        return found

    def _sign(self, name: str) -> int:
        """1 for an angle, printed or only drawn, the sign of a law of time, 0 for other quantities."""
        parameter = self._task.form.parameters.get(name)
        if parameter is None or parameter.unit is None:
            law = angle_law(self._task, name)
            return law[0] if law else 0
        return int(self._is_angle(name))

    def _is_angle(self, name: str) -> bool:
        """Whether a quantity is an angle among the data, printed or only drawn."""
        parameter = self._task.form.parameters.get(name)
        return parameter is not None and parameter.unit is not None and parameter.unit.measures == "angle"

    def is_silent(self, name: str) -> bool:
        """Whether the statement does not print an angle: the drawing shows it, and nothing depends on it."""
        parameter = self._task.form.parameters.get(name)
        return parameter is not None and parameter.silent

    def value(self, name: str) -> Value:
        """A given angle, or the one that a law of time gives at the instant of the problem."""
        if name in self._task.given:
            return self._task.given[name]
        if name not in self._laws:
            law = angle_law(self._task, name)
            assert law is not None, "a name among angles is a given one or a law"
            self._laws[name] = _in_degrees(Name("parameter", name), law[1])
        return self._laws[name]

    def relative(self, form: AngleForm) -> AngleForm:
        """An angle between two rays of the scene, on paper: a reflection changes its sense."""
        return form.times(float(self.sense))

    def on_paper(self, form: AngleForm) -> AngleForm:
        """An angle with the x axis of the scene as one with the x axis of the paper."""
        placed = form if self.sense > 0 else form.times(-1.0).turned(180.0)
        return placed.turned(self._turn)


def _in_degrees(name: Name, law: Expression) -> Value:
    """An angle by its law in degrees; what is ``180 (...) / pi`` is a value in radians first."""
    if not isinstance(law, Ratio) or law.below != Pi():
        return Value(name, "angle", law.number(True), law)
    plain = simplified(law * Pi() / Constant(180.0))
    radians = Value(name, "number", plain.number(True), plain, unit="rad")
    shown = Constant(180.0, "angle") * radians / Pi()
    return Value(name, "angle", shown.number(True), shown)


def corner_name(vertex: str, first: str, second: str) -> Name:
    """The name of the angle at a vertex with its sides in the order of their letters, O before others: ``OCB``."""
    ends = sorted((first, second), key=lambda point: (point[0] != "O", point))
    return Name("angle", vertex, " ".join(ends))


def tidy(number: float) -> float:
    """A number of degrees without the rounding of radians: one that near to a short decimal is that."""
    # Most numbers are whole ones or halves, or nowhere near a short one, which is seen sooner than rounded.
    if number * 64.0 % 1.0 == 0.0:
        return number + 0.0
    if 1e-4 < number * 1e6 % 1.0 < 0.9999:
        return number
    found = round(number, 6)
    return found + 0.0 if abs(found - number) < _ROUNDING else number


def short(number: float) -> float:
    """A number of degrees to six decimals, zero without a sign."""
    return number + 0.0 if number * 64.0 % 1.0 == 0.0 else round(number, 6) + 0.0


def degrees(vector: complex) -> float:
    """The angle of a vector with the x axis in degrees, in (-180, 180]."""
    return normal_angle(math.degrees(cmath.phase(vector)))


def normal_angle(angle: float) -> float:
    """An angle in (-180, 180]; without the rounding of radians."""
    if not -179.0 < angle <= 180.0:
        angle -= 360.0 * math.ceil((angle - 180.0) / 360.0 - 1e-12)
    if angle * 64.0 % 1.0:  # the others are as they should be
        angle = tidy(angle)
    return 180.0 if angle == -180.0 else angle + 0.0


def between(first: float, second: float) -> float:
    """The angle between two directions in degrees, 0 to 180."""
    return abs(normal_angle(first - second))
