"""Names of quantities read: which of them a scene knows, and what to write in place of another."""

from __future__ import annotations

import re
from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.parameters.units import UNITS, usual_name
from variantgen.families.quantities.interval_kinds import ZERO
from variantgen.families.quantities.kinds import BETWEEN, KINDS, NATURAL, ROPE, line_ends
from variantgen.families.quantities.quantity import Quantity
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.rope_speed import rope_piece, rope_pieces
from variantgen.mechanism.scene import Scene, fixed_points
from variantgen.mechanism.turn.crank import crank_of, is_steady

_PART = "[A-Za-z][A-Za-z0-9]*"
_KIND = "|".join(sorted(KINDS, key=len, reverse=True))
_ROPE = re.compile(rf"({re.escape(ROPE)})\.({_PART})\.({_PART})")
_PATTERN = re.compile(rf"({_KIND})_({_PART}(?:[{BETWEEN}/]{_PART})?)(?:\.((?:along_|across_)?{_PART}(?:\.{_PART})?))?")
_OF_POINT = ("", ".x", ".y", ".angle")
_OF_BODY = ("", ".abs", ".sense")
_VECTORS_OF_INTERVAL = ("shift", "average_v", "average_a")
_NO_EXTREMES = (*NATURAL, "x", "y", "angle", "abs", "sense")  # components of which no extreme is asked


def parse_quantity(text: str, scene: Scene, key: str = "ask", offered: Sequence[str] = ()) -> Quantity:
    """The quantity of that name in a scene; InputError with the nearest (``offered``) names if it has none such."""
    known = quantity_names(scene)
    if text in known:
        return split_name(text)
    if scene.course is not None and text == scene.course.found:
        return Quantity("instant", text)
    quantity = split_name(text) if _match(text) else None
    if quantity is None or not _is_further(quantity, scene):
        if quantity is not None and (reason := _of_crank(quantity, scene)):
            raise InputError(Problem(reason, key=key, value=text, remedy="ask for another point or body"))
        remedy = _proposed(text, quantity, scene, known) or nearest(text, offered or known)
        raise InputError(Problem("unknown quantity", key=key, value=text, remedy=remedy))
    return quantity


def is_quantity(text: str, scene: Scene) -> bool:
    """Whether a scene has a quantity of that name, a plain one or a further one."""
    return text in quantity_names(scene) or (_match(text) is not None and _is_further(split_name(text), scene))


def _match(text: str) -> re.Match[str] | None:
    return _ROPE.fullmatch(text) or _PATTERN.fullmatch(text)


def split_name(text: str) -> Quantity:
    """The quantity of a name that is known to be one, with the unit that it may want; ValueError if it is none.

    As books do, ``v_B/A`` may be written for ``v_B_A``.
    """
    name, wanted = split_unit(text)
    match = _match(name)
    if match is None:
        raise ValueError(f"{text} is no name of a quantity")
    return Quantity(match[1], match[2].replace("/", BETWEEN), match[3] or "", wanted)


def split_unit(text: str) -> tuple[str, str]:
    """A name and the unit in which its answer is wanted: ``v_B in ft/s`` is ``v_B`` and ``ft/s``; "" without one."""
    name, _, wanted = f"{text} ".partition(" in ")
    return name.strip(), usual_name(wanted)


def in_unit(quantity: Quantity, wanted: str, key: str) -> Quantity:
    """The quantity with the unit in which its answer is wanted. Raises InputError for a unit of another measure."""
    own = quantity.own_unit("m")
    alike = [other.name for other in UNITS.values() if other.measures == own.measures]
    fitting = [own.name] if quantity.is_direction else alike
    if wanted not in fitting:
        message = f"{wanted} measures no {own.measures}" if wanted in UNITS else "unknown unit"
        if quantity.is_direction and wanted in alike:
            message = f"directions are answered in {own.name}"
        raise InputError(
            Problem(message, key=key, value=f"{quantity.name} in {wanted}", remedy="use one of: " + ", ".join(fitting))
        )
    return replace(quantity, wanted=wanted)


def quantity_names(scene: Scene) -> list[str]:
    """Names of the plain quantities that a scene can be asked for: velocities, accelerations, rates, centres.

    Of what is made of these or of positions alone there would be too many; :func:`parse_quantity` knows them.
    """
    points = _moving_points(scene)
    sliding = list(sliding_points(scene))
    names = [f"{kind}_{p}{part}" for kind in ("v", "a") for p in points for part in _OF_POINT]
    names += [f"{kind}_{body}{part}" for kind in ("omega", "epsilon") for body in scene.bodies for part in _OF_BODY]
    names += [f"{kind}_{p}{part}" for kind in ("v_rel", "a_rel", "a_cor") for p in sliding for part in _OF_POINT]
    names += [f"{kind}_{body}.{p}" for kind in ("P", "Q") for body, members in scene.bodies.items() for p in members]
    return names + [f"mu_{body}" for body in scene.bodies]


