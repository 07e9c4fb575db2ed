"""Vector equations solved by drawing: known vectors laid off to scale, lines of known directions, lengths measured.

One plan holds all vectors of an instant: they start at its pole, and their ends are the images of the points. An
equation with two unknown magnitudes is solved where two lines cross; what is asked is then measured. The exact numbers
behind are those of a drawing without errors; printed readings are rounded to 0.1 mm.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.decimals import DRAWING_LENGTH
from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.steps.step import Derived, Fact, NumberOf, Sentence, Term, VectorLine, VectorOf

_SAME = 1e-9  # of the largest vector: two places of a plan that are one


class Spot(Struct, frozen=True):
    """A place of a plan and how it is called: the image of a point, or the end (or start) of a vector."""

    at: complex
    name: Name
    kind: str = "image"

    @property
    def called(self) -> Sentence:
        """How a sentence calls it: the point b, the end of v_B."""
        fact: Fact = self.name if self.kind == "image" else VectorOf(self.name)
        return Sentence(f"graphical.{self.kind}", {"name": fact})


class PlanDrawing:
    """One plan under construction. ``scale`` is what a millimetre stands for, ``pole`` the letter of the pole."""

    def __init__(self, letter: str, scale: Value, pole: str) -> None:
        self.letter = letter
        self.scale = scale
        self.measure = scale.measure
        self.pole = Spot(0j, Name("pole", pole))
        self.images: dict[str, Spot] = {}

    # What an equation asks for.

    def write(self, book: Book, left: Sequence[Term], right: Sequence[Term], start: int) -> None:
        """The equation; the vector of a point that is in the plan already is written as a whole."""
        sides = [self._wholes(book, side) for side in (left, right)]
        book.items.insert(start, VectorLine(sides[0], sides[1]))

    def solve(self, book: Book, left: Sequence[Term], right: Sequence[Term], wanted: Sequence[Term]) -> list[Value]:
        """Draw an equation with one or two unknown vectors; the wanted ones are measured.

        A negative number means that the vector points against its assumed direction.
        """
        free = [[term for term in side if term.size is None] for side in (left, right)]
        if len(free[0]) == len(free[1]) == 1:
            found = self._from_both_sides(book, (left, right), (free[0][0], free[1][0]))
        elif len(free[0]) + len(free[1]) == 2:
            sides = (left, right) if free[1] else (right, left)
            found = self._from_two_ends(book, sides, free[0] + free[1])
        else:
            sides = (left, right) if free[1] else (right, left)
            found = self._closed(book, sides, (free[0] + free[1])[0])
        return [self._measured(book, term, found[term.name]) for term in wanted]

    def compose(self, book: Book, name: Name, terms: Sequence[Term]) -> Known:
        """The sum of known vectors, laid off one after the other and measured from the pole."""
        end = self._chain(book, terms)
        self.images[name.of] = Spot(end.at, self._image(name.of))
        book.say("graphical.end_is", False, name=self.images[name.of].name, vector=VectorOf(name))
        if abs(end.at) <= _SAME * book.size_of(self.measure):
            return ()
        size = self._reading(book, name, end.at)
        return (Term(name, size, Value(None, "angle", degrees(end.at)), Sentence("graphical.as_drawn")),)

    def size(self, book: Book, name: Name, terms: Known) -> Value:
        """The magnitude of a known vector, measured."""
        if not name.about and not name.part:
            self._spot(book, name.of)
        return self._reading(book, name, resultant(terms))

    def component(self, book: Book, name: Name, terms: Sequence[Term]) -> Expression:
        """A projection on an axis of the paper (``x`` or ``y`` in the name), measured."""
        whole = resultant(terms)
        length = (whole.imag if "y" in name.part.split() else whole.real) / self.scale.exact
        if abs(length) * self.scale.exact <= _SAME * book.size_of(self.measure):
            return Constant(0.0)
        reading = self._drawn(name, abs(length))
        self._say_reading(book, reading)
        return reading * self.scale if length > 0 else -(reading * self.scale)

    # The three constructions.

    def _from_both_sides(
        self, book: Book, sides: tuple[Sequence[Term], Sequence[Term]], free: tuple[Term, Term]
    ) -> dict[Name, complex]:
        """An unknown vector on each side: both chains end in lines that cross at the end of the vector sought."""
        spots = [self._chain(book, [term for term in side if term.size is not None]) for side in sides]
        for spot, term in zip(spots, free, strict=True):
            self._say_line(book, spot, term)
        place = _crossing(spots[0].at, _way(free[0]), spots[1].at, _way(free[1]))
        point = free[0].name.of
        self._enter(book, point, place)
        return {term.name: place - spot.at for spot, term in zip(spots, free, strict=True)}

    def _from_two_ends(
        self, book: Book, sides: tuple[Sequence[Term], Sequence[Term]], free: Sequence[Term]
    ) -> dict[Name, complex]:
        """Both unknown vectors on one side: its chain is drawn from its start and, backwards, from the known sum."""
        first, second = free
        index = next(i for i, term in enumerate(sides[1]) if term is first)
        start = self._chain(book, sides[1][:index])
        end = self._chain(book, sides[0])
        for term in sides[1][index + 1 :]:
            if term.size is not None and term.size.exact:
                end = self._lay_back(book, end, term)
        self._say_line(book, start, first)
        self._say_line(book, end, second)
        place = _crossing(start.at, _way(first), end.at, _way(second))
        self._enter(book, first.name.of, place, transport=bool(first.name.about) or "tr" in first.name.part.split())
        return {first.name: place - start.at, second.name: end.at - place}

    def _closed(self, book: Book, sides: tuple[Sequence[Term], Sequence[Term]], free: Term) -> dict[Name, complex]:
        """One unknown vector: it closes the polygon."""
        end = self._chain(book, sides[0])
        start = self._chain(book, [term for term in sides[1] if term is not free])
        book.say("graphical.closing", False, start=start.called, end=end.called, vector=VectorOf(free.name))
        return {free.name: end.at - start.at}

    # Chains of vectors.

    def _chain(self, book: Book, terms: Sequence[Term]) -> Spot:
        """Lay off known vectors one after the other; what begins with the vector of a point starts at its image."""
        point, rest = _begin(self._known(book), terms)
        spot = self._spot(book, point) if point else self.pole
        for term in rest:
            if term.size is not None and term.size.exact:
                spot = self._lay(book, spot, term)
        return spot

    def _spot(self, book: Book, point: str) -> Spot:
        """The image of a point whose vector is known; it is laid off now if it is not there yet."""
        if point not in self.images:
            terms, spot = self._known(book)[point], self.pole
            place = resultant(terms)
            same = [old for old in self.images.values() if abs(old.at - place) <= _SAME * book.size_of(self.measure)]
            if same:
                book.say("graphical.coincides", False, name=self._image(point), other=same[0].name)
            else:
                for term in terms:
                    spot = self._lay(book, spot, term)
                book.say("graphical.end_is", False, name=self._image(point), vector=VectorOf(Name(self.letter, point)))
            self.images[point] = Spot(place, self._image(point))
        return self.images[point]

    def _lay(self, book: Book, spot: Spot, term: Term) -> Spot:
        """Lay off a known vector from a place; returns its end."""
        book.say("graphical.lay", False, start=spot.called, vector=VectorOf(term.name), way=term.way)
        self._say_length(book, term)
        return Spot(spot.at + resultant((term,)), term.name, "end")

    def _lay_back(self, book: Book, spot: Spot, term: Term) -> Spot:
        """Lay off a known vector that ends at a place; returns its start."""
        book.say("graphical.lay_back", False, end=spot.called, vector=VectorOf(term.name), way=term.way)
        self._say_length(book, term)
        return Spot(spot.at - resultant((term,)), term.name, "start")

    def _say_length(self, book: Book, term: Term) -> None:
        assert term.size is not None
        length = term.size / self.scale
        book.items.append(Derived(Value(self._drawn_name(term.name), DRAWING_LENGTH, length.number(True), length)))

    def _say_line(self, book: Book, spot: Spot, term: Term) -> None:
        book.say("graphical.line", False, place=spot.called, vector=VectorOf(term.name), way=term.way)

    def _enter(self, book: Book, point: str, place: complex, transport: bool = False) -> None:
        """The place where two lines cross: the image of a point, or of the point of the carrier below it."""
        name = self._image(point, "tr" if transport else "")
        if not transport:
            self.images[point] = Spot(place, name)
        book.say("graphical.crossing", False, name=name)

    # Readings.

    def _known(self, book: Book) -> Mapping[str, Known]:
        """The vectors known so far, of the kind of this plan."""
        return book.velocity if self.letter == "v" else book.acceleration

    def _measured(self, book: Book, term: Term, vector: complex) -> Value:
        """The magnitude of a vector that has been found, with the sign that its assumed direction gives it."""
        if abs(vector) <= _SAME * book.size_of(self.measure):
            book.say("graphical.nothing", False, vector=VectorOf(term.name))
            return Value(term.name, self.measure, 0.0, None, book.size_of(self.measure))
        size = self._reading(book, term.name, vector)
        ahead = (vector * _way(term).conjugate()).real > 0
        return size if ahead else Value(term.name, self.measure, -size.exact, -size, size.size)

    def _reading(self, book: Book, name: Name, vector: complex) -> Value:
        """The magnitude of a vector of the plan: its length times the scale."""
        reading = self._drawn(name, abs(vector) / self.scale.exact)
        self._say_reading(book, reading)
        return book.derive(name, self.measure, reading * self.scale)

    def _say_reading(self, book: Book, reading: Value) -> None:
        book.say("graphical.measured", False, reading=reading, value=NumberOf(reading))

    def _drawn(self, name: Name, length: float) -> Value:
        return Value(self._drawn_name(name), DRAWING_LENGTH, length, Constant(length))

    def _drawn_name(self, name: Name) -> Name:
        """The length on paper of a vector: ``l`` with the index of the vector."""
        return replace(name, kind="drawn", body=self.letter)

    def _image(self, point: str, part: str = "") -> Name:
        return Name("image", point, part=part, body=self.letter)

    def _wholes(self, book: Book, terms: Sequence[Term]) -> tuple[Term, ...]:
        """A side of an equation, with the parts of the vector of a point at its beginning as one."""
        point, rest = _begin(self._known(book), terms)
        if not point:
            return tuple(terms)
        whole, name = resultant(self._known(book)[point]), Name(self.letter, point)
        size, angle = Value(name, self.measure, abs(whole)), Value(None, "angle", degrees(whole))
        return (Term(name, size, angle, Sentence("graphical.as_drawn")), *rest)


def _begin(vectors: Mapping[str, Known], terms: Sequence[Term]) -> tuple[str, Sequence[Term]]:
    """The point with whose known vector a side begins, if with any, and the terms after it."""
    for point, known in vectors.items():
        head = terms[: len(known)]
        if known and len(head) == len(known) and all(a is b for a, b in zip(head, known, strict=True)):
            return point, terms[len(known) :]
    return "", terms


def _way(term: Term) -> complex:
    """The unit vector of the direction of a term."""
    angle = math.radians(term.angle.exact)
    return complex(math.cos(angle), math.sin(angle))


def _crossing(start: complex, way: complex, end: complex, other: complex) -> complex:
    """Where two lines cross, given by a place and a direction each."""
    return start + way * ((end - start) * other.conjugate()).imag / (way * other.conjugate()).imag
