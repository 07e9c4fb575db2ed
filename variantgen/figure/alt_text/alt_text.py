"""The words of one figure: phrases of the language, names of points and bodies as the figure shows them."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping, Sequence

from msgspec import Struct, field

from variantgen.figure.alt_text import directions
from variantgen.figure.alt_text.drawn import DrawnMechanism
from variantgen.mechanism.arithmetic import Real
from variantgen.wording.formula import Symbol, to_plain


class RateArrow(Struct, frozen=True):
    """A given rate: the phrase, its symbol and, for a straight arrow, the point and the way on paper (unit)."""

    phrase: str
    symbol: str
    point: str = ""
    way: complex = 0j


class Noun(Struct, frozen=True):
    """Words that inflect: ``{body}`` in a phrase is the plain form, ``{body.of}`` the one that a language calls so."""

    look_up: Callable[[str], str]  # from "" or the point and the name of a form, ``.of``

    def __str__(self) -> str:
        return self.look_up("")

    def __getattr__(self, form: str) -> str:
        return self.look_up(f".{form}")


class AltText(DrawnMechanism):
    """What a phrase may need of a figure that has been drawn on ``board``.

    What has been said is noted for what is said later: ``hinged`` are the points whose hinge a joint has mentioned,
    ``guided`` the directions of guides by point, ``arrows`` those of the drivers.
    """

    hinged: set[str] = field(default_factory=set)
    guided: dict[str, complex] = field(default_factory=dict)
    arrows: list[RateArrow] = field(default_factory=list)

    def say(self, key: str, **words: str | Noun) -> str:
        """A phrase of the table ``[figure]``, filled."""
        return self._phrases[key].format(**words)

    def noun(self, key: str, **words: str | Noun) -> Noun:
        """A phrase of the table ``[figure]`` that the phrase around it asks for in one of its forms."""
        return Noun(lambda form: self.say(key + form, **words))

    @property
    def _phrases(self) -> Mapping[str, str]:
        return self.board.language.words("figure")

    def listed(self, items: Sequence[str]) -> str:
        """``a, b and c``."""
        if len(items) < 2:
            return "".join(items)
        return self.say("and", first=", ".join(items[:-1]), last=items[-1])

    def parts(self, bodies: Sequence[str]) -> Noun:
        """Bodies in a sentence: ``disc 1, OA and AB``, each in the form that is asked for."""
        nouns = [self.part(body) for body in bodies]
        return Noun(lambda form: self.listed([noun.look_up(form) for noun in nouns]))

    # Directions.

    def heading(self, angle: Real) -> complex:
        """The unit vector on paper of a direction in the frame of the scene (rad)."""
        return complex(self.board.frame.place(cmath.rect(1.0, float(angle))))

    def place(self, vector: complex, origin: str) -> str:
        """Where a point lies that is at ``vector`` from a named one: ``above and to the right of O``."""
        if abs(vector) < 1e-6:
            return self.say("same_place", origin=origin)
        return self.board.language.words("figure_place")[directions.compass(vector)].format(origin=origin)

    def way(self, vector: complex) -> str:
        """Where a vector points: ``up and to the right``."""
        return self.board.language.words("figure_way")[directions.compass(vector)]

    def side(self, vector: complex) -> str:
        """On which side of a thing something is, in steps of 45 degrees: ``at the top``."""
        return self.board.language.words("figure_side")[directions.side(vector)]

    def line(self, vector: complex) -> str:
        """How a line runs: ``horizontally``, ``upwards to the right``."""
        return self.board.language.words("figure_line")[directions.line(vector)]

    def inclined(self, vector: complex) -> Noun:
        """The same as an attribute of what lies along the line: ``horizontal``."""
        return Noun(lambda form: self.board.language.words("figure_line_attribute")[directions.line(vector) + form])

    def sense(self, rate: float) -> str:
        """``clockwise`` for a negative rate on paper, else ``counter-clockwise``."""
        return self.say("counter_clockwise" if rate > 0 else "clockwise")

    def straight_arrow(
        self, key: str, point: str, ahead: complex, symbol: Symbol | None, **words: str
    ) -> list[RateArrow]:
        """An arrow at a point, or at a body by one of its points without a name; none for a rate that is not given."""
        if symbol is None or ahead == 0:
            return []
        name = to_plain(symbol)
        owners = self.owners(point)
        where = self.say("at_point", point=self.name(point))
        if not self.is_shown(point) and owners:
            where = self.say("at_body", body=self.body(owners[0]))
        return [RateArrow(self.say(key, symbol=name, where=where, **words), name, point, ahead / abs(ahead))]

    # Bodies.

    def body(self, body: str) -> str:
        """How a body is called: by its points, or by its number."""
        if self.is_spelled(body):
            return body
        return "".join(map(self.name, self.board.form.bodies[body])) or self.board.form.symbols.get(body, "")

    def number(self, centre: str, body: str = "") -> str:
        """The number that the figure gives to a disc, or nothing; a fixed one has no ``body``."""
        if body:
            return "" if self.is_spelled(body) else self.board.form.symbols.get(body, "")
        return next((circle.mark.label for circle in self.circles if circle.mark.centre == centre), "")

    def called(self, centre: str, body: str = "") -> str:
        """What follows a word like gear: its number, or ``with centre O``."""
        return self.number(centre, body) or self.say("with_centre", centre=self.name(centre))

    def disc(self, centre: str, body: str) -> Noun:
        """``disc 1`` or ``the disc with centre O``."""
        number = self.number(centre, body)
        return self.noun("disc", number=number) if number else self.noun("disc_about", centre=self.name(centre))

    def rim(self, body: str, radius: float) -> str:
        """Which rim of a stepped disc has a radius (u): `` (its larger rim)``; nothing for a disc with one rim."""
        larger = self.is_larger(body, radius)
        return "" if larger is None else self.say("larger_rim" if larger else "smaller_rim")

    def part(self, body: str) -> Noun:
        """A body in a sentence, ``disc 1`` or ``OA``."""
        circles = self.circles_of(body)
        if circles and not self.is_spelled(body):
            return self.disc(circles[0].mark.centre, body)
        return self.noun("body", body=self.body(body))

    def hinge(self, point: str) -> Noun:
        """``, hinged to OA and AB`` for a block or a sleeve.

        Nothing for a block of no body; a block on a fixed hinge turns about it.
        """
        owners = self.owners(point)
        self.hinged.add(point)
        if owners:
            return self.noun("hinged", bodies=self.parts(owners))
        return self.noun("on_fixed_hinge") if point in self.fixed else Noun(lambda form: "")
