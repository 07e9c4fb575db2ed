"""Whether the rotation of a body is worth finding: it is asked, or something that is needed depends on it."""

from __future__ import annotations

from collections.abc import Collection

from msgspec.structs import astuple

from variantgen.families.quantities import Quantity
from variantgen.methods.groups.group import ContactGroup, Group, RollingContactPole, RollingWheel, SlidingPair
from variantgen.methods.linkage.problem import Task

_FROM_RATE = {1: ("omega", "P", "Q", "mu"), 2: ("epsilon", "Q", "mu")}


def is_rate_wanted(task: Task, order: int, body: str, known: Collection[str]) -> bool:
    """Whether the rate of a body is needed, when the vectors of its points in ``known`` are found without it.

    ``order`` 1 is the angular velocity, 2 the angular acceleration. For accelerations every angular velocity is needed,
    because of the normal components.
    """
    members = task.scene.bodies[body]
    if order < task.order and not task.fixed & set(members):
        return True  # for normal components; those of a point that turns about a fixed one follow from its velocity too
    if any(q.target == body and q.kind in _FROM_RATE[order] for q in task.sought):
        return True
    if any(p in task.needed.points and p not in known and p not in task.fixed for p in members):
        return True
    first_driver = len(task.scene.joints)
    for number, constraint in enumerate(task.scene.constraints):
        for shape in constraint.shapes():
            alone = number >= first_driver and not shape.points and shape.bodies == (body,)
            if body in shape.bodies and not alone and _leads_on(task, body, shape.bodies, shape.points):
                return True
    return False


def is_last_sought(task: Task, point: str, known: Collection[str]) -> bool:
    """Whether the relative acceleration of a point is all that is still to be found: then no rotation leads on.

    ``known`` are the points whose accelerations are found.
    """

    def is_settled(quantity: Quantity) -> bool:
        match quantity.kind:
            case "a":
                return quantity.point in known
            case "a_rel":
                return quantity.target == point
            case kind:
                return kind == "a_cor"

    return all(is_settled(quantity) for quantity in task.sought if quantity.order == 2)


def _leads_on(task: Task, body: str, bodies: Collection[str], points: Collection[str]) -> bool:
    """Whether a joint of a body couples something that is needed."""
    others = [other for other in bodies if other != body]
    return any(other in task.needed.bodies for other in others) or any(p in task.needed.points for p in points)


def leads_on(task: Task, point: str, body: str) -> bool:
    """Whether more than the magnitude of a point's vector is of use: for another body, a joint, or an answer."""
    key, known = ("leads on", point, body), task.by_names
    if key not in known:
        known[key] = _is_of_use(task, point, body)
    found: bool = known[key]
    return found


def _is_of_use(task: Task, point: str, body: str) -> bool:
    others = (members for name, members in task.scene.bodies.items() if name != body)
    if any(point in members for members in others):
        return True
    if any(point in shape.points for joint in task.scene.joints for shape in joint.shapes()):
        return True
    return any(q.kind in ("v", "a") and q.component and q.point == point for q in task.sought)


def is_accelerated(task: Task, group: Group) -> bool:
    """Whether the accelerations of a group lead to one that is asked: of its bodies, or of the point it gives."""
    needed = task.accelerated
    named = astuple(group)
    bodies = {name for item in named for name in (item if isinstance(item, tuple) else (item,))} & needed.bodies
    return bool(bodies) or bool(_given_points(group) & needed.points)


def _given_points(group: Group) -> set[str]:
    """The points whose vectors a group gives by itself, without the rotation of a body."""
    match group:
        case SlidingPair(path=path, carrier_path=carried):
            return {path.point, *([carried.point] if carried else [])}
        case RollingWheel(centre=centre) | RollingContactPole(centre=centre):
            return {centre}
        case ContactGroup(point=point):
            return {point}
    return set()
