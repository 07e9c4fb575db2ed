"""An asked quantity: its name, what it is of, its unit, its value in a solved motion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.decimals import RECORDED_DIGITS
from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities.kind import MEAN
from variantgen.families.quantities.kinds import ACROSS, ALONG, BETWEEN, KINDS, NATURAL, ROPE, line_ends
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.rope_speed import rope_piece
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.turn.crank import crank_of

# An angle of fewer degrees is noise about zero: the tolerance of an angle is some tenths of a degree.
_NO_ANGLE = 1e-9


class Quantity(Struct, frozen=True, dict=True):
    """An asked quantity: ``kind`` (v, a, omega, ...), point or body, and what of it (see the table of the package)."""

    kind: str
    target: str
    component: str = ""
    wanted: str = ""  # the unit of its answer, if it is not that of the family

    @cached_property
    def name(self) -> str:
        """The name as written in files, ``v_B.x``."""
        return self.whole_name + (f".{self.component}" if self.component else "")

    @property
    def written(self) -> str:
        """The name with the unit that is wanted, ``v_B in ft/s``."""
        return f"{self.name} in {self.wanted}" if self.wanted else self.name

    @cached_property
    def whole_name(self) -> str:
        """The name without what is asked of it, ``v_B``."""
        return f"{self.kind}{'.' if self.kind == ROPE else '_'}{self.target}"

    @cached_property
    def order(self) -> int:
        """0 if positions are enough to know it, 1 if velocities are, 2 if accelerations are needed."""
        return KINDS[self.kind].order

    @cached_property
    def group(self) -> str:
        """The group of its kind, which tells how it is named and read."""
        group = KINDS[self.kind].group
        return "difference" if group == "vector" and BETWEEN in self.target else group

    @property
    def of_instant(self) -> Quantity | None:
        """The quantity of which an extreme, a mean value or a zero is taken; None for any other."""
        of = KINDS[self.kind].of
        return Quantity(of, self.target, self.component) if of else None

    @property
    def is_of_turn(self) -> bool:
        """Whether it belongs to a whole turn of the crank, not to an instant."""
        return self.group == "turn"

    @property
    def is_of_interval(self) -> bool:
        """Whether it belongs to an interval of time."""
        return self.group == "course"

    @property
    def is_of_instant(self) -> bool:
        """Whether it is known at the instant of the problem: of no turn, of no interval."""
        return not (self.is_of_turn or self.is_of_interval)

    @property
    def is_extreme(self) -> bool:
        """Whether it is searched for along a turn or an interval, where no steps of a calculation lead to it."""
        return self.is_of_interval or (self.of_instant is not None and not self.kind.startswith(MEAN))

    @cached_property
    def is_vector(self) -> bool:
        """Whether it belongs to a vector of a point: its magnitude, a component, its angle."""
        return self.group in ("vector", "relative", "difference")

    @property
    def pair(self) -> tuple[str, str]:
        """The point whose motion is seen and the one from which it is seen, of ``v_B_A``."""
        point, _, base = self.target.partition(BETWEEN)
        return point, base

    def common_body(self, scene: Scene) -> str:
        """The body that both points of a pair belong to, or ''."""
        return next((body for body, members in scene.bodies.items() if {*self.pair} <= {*members}), "")

    @property
    def is_magnitude(self) -> bool:
        """Whether it is a length or the magnitude of a vector or rate, which has no sign."""
        if self.component == "abs":
            return True
        return (self.is_vector and not self.component) or (self.is_centre and not self.is_coordinate)

    @property
    def is_relative(self) -> bool:
        """Whether it belongs to the relative motion of a sliding point."""
        return self.group == "relative"

    @property
    def is_rotation(self) -> bool:
        """Whether it belongs to the rotation of a body."""
        return self.group == "rotation"

    @cached_property
    def is_centre(self) -> bool:
        """Whether it is a distance from the velocity or acceleration centre, or a coordinate of it."""
        return self.group == "centre"

    @property
    def is_length(self) -> bool:
        """Whether it is a length or a coordinate."""
        return KINDS[self.kind].measure == "length"

    @property
    def is_angle(self) -> bool:
        """Whether it is an angle: a direction, a corner, that of the acceleration centre."""
        return self.component == "angle" or (KINDS[self.kind].measure == "angle" and not self.is_turning)

    @property
    def is_turning(self) -> bool:
        """Whether it is the angle by which a body turns, of which whole turns count."""
        return self.kind == "turned"

    @property
    def is_direction(self) -> bool:
        """Whether it is the angle of a direction with the x axis, which whole turns do not change."""
        return self.component == "angle" or (self.kind == "angle" and not self.component)

    @property
    def is_coordinate(self) -> bool:
        """Whether it is a coordinate of a point or centre, or its extreme, counted from the origin of the axes."""
        if self.of_instant is not None:
            return self.of_instant.is_coordinate and self.is_length
        return self.kind in ("x", "y") or (self.is_centre and self.component in ("x", "y"))

    @property
    def refers_to_axes(self) -> bool:
        """Whether it means something only with the axes x and y of the paper."""
        if self.of_instant is not None:
            return self.of_instant.refers_to_axes
        return self.is_coordinate or self.is_direction or self.component in ("x", "y")

    @property
    def turns_with_mirror(self) -> bool:
        """Whether it changes its sign with the mirror image of the mechanism, and nothing else of it does."""
        return self.is_turning or (self.is_rotation and self.component != "abs") or self.component.startswith(ACROSS)

    @property
    def line(self) -> str:
        """The two points of the direction that a component is taken along or across, ``AC``; or ''."""
        named = self.component.startswith((ALONG, ACROSS))
        return self.component.partition("_")[2] if named else ""

    def sources(self, scene: Scene) -> tuple[Quantity, ...]:
        """The plain quantities that a solution finds first: itself, what it is made of; none for positions."""
        if self.kind == "a" and self.component in NATURAL:
            return Quantity("v", self.target, "x"), self
        match self.group:
            case "position" | "course":
                return ()
            case "turn":
                crank = crank_of(scene)
                return (Quantity("omega", crank.body),) if crank and self.kind.startswith(MEAN) else ()
            case "difference":
                return self._of_pair(scene)
            case "path":
                return Quantity("v", self.target), Quantity("a", self.target, "x")
            case "ratio":
                return Quantity("omega", self.target), Quantity("omega", self.component)
            case "rope":
                return self._of_rope(scene)
        return (self,)

    def _of_pair(self, scene: Scene) -> tuple[Quantity, ...]:
        """The rotation of the body of both points, or the vectors of both."""
        if body := self.common_body(scene):
            return tuple(Quantity(rate, body) for rate in ("omega", "epsilon")[: self.order])
        return tuple(Quantity(self.kind, point, "x") for point in self.pair)

    def _of_rope(self, scene: Scene) -> tuple[Quantity, ...]:
        """The rotation of the drum, or the motion of the end, from which a rope runs, and of movable pulleys."""
        piece, rest = rope_piece(scene, self.target, self.component), Linkage(scene).resting
        way = piece.way(rest) if piece else None
        if way is None:
            return ()
        end, *pulleys = way.bends
        drum = () if end.body is None else (Quantity("omega", end.body),)
        moving = [bend.point for bend in (end, *pulleys) if bend.point not in rest]
        return (*drum, *(Quantity("v", point) for point in dict.fromkeys(moving)))

    @cached_property
    def point(self) -> str:
        """The point it speaks of, or ''."""
        if self.is_centre:
            return "" if self.is_coordinate else self.component
        if self.group == "difference":
            return ""
        return self.target if self.is_vector or self.group == "path" or self.is_coordinate else ""

    def points(self, known: Mapping[str, object]) -> tuple[str, ...]:
        """All points that its name speaks of, those of a named direction or of a line too; ``known`` are all points."""
        if self.of_instant is not None:
            return self.of_instant.points(known)
        if self.group == "difference":
            return (*self.pair, *((line_ends(self.line, known) or ()) if self.line else ()))
        if self.is_of_interval:
            return (self.target,) if self.target in known else ()
        if self.line:
            return (self.target, *(line_ends(self.line, known) or ()))
        if self.kind in ("distance", ROPE):
            return self.target, self.component
        if self.kind == "angle":
            return (self.target, *self.component.split(".")) if self.component else line_ends(self.target, known) or ()
        return (self.point,) if self.point else ()

    @property
    def whole(self) -> Quantity:
        """The magnitude or signed rate whose direction or sense this is; else the quantity itself."""
        return replace(self, component="") if self.component in ("angle", "sense") else self

    def unit(self, length: str) -> Unit:
        """The unit of its answer: the one that is wanted, or its own."""
        return unit(self.wanted) if self.wanted else self.own_unit(length)

    def own_unit(self, length: str) -> Unit:
        """The unit in which solutions work it out, for a family that gives lengths in the unit ``length``."""
        if self.is_angle or KINDS[self.kind].measure == "angle":
            return unit("deg")
        if self.component == "sense":
            return unit("1")
        names = {"length": length, "velocity": f"{length}/s", "acceleration": f"{length}/s^2", "number": "1"}
        names |= {"angular velocity": "rad/s", "angular acceleration": "rad/s^2", "time": "s"}
        return unit(names[KINDS[self.kind].measure])

    def value(self, motion: Motion) -> Field:
        """Its value in SI, shape (N,); infinite where it has none: a centre at infinity, a ratio by zero."""
        return KINDS[self.kind].value(motion, self.target, self.component)


def motion_order(asked: Iterable[Quantity]) -> int:
    """The order to which a motion is solved for what is asked: velocities are found also where positions are enough."""
    return max((1, *(quantity.order for quantity in asked)))


def recorded(quantity: Quantity, value: float) -> float:
    """A value in its printed unit as keys and manifests have it.

    It has so many digits that the last bits of a machine change no byte; what is left of an angle of zero is zero.
    """
    if quantity.is_angle and abs(value) < _NO_ANGLE:
        return 0.0
    return float(f"{value:.{RECORDED_DIGITS - 1}e}")
