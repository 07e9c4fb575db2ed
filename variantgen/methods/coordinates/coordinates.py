"""The coordinate method: equations of the constraints, differentiated by time once and twice, solved step by step.

It applies to every mechanism: what a joint or a driver says is in :mod:`variantgen.methods.coordinates.equations`. A
program that computes the same is added to the solution (:mod:`variantgen.methods.coordinates.listing`).
"""

from __future__ import annotations

from contextlib import suppress

from variantgen.algebra.derivative import derivative
from variantgen.algebra.expression import Constant, Ratio, Value
from variantgen.algebra.linear import linear, reduced
from variantgen.algebra.normal_form import Maybe, added, forward
from variantgen.algebra.substitution import pruned
from variantgen.methods.coordinates import results
from variantgen.methods.coordinates.blocks import CoordinateBlock, blocks_for, given_coordinates
from variantgen.methods.coordinates.coordinate import Coordinate
from variantgen.methods.coordinates.equations import model_of
from variantgen.methods.coordinates.listing import listing
from variantgen.methods.coordinates.model import Model
from variantgen.methods.coordinates.places import locate
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.shown_system import ZERO, coefficients, enter, enter_solution, system_of
from variantgen.methods.steps.step import Derived, EquationLine, Sentence

_LARGEST = 12  # unknowns of a system that is shown with its numbers


def applies(task: Task) -> bool:
    """Whether the constraints can be written in coordinates: always, unless they do not determine the motion."""
    book = Book(task)
    with book.step("coordinates.equations"):
        try:
            _model_and_blocks(book)
        except NOT_APPLICABLE:
            return False
    return True


def _model_and_blocks(book: Book) -> tuple[Model, list[CoordinateBlock]]:
    """The mechanism in coordinates and what is solved together: of the part on the way to what is asked, or of all.

    Raises LookupError where the equations do not determine the motion.
    """
    with suppress(*NOT_APPLICABLE):
        model = model_of(book)
        return model, blocks_for(model, results.targets(model))
    model = model_of(book, whole=True)
    return model, blocks_for(model, results.targets(model))


def solve(book: Book) -> None:
    """Write the steps of the method; what is asked is then known to the book."""
    with book.step("coordinates.equations", "coordinate_axes") as first:
        book.say("coordinates.idea", True)
        model, blocks = _model_and_blocks(book)
        targets = results.targets(model)
        _state(model, blocks, given_coordinates(model, blocks, targets))
    written = {id(e): (e.left, e.right) for block in blocks for e in block.equations}
    for order in (1, 2)[: book.task.order]:
        model = model.at(order)
        book = model.book
        with book.step(f"coordinates.{book.measure}"):
            book.say(f"coordinates.differentiate_{order}", False)
            for own in given_coordinates(model, blocks, targets):
                book.items.append(Derived(own.speed if order == 1 else own.acceleration))
            written = _differentiated(model, written, order)
            for block in blocks:
                _solve_block(model, block, written, order)
            results.enter(model, blocks)
    locate(model, first)
    with book.step("coordinates.listing"):
        book.say("coordinates.program", False)
        book.items.append(listing(model, blocks, targets))


def _state(model: Model, blocks: list[CoordinateBlock], given: list[Coordinate]) -> None:
    """The unknowns, what is given, and the equations of the positions."""
    book = model.book
    unknowns = tuple(own.place.name for block in blocks for own in block.unknowns if own.place.name)
    if given:
        book.say("coordinates.given", False, given=tuple(own.place.name for own in given if own.place.name))
    if not unknowns:
        return
    book.say("coordinates.unknowns", False, unknowns=unknowns)
    results.say_start(model, [own.place for own in (*given, *(own for block in blocks for own in block.unknowns))])
    said: list[Sentence] = []
    for block in blocks:
        for equation in block.equations:
            sentence = Sentence(f"coordinates.{equation.key}", equation.facts)
            if sentence not in said:
                said.append(sentence)
                book.items.append(sentence)
            book.items.append(EquationLine(equation.left or ZERO, equation.right or ZERO))


Written = dict[int, tuple[Maybe, Maybe]]


def _differentiated(model: Model, written: Written, order: int) -> Written:
    """The derivatives by time of equations; for the second one those of the first derivatives."""
    rates: dict[Value, Maybe] = {}
    for own in model.coordinates.values():
        rates[own.place] = None if own.given and own.speed.exact == own.acceleration.exact == 0 else own.speed
        if order == 2:
            rates[own.speed] = None if own.given and own.acceleration.exact == 0 else own.acceleration
    found: Written = {}
    for key, (left, right) in written.items():
        sides = (None if side is None else derivative(side, rates) for side in (left, right))
        found[key] = reduced(*sides)
    return found


def _solve_block(model: Model, block: CoordinateBlock, written: Written, order: int) -> None:
    """Show the equations of a block and find its unknown derivatives."""
    book = model.book
    unknowns = [own.speed if order == 1 else own.acceleration for own in block.unknowns]
    sides = [tuple(pruned(side, unknowns) for side in written[id(e)]) for e in block.equations]
    if len(unknowns) == 1:
        _solve_one(book, unknowns[0], *sides[0])
        return
    book.items.extend(EquationLine(left or ZERO, right or ZERO) for left, right in sides)
    forms = [linear(added((1, left), (-1, right)), unknowns) for left, right in sides]
    if len(unknowns) <= _LARGEST:
        book.say("coordinates.numbers", True)
        system = system_of(unknowns, forms)
        book.items.append(system)
        enter_solution(unknowns, system.rows, system.right)
    else:
        enter_solution(unknowns, *coefficients(unknowns, forms))
    book.say("coordinates.solved", True)
    book.items.extend(Derived(value, symbolic=False, numeric=False) for value in unknowns)


def _solve_one(book: Book, value: Value, left: Maybe, right: Maybe) -> None:
    """One equation with one unknown: ``x' = ...`` at once, or divided by the coefficient."""
    found, rest = linear(added((1, left), (-1, right)), [value])
    expression = added((-1, rest)) or ZERO
    if left is value:
        enter(value, expression, expression.number(True))
        book.items.append(Derived(value, symbolic=value.exact != 0, numeric=value.exact != 0))
        return
    sign, coefficient = forward(found[value])
    book.items.append(EquationLine(left or ZERO, right or ZERO))
    if sign < 0:
        expression = rest or ZERO
    if not (isinstance(coefficient, Constant) and coefficient.value == 1) and rest is not None:
        expression = Ratio(expression, coefficient)
    enter(value, expression, expression.number(True))
    book.items.append(Derived(value, symbolic=False, numeric=value.exact != 0))
