"""A solution as a document without a look: sections with paragraphs, lines of formulas, tables of vectors, programs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from msgspec import Struct, field

from variantgen.families.quantities import Quantity
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.step_geometry import StepGeometry
from variantgen.wording.formula import Formula, Number
from variantgen.wording.text import Text


class Paragraph(Struct, frozen=True):
    """Text with formulas in it."""

    text: Text


class FormulaLine(Struct, frozen=True):
    """A formula in pieces between which it may be broken: ``v_A``, ``= omega OA``, ``= 3 * 40``, ``= 120 cm/s``."""

    pieces: tuple[tuple[str, Formula], ...]


class FormulaLines(Struct, frozen=True):
    """Formulas one after the other."""

    lines: tuple[FormulaLine, ...]


class VectorTableRow(Struct, frozen=True):
    """A vector of an equation: itself, its direction in words, its magnitude (None: unknown)."""

    vector: Formula
    direction: Text
    magnitude: Formula | None


class VectorTable(Struct, frozen=True):
    """The vectors of an equation with what is known of them."""

    heads: tuple[str, str, str]
    unknown: str
    rows: tuple[VectorTableRow, ...]


class Program(Struct, frozen=True):
    """A listing and what it prints."""

    code: str


Block: TypeAlias = Paragraph | FormulaLines | VectorTable | Program


def append_block(blocks: list[Block], block: Block) -> None:
    """Add a block, if it says anything; formulas join formulas, and sentences sentences."""
    last = blocks[-1] if blocks else None
    if isinstance(block, Paragraph) and not block.text:
        return
    if isinstance(block, FormulaLines) and isinstance(last, FormulaLines):
        blocks[-1] = FormulaLines(last.lines + block.lines)
    elif isinstance(block, Paragraph) and isinstance(last, Paragraph):
        blocks[-1] = Paragraph((*_ended(last.text), " ", *block.text))
    else:
        blocks.append(block)


def _ended(text: Text) -> Text:
    """A sentence with a full stop where it announces formulas that do not follow."""
    *first, last = text
    return (*first, f"{last[:-1]}.") if isinstance(last, str) and last.endswith(":") else text


def both_sides(first: FormulaLine, second: FormulaLine) -> FormulaLines:
    """The two sides of an equation in numbers, each with its result; on one line where the first is one quantity.

    Where the first is zero the second says so by itself.
    """
    if first.pieces[0][1] == Number("0"):
        return FormulaLines((second,))
    if len(first.pieces) > 1:
        return FormulaLines((first, second))
    (_, start), *end = second.pieces
    return FormulaLines((FormulaLine((*first.pieces, ("=", start), *end)),))


def ascending(lines: Sequence[FormulaLine]) -> FormulaLines:
    """Numbers, each smaller than the next, between both ends with their results: ``7 - 2 < 3 * 2.5 = 7.5 < 7 + 2``."""
    (first, *_), *between, (last, *_) = (line.pieces for line in lines)
    inner = [piece for (_, start), *end in between for piece in (("<", start), *end)]
    return FormulaLines((FormulaLine((first, *inner, ("<", last[1]))),))


class Section(Struct, frozen=True):
    """A numbered step with its heading; ``views`` are the kinds of figures that go with it."""

    heading: Text
    blocks: tuple[Block, ...]
    views: tuple[str, ...] = ()


class SolutionText(Struct, frozen=True):
    """A whole solution in a language.

    Figures show its ``centres`` (rays to acceleration centres) as if asked, draw its ``vectors`` and mark its
    ``geometry``, which is told by the names of the figures; with ``true_scale`` all vectors are to scale.
    """

    plan: Text
    sections: tuple[Section, ...]
    answer: Text
    check: tuple[Block, ...] = ()
    centres: tuple[Quantity, ...] = ()
    vectors: tuple[PointVectors, ...] = ()
    geometry: Mapping[str, StepGeometry] = field(default_factory=dict)
    true_scale: bool = False
