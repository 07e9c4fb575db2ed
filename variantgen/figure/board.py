"""What a symbol may ask while it draws itself: the sketch, the scene at its instant, names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from variantgen.families.family import Form
from variantgen.figure.sketch import Sketch
from variantgen.mechanism.rows import Constraint, Frame
from variantgen.mechanism.scene import Scene, fixed_points
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language


@dataclass
class Board:
    """The drawing board of one figure.

    ``scene`` holds the numbers of one variant (scalars), ``shown`` its named points.
    """

    sketch: Sketch
    scene: Scene
    form: Form
    language: Language
    shown: tuple[str, ...]
    accelerations: bool
    clear: dict[str, float] = field(default_factory=dict)

    @property
    def frame(self) -> Frame:
        """How the scene lies on paper."""
        return self.scene.frame

    @property
    def loads(self) -> set[str]:
        """Points that hang on a rope and belong to no body."""
        return {name for joint in self.scene.joints for name in joint.hanging() if not self.owners(name)}

    def owners(self, point: str) -> list[str]:
        """Bodies that a point belongs to."""
        return [body for body, members in self.scene.bodies.items() if point in members]

    def is_disc(self, point: str) -> bool:
        """Whether a disc about the point is drawn."""
        return any(disc.centre == point for disc in self.form.figure.discs)

    def rate(self, driver: Constraint, field_name: str) -> Symbol:
        """The symbol of the given rate that a field of a driver uses (``v`` of a travel, ``omega`` of a rotation)."""
        template = self.form.drivers[next(i for i, own in enumerate(self.scene.drivers) if own is driver)]
        parameters = self.form.parameters
        names = template.fields[field_name].names & {name for name, p in parameters.items() if p.is_rate}
        if names:
            return self.symbol(parameters[min(names)].symbol)
        point_or_body = next(value for value in template.fields.values() if isinstance(value, str))
        return self.symbol(f"{field_name}_{point_or_body}")

    def symbol(self, name: str) -> Symbol:
        """The symbol of a point, parameter or quantity."""
        return self.language.symbol(name, self.form.symbols)

    def sized(self, point: str, reach: float, box: Sequence[complex] = ()) -> None:
        """Note how far the symbol at a point reaches, for arrows that start there and for its label."""
        self.sketch.reach[point] = max(self.sketch.reach.get(point, 0.0), reach)
        radius = max((abs(corner - self.sketch.at[point]) for corner in box), default=reach)
        self.clear[point] = max(self.clear.get(point, 0.0), min(radius, reach))

    def pivot_of(self, body: str) -> str:
        """The fixed point of a body, or its first point."""
        fixed = fixed_points(self.scene)
        members = self.scene.bodies[body]
        return next((name for name in members if name in fixed), members[0])
