"""Under which names a figure of motion shows what the statement gives, as the solution does.

A wedge that moves with the velocity ``v`` has this velocity at each of its points: it is drawn under this name at the
driven point, and as the transport velocity of a point that slides on the wedge.
"""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.families.expressions import FamilyExpression
from variantgen.families.family import ComponentTemplate
from variantgen.mechanism.linkage import driven_body, driven_point
from variantgen.methods.graphical.vector_chain import SlidingPoint, VectorChain
from variantgen.methods.linkage.problem import Task
from variantgen.methods.vectors.given_motion import as_stated, unsigned
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import absolute

_LETTERS = {1: ("v", "omega"), 2: ("a", "epsilon")}


def given_vectors(task: Task, chain: VectorChain, order: int, language: Language) -> dict[str, Symbol]:
    """The symbols of given vectors by point: ``v``, where the statement does not call it ``v_F``."""
    kind, _ = _LETTERS[order]
    found = {}
    for template, driver in zip(task.form.drivers, task.scene.drivers, strict=True):
        point = driven_point(driver)
        # What is given of a point on a circle is its tangential acceleration only.
        circling = any(turn.point == point and turn.pole in chain.resting for turn in chain.turns)
        if point and (order == 1 or not circling):
            found[point] = _symbol(task, template, kind, Name(kind, point), language)
    return {point: symbol for point, symbol in found.items() if symbol is not None}


def given_rates(task: Task, order: int, language: Language) -> dict[str, Symbol]:
    """The symbols of given rates by body: ``omega``, where the statement does not call it ``omega_ABD``."""
    _, kind = _LETTERS[order]
    found = {}
    for template, driver in zip(task.form.drivers, task.scene.drivers, strict=True):
        if body := driven_body(driver):
            found[body] = _symbol(task, template, kind, Name(kind, body), language)
    return {body: symbol for body, symbol in found.items() if symbol is not None}


def _symbol(task: Task, template: ComponentTemplate, field: str, usual: Name, language: Language) -> Symbol | None:
    """The symbol of a parameter that is the given magnitude itself, if that is not its usual name."""
    source = template.fields.get(field)
    size = unsigned(task.expressed(source)) if isinstance(source, FamilyExpression) else None
    name = as_stated(usual, size) if isinstance(size, Value) else usual
    return None if name == usual else language.symbol(name.of, task.form.symbols)


def transport_name(
    task: Task, chain: VectorChain, sliding_point: SlidingPoint, kind: str, stated: dict[str, Symbol]
) -> Symbol | None:
    """The vector of a translating carrier under the name of the point by which it is known; None for other carriers."""
    leading_point = _leading_point(task, chain, sliding_point)
    return None if leading_point is None else stated.get(leading_point, absolute(kind, leading_point))


def _leading_point(task: Task, chain: VectorChain, sliding_point: SlidingPoint) -> str | None:
    """The point of a translating carrier whose motion is given, led by a guide or by a crank, or else its pole."""
    if sliding_point.body not in task.translating:
        return None
    driven = _driven(task)
    members = [name for name in task.scene.bodies[sliding_point.body] if name not in task.form.figure.hidden]
    led = {turn.point for turn in chain.turns if turn.pole in chain.resting}
    known = [name for names in (driven, chain.guides, led) for name in members if name in names]
    return next(iter(known), sliding_point.pole)


def _driven(task: Task) -> set[str]:
    """Points whose absolute motion is given: a motion relative to a body is no such motion."""
    shapes = (shape for driver in task.scene.drivers for shape in driver.shapes() if not shape.bodies)
    return {point for shape in shapes for point in shape.points}


def distinct_points(task: Task, chain: VectorChain, points: Sequence[str]) -> list[str]:
    """Points without those that only repeat what another point of the same translating body shows."""
    driven = _driven(task)
    vital = (
        driven
        | {quantity.point for quantity in task.asked}
        | {sliding_point.point for sliding_point in chain.sliding_points}
    )
    vital |= {
        leading_point
        for sliding_point in chain.sliding_points
        if (leading_point := _leading_point(task, chain, sliding_point))
    }
    repeated: set[str] = set()
    for body in task.translating:
        alone = [name for name in points if _owners(task, name) == [body]]
        if vital & set(task.scene.bodies[body]):
            repeated |= set(alone) - vital
    return [name for name in points if name not in repeated]


def _owners(task: Task, point: str) -> list[str]:
    return [body for body, members in task.scene.bodies.items() if point in members]
