"""What the statement and the figure give of the position: lengths, directions of lines, coordinates.

Constructions, conditions and marks of the figure are read once. The solved position only decides which side, which
sense, and what is zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from variantgen.algebra.expression import Constant, Expression, Total, Value
from variantgen.algebra.normal_form import summed
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.conditions.distance import Distance
from variantgen.mechanism.conditions.line import PointOnLine
from variantgen.methods.geometry.angles import AngleForm, Angles, Atom, corner_name, degrees, normal_angle
from variantgen.methods.geometry.legs import Leg, collected
from variantgen.methods.geometry.lines import Lines
from variantgen.methods.geometry.located_point import ORIGIN, LocatedPoint, Ray
from variantgen.methods.linkage.problem import CLOSE, Task

_NOTHING = 1e-10  # of the size: a length below it is none
_SAME = 1e-7  # degrees within which an angle of the figure is that of the position
_AXES = {"+x": 0.0, "+y": 90.0, "-x": 180.0, "-y": -90.0}


class Layout:
    """The given geometry of one variant; ``places`` are its points in the order in which they can be placed.

    ``printed`` are the angles of the position that the sheet prints, by their three points, the corner in the middle.
    """

    def __init__(self, task: Task) -> None:
        self.task = task
        self.angles = Angles(task)
        self.nothing = _NOTHING * task.size
        self.places: dict[str, LocatedPoint] = {}
        self._ranks: dict[str, int] = {}
        self._lines = Lines(task.now.z, self.nothing, self.number)
        self._stated: dict[frozenset[str], Expression] = {}
        self._bases: dict[str, AngleForm] = {}
        self._plain: dict[str, tuple[Leg, ...]] = {}
        self._data: dict[tuple[str, str], AngleForm | None] = {}  # directions that were asked, as lines are known
        self._bearings: dict[tuple[str, str], float] = {}
        self.printed = {corner: self._printed_angle(*corner) for corner in task.form.figure.found}
        self._marks = self._marked()

    def read(self, places: Mapping[str, LocatedPoint]) -> None:
        """Note what the constructions, the conditions and the figure give."""
        for name, place in places.items():
            self.places[name] = place
            self._ranks[name] = len(self._ranks)
            for ray in place.rays():
                self._line(ray.start, ray.end, self._based(ray))
            self._read_marks(name)
            self._stated |= {frozenset(pair): length for pair, length in place.lengths().items()}
        for condition in self.task.form.conditions:
            fields = condition.fields
            if condition.component is Distance:
                self._stated[frozenset((fields["start"], fields["end"]))] = self.read_length(fields["length"])
            if condition.component is PointOnLine and fields.get("towards") is None:
                angle = self.angles.on_paper(self.angles.read(fields.get("angle")))
                self._line(fields["through"], fields["point"], angle)

    def _based(self, ray: Ray) -> AngleForm:
        """The direction of a ray; the first one by an angle that only the drawing shows is the base of the others."""
        form = self.on_bases(ray.form)
        if len(form.parts) == 1 and isinstance(name := form.parts[0][0], str) and self.angles.is_silent(name):
            low, high = self.ordered(ray.start, ray.end)
            here = AngleForm((((low, high), 1.0),), 0.0 if low == ray.start else 180.0)
            self._bases[name] = here.turned(-form.constant).times(1.0 / form.parts[0][1])
            return here
        return form

    def on_bases(self, form: AngleForm) -> AngleForm:
        """A sum of angles with those that only the drawing shows replaced by directions in it."""
        for atom, coefficient in form.parts:
            if isinstance(atom, str) and atom in self._bases:
                form = form.minus(AngleForm(((atom, coefficient),))).plus(self._bases[atom], coefficient)
        return form

    def is_drawn(self, start: str, end: str) -> bool:
        """Whether a direction is a base: only the drawing shows it."""
        return any(base.parts[0][0] == (start, end) for base in self._bases.values())

    def _printed_angle(self, start: str, at: str, end: str) -> Value:
        """An angle that the sheet prints although the position decides it: known, and rounded like all others."""
        size = abs(normal_angle(self.bearing(at, end) - self.bearing(at, start)))
        return Value(corner_name(at, start, end), "angle", size, Constant(size, "angle"))

    def _marked(self) -> list[tuple[str, str, str, Atom]]:
        """Angles that the figure or the sheet gives: the corner, a point on each side, from the one that is known."""
        found: list[tuple[str, str, str, Atom]] = [
            (mark.at, mark.start, mark.end, mark.name)
            for mark in self.task.form.figure.angles
            if mark.name in self.task.given
        ]
        for (start, at, end), angle in self.printed.items():
            found += [(at, start, end, angle), (at, end, start, angle)]
        return found

    def _read_marks(self, newest: str) -> None:
        """Angles that the figure or the sheet gives between a known ray and another one, with the newest point."""
        for at, start, end, angle in self._marks:
            if newest in (at, start, end) and {at, start, end} - _AXES.keys() <= self.places.keys():
                self._read_angle(at, start, end, angle)

    def _read_angle(self, at: str, start: str, end: str, angle: Atom) -> None:
        """The direction of the second side of an angle by that of the first."""
        known = self._side(at, start)
        if known is None and isinstance(angle, Value) and start in self.places[at].neighbours():
            known = self.form(at, start)  # of a triangle
        if known is None or self.data(at, end) is not None:
            return
        turn = normal_angle(self.bearing(at, end) - self.number(known))
        size = AngleForm(((angle, 1.0),))
        if abs(abs(turn) - self.number(size)) < _SAME:
            self._line(at, end, known.plus(size, 1.0 if turn > 0 else -1.0))

    def _side(self, at: str, start: str) -> AngleForm | None:
        if start in _AXES:
            return self.angles.on_paper(AngleForm((), _AXES[start]))
        return self.data(at, start)

    # The solved position: only for questions of sense and side.

    def vector(self, start: str, end: str) -> complex:
        """The vector between two points as it was solved (printed unit of length)."""
        return self.task.now.z[end] - self.task.now.z[start]

    def bearing(self, start: str, end: str) -> float:
        """The direction of a ray as it was solved (degrees)."""
        if (start, end) not in self._bearings:
            self._bearings[start, end] = degrees(self.vector(start, end))
        return self._bearings[start, end]

    def number(self, form: AngleForm) -> float:
        """The degrees of a sum of angles, between -180 and 180."""
        return normal_angle(self.total(form))

    def total(self, form: AngleForm) -> float:
        """The degrees of a sum of angles, whole turns kept."""
        return form.constant + sum([c * self._degrees(atom) for atom, c in form.parts])

    def _degrees(self, atom: Atom) -> float:
        if isinstance(atom, Value):
            return atom.exact
        return self.angles.value(atom).exact if isinstance(atom, str) else self.bearing(*atom)

    def is_nothing(self, length: Expression) -> bool:
        """Whether a length is zero but for rounding."""
        return abs(length.number(True)) <= self.nothing

    # What is given.

    def read_length(self, expression: FamilyExpression) -> Expression:
        """A length of the family in the printed unit; one that cannot be written out is a number of the drawing."""
        found = self.task.expressed(expression)
        if found is None:
            return Constant(self.task.read(expression) / self.task.length_unit, "length")
        return summed([(1, found)]) if isinstance(found, Total) else found

    def stated(self, start: str, end: str) -> Expression | None:
        """The given distance of two points: of a construction, or a parameter named or dimensioned like it."""
        found = self._stated.get(frozenset((start, end)))
        if found is not None:
            return found
        form = self.task.form
        marks = [m.name for m in form.figure.lengths if {m.start, m.end} == {start, end}]
        for name in (start + end, end + start, *marks):
            value = self.task.given.get(name)
            if value is None or value.measure != "length" or not form.parameters[name].given:
                continue
            if abs(value.exact - abs(self.vector(start, end))) <= CLOSE * self.task.size:
                return value
        return None

    def form(self, start: str, end: str) -> AngleForm:
        """The direction of a ray as a sum of given angles, or by itself."""
        found = self.data(start, end)
        if found is not None:
            return found
        low, high = self.ordered(start, end)
        return AngleForm((((low, high), 1.0),), 0.0 if low == start else 180.0)

    def _line(self, start: str, end: str, form: AngleForm) -> None:
        """Note that a line of this direction goes through two points."""
        self._lines.add(start, end, form)
        self._data.clear()

    def data(self, start: str, end: str) -> AngleForm | None:
        """The direction as it is given: along a line, or along an axis between given coordinates."""
        if (start, end) not in self._data:
            self._data[start, end] = self._given(start, end)
        return self._data[start, end]

    def _given(self, start: str, end: str) -> AngleForm | None:
        found = self._lines.form(start, end)
        if found is None and self.is_given(start) and self.is_given(end):
            legs = [*(leg.reversed() for leg in self.plain_legs(start)), *self.plain_legs(end)]
            kept = collected(legs, self.nothing)
            found = kept[0].form if len(kept) == 1 else None
        return found

    def is_given(self, point: str) -> bool:
        """Whether a point is given by its coordinates."""
        place = self.places[point]
        return ORIGIN in place.neighbours() and not place.in_system

    def plain_legs(self, point: str) -> Iterable[Leg]:
        """The legs from the origin to a point given by its coordinates."""
        if point not in self._plain:
            self._plain[point] = self.places[point].legs(ORIGIN)
        return self._plain[point]

    def ordered(self, start: str, end: str) -> tuple[str, str]:
        """Two points in the order in which they are placed."""
        return (start, end) if self._ranks[start] <= self._ranks[end] else (end, start)
