"""The position of a mechanism taken from its drawing: directions as drawn, lengths that are not given measured."""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import Geometry, degrees
from variantgen.methods.graphical.plan_scale import per_millimetre
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import NumberOf, Sentence

_SHEET = (150.0, 150.0)  # room for the mechanism on millimetre paper, mm


class DrawnGeometry(Geometry):
    """Geometry of a drawing to scale: no coordinates are worked out, what is missing is measured to 0.1 mm."""

    def __init__(self, task: Task) -> None:
        super().__init__(task)
        scale = float(per_millimetre(list(task.now.z.values()), _SHEET))
        self.scale = Value(Name("scale", "l"), "length", scale)
        self.items.append(Sentence("graphical.mechanism", {"scale": self.scale, "value": NumberOf(self.scale)}))

    def _worked_length(self, start: str, end: str) -> Expression:
        """A length that is not given: measured in the drawing."""
        millimetres = abs(self.vector(start, end)) / self.scale.exact
        reading = Value(Name("drawn", start, end, body="l"), "drawing length", millimetres, Constant(millimetres))
        return reading * self.scale

    def _direction(self, start: str, end: str) -> Value:
        return Value(Name("direction", start, end), "angle", degrees(self.vector(start, end)))
