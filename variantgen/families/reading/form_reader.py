"""Reading of one form of a family: parameters, derived quantities, laws, scene, screens, figure hints."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace
from decimal import Decimal
from fnmatch import fnmatchcase
from heapq import heappop, heappush
from typing import Any

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.asking import read_ask
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.found_instant import read_found_instant, with_found_instant
from variantgen.families.hints import check_marks, read_figure, read_pose, read_screens
from variantgen.families.machine import read_machine
from variantgen.families.nice import read_nice
from variantgen.families.parameters.dimensions import Dimension, dimension_name
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.families.parameters.laws import Law
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.plain_angles import Kind, check_angle, kind_of, kind_of_parameter
from variantgen.families.parameters.reading import check_name, read_parameter, unknown_name
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import is_quantity, quantity_names
from variantgen.families.reading.driven_laws import with_accelerations
from variantgen.families.reading.implied import belt_words, with_blocks, with_stations
from variantgen.families.reading.law_reader import check_motion, read_interval, read_laws
from variantgen.families.reading.soundness import check_constants
from variantgen.families.templates import TemplateReader
from variantgen.limits import DERIVED, GRID, PARAMETERS, PARTS
from variantgen.mechanism.component import DIMENSIONS
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
        self.derived: dict[str, FamilyExpression] = {}
        self.dimensions: dict[str, Dimension] = {}
        self.kinds: dict[str, Kind] = {}  # which of them are angles
        self.laws: dict[str, Law] = {}
        self._values = 0
        self._length = length
        self._templates = TemplateReader(self.expression, unit(length))

    def read(self, may_ask: tuple[str, ...] = ()) -> Form | None:
        """The form, or None."""
        before = len(self.problems)
        for section, most in _MOST.items():
            self.top.bounded(section, most)
        self._check_headings()
        if len(self.problems) > before:
            return None  # what refers to the missing entries would be reported too
        parameters = self.top.table("parameters")
        self.parameters = parameters.each(lambda key, value: self._read_parameter(parameters, key, value))
        if len(self.problems) > before:  # what uses a wrong parameter would only repeat that it is unknown
            return None
        self._add_found_time(self.top.data.get("laws"))
        self.dimensions = {n: p.unit.dimension if p.unit else (0, 0) for n, p in self.parameters.items()}
        self.kinds = {name: kind_of_parameter(parameter) for name, parameter in self.parameters.items()}
        self._read_derived(self.top.table("derived"))
        known = len(self.problems)
        laws = self.top.table("laws")
        self.laws = read_laws(self, laws, self.top.data, self._length, self._templates.quantity, self.parameters)
        interval = read_interval(laws, self._templates.quantity, self.dimensions)
        if len(self.problems) > known:  # what uses a wrong law would only repeat that it is unknown
            return None
        points = self._templates.points(self.top.table("points"))
        bodies_table = self.top.table("bodies")
        bodies = {name: bodies_table.strings(name) for name in bodies_table.data}
        self._check_names("points", points)
        self._check_names("bodies", bodies)
        conditions, joints, drivers = (
            self._listed(name, f"variantgen.mechanism.{name}") for name in ("conditions", "joints", "drivers")
        )
        if len(self.problems) == before:
            drivers = with_accelerations(drivers, self.laws, self.expression)
            joints = with_blocks(with_stations(joints, drivers, bodies), drivers, bodies)
        screens = read_screens(self.top.table("screens"), self.expression, points)
        pose = read_pose(self.top.table("pose"))
        figure = read_figure(self.top.table("figure"), set(points), bodies, self._templates.quantity)
        check_marks(self.top, figure, self.parameters)
        nice = read_nice(self.top.table("nice"), self.parameters, self.expression)
        written = self.top.table("symbols")
        symbols = {name: written.take(name, str, "") for name in written.data} | belt_words(joints)
        machine = read_machine(self.top.table("machine"))
        called = self.top.table("nouns")
        nouns = {name: called.take(name, str, "") for name in called.data}
        self.top.finish()
        self._check_symbols()
        for name in sorted(set(nouns) - set(bodies)):
            self.top.problem("unknown body", f"nouns.{name}", name, nearest(name, bodies))
        if len(self.problems) > before:
            return None
        form = Form(
            self.name,
            self.parameters,
            self.derived,
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
            symbols,
            nice,
            self.laws,
            nouns=nouns,
            machine=machine,
            interval=interval,
        )
        with self.top.collecting(""):
            check_constants(form)
            _ = form.plan
            check_motion(form, self.top.data.get("laws", {}))
            form = self._with_instant(form)
            self._check_ask(form)
        return form if len(self.problems) == before else None

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

    def _check_ask(self, form: Form) -> None:
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
            return
        given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
        plain = tuple(name for name in form.askable if name not in given and ("." not in name or form.may_ask))
        if not plain:
            raise InputError(
                Problem("nothing moves in this scene", key="bodies", remedy="add bodies, joints and a driver")
            )
        object.__setattr__(form, "ask", plain)

    def _read_derived(self, table: Table) -> None:
        """Derived quantities, each after those it uses; of several that could be next, the first in the file."""
        parsed = {name: self.parsed(table, name, value) for name, value in table.data.items()}
        waiting = {name: expression for name, expression in parsed.items() if expression is not None}
        order = {name: place for place, name in enumerate(waiting)}
        lacking = {name: len(expression.names & waiting.keys()) for name, expression in waiting.items()}
        users: dict[str, list[str]] = {name: [] for name in waiting}
        for name, expression in waiting.items():
            for used in expression.names & waiting.keys():
                users[used].append(name)
        ready = [(order[name], name) for name in waiting if not lacking[name]]
        while ready:
            _, name = heappop(ready)
            with table.collecting(name):
                self.define(name, waiting.pop(name))
            for user in users[name]:
                lacking[user] -= 1
                if not lacking[user]:
                    heappush(ready, (order[user], user))
        if waiting:
            table.problem("derived quantities use each other in a circle", "", ", ".join(waiting))

    def parsed(self, table: Table, name: str, value: Any) -> FamilyExpression | None:
        """The expression of a key; None for a wrong one, which is noted."""
        if not isinstance(value, str):
            table.problem("expected an expression in quotes", name, value)
            return None
        found: list[FamilyExpression] = []
        with table.collecting(name):
            found.append(parse(value))
        return found[0] if found else None

    def define(self, name: str, expression: FamilyExpression, dimension: Dimension | None = None) -> Dimension:
        """Make a name known; its dimension is that of the expression unless it is stated. Raises InputError."""
        if name in self.dimensions:
            raise InputError(Problem("the name is taken", value=name, remedy="choose another name"))
        check_name(name)
        self.known_names(expression)
        found = dimension or expression.dimension(self.dimensions) or (0, 0)
        self.dimensions[name] = found
        self.kinds[name] = kind_of(expression, self.kinds)
        self.derived[name] = expression
        return found

    def known_names(self, expression: FamilyExpression) -> None:
        """Raise InputError for an expression with an unknown name."""
        for used in sorted(expression.names):
            if used not in self.dimensions:
                raise InputError(unknown_name(used, list(self.dimensions), expression.text))

    def expression(self, text: str, dimension: str = "") -> FamilyExpression:
        """An expression over the known names, of the given dimension if one is due. Raises InputError."""
        expression = parse(text)
        self.known_names(expression)
        found = expression.dimension(self.dimensions)
        if dimension and found is not None and found != DIMENSIONS[dimension]:
            raise InputError(
                Problem(f"is {dimension_name(found)}, expected {dimension_name(DIMENSIONS[dimension])}", value=text)
            )
        (check_angle if dimension == "angle" else kind_of)(expression, self.kinds)
        return expression

    def _listed(self, name: str, package: str) -> tuple[ComponentTemplate, ...]:
        found = [self._templates.read(table, package) for table in self.top.tables(name)]
        return tuple(template for template in found if template is not None)
