"""Answers as students write them: got wrong by one cause after the other, and right ones in many spellings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

from variantgen.exam.sheets import Answer
from variantgen.marking.diagnosis.plausible_mistakes import OfProblem
from variantgen.marking.key import scale

_UNITS = {(1, 0): (0.01,), (1, -1): (0.01, 3.6), (1, -2): (0.01,), (0, -1): (57.29578, 9.549297), (0, -2): (57.29578,)}
# Spellings of units, and the powers of ten by which numbers in them are other ones.
_SPELLINGS = {
    "cm": (("cm", 0), ("см", 0), ("m", -2), ("мм", 1)),
    "m": (("m", 0), ("cm", 2), ("мм", 3)),
    "cm/s": (("cm/s", 0), ("см/с", 0), ("m/s", -2), ("м·с⁻¹", -2), ("mm/s", 1)),
    "m/s": (("m/s", 0), ("м/сек", 0), ("cm/s", 2), ("мм / с", 3)),
    "cm/s^2": (("cm/s^2", 0), ("см/с²", 0), ("m/s2", -2), ("m s^-2", -2)),
    "m/s^2": (("m/s^2", 0), ("м/с²", 0), ("cm/s2", 2)),
    "rad/s": (("rad/s", 0), ("рад/с", 0), ("1/s", 0), ("с^-1", 0)),
    "rad/s^2": (("rad/s^2", 0), ("рад/с²", 0), ("1/s^2", 0), ("с⁻²", 0)),
    "deg": (("deg", 0), ("°", 0), ("град", 0)),
}
_GROUP = 3  # digits of a group of thousands


def written(value: float) -> float:
    """A number as a student writes it."""
    return float(f"{value:.4g}")


def width_of(answer: Answer) -> float:
    """How far a number may be from the right one, in the unit of the answer."""
    return answer.tolerance * (1.0 if answer.quantity.is_angle else abs(answer.value) / scale(answer))


def planted(answer: Answer, name: str, results: OfProblem, siblings: Sequence[Answer]) -> Iterator[tuple[str, float]]:
    """Wrong answers by their causes, those of mistakes with the name of the mistake."""
    yield "sign", -answer.value
    if not answer.quantity.is_angle:
        yield "power_of_ten", 10.0 * answer.value
        for factor in _UNITS.get(answer.unit.dimension, ()):
            yield "unit", factor * answer.value
    mistakes, parts = results
    for mistake, value in mistakes[name].items():
        yield f"mistake: {mistake}", value
    for part, value in parts[name].items():
        yield f"component: {part}", value
    for other in siblings:
        alike = (other.unit.dimension, other.quantity.is_angle) == (answer.unit.dimension, answer.quantity.is_angle)
        if alike and other.quantity != answer.quantity:
            yield "other_answer", answer.unit.from_si(other.value * other.unit.size)
    yield "rounding", answer.value + 2.0 * width_of(answer)


def spelled(answer: Answer) -> Iterator[str]:
    """A right answer and both ends of its tolerance, in many spellings and in other units by exact powers of ten."""
    right, tolerance = Decimal(repr(answer.value)), Decimal(repr(answer.tolerance))
    yield f"{written(answer.value)!r}"
    for value in (right, right - tolerance, right + tolerance):
        plain = f"{value:f}"
        yield plain
        yield plain.replace(".", ",")
        yield f" \N{MINUS SIGN}{plain[1:]}" if value < 0 else f"+{plain}"
        yield f"{value.scaleb(2):f}*10^-2"
        yield f"{value.scaleb(-3):f}e3"
        whole, dot, rest = plain.lstrip("-").partition(".")
        if len(whole) > _GROUP:
            yield f"{'-' * (value < 0)}{whole[:-_GROUP]} {whole[-_GROUP:]}{dot and ','}{rest}"
        for name, power in _SPELLINGS.get(answer.unit.name, ()):
            yield f"{value.scaleb(power):f} {name}"
            yield f"{value.scaleb(power):f}".replace(".", ",") + f" {name}"
