"""Reading of family files and one-off scene files."""

from __future__ import annotations

from contextlib import suppress
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.asking import read_ask
from variantgen.families.expressions import Dimension, Expression, dimension_name, number, parse
from variantgen.families.family import Family, Form, Parameter, Template
from variantgen.families.hints import read_figure, read_pose, read_screens
from variantgen.families.parameters import read_parameter, unknown_name
from variantgen.families.quantities import quantity_names
from variantgen.families.units import UNITS, Unit, is_number_with_unit, parse_value, sound, unit
from variantgen.mechanism.component import DIMENSIONS, FieldSpec, discover, field_specs
from variantgen.resources import catalog_dir
from variantgen.tables import Table, read_toml, shown

SCHEMA = 1
_SECTIONS = ("parameters", "derived", "points", "bodies", "joints", "drivers", "screens", "pose", "figure", "symbols")


def family_names() -> list[str]:
    """Names of the families of the catalogue, sorted."""
    return sorted(path.parent.name for path in catalog_dir().glob("*/family.toml"))


@cache
def load_family(name_or_path: str) -> Family:
    """A family of the catalogue by name, or from a family folder or file by path. Raises InputError."""
    if name_or_path in family_names():
        return read_family(catalog_dir() / name_or_path / "family.toml")
    path = Path(name_or_path)
    with suppress(OSError, ValueError):  # a name no file can have is just unknown
        if (path / "family.toml").is_file():
            return read_family(path / "family.toml")
        if path.suffix == ".toml" or path.is_file():
            return read_family(path)
    remedy = nearest(name_or_path, family_names())
    raise InputError(Problem("unknown family", key="family", value=name_or_path, remedy=remedy))


def read_family(path: Path) -> Family:
    """Read and check a family file. Raises InputError with every problem found."""
    try:
        return parse_family(read_toml(path), path)
    except InputError as error:
        raise error.located(str(path)) from None


def parse_family(data: dict[str, Any], path: Path) -> Family:
    """A family from the content of its file; ``path`` gives its name and folder."""
    problems: list[Problem] = []
    top = Table(data, "", problems)
    version = top.take("schema", int, SCHEMA)
    if version != SCHEMA:
        age = "newer than this program: update the program" if version > SCHEMA else "too old: see CHANGELOG.md"
        top.problem(f"expected schema {SCHEMA}", "schema", version, f"the file is {age}")
    titles = top.table("title").each(lambda key, value: value if isinstance(value, str) else None)
    length = top.take("length_unit", str, "m")
    with top.collecting("length_unit"):
        if unit(length, "").measures != "length":
            raise InputError(Problem("expected a unit of length", value=length, remedy="m, cm or mm"))
    ask = top.strings("ask")
    source = top.take("source", str, "")
    overlays = top.take("forms", dict, {}, "a table of forms")
    base = {name: top.take(name, (dict, list), {}) for name in _SECTIONS if name in data}
    top.finish()
    if problems:
        raise InputError(problems)
    forms: dict[str, Form] = {}
    for name, overlay in (overlays or {"": {}}).items():
        table = Table(overlay, f"forms.{name}" if name else "", problems)
        merged = _overlaid(base, {k: v for k, v in table.data.items() if k != "ask"})
        own_ask = table.strings("ask", ask)
        form = _FormReader(name, merged, length, own_ask, problems).read()
        if form is not None:
            forms[name] = form
    if problems:
        raise InputError(dict.fromkeys(problems))
    is_family = path.name == "family.toml"
    return Family(
        path.resolve().parent.name if is_family else path.stem,
        titles,
        length,
        forms,
        path.resolve().parent if is_family else None,
        source,
        frozenset(
            name
            for form in forms.values()
            for name in (*form.points, *form.bodies, *(p.symbol for p in form.parameters.values() if p.given))
        ),
    )


def _overlaid(base: dict[str, Any], overlay: dict[str, Any]) -> dict[str, Any]:
    """The base with the entries of each section replaced by those of the form; lists are replaced whole."""
    merged = dict(base)
    for section, content in overlay.items():
        under = merged.get(section)
        merged[section] = {**under, **content} if isinstance(under, dict) and isinstance(content, dict) else content
    return merged


