"""The chain of a solution: which points lead from the given motion to what is asked, and through which poles.

The order is that of the solver's plan (:mod:`variantgen.mechanism.solving.structure`), which is that of a textbook
solution: ``v_B = v_A + v_BA`` with the pole A that is reached before B, and where B also turns about C,
``v_B = v_BC`` as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from msgspec import Struct

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.joint import GroundWheel, Sliding
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import fixed_points
from variantgen.mechanism.solving.structure import Closure, FreePoint, GuidedPoint, Plan, RigidPoint
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.linkage.needed import needed_for

_STRAIGHT = 1e-9


class Turn(Struct, frozen=True):
    """``point`` keeps its distance from ``pole``: both belong to ``body``, or the point goes round the pole (no body).

    A ``closing`` turn is a second expression for a point that is already reached through another pole.
    """

    point: str
    pole: str
    body: str = ""
    closing: bool = False


class SlidingPoint(Struct, frozen=True):
    """A point slides on a body; ``pole`` is the shown point of the body from which the point below it is reached.

    ``carried`` says that the motion of the body is known before that of the point.
    """

    point: str
    body: str
    pole: str | None
    carried: bool
    path: Sliding


class Cylinder(Struct, frozen=True):
    """The distance of ``point`` from ``base`` grows as given: the rod of a cylinder."""

    point: str
    base: str


class VectorChain(Struct, frozen=True):
    """Moving points in the order of the solution, their turns and slips, points at rest, directions of fixed guides.

    ``cylinders`` are the pairs of points whose distance is driven.
    """

    points: tuple[str, ...]
    turns: tuple[Turn, ...]
    sliding_points: tuple[SlidingPoint, ...]
    resting: frozenset[str]
    guides: dict[str, complex]
    cylinders: tuple[Cylinder, ...] = ()

    def members(self, body: str) -> tuple[str, ...]:
        """The points of the chain that belong to a body by its turns, its pole first."""
        found = [name for turn in self.turns if turn.body == body for name in (turn.pole, turn.point)]
        return tuple(dict.fromkeys(found))


def chain_of(form: Form, now: Instant, asked: Sequence[Quantity], shown: Sequence[str]) -> VectorChain:
    """The chain that leads to the asked quantities, through the points that the figure shows.

    A wheel that is held by its rim only has the point of contact as its pole, shown or not.
    """
    linkage = Linkage(now.scene)
    resting = linkage.resting
    needed = needed_for(form, tuple(asked))
    points = [name for name in (*_order(form.plan), *shown) if name in needed.points and name in shown]
    held_by_rim = {body: wheel for body, wheel in _wheels_held_by_rim(form).items() if body in needed.bodies}
    points = [*(wheel.contact for wheel in held_by_rim.values()), *points]
    points = list(dict.fromkeys(name for name in points if name not in resting))
    visible = {*points, *(resting & set(shown))}
    straight = linkage.guides(Placement(now.z, now.scene.frame))
    guides = {point: -way for point, way in straight.items() if point in points}
    poles = {body: _pole(form, body, visible, guides.keys()) for body in form.bodies}
    poles |= {body: wheel.contact for body, wheel in held_by_rim.items()}
    turns = [turn for turn in (*_carried(form, poles), *_circled(now, points)) if {turn.point, turn.pole} <= visible]
    # The centre follows from the rate of such a wheel, by the condition of rolling.
    turns = [turn for turn in turns if turn.body not in held_by_rim or turn.point != held_by_rim[turn.body].centre]
    sliding_points = [
        SlidingPoint(path.point, path.body, poles[path.body], needed.known_before(path), path)
        for path in linkage.slides
        if path.point in visible and path.body in needed.bodies
    ]
    keep = (
        {q.point for q in asked}
        | _driven(form)
        | {sliding_point.point for sliding_point in sliding_points}
        | set(guides)
    )
    keep |= {turn.point for turn in turns if not turn.body}
    points = _useful(form, points, turns, sliding_points, keep)
    # A point has one pole of each body; what it is reached by first is no closure.
    first: dict[str, Turn] = {}
    turns = [turn for turn in dict.fromkeys(turns) if turn.point in points]
    found = [Turn(t.point, t.pole, t.body, first.setdefault(t.point, t) is not t) for t in turns]
    cylinders = (Cylinder(driver.end, driver.start) for driver in now.scene.drivers if isinstance(driver, Extension))
    seen = tuple(cylinder for cylinder in cylinders if cylinder.point in points and cylinder.base in visible)
    return VectorChain(tuple(points), tuple(found), tuple(sliding_points), resting, guides, seen)


def _useful(
    form: Form, points: Sequence[str], turns: Sequence[Turn], sliding_points: Sequence[SlidingPoint], keep: set[str]
) -> list[str]:
    """Points without those that only describe a line of their body: no hinge, not asked, the pole of no other."""
    count = {name: sum(name in members for members in form.bodies.values()) for name in points}
    left = list(points)
    while True:
        poles = {turn.pole for turn in turns if turn.point in left} | {
            sliding_point.pole for sliding_point in sliding_points
        }
        fewer = [name for name in left if name in keep or name in poles or count[name] != 1]
        if fewer == left:
            return left
        left = fewer


def _wheels_held_by_rim(form: Form) -> dict[str, GroundWheel]:
    """Wheels on a line at rest that only a link at another point than the centre moves, by body."""
    scene, found = form.sample, {}
    for joint in scene.joints:
        wheel = joint.on_ground()
        if wheel is None:
            continue
        others = (other for other in (*scene.joints, *scene.drivers) if other is not joint)
        shapes = [shape for other in others for shape in other.shapes()]
        held = any(wheel.body in shape.bodies or wheel.centre in shape.points for shape in shapes)
        hinged = sum(wheel.centre in members for members in scene.bodies.values()) > 1
        if not held and not hinged and wheel.contact in scene.bodies[wheel.body]:
            found[wheel.body] = wheel
    return found


def _driven(form: Form) -> set[str]:
    """Points whose motion the drivers give."""
    return {
        name for driver in form.sample.drivers for shape in driver.shapes() if not shape.bodies for name in shape.points
    }


def _order(plan: Plan) -> list[str]:
    return [step.point for step in plan.steps]


def _pole(form: Form, body: str, visible: set[str], guides: AbstractSet[str]) -> str | None:
    """The pole of a body: that of the plan unless it is hidden or its motion is not the given one.

    A body of which two points are led is held at three, none of which is known: its pole is one whose path is known.
    """
    steps: list[RigidPoint] = [s for s in form.plan.steps if isinstance(s, RigidPoint) and s.body == body]
    steps += [
        e.step
        for e in form.plan.equations
        if isinstance(e, Closure) and isinstance(e.step, RigidPoint) and e.step.body == body
    ]
    members = [name for name in form.bodies[body] if name in visible]
    planned = steps[0].pole if steps else None
    reached = {step.point: step for step in form.plan.steps}
    driven = _driven(form)
    uncertain = isinstance(reached.get(planned or ""), FreePoint | GuidedPoint) and planned not in driven
    given = [name for name in members if name in driven]
    if uncertain and given:
        return given[0]
    led = [name for name in form.bodies[body] if name in members and _is_led(form, name, body, guides)]
    if planned not in led and len(led) > 1:
        return led[0]
    if planned in members:
        return planned
    return next((name for name in _order(form.plan) if name in members), None)


def _is_led(form: Form, point: str, body: str, guides: AbstractSet[str]) -> bool:
    """Whether a point of a body is kept on a fixed path: by a guide, or by another body that turns about a pivot."""
    fixed = fixed_points(form.sample)
    others = (members for other, members in form.bodies.items() if other != body and point in members)
    return point in guides or any(fixed & set(members) for members in others)


def _carried(form: Form, poles: dict[str, str | None]) -> list[Turn]:
    """Turns of points about the poles of their bodies, first those by which a point is reached."""
    steps = [step for step in form.plan.steps if isinstance(step, RigidPoint)]
    closing = [e.step for e in form.plan.equations if isinstance(e, Closure) and isinstance(e.step, RigidPoint)]
    found = []
    for step in (*steps, *closing):
        pole = poles[step.body]
        # A pole of the plan that is not the pole here turns about that one like any other point.
        found += [
            Turn(point, pole, step.body) for point in (step.point, step.pole) if pole is not None and point != pole
        ]
    return found


def _circled(now: Instant, points: Sequence[str]) -> list[Turn]:
    """Turns of points that a joint leads round a centre: an arc at rest, a wheel on a circle."""
    found = []
    at = Placement(now.z, now.scene.frame)
    for joint in now.scene.joints:
        contact = joint.contact_at(at)
        centres = [*joint.landmarks(), *([contact.other[1]] if contact and contact.other else [])]
        names = [s.given_point or s.points[0] for s in joint.shapes() if s.points]
        found += [Turn(name, c) for name in names[:1] for c in centres if name in points and _keeps(now, name, c)]
    # Gears on a crank: the crank says it already.
    return [turn for turn in found if not any({turn.point, turn.pole} <= set(m) for m in now.scene.bodies.values())]


def _keeps(now: Instant, point: str, centre: str) -> bool:
    """Whether the velocities (and accelerations, if known) keep the distance of two points."""
    arm = now.z[point] - now.z[centre]
    swing = now.v[point] - now.v[centre]
    if abs((swing * arm.conjugate()).real) > _STRAIGHT * abs(arm) * max(abs(now.v[point]), abs(swing)):
        return False
    if not now.accelerated:
        return True
    gap = ((now.a[point] - now.a[centre]) * arm.conjugate()).real + abs(swing) ** 2
    return abs(gap) <= 1e-6 * (abs(arm) * abs(now.a[point]) + abs(swing) ** 2)


def taken_apart(chain: VectorChain) -> set[tuple[str, str]]:
    """Body and point of the accelerations that are shown with their components.

    Of the points of a body on a fixed axis one is enough: the plan of the others is similar to the body. It is the one
    below a sliding point, or the end of a cylinder, where that is how the rotation is found.
    """
    found = {(turn.body, turn.point) for turn in chain.turns if turn.pole not in chain.resting}
    found |= {
        (sliding_point.body, sliding_point.point)
        for sliding_point in chain.sliding_points
        if sliding_point.pole not in chain.resting
    }
    driven = {cylinder.point for cylinder in chain.cylinders}
    about_axes = [
        (turn.body, turn.point) for turn in chain.turns if turn.pole in chain.resting and turn.point in driven
    ]
    about_axes += [
        (sliding_point.body, sliding_point.point)
        for sliding_point in chain.sliding_points
        if sliding_point.pole in chain.resting and not sliding_point.carried
    ]
    about_axes += [(turn.body, turn.point) for turn in chain.turns if turn.pole in chain.resting]
    about_axes += [
        (sliding_point.body, sliding_point.point)
        for sliding_point in chain.sliding_points
        if sliding_point.pole in chain.resting
    ]
    first: dict[str, tuple[str, str]] = {}
    for body, point in about_axes:
        first.setdefault(body or point, (body, point))
    return found | set(first.values())
