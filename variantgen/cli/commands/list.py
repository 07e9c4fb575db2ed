"""``variantgen list``: what there is to choose from."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from variantgen.cli.columns import in_columns
from variantgen.cli.exam_preview import refuse_exam
from variantgen.cli.messages import say, tell
from variantgen.cli.options import add_families, add_language
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.families.family import Family

_Heading: TypeAlias = "tuple[Mapping[str, str], list[str], Mapping[str, Mapping[str, Any]]]"

HELP = "list the problem families, or what a family offers"
DESCRIPTION = """\
List the problem families of the catalogue and of your own folders: title, forms, and for those of the
catalogue the calculations that a usual variant takes, with the level (docs/fairness.md).
With the name of a family (or the path of a scene): its forms, their work, their parameters with ranges,
all that can be asked with symbol and unit, and a problem to paste into an exam file.
With --structures: the structures that compose makes families of, and which families have them."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("family", nargs="?", default="", metavar="FAMILY_OR_FILE", help="what this one offers")
    parser.add_argument(
        "--figure",
        type=Path,
        metavar="FILE",
        help="draw the family: .svg, .png, .pdf, .tikz or .tex; of several forms each into a file of its own",
    )
    parser.add_argument("--structures", action="store_true", help="list structures; --figure page.html draws them")
    parser.add_argument("--links", type=int, default=5, metavar="N", help="with at most N moving links (default: 5)")
    add_language(parser)
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Print names, titles and forms, or what one family offers. Raises InputError."""
    from variantgen.families.reading.folders import family_folders, family_names
    from variantgen.wording.words import check_language

    check_language(arguments.lang)
    folders = family_folders(arguments.families)
    if arguments.structures:
        _structures(arguments, folders)
    elif arguments.family:
        refuse_exam(arguments, "list tells what a family offers")
        _one(arguments, folders)
    elif arguments.figure:
        raise InputError(Problem("of which family?", key="--figure", remedy="name it: variantgen list four_bar ..."))
    else:
        _all(arguments, {name: _heading(name, folders) for name in family_names(folders)})
    return 0


def _heading(name: str, folders: tuple[Path, ...]) -> _Heading:
    """The titles of a family by language, its forms, and the work of forms of the catalogue.

    A family of the catalogue is only read: to check them all takes longer than everything else, and
    they are right.
    """
    from variantgen.exam.work.kept_work import kept_medians
    from variantgen.exam.work.wanted_work import level_of
    from variantgen.families.reading.folders import file_of
    from variantgen.resources import catalog_dir
    from variantgen.tables import read_toml

    path = file_of(name, folders)
    if path is not None and path.parent.parent == catalog_dir():
        data = read_toml(path)
        forms = list(data.get("forms", ()))
        usual = {form: kept_medians().get((name, form)) for form in forms or [""]}
        works = {form: {"calculations": n, "level": level_of(n)} for form, n in usual.items() if n}
        return data["title"], forms, works
    from variantgen.families.reading.load import load_family

    family = load_family(name, folders)
    return family.titles, [form for form in family.forms if form], {}


def _all(arguments: argparse.Namespace, families: Mapping[str, _Heading]) -> None:
    """A line for each family."""
    if arguments.json:
        rows = [
            {"family": name, "title": dict(titles), "forms": forms, "work": works}
            for name, (titles, forms, works) in families.items()
        ]
        say(json.dumps(rows, ensure_ascii=False, indent=2))
        return
    width = max(map(len, families))
    for name, (titles, forms, works) in families.items():
        title = titles.get(arguments.lang) or titles.get("en") or name
        shown = ", ".join(f"{form} {_work(works.get(form))}".strip() for form in forms or [""])
        say(f"{name:{width}}  {title}" + (f"  [{shown}]" if shown else ""))


def _work(found: Mapping[str, Any] | None) -> str:
    """``44 medium``; nothing where it is not known."""
    return "" if found is None else f"{found['calculations']:g} {found['level']}"


def _structures(arguments: argparse.Namespace, folders: tuple[Path, ...]) -> None:
    """The structures of textbooks, or a page with their pictures."""
    from variantgen.families.reading.folders import family_names
    from variantgen.families.reading.load import load_family
    from variantgen.outputs.structures import structure_rows, write_structures

    path: Path | None = arguments.figure
    if path is not None and path.suffix != ".html":
        raise InputError(Problem("expected a page", key="--figure", value=str(path), remedy="structures.html"))
    families = [load_family(name, folders) for name in family_names(folders)]
    rows = structure_rows(families, arguments.links)
    if path is not None:
        write_structures(rows, arguments.links, path)
        tell(f"written: {path}")
    elif arguments.json:
        document = [{"structure": row.code, "level": row.level, "families": list(row.families)} for row in rows]
        say(json.dumps(document, indent=2))
    else:
        for line in in_columns([(row.code, row.level, ", ".join(row.families)) for row in rows]):
            say(line)


def _one(arguments: argparse.Namespace, folders: tuple[Path, ...]) -> None:
    """What one family offers, and its figures."""
    from variantgen.families.reading.load import load_family
    from variantgen.overview import overview
    from variantgen.wording.language import load_language

    family = load_family(arguments.family, folders)
    named = "" if arguments.family == family.name else arguments.family
    if arguments.figure:
        _draw(arguments, family, folders)
    found = overview(family, load_language(arguments.lang), named)
    if arguments.json:
        say(json.dumps(found, ensure_ascii=False, indent=2))
        return
    title = family.title(arguments.lang)
    say(f"{family.name}: {title}" if title and title != family.name else family.name)
    if family.source:
        say(f"source: {family.source}")
    for names, form in _alike(found["forms"]):
        if names:
            say(f"\n{'form' if len(names) == 1 else 'forms'} {', '.join(names)}")
        for line in _told(form):
            say(line)
    if not arguments.figure:
        say(f"\nfigure: variantgen list {arguments.family} --figure {family.name}.svg")
    say(f"\n{found['problem']}")


def _alike(forms: list[dict[str, Any]]) -> Iterator[tuple[list[str], dict[str, Any]]]:
    """Forms that differ in nothing but their names, together."""
    left = list(forms)
    while left:
        first = left[0]
        same = [form for form in left if {**form, "form": ""} == {**first, "form": ""}]
        left = [form for form in left if form not in same]
        yield [form["form"] for form in same if form["form"]], first


def _told(form: Mapping[str, Any]) -> Iterator[str]:
    """The work of a form, its parameters, and what it can be asked for."""
    if form["work"]:
        yield from ("", f"work: some {form['work']['calculations']:g} calculations ({form['work']['level']})")
    rows = [
        (f"  {name}", parameter.get("unit", ""), _values(parameter)) for name, parameter in form["parameters"].items()
    ]
    yield from ("", "parameters") if rows else ("", "no parameters: one variant")
    yield from in_columns(rows)
    yield from ("", "can be asked (* is asked if nothing is named)")
    yield from in_columns(list(_asked(form)))
    if form["likewise"]:
        yield from ("", "likewise, of any points, lines and bodies for which the data do not tell it, such as")
        yield from in_columns([(f"  {item['quantity']}", item["symbol"], item["unit"]) for item in form["likewise"]])


def _values(parameter: Mapping[str, Any]) -> str:
    """``10 to 30, step 2``, the values of a list, or the words of a choice."""
    if "choices" in parameter:
        return " or ".join(parameter["choices"])
    unseen = "" if parameter.get("printed", True) else "  (only varies the figure)"
    if "step" in parameter:
        return f"{parameter['from']:g} to {parameter['to']:g}, step {parameter['step']:g}{unseen}"
    shown = [f"{value:g}" for value in parameter["values"]]
    if len(shown) > _LISTED:
        shown = [*shown[:_LISTED], f"... {shown[-1]} ({len(shown)} values)"]
    return ", ".join(shown) + unseen


_LISTED = 12  # values that are written one by one


def _asked(form: Mapping[str, Any]) -> Iterator[tuple[str, ...]]:
    """A line for each quantity; what can be asked of it besides, as components, stands behind it."""
    names = {item["quantity"]: item for item in form["can_be_asked"]}
    for name, item in names.items():
        whole, _, part = name.rpartition(".")
        if part and whole in names:
            continue
        mark = "*" if any(own == name or own.startswith(name + ".") for own in form["ask"]) else " "
        further = [
            other.removeprefix(name) + (f" ({own['unit']})" if own["unit"] not in (item["unit"], "1") else "")
            for other, own in names.items()
            if other.rpartition(".")[0] == name
        ]
        yield f"{mark} {name}", item["symbol"], item["unit"], "  ".join(further)


def _draw(arguments: argparse.Namespace, family: Family, folders: tuple[Path, ...]) -> None:
    """The figure of each form, with the name of the form before the ending where there are several."""
    from variantgen.outputs.figures import check_ending
    from variantgen.outputs.single.picture import picture
    from variantgen.single import one_variant

    check_ending(arguments.figure)
    for form in family.forms:
        variant = one_variant(arguments.family, form=form, folders=folders)
        goal: Path = arguments.figure
        if len(family.forms) > 1:
            goal = goal.with_stem(f"{goal.stem}-{form}")
        picture(variant, language=arguments.lang).save(goal)
        tell(f"written: {goal}")
