"""Reading of one form of a family: parameters, derived quantities, laws, scene, screens, figure hints."""

from __future__ import annotations

import re
from collections.abc import Collection
from decimal import Decimal
from fnmatch import fnmatchcase
from typing import Any, NamedTuple

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.asking import read_ask
from variantgen.families.course import Interval
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.found_instant import read_found_instant, with_found_instant
from variantgen.families.hints import check_marks, read_figure, read_pose, read_screens
from variantgen.families.machine import read_machine
from variantgen.families.nice import read_nice
from variantgen.families.parameters.laws import Law
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.reading import read_parameter
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import is_quantity, quantity_names
from variantgen.families.reading.definitions import Definitions
from variantgen.families.reading.driven_laws import with_accelerations
from variantgen.families.reading.implied import belt_words, with_blocks, with_stations
from variantgen.families.reading.law_reader import check_motion, read_interval, read_laws
from variantgen.families.reading.soundness import check_constants
from variantgen.families.templates import TemplateReader
from variantgen.limits import DERIVED, GRID, PARAMETERS, PARTS
from variantgen.tables import Table

SECTIONS = (
    "parameters", "derived", "laws", "points", "conditions", "bodies", "joints", "drivers", "screens", "pose", "figure",
    "symbols", "nouns", "nice", "machine",
)  # fmt: skip
_OF_NAMES = ("parameters", "derived", "laws", "points", "bodies", "symbols", "nouns")  # tables with names as keys
_LISTED = ("joints", "drivers", "conditions")
_OF_FORM = (*_LISTED, "ask", "may_ask", "length_unit")
_WITHIN = Decimal("0.43")  # of an interval of time: no instant at which something happens by accident
_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9]{0,20}")
_MOST = {"parameters": PARAMETERS, "derived": DERIVED, "laws": DERIVED} | dict.fromkeys(
    ("points", "conditions", "bodies", "joints", "drivers"), PARTS
)


class _Mechanism(NamedTuple):
    """The scene of a form as its file has it."""

    points: dict[str, ComponentTemplate]
    bodies: dict[str, tuple[str, ...]]
    conditions: tuple[ComponentTemplate, ...]
    joints: tuple[ComponentTemplate, ...]
    drivers: tuple[ComponentTemplate, ...]


