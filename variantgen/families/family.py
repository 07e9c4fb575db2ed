"""A family: a parametrised problem, ready to be drawn and solved."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from fnmatch import fnmatchcase
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.families.expressions import FamilyExpression
from variantgen.families.figure_hints import FigureHints
from variantgen.families.quantities import quantity_names
from variantgen.families.units import Unit
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.structure import Plan, analyse


@dataclass(frozen=True)
class Parameter:
    """A drawn parameter: its grid of printed values, and the same in SI.

    A choice parameter has ``words`` and no unit. ``symbol`` is how it is written (``omega_OA``, ``phi``). A
    ``constant`` has the dimension of a rate but is none that the figure shows (g, the acceleration of free fall).
    A ``silent`` parameter only gives the figure variety: it is not printed and no answer may depend on it.
    """

    name: str
    unit: Unit | None
    printed: tuple[Decimal, ...]
    words: tuple[str, ...] = ()
    symbol: str = ""
    constant: bool = False
    silent: bool = False

    @cached_property
    def si(self) -> NDArray[np.float64]:
        """The grid in SI, shape (G,): what is printed is what is solved."""
        return np.array([self._to_si(value) for value in self.printed])

    def in_si(self, printed: Iterable[Decimal]) -> NDArray[np.float64]:
        """Printed values in SI; they need not lie on the grid."""
        known = self._on_grid
        return np.array([known[value] if value in known else self._to_si(value) for value in printed])

    @cached_property
    def _on_grid(self) -> dict[Decimal, float]:
        return dict(zip(self.printed, self.si.tolist(), strict=True))

    def _to_si(self, value: Decimal) -> float:
        return float(value) if self.unit is None else self.unit.to_si(value)

    @property
    def given(self) -> bool:
        """Whether its value is printed (a choice is seen in the figure)."""
        return self.unit is not None and not self.silent

    @property
    def is_rate(self) -> bool:
        """Whether it is a velocity, acceleration or their angular kin, whose sign the figure shows."""
        return self.unit is not None and self.unit.dimension[1] < 0 and not self.constant

    @property
    def of_second_order(self) -> bool:
        """Whether only accelerations depend on it."""
        return self.unit is not None and self.unit.dimension[1] == -2 and not self.constant


@dataclass(frozen=True)
class ComponentTemplate:
    """A construction, joint or driver whose numbers are expressions."""

    component: type
    fields: Mapping[str, Any]

    def build(self, values: Mapping[str, Real]) -> Any:
        """The component with numbers in SI."""
        return self.component(**{name: _built(item, values) for name, item in self.fields.items()})

    @property
    def names(self) -> frozenset[str]:
        """Parameters and derived quantities that it uses."""
        every = [part for item in self.fields.values() for part in (item if isinstance(item, tuple) else (item,))]
        used = [part.names for part in every if isinstance(part, FamilyExpression | ComponentTemplate)]
        return frozenset().union(*used)


def _built(item: Any, values: Mapping[str, Real]) -> Any:
    if isinstance(item, FamilyExpression):
        return item.value(values)
    if isinstance(item, tuple):
        return tuple(part.build(values) if isinstance(part, ComponentTemplate) else part for part in item)
    return item


@dataclass(frozen=True)
class Comparison:
    """``left < right`` (strict) or ``left <= right``, as written in ``text``."""

    text: str
    left: FamilyExpression
    right: FamilyExpression
    strict: bool

    def holds(self, values: Mapping[str, Real]) -> Any:
        """Whether it holds, per variant."""
        left, right = self.left.value(values), self.right.value(values)
        return np.less(left, right) if self.strict else np.less_equal(left, right)


@dataclass(frozen=True)
class Screens:
    """What a variant must meet. Angles in rad, the others relative to the size or rates of the mechanism.

    ``transmission``: distance from dead points (see Motion.transmission); ``spacing``: smallest distance of two
    hinges, of a hinge from a foreign link in proportion; ``aspect``: largest ratio of the sides;
    ``inside``: (point, end, end) triples, the point well between the ends; ``require``: comparisons of parameters;
    ``trivial``: smallest size of an answer; ``sensitivity``: largest relative change of an answer per relative
    change of the data; ``ceiling``: the largest relative error that a careful hand calculation may lead to;
    ``mistakes``: how far a plausible mistake must lead from the right answer, relative, to be noticed.
    """

    transmission: float = float(np.radians(30))
    spacing: float = 0.11
    aspect: float = 4.0
    trivial: float = 0.04
    sensitivity: float = 10.0
    ceiling: float = 0.03
    mistakes: float = 0.01
    inside: tuple[tuple[str, str, str], ...] = ()
    require: tuple[Comparison, ...] = ()


@dataclass(frozen=True)
class TiedValues:
    """Values of some parameters that go together: one of the ``rows`` is drawn, each with a printed value per name."""

    names: tuple[str, ...]
    rows: tuple[tuple[Decimal, ...], ...]

    def within(self, parameters: Mapping[str, Parameter]) -> TiedValues:
        """The rows that lie on the grids of the parameters."""
        grids = [parameters[name].printed for name in self.names]
        return TiedValues(self.names, tuple(r for r in self.rows if all(v in g for v, g in zip(r, grids, strict=True))))

    def places(self, parameters: Mapping[str, Parameter]) -> dict[str, NDArray[np.int64]]:
        """Per name the places of the values of the rows on its grid, shape (R,)."""
        return {
            name: np.array([parameters[name].printed.index(row[k]) for row in self.rows], dtype=np.int64)
            for k, name in enumerate(self.names)
        }


@dataclass(frozen=True)
class HandFriendly:
    """How hand-friendly variants are drawn: grids in place of those of the form, rows of values that go together.

    ``require``: further comparisons; ``possible``: whether there are such variants at all; ``answers``: whether the
    answers, too, must be short decimals or simple roots.
    """

    parameters: Mapping[str, Parameter] = field(default_factory=dict)
    ties: TiedValues | None = None
    require: tuple[Comparison, ...] = ()
    possible: bool = True
    answers: bool = True


@dataclass(frozen=True)
class Pose:
    """How a scene may be laid on paper: reflected, turned by quarter turns."""

    mirror: bool = True
    quarter_turns: tuple[int, ...] = (0,)

    def frames(self) -> list[tuple[int, int]]:
        """All (sense, quarter turns) pairs."""
        return [(sense, turn) for sense in ((1, -1) if self.mirror else (1,)) for turn in self.quarter_turns]


def frame(sense: Any, quarter_turns: Any) -> Frame:
    """The frame of a pose; exact at all quarter turns. Scalars or arrays."""
    turns = np.array([1.0, 1.0j, -1.0, -1.0j])[np.asarray(quarter_turns) % 4]
    return Frame(turns, np.asarray(sense, dtype=float))


@dataclass(frozen=True, eq=False)
class Form:
    """One arrangement of a family (driven by the crank, by the rocker, ...): everything that a variant needs.

    A form is itself and equal to no other, so that what follows from it alone can be remembered by it.
    """

    name: str
    parameters: Mapping[str, Parameter]
    derived: Mapping[str, FamilyExpression]
    points: Mapping[str, ComponentTemplate]
    bodies: Mapping[str, tuple[str, ...]]
    joints: tuple[ComponentTemplate, ...]
    drivers: tuple[ComponentTemplate, ...]
    ask: tuple[str, ...]
    conditions: tuple[ComponentTemplate, ...] = ()
    may_ask: tuple[str, ...] = ()
    screens: Screens = Screens()
    pose: Pose = Pose()
    figure: FigureHints = FigureHints()
    symbols: Mapping[str, str] = field(default_factory=dict)
    nice: HandFriendly = field(default_factory=HandFriendly)
    ties: TiedValues | None = None
    nouns: Mapping[str, str] = field(default_factory=dict)  # what a body is called in a solution
    friendly: bool = False  # only variants whose answers are short decimals or simple roots

    def values(self, parameters: Mapping[str, Real]) -> dict[str, Real]:
        """Parameters in SI together with the derived quantities."""
        found = dict(parameters)
        for name, expression in self.derived.items():
            found[name] = expression.value(found)
        return found

    def scene(self, values: Mapping[str, Real], on_paper: Frame | None = None) -> Scene:
        """The scene for SI values of parameters and derived quantities."""
        return Scene(
            {name: template.build(values) for name, template in self.points.items()},
            self.bodies,
            tuple(template.build(values) for template in self.joints),
            tuple(template.build(values) for template in self.drivers),
            on_paper or Frame(),
            tuple(template.build(values) for template in self.conditions),
        )

    @cached_property
    def remembered(self) -> dict[Hashable, Any]:
        """What other parts of the program have worked out from this form alone, by keys of their own."""
        return {}

    def __getstate__(self) -> dict[str, Any]:
        # What is remembered stays in its process: it can be worked out again, and is larger than the form.
        return {name: value for name, value in vars(self).items() if name != "remembered"}

    @cached_property
    def askable(self) -> list[str]:
        """Names of the quantities that may be asked: those of the scene, or those of them that ``may_ask`` allows."""
        names = quantity_names(self.sample)
        return [name for name in names if not self.may_ask or any(fnmatchcase(name, p) for p in self.may_ask)]

    @cached_property
    def sample(self) -> Scene:
        """The scene with the middle of every grid: for questions about names only."""
        middle = {name: float(p.si[len(p.si) // 2]) for name, p in self.parameters.items()}
        return self.scene(self.values(middle))

    @cached_property
    def plan(self) -> Plan:
        """The structure of the scene; the same for all variants."""
        return analyse(self.sample)

    @property
    def bars(self) -> list[tuple[str, str, str]]:
        """Bodies drawn as bars, with the two ends (their first two points)."""
        drawn = {disc.body for disc in self.figure.discs} | {*self.figure.plates, *self.figure.plain}
        return [(body, points[0], points[1]) for body, points in self.bodies.items() if body not in drawn]

    @property
    def grid_size(self) -> int:
        """Number of points of the parameter grid (poses and silent parameters not counted)."""
        size = len(self.ties.rows) if self.ties else 1
        for name in self.free_names:
            size *= len(self.parameters[name].printed)
        return size

    @property
    def free_names(self) -> list[str]:
        """Parameters that are drawn each by itself, without the silent ones, in order of their names."""
        tied = self.ties.names if self.ties else ()
        return sorted(name for name, p in self.parameters.items() if not p.silent and name not in tied)


@dataclass(frozen=True)
class Family:
    """A parametrised problem: its forms, its titles per language, the unit of lengths, and where its files are.

    ``names`` are the names of points, bodies and printed parameters of all its forms, which its templates may use;
    they stay when the family is narrowed to some forms. ``solution`` are the methods natural to it, in order.
    """

    name: str
    titles: Mapping[str, str]
    length_unit: str
    forms: Mapping[str, Form]
    folder: Path | None = None
    source: str = ""
    names: frozenset[str] = frozenset()
    solution: tuple[str, ...] = ()

    @property
    def nice_forms(self) -> list[str]:
        """Names of the forms that have hand-friendly variants."""
        return [name for name, form in self.forms.items() if form.nice.possible]

    def title(self, language: str) -> str:
        """The title in a language, or in English, or the name."""
        return self.titles.get(language) or self.titles.get("en") or self.name