def interval_names(scene: Scene) -> list[str]:
    """Names of what can be asked of the interval of time of a scene: ways, means, extremes, instants; none without."""
    of_point: tuple[str, ...] = (
        "way_{}",
        "shift_{}",
        "average_v_{}",
        "mean_t_v_{}",
        "max_t_v_{}",
        "t_max_v_{}",
        "t_zero_v_{}",
    )
    of_body = ("turned_{}", "mean_t_omega_{}", "max_t_omega_{}", "t_max_omega_{}", "t_zero_omega_{}")
    if scene.course is None:
        return []
    of_point += ("duration_{}",) if scene.course.is_by_place else ("t_back_{}",)
    found = [name.format(point) for point in _moving_points(scene) for name in of_point]
    return found + [name.format(body) for body in scene.bodies for name in of_body]


def _moving_points(scene: Scene) -> list[str]:
    moving = {p for members in scene.bodies.values() for p in members}
    moving |= {p for c in scene.constraints for shape in c.shapes() for p in shape.points}
    fixed = fixed_points(scene)
    return [p for p in scene.points if p in moving and p not in fixed]


def _is_further(quantity: Quantity, scene: Scene) -> bool:
    """Whether a scene has a quantity that is not among its plain ones."""
    target, component = quantity.target, quantity.component
    if quantity.is_vector:
        return _has_vector(quantity, scene) and _has_part(quantity, scene)
    match quantity.group:
        case "centre":
            return target in scene.bodies and component in ("x", "y")
        case "ratio":
            return target != component and {target, component} <= scene.bodies.keys()
        case "path":
            return not component and target in _moving_points(scene)
        case "rope":
            return rope_piece(scene, target, component) is not None
        case "position":
            return _is_position(quantity, scene)
        case "turn":
            return crank_of(scene) is not None and _has_turn(quantity, scene)
        case "course":
            return scene.course is not None and _has_course(quantity, scene)
    return False


def _has_vector(quantity: Quantity, scene: Scene) -> bool:
    """Whether a scene has the point that moves or slides, or both points, of a vector."""
    match quantity.group:
        case "vector":
            return quantity.target in _moving_points(scene)
        case "relative":
            return quantity.target in sliding_points(scene)
    return len({*quantity.pair} & {*_moving_points(scene)}) == 2


def _has_part(quantity: Quantity, scene: Scene) -> bool:
    """Whether a vector has the component that is asked, which no plain quantity is."""
    if quantity.line:
        return line_ends(quantity.line, scene.points) is not None
    if quantity.group == "difference":
        return quantity.component in ("", *(part[1:] for part in _OF_POINT[1:]))
    return quantity.group == "vector" and quantity.kind == "a" and quantity.component in NATURAL


def _has_turn(quantity: Quantity, scene: Scene) -> bool:
    """Whether a scene with a crank has the quantity of which an extreme is taken, or what goes to and fro."""
    if _of_crank(quantity, scene):
        return False
    of = quantity.of_instant
    if of is not None:
        plain = not of.is_direction and of.component not in _NO_EXTREMES and not of.line
        steady = of.order < 2 or is_steady(scene)
        moves = of.group != "position" or bool({*of.points(scene.points)} & {*_moving_points(scene)})
        return plain and steady and moves and (of.name in quantity_names(scene) or _is_further(of, scene))
    movers = {"stroke": _moving_points(scene), "swing": scene.bodies}
    return not quantity.component and quantity.target in movers.get(quantity.kind, {*movers["stroke"], *scene.bodies})


def _has_course(quantity: Quantity, scene: Scene) -> bool:
    """Whether a scene that moves for an interval of time has what is asked of it."""
    of, component = quantity.of_instant, quantity.component
    if quantity.kind == "instant":
        return scene.course is not None and quantity.target == scene.course.found and not component
    if of is not None:
        known = of.name in quantity_names(scene) or _is_further(of, scene)
        moves = of.group != "position" or bool({*of.points(scene.points)} & {*_moving_points(scene)})
        is_part = component in ("x", "y") and quantity.kind.startswith(ZERO)
        return known and moves and not of.line and (is_part or component not in _NO_EXTREMES)
    if quantity.is_turning:
        return quantity.target in scene.bodies and not component
    assert scene.course is not None, "there is an interval"
    if quantity.kind == "duration" and not scene.course.is_by_place:
        return False  # the data tell it
    parts = ("", "x", "y", "angle") if quantity.kind in _VECTORS_OF_INTERVAL else ("",)
    return quantity.target in _moving_points(scene) and component in parts


def _of_crank(quantity: Quantity, scene: Scene) -> str:
    """Why a quantity of the crank itself is none of a turn: no limit positions, or a rate that stays; "" for others."""
    crank = crank_of(scene)
    target, of = quantity.target, quantity.of_instant
    if not quantity.is_of_turn or crank is None or target not in (crank.body, *scene.bodies[crank.body]):
        return ""
    if of is None:
        mover = f"the crank {target}" if target == crank.body else f"{target} of the crank {crank.body}"
        return f"{mover} goes round and has no limit positions"
    if of.kind in ("v", "a", "omega", "epsilon"):
        return f"the crank {crank.body} turns at a constant angular velocity, so {of.name} is the same all along"
    return ""


