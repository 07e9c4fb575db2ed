"""Reading of family files and one-off scene files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.family import Family, Form
from variantgen.families.length_units import check_length_unit
from variantgen.families.method_names import check_methods
from variantgen.families.parameters.units import unit
from variantgen.families.rate_graphs import read_from_graph
from variantgen.families.reading.drawn_bodies import with_drawn_bodies
from variantgen.families.reading.driven_laws import as_written
from variantgen.families.reading.files import FAMILY, check_files
from variantgen.families.reading.folders import Folders, family_names, file_of
from variantgen.families.reading.form_reader import SECTIONS, FormReader
from variantgen.families.reading.implied import belt_words
from variantgen.families.reading.repeated import reported_once
from variantgen.families.sketches import check_sketch
from variantgen.letters import named, unseen
from variantgen.limits import FORMS
from variantgen.tables import Table, parse_toml, read_text

SCHEMA = 1
# What no exam says; a title and the number of the schema stand there too.
FAMILY_KEYS = frozenset({*SECTIONS, "length_unit", "ask", "may_ask", "source", "solution", "forms"})


def load_family(name_or_path: str | PathLike[str], folders: Folders = ()) -> Family:
    """A family by name, from the given folders or the catalogue (the first that has it), or by path.

    A path leads to a family folder, its ``family.toml``, or a scene file. The file is read anew each time; as long as
    it says the same, it is the same family. Raises InputError.
    """
    name_or_path = str(name_or_path)
    known = family_names(folders)
    if name_or_path in known and (own := file_of(name_or_path, folders)):
        return read_family(own)
    path = Path(name_or_path)
    found: Path | None = None
    with suppress(OSError, ValueError):  # a name no file can have is just unknown
        if (path / FAMILY).is_file():
            found = path / FAMILY
        elif path.suffix == ".toml" or path.is_file():
            found = path
    if found is not None:
        return read_family(found)
    raise InputError(Problem("unknown family", key="family", value=name_or_path, remedy=nearest(name_or_path, known)))


def read_family(path: Path) -> Family:
    """Read and check a family file. Raises InputError with every problem found."""
    if path.name == FAMILY:
        check_files(path.parent)
    try:
        return _of_text(read_text(path), path)
    except InputError as error:
        raise error.located(str(path)) from None


@cache
def _of_text(text: str, path: Path) -> Family:
    """The family that the text of a file says."""
    return parse_family(parse_toml(text, path), path)


def parse_family(data: dict[str, Any], path: Path) -> Family:
    """A family from the content of its file; ``path`` gives its name and folder.

    Raises InputError with every problem found.
    """
    head = _read_head(data)
    forms = _read_forms(head)
    is_family = path.name == FAMILY
    if not is_family:
        forms = {name: with_drawn_bodies(as_written(form)) for name, form in forms.items()}
    return Family(
        path.resolve().parent.name if is_family else path.stem,
        head.titles,
        head.length,
        forms,
        path.resolve().parent if is_family else None,
        head.source,
        frozenset(
            name
            for form in forms.values()
            for name in (*form.points, *form.bodies, *(p.symbol for p in form.parameters.values() if p.given))
        ),
        head.solution,
        head.units,
    )


class _Head(NamedTuple):
    """What a file says of all its forms: ``base`` are the sections that they share, ``overlays`` what each changes."""

    titles: dict[str, str]
    length: str
    units: tuple[str, ...]
    ask: tuple[str, ...]
    may_ask: tuple[str, ...]
    source: str
    solution: tuple[str, ...]
    overlays: dict[str, Any]
    base: dict[str, Any]


def _read_head(data: dict[str, Any]) -> _Head:
    """What stands above and beside the forms. Raises InputError."""
    problems: list[Problem] = []
    top = Table(data, "", problems)
    for key, letter, kind in _unseen(data, ""):
        remedy = "remove it: type the text anew instead of pasting it"
        problems.append(Problem(f"holds {kind}", key=key, value=named(letter), remedy=remedy))
    version = top.take("schema", int, SCHEMA)
    if version != SCHEMA:
        age = "newer than this program: update the program" if version > SCHEMA else "too old: see CHANGELOG.md"
        top.problem(f"expected schema {SCHEMA}", "schema", version, f"the file is {age}")
    title = top.table("title")
    titles = {name: title.take(name, str, "") for name in title.data}
    length, units = _read_units(top)
    ask, may_ask = top.strings("ask"), top.strings("may_ask")
    source = top.take("source", str, "")
    solution = top.strings("solution")
    with top.collecting("solution"):
        check_methods(solution, "solution")
    top.bounded("forms", FORMS)
    overlays = top.take("forms", dict, {}, "a table of forms")
    base = {name: top.take(name, (dict, list), {}) for name in SECTIONS if name in data}
    top.finish()
    if problems:
        raise InputError(problems)
    return _Head(titles, length, units, ask, may_ask, source, solution, overlays, base)


def _read_units(top: Table) -> tuple[str, tuple[str, ...]]:
    """The unit of the lengths of a file, and those that it offers; mistakes are noted."""
    length = top.take("length_unit", str, "m")
    with top.collecting("length_unit"):
        if unit(length, "").measures != "length":
            raise InputError(Problem("expected a unit of length", value=length, remedy="m, cm or mm"))
    units = top.strings("units")
    for number, name in enumerate(units, start=1):
        with top.collecting(f"units[{number}]"):
            check_length_unit(name, "")
    if units and length not in units:
        top.problem("names other units than that of its numbers", "units", ", ".join(units), f'add "{length}"')
    return length, units


def _read_forms(head: _Head) -> dict[str, Form]:
    """The forms by name; one without a name where the file has no forms. Raises InputError."""
    problems: list[Problem] = []
    forms: dict[str, Form] = {}
    for name, overlay in (head.overlays or {"": {}}).items():
        table = Table(overlay, f"forms.{name}" if name else "", problems)
        merged = _overlaid(head.base, {k: v for k, v in table.data.items() if k not in ("ask", "may_ask")})
        reader = FormReader(name, merged, head.length, table.strings("ask", head.ask), problems)
        form = reader.read(table.strings("may_ask", head.may_ask))
        if form is not None:
            forms[name] = form
    _check_symbols(forms, problems)
    for name, form in forms.items() if not problems else ():
        with Table({}, "", problems).collecting(""):
            check_sketch(form, form.figure.sketch, "figure.sketch")
            if form.figure.graph:
                forms[name] = read_from_graph(form, form.figure.graph)
    if problems:
        raise InputError(reported_once(problems, head.overlays))
    return forms


def _check_symbols(forms: Mapping[str, Form], problems: list[Problem]) -> None:
    """What is written otherwise must be a body or a parameter of some form (forms share the table)."""
    known = {n for form in forms.values() for n in (*form.bodies, *form.parameters, *belt_words(form.joints))}
    for name in sorted({name for form in forms.values() for name in form.symbols} - known):
        remedy = nearest(name, known)
        problems.append(Problem("unknown body or parameter", key=f"symbols.{name}", value=name, remedy=remedy))


def _unseen(value: Any, key: str) -> Iterator[tuple[str, str, str]]:
    """What cannot be seen in the names and texts of a file: where, the character, what it is."""
    if isinstance(value, dict):
        for name, item in value.items():
            inner = f"{key}.{name}" if key else name
            yield from ((inner, letter, kind) for letter, kind in unseen(name).items())
            yield from _unseen(item, inner)
    elif isinstance(value, list):
        for number, item in enumerate(value, start=1):
            yield from _unseen(item, f"{key}[{number}]")
    elif isinstance(value, str):
        yield from ((key, letter, kind) for letter, kind in unseen(value, allowed="\n\r\t").items())


def _overlaid(base: dict[str, Any], overlay: dict[str, Any]) -> dict[str, Any]:
    """The base with the entries of each section replaced by those of the form; lists are replaced whole."""
    merged = dict(base)
    for section, content in overlay.items():
        under = merged.get(section)
        merged[section] = {**under, **content} if isinstance(under, dict) and isinstance(content, dict) else content
    return merged
