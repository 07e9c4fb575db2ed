"""Sums of angles that have a name: each is worked out once, and where it is long before it is used."""

from __future__ import annotations

from dataclasses import replace

from variantgen.algebra.expression import Constant, Value
from variantgen.methods.geometry.angle_sums import angle_sum, is_short, is_single, valued
from variantgen.methods.geometry.angles import AngleForm, form_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, Share

_RIGHT = 90.0  # degrees
_DIGITS = 6  # decimals of a number of degrees by which sums are told apart


def _key(form: AngleForm) -> AngleForm:
    return form_of(form.parts, round(form.constant, _DIGITS) + 0.0)


def by_name(book: Book, angle: Value) -> Value:
    """An angle as one that has a name already, if there is one."""
    found = book.named_angles.get(_key(angle_sum(angle)))
    return angle if found is None else Value(angle.name, "angle", angle.exact, found)


def note_sum(book: Book, angle: Value) -> None:
    """Note that a sum of angles has a name and a line."""
    book.named_angles.setdefault(_key(angle_sum(angle)), angle)


def named(book: Book, share: Share) -> Share:
    """A projection whose angle, if it is a long sum, is named: by a corner found before, or by a letter with a line."""
    found = renamed(book, share)
    if found is not share or share.angle is None or is_short(form := angle_sum(share.angle)):
        return found
    angle = valued(book.geometry.letter(), form)
    book.items.append(Derived(angle))
    note_sum(book, angle)
    return replace(share, angle=angle)


def renamed(book: Book, share: Share) -> Share:
    """A projection with the angle that has a name, where its sum is that or its complement or supplement."""
    if share.angle is None or is_single(form := angle_sum(share.angle)):
        return share
    for constant, sign, function in ((0.0, 1.0, share.function), (90.0, -1.0, _OTHER[share.function])):
        found = book.named_angles.get(_key(form.times(sign).turned(constant)))
        if found is not None:
            return replace(share, angle=found, function=function)
    found = book.named_angles.get(_key(form.times(-1.0).turned(180.0)))
    if found is not None and ((share.function == "sin" and found.exact < _RIGHT) or not is_short(form)):
        rest = Constant(180.0, "angle") - found
        return replace(share, angle=found if share.function == "sin" else Value(None, "angle", rest.number(True), rest))
    return share


_OTHER = {"cos": "sin", "sin": "cos"}
