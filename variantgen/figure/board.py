"""What a symbol may ask while it draws itself: the sketch, the scene at its instant, names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from variantgen.families.family import Form
from variantgen.figure.sketch import Sketch
from variantgen.mechanism.rows import Frame
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
        """Points that hang on a thread."""
        return {name for joint in self.scene.joints for name in (getattr(joint, "load", None),) if name is not None}

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