class _FormReader:
    """Reads one form; problems are collected, ``read`` returns None if there were any."""

    def __init__(
        self, name: str, data: dict[str, Any], length: str, ask: tuple[str, ...], problems: list[Problem]
    ) -> None:
        self.name = name
        self.top = Table(data, f"forms.{name}" if name else "", problems)
        self.length = unit(length)
        self.ask = ask
        self.problems = problems
        self.parameters: dict[str, Parameter] = {}
        self.derived: dict[str, Expression] = {}
        self.dimensions: dict[str, Dimension] = {}

    def read(self) -> Form | None:
        """The form, or None."""
        before = len(self.problems)
        parameters = self.top.table("parameters")
        self.parameters = parameters.each(lambda key, value: read_parameter(parameters, key, value))
        self.dimensions = {n: p.unit.dimension if p.unit else (0, 0) for n, p in self.parameters.items()}
        self._read_derived(self.top.table("derived"))
        points = self._templates_by_name(self.top.table("points"), "variantgen.mechanism.constructions")
        bodies = self._bodies(self.top.table("bodies"))
        joints = self._template_list("joints", "variantgen.mechanism.joints")
        drivers = self._template_list("drivers", "variantgen.mechanism.drivers")
        screens = read_screens(self.top.table("screens"), self.comparison_side)
        pose = read_pose(self.top.table("pose"))
        figure = read_figure(self.top.table("figure"), set(points), bodies, self.comparison_side)
        symbols = self.top.table("symbols").each(lambda key, value: value if isinstance(value, str) else None)
        self.top.finish()
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
            screens,
            pose,
            figure,
            symbols,
        )
        with self.top.collecting(""):
            _ = form.plan
            self._check_ask(form)
        return form if len(self.problems) == before else None

    def _check_ask(self, form: Form) -> None:
        if self.ask:
            read_ask(form)
        else:
            names = tuple(name for name in quantity_names(form.sample) if "." not in name)
            if not names:
                raise InputError(
                    Problem("nothing moves in this scene", key="bodies", remedy="add bodies, joints and a driver")
                )
            object.__setattr__(form, "ask", names)

    def _read_derived(self, table: Table) -> None:
        waiting = dict(table.data)
        while waiting:
            for name, value in list(waiting.items()):
                expression = self._expression(table, name, value)
                if expression is None:
                    waiting.pop(name)
                elif not (expression.names & waiting.keys()):
                    waiting.pop(name)
                    self._define(table, name, expression)
                    break
            else:
                if waiting:
                    table.problem("derived quantities use each other in a circle", "", ", ".join(waiting))
                return

    def _expression(self, table: Table, name: str, value: Any) -> Expression | None:
        if not isinstance(value, str):
            table.problem("expected an expression in quotes", name, value)
            return None
        found: list[Expression] = []
        with table.collecting(name):
            found.append(parse(value))
        return found[0] if found else None

    def _define(self, table: Table, name: str, expression: Expression) -> None:
        if name in self.dimensions:
            table.problem("the name is taken", name)
            return
        with table.collecting(name):
            self._known_names(expression)
            self.dimensions[name] = expression.dimension(self.dimensions) or (0, 0)
            self.derived[name] = expression

    def _known_names(self, expression: Expression) -> None:
        for used in sorted(expression.names):
            if used not in self.dimensions:
                raise InputError(unknown_name(used, list(self.dimensions), expression.text))

    def comparison_side(self, text: str, dimension: str = "") -> Expression:
        """An expression over the known names, of the given dimension if one is due. Raises InputError."""
        expression = parse(text)
        self._known_names(expression)
        found = expression.dimension(self.dimensions)
        if dimension and found is not None and found != DIMENSIONS[dimension]:
            raise InputError(
                Problem(f"is {dimension_name(found)}, expected {dimension_name(DIMENSIONS[dimension])}", value=text)
            )
        return expression

    def _bodies(self, table: Table) -> dict[str, tuple[str, ...]]:
        found = {}
        for name in table.data:
            found[name] = table.strings(name)
        return found

    def _templates_by_name(self, table: Table, package: str) -> dict[str, Template]:
        return table.each(lambda name, value: self._template(Table(value, table.key(name), self.problems), package))

    def _template_list(self, name: str, package: str) -> tuple[Template, ...]:
        found = [self._template(table, package) for table in self.top.tables(name)]
        return tuple(template for template in found if template is not None)

    def _template(self, table: Table, package: str) -> Template | None:
        """``{ kind = { field = value, ... } }``."""
        kinds = discover(package)
        if len(table.data) != 1:
            table.problem("expected one kind with its fields", "", ", ".join(table.data), f"known: {', '.join(kinds)}")
            return None
        kind = next(iter(table.data))
        if kind not in kinds:
            table.problem("unknown kind", "", kind, nearest(kind, kinds))
            return None
        inner = table.table(kind)
        inner.expect(*(spec.name for spec in field_specs(kinds[kind])))
        fields: dict[str, Any] = {}
        for spec in field_specs(kinds[kind]):
            if spec.name not in inner.data:
                if spec.required:
                    inner.problem(f"missing, expected {spec.expects}", spec.name)
                continue
            with inner.collecting(spec.name):
                fields[spec.name] = self._field(spec, inner.data[spec.name])
        inner.finish()
        return Template(kinds[kind], fields)

    def _field(self, spec: FieldSpec, value: Any) -> Any:
        wrong = InputError(Problem(f"expected {spec.expects}", value=shown(value)))
        if spec.flag:
            if not isinstance(value, bool):
                raise wrong
            return value
        if spec.ref:
            names = value if spec.many else [value]
            if (
                not isinstance(names, list)
                or any(not isinstance(n, str) for n in names)
                or (spec.many and len(names) != 2)
            ):
                raise wrong
            return tuple(names) if spec.many else value
        if isinstance(value, bool) or not isinstance(value, int | Decimal | str):
            raise wrong
        if isinstance(value, str) and value in spec.words:
            return number(spec.words[value])
        return self._number(spec, value)

    def _number(self, spec: FieldSpec, value: int | Decimal | str) -> Expression:
        default = self._printed_unit(spec.dimension)
        if not isinstance(value, str):
            return number(default.to_si(sound(Decimal(value), "")))
        if is_number_with_unit(value):
            return number(default.to_si(parse_value(value, default, "")))
        return self.comparison_side(value, spec.dimension)

    def _printed_unit(self, dimension: str) -> Unit:
        """The unit of a bare number in a file: the family's length unit, degrees, seconds."""
        length = self.length.name
        names = {
            "length": length,
            "velocity": f"{length}/s",
            "acceleration": f"{length}/s^2",
            "angle": "deg",
            "angular velocity": "rad/s",
            "angular acceleration": "rad/s^2",
        }
        return UNITS[names.get(dimension, "1")]