class FormReader:
    """Reads one form; problems are collected, ``read`` returns None if there were any."""

    def __init__(
        self, name: str, data: dict[str, Any], length: str, ask: tuple[str, ...], problems: list[Problem]
    ) -> None:
        self.name = name
        self.top = Table(data, f"forms.{name}" if name else "", problems)
        self.ask = ask
        self.problems = problems
        self.parameters: dict[str, Parameter] = {}
        self._known = Definitions()
        self.laws: dict[str, Law] = {}
        self._values = 0
        self._length = length
        self._templates = TemplateReader(self._known.expression, unit(length))

    def read(self, may_ask: tuple[str, ...] = ()) -> Form | None:
        """The form, or None."""
        before = len(self.problems)

        def is_faulty() -> bool:
            return len(self.problems) > before

        for section, most in _MOST.items():
            self.top.bounded(section, most)
        self._check_headings()
        if is_faulty():
            return None  # what refers to the missing entries would be reported too
        self._read_parameters()
        if is_faulty():  # what uses a wrong parameter would only repeat that it is unknown
            return None
        self._known.read(self.top.table("derived"))
        known = len(self.problems)
        interval = self._read_laws()
        if len(self.problems) > known:  # what uses a wrong law would only repeat that it is unknown
            return None
        mechanism = self._read_mechanism()
        if not is_faulty():
            mechanism = self._completed(mechanism)
        form = self._read_form(mechanism, interval, may_ask)
        if is_faulty():
            return None
        with self.top.collecting(""):
            form = self._sound(form)
        return None if is_faulty() else form

    def _read_parameters(self) -> None:
        """The parameters, of which expressions are made."""
        before, table = len(self.problems), self.top.table("parameters")
        self.parameters = table.each(lambda key, value: self._read_parameter(table, key, value))
        if len(self.problems) == before:
            self._add_found_time(self.top.data.get("laws"))
        self._known.add(self.parameters)

    def _read_laws(self) -> Interval | None:
        """The laws; their interval of time, if they have one."""
        table = self.top.table("laws")
        self.laws = read_laws(
            self._known, table, self.top.data, self._length, self._templates.quantity, self.parameters
        )
        return read_interval(table, self._templates.quantity, self._known.dimensions)

    def _read_mechanism(self) -> _Mechanism:
        """Points, bodies and what joins and drives them."""
        points = self._templates.points(self.top.table("points"))
        table = self.top.table("bodies")
        bodies = {name: table.strings(name) for name in table.data}
        self._check_names("points", points)
        self._check_names("bodies", bodies)
        conditions, joints, drivers = (
            self._listed(name, f"variantgen.mechanism.{name}") for name in ("conditions", "joints", "drivers")
        )
        return _Mechanism(points, bodies, conditions, joints, drivers)

    def _completed(self, mechanism: _Mechanism) -> _Mechanism:
        """The mechanism with what its file leaves unsaid."""
        bodies = mechanism.bodies
        drivers = with_accelerations(mechanism.drivers, self.laws, self._known.expression)
        joints = with_blocks(with_stations(mechanism.joints, drivers, bodies), drivers, bodies)
        return mechanism._replace(joints=joints, drivers=drivers)

    def _read_form(self, mechanism: _Mechanism, interval: Interval | None, may_ask: tuple[str, ...]) -> Form:
        """The form, with how it is drawn, screened, called and written."""
        points, bodies, conditions, joints, drivers = mechanism
        screens = read_screens(self.top.table("screens"), self._known.expression, points)
        pose = read_pose(self.top.table("pose"))
        figure = read_figure(self.top.table("figure"), set(points), bodies, self._templates.quantity)
        check_marks(self.top, figure, self.parameters)
        form = Form(
            self.name,
            self.parameters,
            self._known.derived,
            points,
            bodies,
            joints,
            drivers,
            self.ask,
            conditions,
            may_ask,
            screens,
            pose,
            figure,
            nice=read_nice(self.top.table("nice"), self.parameters, self._known.expression),
            symbols=self._words("symbols") | belt_words(joints),
            laws=self.laws,
            machine=read_machine(self.top.table("machine")),
            nouns=self._words("nouns"),
            interval=interval,
        )
        self.top.finish()
        self._check_symbols()
        for name in sorted(set(form.nouns) - set(bodies)):
            self.top.problem("unknown body", f"nouns.{name}", name, nearest(name, bodies))
        return form

    def _words(self, section: str) -> dict[str, str]:
        """A table of words by names."""
        table = self.top.table(section)
        return {name: table.take(name, str, "") for name in table.data}

    def _sound(self, form: Form) -> Form:
        """The form with the instant that its laws say how to find, once all agrees. Raises InputError."""
        check_constants(form)
        _ = form.plan
        check_motion(form, self.top.data.get("laws", {}))
        form = self._with_instant(form)
        return self._asking(form)

    def _with_instant(self, form: Form) -> Form:
        """The form with the instant that its laws say how to find. Raises InputError."""
        laws = self.top.data.get("laws") or {}
        if "instant" not in laws:
            return form
        return with_found_instant(replace(form, found_instant=read_found_instant(form, laws["instant"], self._length)))

    def _add_found_time(self, laws: Any) -> None:
        """The parameter of an instant that is found: until then somewhere in the interval."""
        if not isinstance(laws, dict) or "instant" not in laws:
            return
        name, ends = laws.get("time", "t"), laws.get("interval")
        if not isinstance(name, str) or name in self.parameters:
            remedy = f"leave the parameter {name} out, or instant in [laws]"
            self.top.problem("is found and cannot be given", f"parameters.{name}", name, remedy)
            return
        within = Decimal(1)
        if isinstance(ends, list) and len(ends) == 2 and all(isinstance(end, int | Decimal) for end in ends):
            within = ends[0] + _WITHIN * (ends[1] - ends[0])
        self.parameters[name] = Parameter(name, unit("s"), (within,), symbol=name, found=True)

    def _check_headings(self) -> None:
        """What is meant for the whole form does not stand below the heading of a table of names."""
        for section in _OF_NAMES:
            table = self.top.data.get(section)
            for key in table if isinstance(table, dict) else ():
                if key in _OF_FORM:
                    said = f"stands below the heading [{section}], so it belongs to that table"
                    heading = f"[[{key}]] as a heading of its own" if key in _LISTED else "it above the first heading"
                    self.top.problem(said, f"{section}.{key}", "", f"write {heading}")

    def _read_parameter(self, table: Table, name: str, value: Any) -> Parameter | None:
        """A parameter, as long as there is room for the values of all of them."""
        if self._values > GRID:
            return None  # that is noted already
        parameter = read_parameter(table, name, value)
        self._values += len(parameter.printed) if parameter else 0
        if self._values > GRID:
            remedy = "take larger steps, or fewer parameters"
            table.problem(f"more than {GRID} values of parameters together", name, self._values, remedy)
        return parameter

    def _check_names(self, section: str, names: Collection[str]) -> None:
        """Names of points and bodies are parts of the names of quantities: letters and digits only."""
        for name in names:
            if not _PLAIN.fullmatch(name):
                self.top.problem(
                    "a point or body is named by a Latin letter followed by letters and digits",
                    f"{section}.{name}",
                    name,
                )

    def _check_symbols(self) -> None:
        """No two printed parameters are written alike."""
        seen: dict[str, str] = {}
        for name, parameter in self.parameters.items():
            other = seen.setdefault(parameter.symbol, name)
            if other != name and parameter.given:
                self.top.problem(f"is written like {other}", f"parameters.{name}.symbol", parameter.symbol)

    def _asking(self, form: Form) -> Form:
        """The form with what it asks, all plain quantities if its file does not say; it can be asked for all of it."""
        names = quantity_names(form.sample)
        for pattern in form.may_ask:
            if not any(fnmatchcase(name, pattern) for name in names) and not is_quantity(pattern, form.sample):
                raise InputError(
                    Problem(
                        "fits no quantity of the scene",
                        key="may_ask",
                        value=pattern,
                        remedy="known: " + ", ".join(names),
                    )
                )
        if self.ask:
            read_ask(form)
            return form
        given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
        plain = tuple(name for name in form.askable if name not in given and ("." not in name or form.may_ask))
        if not plain:
            raise InputError(
                Problem("nothing moves in this scene", key="bodies", remedy="add bodies, joints and a driver")
            )
        return replace(form, ask=plain)

    def _listed(self, name: str, package: str) -> tuple[ComponentTemplate, ...]:
        found = [self._templates.read(table, package) for table in self.top.tables(name)]
        return tuple(template for template in found if template is not None)
