"""The mechanism in many positions on one sheet of paper: the figure of the statement without its marks."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.families.quantities import Quantity
from variantgen.figure.board import Board
from variantgen.figure.build import Mechanism, finished
from variantgen.figure.drawing import Arc, Drawing, Label, Layer, Line
from variantgen.figure.ground import Ground, moving_ground, resting_ground, rounded
from variantgen.figure.sketch import moved
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import fixed_points
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Formula
from variantgen.wording.language import Language

_FILM = 72.0  # diagonal of what the mechanism reaches in a film, u
_BESIDE = 4.6  # between a moving point and its name, u
_SAME = 1e-4  # distance below which two places are the same, u


class Paper(Struct, frozen=True):
    """Where a point in metres lies: ``scale * z + shift`` (u)."""

    scale: float
    shift: complex

    def at(self, z: ComplexField) -> ComplexField:
        """Places in u, of the shape of ``z`` (m)."""
        return np.asarray(self.scale * z + self.shift)


class Moving(Struct, frozen=True, dict=True):
    """The figures of a variant in the positions of a batch ``motion``; ``asked`` decides which points have names."""

    variant: Variant
    motion: Motion
    asked: Sequence[Quantity]
    language: Language

    @cached_property
    def paths(self) -> dict[str, ComplexField]:
        """Places (m) of the shown points that move by name, shape (K,) each."""
        size = float(self.motion.length_scale()[0])
        shown = {name: self.motion.z[name] for name in shown_points(self.variant, self.asked)}
        return {name: z for name, z in shown.items() if np.ptp(z.real) + np.ptp(z.imag) > 1e-6 * size}

    @cached_property
    def ground(self) -> list[ComplexField]:
        """Places (m), shape (K,) each, at which wheels touch what is at rest: the parts of rails that are rolled on."""
        at = Placement(self.motion.z, self.motion.frame)
        touches = [joint.contact_at(at) for joint in self.motion.scene.joints]
        return [np.asarray(contact.place) for contact in touches if contact is not None and contact.other is None]

    @cached_property
    def _box(self) -> tuple[complex, complex]:
        """Lower left and upper right corner (m) of the points and discs in all positions."""
        form = self.variant.form
        values = form.values({name: self.variant.si(name) for name in form.parameters})
        parts = [self.motion.z[name] for name in shown_points(self.variant, self.asked)]
        for disc in (disc for disc in form.figure.discs if not disc.arc):
            half_box = float(disc.radius.value(values)) * (1 + 1j)
            parts += [self.motion.z[disc.centre] + half_box, self.motion.z[disc.centre] - half_box]
        every = np.concatenate(parts)
        low = complex(every.real.min(), every.imag.min())
        high = complex(every.real.max(), every.imag.max())
        return low, high

    def _board(self, index: int, scale: float | None = None, bases: bool = True) -> Board:
        """The mechanism in one position, with or without the bases of fixed hinges (which seek room anew each time)."""
        joints = self.motion.scene.joints
        held = fixed_points(self.motion.scene)
        if not bases:
            joints = tuple(j for j in joints if not {shape.given_point for shape in j.shapes()} & held)
        one = replace(
            self.motion,
            scene=replace(self.motion.scene, joints=joints),
            outcome=np.zeros(1, dtype=np.int8),
            transmission=np.ones(1),
            z={name: places[index : index + 1] for name, places in self.motion.z.items()},
            v={},
            a={},
            omega={},
            epsilon={},
        )
        return Mechanism(self.variant, one, 0, self.asked, self.language).board(marks=False, scale=scale)

    def _lines(self, index: int, paper: Paper) -> tuple[list[Line], Ground]:
        """The lines of one position without bases, on the paper of another one; those of the ground for themselves."""
        sketch = self._board(index, paper.scale, bases=False).sketch
        lines, by = [moved(line, paper.shift) for line in sketch.lines], paper.shift
        ground = Ground(
            [line for line in lines if line.layer == Layer.GROUND],
            [wall._replace(start=wall.start + by, end=wall.end + by) for wall in sketch.walls],
            [wall._replace(centre=wall.centre + by) for wall in sketch.round_walls],
        )
        return [line for line in lines if Layer.GROUND < line.layer < Layer.MARK], ground

    def _may_rest(self, line: Line, index: int, paper: Paper) -> bool:
        """Whether a line that is drawn with the bases of hinges is part of them: no circle about a moving point."""
        places = [complex(paper.at(z[index : index + 1])[0]) for z in self.paths.values()]
        about = isinstance(line, Arc) and any(abs(line.centre - place) < _SAME for place in places)
        return line.layer < Layer.MARK and not about

    def corners(self, paper: Paper) -> list[complex]:
        """Lower left and upper right corner (u) of what the mechanism reaches."""
        return [complex(paper.at(np.array(corner))) for corner in self._box]

    def still(self, index: int) -> tuple[Drawing, Paper]:
        """The figure of one position with its labels, and where a point in metres lies in it."""
        drawing = finished(self._board(index))
        return drawing, Paper(drawing.scale, drawing.origin)

    def film(self, indices: Sequence[int], first: int) -> tuple[list[Line], list[list[Line]], list[Label], Paper]:
        """What rests, what moves in each of the positions, names of points in the position ``first``, the paper.

        All on the paper of the position ``first``. A position that cannot be drawn shows the picture before it.
        """
        low, high = self._box
        drawing = finished(self._board(first, _FILM / abs(high - low)))
        paper = Paper(drawing.scale, drawing.origin)
        last = self._lines(first, paper)
        known = {rounded(line) for line in (*last[0], *last[1].lines)}
        bases = [line for line in drawing.lines if rounded(line) not in known and self._may_rest(line, first, paper)]
        drawn = []
        for index in indices:
            with suppress(InputError):
                last = self._lines(index, paper)
            drawn.append(last)
        ground = resting_ground(self._lines(first, paper)[1], [one for _, one in drawn])
        frames = [[*moving_ground(one, ground), *lines] for lines, one in drawn]
        return [*ground, *bases], frames, list(drawing.labels), paper

    def names(self, labels: Sequence[Label], paper: Paper) -> list[tuple[Formula, ComplexField, ComplexField]]:
        """The names of points among ``labels``, where the points are and where the names stand (u), shape (K,) each.

        Those of moving points keep off the links; those of points at rest stay where they are.
        """
        named = {self.language.symbol(name, self.variant.form.symbols): name for name in self.motion.z}
        found: list[tuple[Formula, ComplexField, ComplexField]] = []
        for label in labels:
            name = next((name for symbol, name in named.items() if symbol == label.formula), None)
            if name is not None:
                at = paper.at(self.motion.z[name])
                beside = at + _BESIDE * self._free_side(name) if name in self.paths else np.full_like(at, label.at)
                found.append((label.formula, at, beside))
        return found

    def _free_side(self, name: str) -> ComplexField:
        """Unit vectors from a point to where its name does not lie on its links: away from them and somewhat aside."""
        shown = shown_points(self.variant, self.asked)
        bodies = [members for members in self.motion.scene.bodies.values() if name in members]
        joined = sorted({p for members in bodies for p in members if p != name and p in shown})
        rays = [self.motion.z[p] - self.motion.z[name] for p in joined]
        size = self.motion.size
        units = np.array([ray / np.abs(ray) for ray in rays if np.min(np.abs(ray)) > 0] or [np.full(size, -1.0)])
        side = 0.8j * units[0] - np.mean(units, axis=0)
        return np.asarray(side / np.where(np.abs(side) > 0, np.abs(side), 1.0))
