"""What a symbol may ask while it draws itself: the sketch, the scene at its instant, names."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from copy import copy
from typing import Self

from msgspec import Struct, field

from variantgen.families.family import TOOTHED_RACK, Form
from variantgen.families.literal_data import rate_name
from variantgen.figure.making import Unlettered
from variantgen.figure.sketch import Sketch
from variantgen.mechanism.component import DIMENSIONS, field_specs
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Constraint, Frame
from variantgen.mechanism.scene import Scene
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language


class Board(Struct):
    """The drawing board of one figure.

    ``linkage`` has the numbers of one variant (scalars), ``shown`` are its named points, ``given`` the parameters that
    are marked, ``discs`` the radii (u) of the circles drawn of each body, ``poses`` the directions (rad) in which the
    supports of fixed points stand, ``grounds`` the ends of the ground lines of guides by their points.
    """

    sketch: Sketch
    linkage: Linkage
    form: Form
    language: Language
    shown: tuple[str, ...]
    accelerations: bool
    given: frozenset[str] = frozenset()
    clear: dict[str, float] = field(default_factory=dict)
    discs: dict[str, list[float]] = field(default_factory=dict)
    poses: dict[str, float] = field(default_factory=dict)
    grounds: dict[str, tuple[complex, complex]] = field(default_factory=dict)

    @property
    def frame(self) -> Frame:
        """How the scene lies on paper."""
        return self.scene.frame

    @property
    def scene(self) -> Scene:
        """The joints and drivers with their numbers."""
        return self.linkage.scene

    @property
    def fixed(self) -> frozenset[str]:
        """Points that a joint holds in place."""
        return self.linkage.hinged

    @property
    def loads(self) -> set[str]:
        """Points that hang on a rope and belong to no body of several points, nor to a round one."""
        hanging = {name for joint in self.scene.joints for name in joint.hanging()}
        return {name for name in hanging if not self.is_disc(name) and not self.is_linked(name)}

    def is_linked(self, point: str) -> bool:
        """Whether a point belongs to a body of several points."""
        return any(len(self.scene.bodies[body]) > 1 for body in self.owners(point))

    def owners(self, point: str) -> list[str]:
        """Bodies that a point belongs to."""
        return self.linkage.owners(point)

    def links_at(self, point: str) -> list[complex]:
        """Unit vectors along the bars and plates that leave a point."""
        found = []
        for body in self.owners(point):
            if any(disc.body == body for disc in self.form.figure.discs) or body in self.form.figure.plain:
                continue
            members = self.form.bodies[body]
            ends = members if body in self.form.figure.plates else members[:2]
            found += [self.sketch.at[name] - self.sketch.at[point] for name in ends if name != point]
        return [step / abs(step) for step in found if abs(step) > 1e-6]

    def is_rack(self, body: str | None) -> bool:
        """Whether a body is a rack with teeth."""
        return body is not None and self.form.nouns.get(body) == TOOTHED_RACK

    def is_disc(self, point: str) -> bool:
        """Whether a disc about the point is drawn."""
        return any(disc.centre == point and not disc.arc for disc in self.form.figure.discs)

    def rims(self, point: str) -> list[float]:
        """The radii (u) of the discs drawn about a point."""
        drawn = {name: iter(radii) for name, radii in self.discs.items()}
        marks = [disc for disc in self.form.figure.discs if not disc.arc and disc.body in drawn]
        radii = [(disc.centre, next(drawn[disc.body], 0.0)) for disc in marks]
        return [radius for centre, radius in radii if centre == point]

    def is_translated(self, point: str) -> bool:
        """Whether a point belongs to bodies that a joint keeps from turning, and to no other."""
        owners = self.owners(point)
        return bool(owners) and self.linkage.translating.issuperset(owners)

    def rate(self, driver: Constraint, field_name: str) -> Symbol | None:
        """The symbol of the given rate that a field of a driver uses (``v`` of a travel, ``omega`` of a rotation).

        That is the parameter of the same dimension on which the field depends, directly or through derived quantities.
        None where a rate follows from data of other kinds (a velocity from a law of motion): then it is not given.
        """
        template = self.form.drivers[next(i for i, own in enumerate(self.scene.drivers) if own is driver)]
        names = self._sources(template.fields[field_name].names)
        if not names:
            return self.symbol(rate_name(template, field_name))
        spec = next(spec for spec in field_specs(template.component) if spec.name == field_name)
        wanted, parameters = DIMENSIONS[spec.dimension], self.form.parameters
        same = [name for name in sorted(names) if (unit := parameters[name].unit) and unit.dimension == wanted]
        return self.symbol(parameters[same[0]].symbol) if same else None

    def _sources(self, names: Iterable[str]) -> set[str]:
        """Parameters behind names of parameters and derived quantities."""
        found: set[str] = set()
        for name in names:
            derived = self.form.derived.get(name)
            found |= {name} if derived is None else self._sources(derived.names)
        return found

    def copied(self) -> Self:
        """The same board on a sheet of its own: what is drawn on one is not on the other."""
        other = copy(self)
        other.sketch, other.clear = self.sketch.copied(), dict(self.clear)
        return other

    def draft(self, widest: float = math.inf) -> Unlettered:
        """What is drawn, its labels not yet placed; its drawing is not to be so wide (u)."""
        return Unlettered(self.sketch, {name: self.sketch.at[name] for name in self.shown}, widest)

    def symbol(self, name: str) -> Symbol:
        """The symbol of a point, parameter or quantity."""
        return self.language.symbol(name, self.form.symbols)

    def sized(self, point: str, extent: float, box: Sequence[complex] = ()) -> None:
        """Note how far the symbol at a point reaches, for arrows that start there and for its label."""
        self.sketch.symbol_radius[point] = max(self.sketch.symbol_radius.get(point, 0.0), extent)
        radius = max((abs(corner - self.sketch.at[point]) for corner in box), default=extent)
        self.clear[point] = max(self.clear.get(point, 0.0), min(radius, extent))

    def centre_of_rotation(self, body: str) -> str:
        """The key in ``sketch.at`` of the place about which the arcs of a body's rotation are drawn.

        That is the pivot, or the middle of a plate that has no fixed point.
        """
        members = self.scene.bodies[body]
        if body not in self.form.figure.plates or self.fixed & set(members):
            return self.pivot_of(body)
        key = f"middle of {body}"
        self.sketch.at[key] = sum(self.sketch.at[name] for name in members) / len(members)
        return key

    def pivot_of(self, body: str) -> str:
        """The fixed point of a body, or one whose motion is given, or its first point."""
        members = self.scene.bodies[body]
        given = {name for driver in self.scene.drivers for shape in driver.shapes() for name in shape.points}
        return next((name for known in (self.fixed, given) for name in members if name in known), members[0])
