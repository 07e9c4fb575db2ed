"""The vectors and rates of a solution under the symbols that it writes: what figures of its motion draw."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from variantgen.figure.motion.motion_data import MovingMechanism
from variantgen.methods.compose import named_vectors
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.wording.formula import Symbol
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols

Named = list[tuple[Symbol, complex]]


class Vectors(Struct, frozen=True):
    """Vectors (m/s or m/s^2) and rates of one order, as a solution names them in a language."""

    task: Task
    found: PointVectors
    symbols: Symbols

    def own(self, point: str) -> tuple[Symbol, complex]:
        """The vector of a point itself."""
        arrow = self.found.own[point]
        return self.symbols.letter(arrow.name), arrow.vector

    def terms(self, point: str) -> Named:
        """What the vector of a point is put together from."""
        return [(self.symbols.letter(arrow.name), arrow.vector) for arrow in self.found.terms(point)]

    def rate(self, body: str) -> Symbol:
        """The symbol of the rate of a body."""
        return self.symbols.letter(self.found.rates[body])

    def slid_over(self) -> list[str]:
        """Points at rest over which a body slides: they have no vector of their own, but those of its motion."""
        return sorted({equation.point for equation in self.found.equations} & self.found.compound & self.task.fixed)

    def telling(self, points: Sequence[str]) -> list[str]:
        """Points without those that only repeat what another point of the same translating body shows."""
        shapes = (shape for driver in self.task.scene.drivers for shape in driver.shapes() if not shape.bodies)
        about = {equation.point for equation in self.found.equations}
        named = {arrow.name for point in about for arrow in self.found.terms(point)}
        vital = {point for shape in shapes for point in shape.points} | {q.point for q in self.task.asked}
        vital |= {*about, *(point for point, arrow in self.found.own.items() if arrow.name in named)}
        repeated: set[str] = set()
        for body in self.task.translating:
            alone = {point for point in points if self.task.linkage.owners(point) == [body]}
            if vital & set(self.task.scene.bodies[body]):
                repeated |= alone - vital
        return [point for point in points if point not in repeated]


def vectors_of(
    mechanism: MovingMechanism,
    order: int,
    vectors: Sequence[PointVectors] = (),
    methods: Sequence[str] = (),
) -> Vectors:
    """The ``vectors`` of a solution of velocities (``order`` 1) or accelerations (2).

    Where there is no solution beside the figure, those of one by the ``methods``, or by its natural ones.
    """
    task, language = mechanism.task, mechanism.language
    symbols = Symbols(task.form, language, load_phrases(language.name), {})
    return Vectors(task, (vectors or named_vectors(task, methods))[order - 1], symbols)
