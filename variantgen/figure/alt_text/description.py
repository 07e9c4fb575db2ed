"""The alternative text of a figure: parts, hinges, joints, positions, marks, arrows, a sentence each."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Iterator, Sequence
from types import ModuleType

from variantgen.families.quantities import Quantity
from variantgen.figure.alt_text.alt_text import AltText, Noun
from variantgen.figure.alt_text.marks import marks
from variantgen.figure.alt_text.parts import hinges, parts
from variantgen.figure.alt_text.positions import positions
from variantgen.figure.axes import lines_of, origin_point
from variantgen.figure.board import Board
from variantgen.mechanism.component import field_specs
from variantgen.mechanism.rows import Constraint


def describe(board: Board, asked: Sequence[Quantity] = ()) -> str:
    """What a statement figure shows, in words, once it is drawn on ``board``; what is ``asked`` tells which axes.

    Tells what is fixed, what joins what, where each named point lies, which data are marked and the senses of the
    given rates: nothing that the figure does not show, in the language of the board.
    """
    alt_text = AltText(board)
    scene = board.scene
    joints = [_clauses(alt_text, items) for items in _by_kind(scene.joints)]
    driven = [_clauses(alt_text, items) for items in _by_kind(scene.drivers)]
    for driver in scene.drivers:
        arrows = getattr(_module(_stem(driver)), "arrows", None)
        alt_text.arrows += arrows(alt_text, driver) if arrows else []
    listed = [
        ("parts", parts(alt_text)),
        ("", hinges(alt_text)),
        *(("", clauses) for clauses in (*joints, *driven)),
        ("positions", positions(alt_text)),
        ("marks", [*marks(alt_text), *_axes(alt_text, asked)]),
        ("arrows", [arrow.phrase for arrow in alt_text.arrows]),
    ]
    sentences = [_sentence(alt_text, key, clauses) for key, clauses in listed if clauses]
    return " ".join(" ".join(sentences).split())


def _axes(alt_text: AltText, asked: Sequence[Quantity]) -> Iterator[str]:
    """The axes x and y, their origin where coordinates are counted from it, and the lines of other components."""
    if any(quantity.is_coordinate for quantity in asked):
        board = alt_text.board
        point = origin_point(board) or min(board.shown, key=lambda name: abs(board.sketch.at[name]))
        place = alt_text.name(point)
        yield alt_text.say(
            "axes_at", place=place if origin_point(board) else alt_text.place(-alt_text.at(point), place)
        )
    elif any(quantity.refers_to_axes for quantity in asked):
        yield alt_text.say("axes")
    for line, sides in lines_of(asked).items():
        for side in sides:
            yield alt_text.say(f"axis_{side}", line=line)


def _sentence(alt_text: AltText, key: str, clauses: Sequence[str]) -> str:
    """``Parts: a; b.`` or, without a key, ``A; b.``"""
    text = "; ".join(clauses)
    return alt_text.say(key, items=text) if key else f"{text[0].upper()}{text[1:]}."


def _by_kind(items: Sequence[Constraint]) -> list[list[Constraint]]:
    """Joints or drivers in groups of one kind, in the order in which the kinds appear."""
    groups: dict[type, list[Constraint]] = {}
    for item in items:
        groups.setdefault(type(item), []).append(item)
    return list(groups.values())


def _clauses(alt_text: AltText, items: Sequence[Constraint]) -> list[str]:
    """The clauses of joints or drivers of one kind."""
    stem = _stem(items[0])
    module = _module(stem)
    if module is not None:
        found: list[str] = module.tell(alt_text, items)
        return found
    clauses = [alt_text.say(stem, **_fields(alt_text, item)) for item in items]
    return [clause for clause in clauses if clause]


def _fields(alt_text: AltText, item: Constraint) -> dict[str, str | Noun]:
    """Names of the points and bodies that a joint or driver acts on, by field, as the figure shows them."""
    found: dict[str, str | Noun] = {}
    for spec in field_specs(type(item)):
        value = getattr(item, spec.name)
        if spec.ref and value is not None:
            tell = alt_text.name if spec.ref == "point" else alt_text.part
            found[spec.name] = "".join(str(tell(name)) for name in value) if spec.many else tell(value)
    return found


def _stem(item: Constraint) -> str:
    return type(item).__module__.rsplit(".", 1)[-1]


def _module(stem: str) -> ModuleType | None:
    """The module that tells a kind, if it has one."""
    name = f"{__package__}.kinds.{stem}"
    return importlib.import_module(name) if importlib.util.find_spec(name) else None
