"""The mechanism in many positions on one sheet of paper: the figure of the statement without its marks.

The figure of each position is made like that of the statement. A thin line from a point to another and back is given
to it and taken out again: it tells where the figure lies. For a film a circle about everything that the mechanism
reaches is added likewise, which keeps the scale the same.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import starmap

import numpy as np

from variantgen.errors import InputError
from variantgen.families.expressions import Expression
from variantgen.families.family import DiscMark, Form
from variantgen.families.quantities import Quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing, Label, Layer, Line, Path, Strokes
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import fixed_points
from variantgen.variants.needed import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language

_FRAME = "frame of all positions"  # a name that no point of a family can have
_ROOM = 1.02  # radius of the circle, of what it surrounds
_SAME = 1e-4  # distance below which two lines are the same, u


@dataclass(frozen=True)
class Paper:
    """Where a point in metres lies: ``scale * z + shift`` (u)."""

    scale: float
    shift: complex

    def at(self, z: ComplexField) -> ComplexField:
        """Places in u."""
        return np.asarray(self.scale * z + self.shift)


@dataclass(frozen=True)
class Moving:
    """The figures of a variant in the positions of a batch ``motion``; ``asked`` decides which points have names."""

    variant: Variant
    motion: Motion
    asked: Sequence[Quantity]
    language: Language

    @cached_property
    def paths(self) -> dict[str, ComplexField]:
        """Places (m) of the shown points that move, by name."""
        size = float(self.motion.length_scale()[0])
        shown = {name: self.motion.z[name] for name in shown_points(self.variant, self.asked)}
        return {name: z for name, z in shown.items() if np.ptp(z.real) + np.ptp(z.imag) > 1e-6 * size}

    @cached_property
    def ground(self) -> list[ComplexField]:
        """Places (m) at which wheels touch what is at rest: rails and circles as far as they are rolled on."""
        at = Placement(self.motion.z, self.motion.frame)
        touches = [joint.contact_at(at) for joint in self.motion.scene.joints]
        return [np.asarray(touch.place) for touch in touches if touch is not None and touch.other is None]

    @cached_property
    def _box(self) -> tuple[complex, complex]:
        """Lower left and upper right corner (m) of the points and discs in all positions."""
        form = self.variant.form
        values = form.values({name: self.variant.si(name) for name in form.parameters})
        parts = [self.motion.z[name] for name in shown_points(self.variant, self.asked)]
        for disc in (disc for disc in form.figure.discs if not disc.arc):
            reach = float(disc.radius.value(values)) * (1 + 1j)
            parts += [self.motion.z[disc.centre] + reach, self.motion.z[disc.centre] - reach]
        every = np.concatenate(parts)
        low = complex(every.real.min(), every.imag.min())
        high = complex(every.real.max(), every.imag.max())
        return low, high

    @cached_property
    def _circle(self) -> tuple[complex, float]:
        """Middle and radius (m) of a circle about everything in all positions."""
        low, high = self._box
        return (low + high) / 2, _ROOM * abs(high - low) / 2

    @cached_property
    def _probe(self) -> tuple[str, str, str]:
        """Two points that are apart in all positions, if possible joined by a bar: there and back."""
        pairs = [(start, end) for _, start, end in self.variant.form.bars]
        shown = shown_points(self.variant, self.asked)
        pairs = pairs or [(a, b) for a in shown for b in self.motion.z if a != b]
        start, end = max(pairs, key=lambda pair: float(np.min(np.abs(self.motion.z[pair[0]] - self.motion.z[pair[1]]))))
        return start, end, start

    def _unmarked(self, framed: bool) -> Variant:
        """The variant without marks of data, with the probe and perhaps with the circle."""
        hints = self.variant.form.figure
        discs = tuple(replace(disc, name="") for disc in hints.discs)
        if framed:
            radius = Expression("radius", ast.Constant(self._circle[1]), frozenset())
            discs = (*discs, DiscMark(_FRAME, radius))
        thin = (*hints.thin, self._probe)
        form: Form = replace(self.variant.form, figure=replace(hints, angles=(), lengths=(), discs=discs, thin=thin))
        return replace(self.variant, form=form)

    def _drawn(self, index: int, variant: Variant, bases: bool = True) -> tuple[Drawing, Paper]:
        """The figure of one position, and where it lies; with or without the bases of fixed hinges."""
        joints = self.motion.scene.joints
        held = fixed_points(self.motion.scene)
        if not bases:
            joints = tuple(j for j in joints if not {shape.lead for shape in j.shapes()} & held)
        z = {name: places[index : index + 1] for name, places in self.motion.z.items()}
        one = replace(
            self.motion,
            scene=replace(self.motion.scene, joints=joints),
            outcome=np.zeros(1, dtype=np.int8),
            transmission=np.ones(1),
            z={**z, _FRAME: np.array([self._circle[0]])},
            v={},
            a={},
            omega={},
            epsilon={},
        )
        drawing = statement_figure(variant, one, 0, self.asked, self.language)
        probe = next(line for line in drawing.lines if _is_probe(line))
        assert isinstance(probe, Path)
        start, end = (complex(z[name][0]) for name in self._probe[:2])
        scale = abs(probe.points[1] - probe.points[0]) / abs(end - start)
        paper = Paper(scale, probe.points[0] - scale * start)
        lines = [line for line in drawing.lines if line is not probe and not self._is_frame(line, paper)]
        return replace(drawing, lines=tuple(lines)), paper

    def _is_frame(self, line: Line, paper: Paper) -> bool:
        """Whether a line is the circle about everything."""
        centre, radius = self._circle
        if not isinstance(line, Arc):
            return False
        place = complex(paper.at(np.array(centre)))
        return abs(line.radius - paper.scale * radius) + abs(line.centre - place) < _SAME

    def _may_rest(self, line: Line, index: int, paper: Paper) -> bool:
        """Whether a line that is drawn with the bases of hinges is part of them: no circle about a moving point."""
        places = [complex(paper.at(z[index : index + 1])[0]) for z in self.paths.values()]
        about = isinstance(line, Arc) and any(abs(line.centre - place) < _SAME for place in places)
        return line.layer != Layer.GROUND and not about

    def corners(self, paper: Paper) -> list[complex]:
        """Lower left and upper right corner (u) of what the mechanism reaches."""
        return [complex(paper.at(np.array(corner))) for corner in self._box]

    def still(self, index: int) -> tuple[Drawing, Paper]:
        """The figure of one position with its labels, and where a point in metres lies in it."""
        return self._drawn(index, self._unmarked(framed=False))

    def film(self, indices: Sequence[int], first: int) -> tuple[list[Line], list[list[Line]], list[Label], Paper]:
        """What rests, what moves in each of the positions, names of points in the position ``first``, the paper.

        All in the paper of the position ``first``. A position that cannot be drawn shows the picture before it.
        """
        variant = self._unmarked(framed=True)
        drawing, paper = self._drawn(first, variant)
        bare, where = self._drawn(first, variant, bases=False)
        lines = [_moved(line, paper.shift - where.shift) for line in bare.lines]
        known = {_rounded(line) for line in lines}
        bases = [line for line in drawing.lines if _rounded(line) not in known and self._may_rest(line, first, paper)]
        resting = [line for line in drawing.lines if line.layer == Layer.GROUND] + bases
        frames: list[list[Line]] = []
        last = lines
        for index in indices:
            try:
                bare, where = self._drawn(index, variant, bases=False)
                last = [_moved(line, paper.shift - where.shift) for line in bare.lines]
            except InputError:
                pass
            frames.append([line for line in last if Layer.GROUND < line.layer < Layer.MARK])
        return [line for line in resting if line.layer < Layer.MARK], frames, list(drawing.labels), paper


def _is_probe(line: Line) -> bool:
    """Whether a line leads to a point and back."""
    return isinstance(line, Path) and not line.closed and len(line.points) == 3 and line.points[0] == line.points[2]


def _rounded(line: Line) -> tuple[object, ...]:
    """What two equal lines have in common."""

    def near(place: complex) -> tuple[int, int]:
        return round(place.real / _SAME), round(place.imag / _SAME)

    match line:
        case Path(points, layer):
            return (layer, *(near(point) for point in points))
        case Strokes(segments, layer):
            return (layer, *(near(point) for segment in segments for point in segment))
        case Arc(centre, radius, layer):
            return (layer, near(centre), near(complex(radius, line.sweep)), near(line.at(0)))


def _moved(line: Line, by: complex) -> Line:
    """A line at another place."""
    match line:
        case Path(points):
            return replace(line, points=tuple(point + by for point in points))
        case Strokes(segments):
            return replace(line, segments=tuple(starmap(lambda a, b: (a + by, b + by), segments)))
        case Arc(centre):
            return replace(line, centre=centre + by)
