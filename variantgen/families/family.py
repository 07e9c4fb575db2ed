"""A family: a parametrised problem, ready to be drawn and solved."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from fnmatch import fnmatchcase
from functools import cached_property
from pathlib import Path
from typing import Any

from msgspec import Struct, field

from variantgen.families.course import FormByPlace, FormInTime, FoundInstant, Interval
from variantgen.families.figure_hints import FigureHints
from variantgen.families.machine import Machine
from variantgen.families.parameters.draw_rules import HandFriendly, Pose, Screens, TiedValues
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.laws import Law
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.quantities import Quantity, is_quantity, quantity_names
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.structure import Plan, analyse

TOOTHED_RACK = "toothed_rack"  # what a bar is called with which a gear is in mesh


class ComponentTemplate(Struct, frozen=True):
    """A construction, joint or driver whose numbers are expressions."""

    component: type[Struct]
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


class Form(Struct, frozen=True, eq=False, dict=True):
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
    laws: Mapping[str, Law] = field(default_factory=dict)
    ties: TiedValues | None = None
    nouns: Mapping[str, str] = field(default_factory=dict)  # what a body is called in a solution
    machine: Machine | None = None  # its size class; without one nothing is too large or too fast
    interval: Interval | None = None  # of time, in which it moves by its laws
    found_instant: FoundInstant | None = None  # by what the instant of the problem is found, if it is not given
    friendly: bool = False  # only variants whose answers are short decimals or simple roots

    def __repr__(self) -> str:
        return f"<Form {self.name or '(the only one)'}: {', '.join(self.parameters)}; asks {', '.join(self.ask)}>"

    def values(self, parameters: Mapping[str, Real]) -> dict[str, Real]:
        """Parameters in SI together with the derived quantities."""
        found = dict(parameters)
        for name, expression in self.derived.items():
            found[name] = expression.value(found)
        return found

    def scene(self, values: Mapping[str, Real], on_paper: Frame | None = None) -> Scene:
        """The scene for SI values of parameters and derived quantities."""
        frame = on_paper or Frame()
        return Scene(
            {name: template.build(values) for name, template in self.points.items()},
            self.bodies,
            tuple(template.build(values) for template in self.joints),
            tuple(template.build(values) for template in self.drivers),
            frame,
            tuple(template.build(values) for template in self.conditions),
            self._course(values, frame) if self.interval else None,
        )

    def _course(self, values: Mapping[str, Real], frame: Frame) -> FormInTime | FormByPlace:
        """The motion in the interval of time."""
        assert self.interval is not None, "there is an interval"
        start, end = (expression.value(values) for expression in (self.interval.start, self.interval.end))
        parameters = {name: values[name] for name in self.parameters}
        if self.interval.is_of_place:
            return FormByPlace(self, self.interval.time, parameters, frame, start, end)
        return FormInTime(self, self.interval.time, parameters, frame, start, end)

    @cached_property
    def remembered(self) -> dict[Hashable, Any]:
        """What other parts of the program have worked out from this form alone, by keys of their own."""
        return {}

    @cached_property
    def of_accelerations_alone(self) -> frozenset[str]:
        """Parameters on which only accelerations depend: those of second order that are in no law of time, nor in an
        acceleration by which a law gives the velocity.
        """
        in_laws = set(self.laws) | {f"{name}_dot" for name, law in self.laws.items() if law.rate is not None}
        for name, expression in reversed(list(self.derived.items())):
            in_laws |= expression.names if name in in_laws else set()
        second = {name for name, parameter in self.parameters.items() if parameter.of_second_order}
        return frozenset(second - in_laws)

    @cached_property
    def askable(self) -> list[str]:
        """Names of the quantities that may be asked: the plain ones of the scene, or those that ``may_ask`` allows."""
        names = quantity_names(self.sample)
        if not self.may_ask:
            return names
        further = [name for name in self.may_ask if name not in names and is_quantity(name, self.sample)]
        return [name for name in names if any(fnmatchcase(name, p) for p in self.may_ask)] + further

    def may_be_asked(self, quantity: Quantity) -> bool:
        """Whether the data determine a quantity of the scene: itself, or the plain ones that it is made of."""
        if not self.may_ask or any(fnmatchcase(quantity.name, pattern) for pattern in self.may_ask):
            return True
        sources = quantity.sources(self.sample)
        return bool(sources) and quantity.is_of_instant and all(self._is_determined(source) for source in sources)

    def _is_determined(self, plain: Quantity) -> bool:
        """Whether a plain quantity is given, or ``may_ask`` allows it or another component of it."""
        if any(parameter.given and parameter.symbol == plain.whole_name for parameter in self.parameters.values()):
            return True
        if plain.is_vector:
            return plain.name in self.askable or f"{plain.whole_name}.x" in self.askable
        return any(name == plain.name or name.startswith(f"{plain.whole_name}.") for name in self.askable)

    @cached_property
    def sample(self) -> Scene:
        """The scene with the middle of every grid: for questions about names only."""
        middle = {name: float(p.si[len(p.si) // 2]) for name, p in self.parameters.items()}
        return self.scene(self.values(middle))

    @cached_property
    def linkage(self) -> Linkage:
        """Its reading by a reader of the figure: for questions about names only."""
        return Linkage(self.sample)

    @cached_property
    def plan(self) -> Plan:
        """The structure of the scene; the same for all variants."""
        return analyse(self.sample)

    @cached_property
    def bars(self) -> list[tuple[str, str, str]]:
        """Bodies drawn as bars, with the two ends (their first two points)."""
        drawn = {disc.body for disc in self.figure.discs} | {*self.figure.plates, *self.figure.plain}
        bars = {body: points for body, points in self.bodies.items() if len(points) > 1 and body not in drawn}
        return [(body, points[0], points[1]) for body, points in bars.items()]

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


class Family(Struct, frozen=True):
    """A parametrised problem: its forms, its titles per language, the unit of lengths, and where its files are.

    ``names`` are the names of points, bodies and printed parameters of all its forms, which its templates may use;
    they stay when the family is narrowed to some forms. ``solution`` are the methods natural to it, in order,
    ``units`` the units of length that it offers, if it names them; else it can be given in any.
    """

    name: str
    titles: Mapping[str, str]
    length_unit: str
    forms: Mapping[str, Form]
    folder: Path | None = None
    source: str = ""
    names: frozenset[str] = frozenset()
    solution: tuple[str, ...] = ()
    units: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<Family {self.name}: {', '.join(map(repr, self.forms.values()))}>"

    @property
    def is_scene(self) -> bool:
        """Whether it is a mechanism of a file by itself, without a statement: the program makes its sheet."""
        return self.folder is None

    @property
    def nice_forms(self) -> list[str]:
        """Names of the forms that have hand-friendly variants."""
        return [name for name, form in self.forms.items() if form.nice.possible]

    def title(self, language: str) -> str:
        """The title in a language, or in English, or the name."""
        return self.titles.get(language) or self.titles.get("en") or self.name
