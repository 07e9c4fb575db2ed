"""The values of the position and the lines and sentences of a solution that derive them."""

from __future__ import annotations

import cmath
import math
from itertools import combinations

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import parts
from variantgen.methods.geometry.angles import AngleForm, between
from variantgen.methods.geometry.layout import Layout
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import Pair
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import Derived, Fact, Item, Point, Segment, Sentence, triangle

_FEET = ("H", "K", "L", "N", "S", "T", "U", "W")  # letters of feet of perpendiculars


class PositionLines(Layout):
    """The given geometry of one variant; ``items`` are the lines that derive further values, in order."""

    def __init__(self, task: Task) -> None:
        super().__init__(task)
        self.items: list[Item] = []
        self._corners: dict[tuple[str, frozenset[str]], Value] = {}
        self._feet: dict[tuple[str, str, str], Pair] = {}
        self._letters = 0  # given to angles

    def located(self, name: Name, expression: Expression) -> Value:
        """A coordinate by an expression; zero is a plain number."""
        number = expression.number(True)
        return Value(name, "length", number, None if self.is_nothing(expression) else expression, self.task.size)

    def solution(self, name: Name, number: float) -> Value:
        """A coordinate found by solving equations: its printed number is rounded like all others."""
        return Value(name, "length", number, Constant(number), self.task.size)

    def show(self, pair: Pair) -> None:
        """Add the lines of coordinates other than zero; what is a number already is written once."""
        for value in pair:
            if value.exact != 0:
                plain = value.expression is None or not any(parts(value.expression))
                self.items.append(Derived(value, symbolic=not plain, numeric=not plain))

    def say(self, key: str, detail: bool = True, /, **facts: Fact) -> None:
        """Add a sentence of the file ``position``; a short solution leaves out a ``detail``."""
        self.items.append(Sentence(f"position.{key}", facts, detail))

    def _entered(self, name: Name, measure: str, expression: Expression) -> Value:
        """A value by its expression with the line that shows it; what is given or a plain number needs none."""
        if isinstance(expression, Value):
            return self._taken(expression)
        number = expression.number(True)
        if isinstance(expression, Constant):
            return Value(name, measure, number)
        value = Value(name, measure, number, expression, self.task.size if measure == "length" else 0.0)
        self.items.append(Derived(value))
        return value

    def _taken(self, value: Value) -> Value:
        """A given value, one in another unit converted first, or the angle that a law of time gives."""
        if value in self.printed.values():
            return value
        if value.expression is not None and not any(isinstance(i, Derived) and i.value is value for i in self.items):
            if value.name is not None and value.name.of not in self.task.given:  # found by a law of time
                self.say("law_angle", False, angle=value)
            same = [part for part in parts(value.expression) if part.name == value.name and part.expression]
            self.items += [*map(Derived, same), Derived(value, symbolic=not same)]
        return value

    # Corners of triangles.

    def corner(self, vertex: str, first: str, second: str, expression: Expression) -> Expression:
        """The angle of a triangle at a vertex, 0 to 180 degrees, with its line; a plain number needs none."""
        if isinstance(expression, Constant) or {vertex, first, second} & set(self.task.form.figure.hidden):
            return expression
        key = (vertex, frozenset(map(self._named_place, (first, second))))
        if key not in self._corners:
            self._corners[key] = self._entered(Name("angle", vertex, f"{first} {second}"), "angle", expression)
        return self._corners[key]

    def known_corner(self, vertex: str, first: str, second: str) -> Value | None:
        """A corner of a triangle that has a line already."""
        return self._corners.get((vertex, frozenset(map(self._named_place, (first, second)))))

    def _named_place(self, point: str) -> str:
        """The first of the points in one place: under a pin lies a point of the slotted link. A foot has its letter."""
        z = self.task.now.z
        return next(name for name in z if z[name] == z[point]) if point in z else point

    def foot(
        self, start: str, on_line: str, end: str, along: Expression, across: Expression, beyond: bool
    ) -> Pair | None:
        """The legs SH along a line and EH of the right triangle that a perpendicular from the end E makes, with lines.

        Its foot may lie ``beyond`` the start S, or beyond the other point of the line: then it is said that the line is
        produced. None where a point has no letter in the figure, or no letter is left.
        """
        if {start, on_line, end} & set(self.task.form.figure.hidden):
            return None
        key = (start, on_line, end)
        if key not in self._feet:
            letter = next((letter for letter in _FEET if letter not in self._taken_letters()), "")
            if not letter:
                return None
            to = Segment(*self.ordered(start, on_line))
            past = start if beyond else on_line
            is_off = beyond or along.number(True) > abs(self.vector(start, on_line))
            key_of = "perpendicular_beyond" if is_off else "perpendicular"
            self.say(key_of, False, line=Segment(end, letter), to=to, start=Point(past))
            down = self._entered(Name("length", end, letter), "length", across)
            self._feet[key] = self._entered(Name("length", start, letter), "length", along), down
        return self._feet[key]

    def projections(self, ends: tuple[str, str], axis: AngleForm, along: Expression, across: Expression) -> Pair | None:
        """The legs AH and BH of a right triangle on AB along and across a line of the figure, with their lines.

        None where the line or a point has no letters, or no letter is left.
        """
        start, end = ends
        if (start, "", end) not in self._feet:
            letter = next((letter for letter in _FEET if letter not in self._taken_letters()), "")
            shown = [name for name in self.places if name not in self.task.form.figure.hidden]
            lines = ((a, b) for a, b in combinations(shown, 2) if (form := self.data(a, b)) and form.is_along(axis))
            line = next(lines, None)
            if line is None or not letter or not set(ends) <= set(shown):
                return None
            corners = triangle(start, end, letter)
            self.say("projections", False, triangle=corners, leg=Segment(start, letter), line=Segment(*line))
            first = self._entered(Name("length", start, letter), "length", along)
            self._feet[start, "", end] = first, self._entered(Name("length", end, letter), "length", across)
        return self._feet[start, "", end]

    @property
    def lettered(self) -> set[str]:
        """The points that have letters in the figure."""
        return set(self.places) - set(self.task.form.figure.hidden)

    def say_triangle(self, ends: tuple[str, str], first: Leg, shape: str) -> None:
        """Say of the triangle with a base between two points and a side from the first what ``shape`` it has, the key
        of a sentence; once.
        """
        place = self.task.now.z[ends[0]] + cmath.rect(first.length.number(True), math.radians(self.number(first.form)))
        shown = self.lettered
        apex = next(
            (name for name in self.places if name in shown and abs(self.task.now.z[name] - place) <= self.nothing), ""
        )
        if apex and set(ends) <= shown:
            said = Sentence(f"position.{shape}", {"triangle": triangle(*sorted((*ends, apex)))}, detail=False)
            if said not in self.items:
                self.items.append(said)

    def _taken_letters(self) -> set[str]:
        """Letters of points, with the feet of perpendiculars."""
        return {*self.places, *(pair[0].name.about for pair in self._feet.values() if pair[0].name is not None)}

    def inclination(
        self, start: str, end: str, line: str, expression: Expression, on_line: tuple[str, ...] = ()
    ) -> Expression:
        """The acute angle between a segment and a line that has no second point with it, under a letter of its own.

        ``line`` is the key of the sentence that says which angle it is: ``guide``, ``horizontal``, ``vertical``, or
        ``link``, which two points are ``on_line``.
        """
        if isinstance(expression, Constant) or {start, end} & set(self.task.form.figure.hidden):
            return expression
        value = Value(self.letter(), "angle", expression.number(True), expression)
        facts: dict[str, Fact] = {"line": Segment(*self.ordered(*on_line))} if on_line else {"point": Point(end)}
        self.say(f"inclination_{line}", False, angle=value, segment=Segment(start, end), **facts)
        self.items.append(Derived(value))
        return value

    def letter(self) -> Name:
        """The name of an angle without points, by a number: those that are written get their Greek letters at last."""
        self._letters += 1
        return Name("inclination", str(self._letters))

    def ahead_on(self, start: str, form: AngleForm) -> str:
        """A point of the figure that lies in a direction from another one as it is given, or nothing."""
        hidden = self.task.form.figure.hidden
        for name in self.places:
            if name != start and name not in hidden and abs(self.vector(start, name)) > self.nothing:
                found = self.data(start, name)
                if found is not None and found.is_along(form) and between(self.number(found), self.number(form)) < 90:
                    return name
        return ""
