"""Whether words for senses agree with the numbers: faster and slower, clockwise, up and down, left and right."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from variantgen.check.printed import Fault
from variantgen.check.statement_reading import Mention, Sense, StatementReading
from variantgen.families.family import Form
from variantgen.mechanism.motion import Motion
from variantgen.variants.variant import Variant

_NOTHING = 1e-9  # relative to the largest of its kind: what has no sense
_SPEEDS = {"faster": 1, "slower": -1}
_TURNS = {"counter_clockwise": 1, "clockwise": -1}
_WAYS = {"up": 1j, "down": -1j, "left": -1, "right": 1}
_GROWTH = {"grows": 1, "shrinks": -1}


def wrong_senses(sheet: StatementReading, variant: Variant, motion: Motion, place: int) -> Iterator[Fault]:
    """Words for senses in a statement that the numbers contradict.

    A word belongs to the nearest name before it that has such a sense, or to the nearest after it: in its clause, or
    else in its sentence.
    """
    reader = _Numbers(variant.form, motion, place)
    for sense in sheet.senses:
        for table, measure in (
            (_SPEEDS, reader.speeding),
            (_TURNS, reader.turning),
            (_GROWTH, reader.growing),
        ):
            if sense.key in table and (found := _nearest(sheet, sense, measure)):
                name, value = found
                if value * table[sense.key] <= 0:
                    yield _fault(sense, name)
        if sense.key in _WAYS and (found := _nearest(sheet, sense, reader.way)):
            name, vector = found
            if (vector * np.conj(_WAYS[sense.key])).real <= 0:
                yield _fault(sense, name)


def _fault(sense: Sense, name: str) -> Fault:
    message = f"the text says {sense.word!r} of {name}, which the numbers contradict"
    return message, f"{message}; say it by speeding, speeds or choice, or leave it to the figure"


def _nearest(sheet: StatementReading, sense: Sense, measure: Callable[[str], Any]) -> tuple[str, Any] | None:
    """The name that a word belongs to, and what is measured of it."""
    first, last = (
        bisect(sheet.mentions, sense.place.sentence, key=lambda mention: mention.place.sentence)
        for bisect in (bisect_left, bisect_right)
    )

    def distance(mention: Mention) -> tuple[bool, bool, int]:
        ahead = mention.place > sense.place
        return mention.place.clause != sense.place.clause, ahead, abs(mention.place.at - sense.place.at)

    for mention in sorted(sheet.mentions[first:last], key=distance):
        value = measure(mention.name)
        if value is not None:
            return mention.name, value
    return None


class _Numbers:
    """What the numbers of one variant say of a name; None where it has no such sense."""

    def __init__(self, form: Form, motion: Motion, place: int) -> None:
        self._form, self._motion, self._place = form, motion, place
        self._drivers = list(zip(form.drivers, motion.scene.drivers, strict=True))

    def speeding(self, name: str) -> float | None:
        """Whether the motion whose acceleration has this name gets faster: 1, or slower: -1."""
        driver = self._driver(name, (2,))
        if driver is None:
            return None
        first, second = (self._rates(driver, order) for order in (1, 2))
        return float(np.sign(np.dot(first, second))) if np.any(first) and np.any(second) else None

    def growing(self, name: str) -> float | None:
        """Whether the distance whose rate has this name grows: 1, or shrinks: -1."""
        driver = self._driver(name, (1,))
        if driver is None or len(driver.shapes()[0].points) != 2 or driver.shapes()[0].bodies:
            return None
        return float(np.sign(self._rates(driver, 1)[0])) or None

    def turning(self, name: str) -> float | None:
        """The sense in which a body turns, or changes its rate, by the name of the body or of the datum."""
        driver = self._driver(name, (1, 2))
        table = self._motion.omega
        if driver is not None:
            bodies: Sequence[str] = () if driver.shapes()[0].points else driver.shapes()[0].bodies
            table = self._motion.epsilon if self._form.parameters[name].of_second_order else table
        else:
            bodies = (name,) if name in self._motion.omega else ()
        if not bodies or any(body not in table for body in bodies):
            return None
        rates = [float(table[body][self._place]) for body in bodies]
        rate = rates[0] - sum(rates[1:])
        scale = max((float(np.abs(values[self._place])) for values in table.values()), default=0.0)
        return float(np.sign(rate)) if abs(rate) > _NOTHING * scale else None

    def way(self, name: str) -> complex | None:
        """The direction on paper in which a point moves, or changes its velocity."""
        driver = self._driver(name, (1, 2))
        point, table = name, self._motion.v
        if driver is not None:
            shape = driver.shapes()[0]
            point = shape.points[0] if len(shape.points) == 1 and not shape.bodies else ""
            table = self._motion.a if self._form.parameters[name].of_second_order else table
        if point not in table:
            return None
        vector = complex(table[point][self._place])
        scale = max(float(np.abs(values[self._place])) for values in table.values())
        return vector if abs(vector) > _NOTHING * scale else None

    def _driver(self, name: str, orders: Sequence[int]) -> Any:
        """The driver that takes a rate of this name."""
        parameter = self._form.parameters.get(name)
        if parameter is None or not parameter.is_rate or (2 if parameter.of_second_order else 1) not in orders:
            return None
        for template, driver in self._drivers:
            used = set(template.names)
            for derived, expression in reversed(list(self._form.derived.items())):
                used |= expression.names if derived in used else set()
            if name in used:
                return driver
        return None

    def _rates(self, driver: Any, order: int) -> Any:
        """The prescribed rates of a driver for this variant, a number for each of its rows."""
        rates = driver.rates(order)
        return np.array([np.broadcast_to(rate, (self._motion.size,))[self._place] for rate in rates], dtype=float)