def _is_position(quantity: Quantity, scene: Scene) -> bool:
    """Whether a scene has the points or the body that a coordinate, an angle or a distance is of."""
    if quantity.kind == "angle" and not quantity.component:
        return line_ends(quantity.target, scene.points) is not None
    named = [quantity.target, *filter(None, quantity.component.split("."))]
    count = {"x": 1, "y": 1, "distance": 2, "angle": 3}[quantity.kind]
    return len(named) == len(set(named)) == count and set(named) <= scene.points.keys()


# How others write a quantity, and how it is written here.
_OTHERWISE = {"alpha": "epsilon", "eps": "epsilon", "w": "omega", "om": "omega", "vel": "v", "acc": "a"}
_ANGLES = ("theta", "phi", "beta", "gamma", "psi")
_INSTANT = re.compile(r"\s(at|after|when)\s|\bt\s*=")
_LENGTHS = ("z", "s", "l", "r")


def _for_turn(quantity: Quantity, scene: Scene) -> str:
    """What an extreme, a mean value or a stroke needs."""
    if crank_of(scene) is None:
        return f"values of a turn need one driver that rotates a body about a fixed point; {_for_interval(scene)}"
    if quantity.order == 2 and not is_steady(scene):
        return "accelerations over a turn are those of a constant angular velocity: leave epsilon of the driver out"
    return (
        "write max_, min_, phi_max_, phi_min_ before v_B, a_B, omega_AB, epsilon_AB, x_B, y_B, angle_O.A.B, "
        "distance_A.B; mean_v_B, mean_omega_AB; stroke_B, swing_BC, time_ratio_B"
    )


def _for_interval(scene: Scene) -> str:
    """What a value of an interval of time needs."""
    names = "max_t_v_B, min_t_x_B, mean_t_v_B, t_max_v_B, t_zero_v_B, t_back_B, way_B, shift_B, turned_AB, average_v_B"
    stated = "" if scene.course else ", and state the interval in [laws]: interval = [0, 3]"
    return f"of an interval of time write {names}, and duration_B where it is stated by its places{stated}"


def _bodies_with(target: str, scene: Scene) -> list[str]:
    """The bodies that a point belongs to, or both points of a line."""
    points = {*(line_ends(target, scene.points) or (target,))}
    return [body for body, members in scene.bodies.items() if points <= {*members} and body != target]


def _proposed(text: str, quantity: Quantity | None, scene: Scene, known: Sequence[str]) -> str:
    """What to ask for in place of a quantity in other letters, or of one that is not quite written so; "" for none."""
    letter, _, target = text.partition("_")
    points = ", ".join(sorted(scene.points))  # forms that differ in their order say the same
    own = f"{_OTHERWISE.get(letter, letter)}_{target}"
    if letter in _OTHERWISE and own in known:
        return f"write {own}: angular velocities are omega, angular accelerations epsilon"
    if _INSTANT.search(text):
        given = "an instant is told by the data: state a law of time in [laws], and the time as a parameter"
        return f'{given}, or in [laws] when it is:  instant = "v_B = 2 m/s"'
    if letter in ("omega", "epsilon") and (turning := _bodies_with(target, scene)):
        return f"{target} is no body; its rotation is that of {' or '.join(f'{letter}_{body}' for body in turning)}"
    if quantity is not None and quantity.line and line_ends(quantity.line, scene.points) is None:
        return f"after along_ and across_ stand two points, each a letter or a letter with a number, of: {points}"
    if quantity is not None and quantity.group == "ratio":
        return f"write the two bodies of omega / omega: ratio_AB.CD with two of {', '.join(sorted(scene.bodies))}"
    if quantity is not None and quantity.group == "rope":
        pieces = [".".join((ROPE, *piece.ends)) for piece in rope_pieces(scene)]
        if any({*piece.ends} == {quantity.target, quantity.component} for piece in rope_pieces(scene)):
            return "several strands run so, each as fast as its own rope lets it: give them stations with other names"
        return "a rope runs straight between: " + ", ".join(pieces) if pieces else "there is no rope"
    if quantity is not None and quantity.is_of_interval:
        return _for_interval(scene)
    if quantity is not None and quantity.is_of_turn:
        return _for_turn(quantity, scene)
    if letter in _ANGLES or letter == "angle":
        if line_ends(target, scene.points):
            return f"the direction of {target} is angle_{target}, a corner of three points angle_O.A.B"
        return f"the direction of a link AB is angle_AB, the corner of three points angle_O.A.B; points: {points}"
    if letter in (*_LENGTHS, "x", "y", "distance"):
        return f"a coordinate is x_B or y_B, the distance of two points distance_A.B; points: {points}"
    return ""
