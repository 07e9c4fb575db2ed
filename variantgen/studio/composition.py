"""The problems of an exam as the page Compose shows them: the list, and one problem with all that can be chosen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from variantgen.errors import InputError, Problem
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.studio.documents.document import Document
from variantgen.studio.documents.journal import version_of
from variantgen.studio.gallery.cards import ONLY, family_files, family_version, form_titles, own_folders
from variantgen.studio.gallery.figures import FIRST_SEED
from variantgen.studio.summary import problems_of
from variantgen.studio.workspace import Workspace
from variantgen.wording.html import to_html
from variantgen.wording.language import load_language

if TYPE_CHECKING:
    from variantgen.families.family import Family, Form
    from variantgen.variants.variant import Variant

_LARGEST = 1000  # share that is shown
_LISTED = 4  # symbols of what is asked, in the list


def names_of(table: Mapping[str, Any]) -> list[str]:
    """The families of the table of a problem. Raises InputError where there are none."""
    found = table.get("families") or ([table["family"]] if isinstance(table.get("family"), str) else [])
    names = [name for name in found if isinstance(name, str)] if isinstance(found, list) else []
    if not names:
        raise InputError(Problem("missing, expected the name of a family", key="family"))
    return names


def forms_of(table: Mapping[str, Any]) -> tuple[str, ...]:
    """The forms that the table of a problem names."""
    found = table.get("form", ())
    if isinstance(found, str):
        return (found,)
    return tuple(name for name in found if isinstance(name, str)) if isinstance(found, list) else ()


def table_of(document: Document, number: int) -> Mapping[str, Any]:
    """The table of a problem by its number from 1. Raises InputError."""
    tables = problems_of(document)
    if not 1 <= number <= len(tables):
        raise InputError(Problem("there is no such problem", key="problem", value=str(number)))
    return tables[number - 1]


def narrowed(table: Mapping[str, Any], name: str, workspace: Workspace, whole: bool = False) -> Family:
    """A family of a problem as the exam draws it; ``whole``: with all its values. Raises InputError."""
    family = load_family(name, own_folders(workspace, name))
    forms = tuple(form for form in forms_of(table) if form in family.forms)
    fixed, ranges = (_plain(table.get(key)) for key in ("set", "range"))
    nice, units = table.get("nice") is True, table.get("units")
    units = units if isinstance(units, str) else ""
    return restrict(family, {} if whole else fixed, {} if whole else ranges, forms, nice and not whole, units=units)


def _plain(found: Any) -> dict[str, Any]:
    return found if isinstance(found, dict) else {}


def asked_names(table: Mapping[str, Any], form: str) -> tuple[str, ...] | None:
    """What a problem asks of a form; None for what the form asks by itself."""
    ask = table.get("ask")
    if isinstance(ask, dict):
        ask = ask.get(form)
    if isinstance(ask, str):
        return (ask,)
    return tuple(name for name in ask if isinstance(name, str)) if isinstance(ask, list) else None


def listed(document: Document, workspace: Workspace, language: str) -> list[dict[str, Any]]:
    """The problems of an exam for the list: title, figure, what is asked, points."""
    files = family_files(workspace)
    found = []
    for number, table in enumerate(problems_of(document), start=1):
        try:
            names = names_of(table)
        except InputError:  # said at its line
            names = []
        row: dict[str, Any] = {
            "number": number,
            "key": version_of(repr(table)),
            "title": " / ".join(names),
            "points": table.get("points", ""),
            "asked": [],
        }
        row |= {"figure": "", "answers": 0, "several": len(names) > 1, "forms": len(forms_of(table))}
        try:
            families = [load_family(name, own_folders(workspace, name)) for name in names]
            row["title"] = " / ".join(family.title(language) for family in families)
            form = next(f for n, f in families[0].forms.items() if not forms_of(table) or n in forms_of(table))
            asked = _asked(form, asked_names(table, form.name))
            row["answers"] = len(asked)
            row["asked"] = [symbol(quantity, form, language) for quantity in asked[:_LISTED]]
            version = family_version(files[names[0]])
            row["figure"] = f"/figure/{names[0]}/{form.name or ONLY}/{FIRST_SEED}.svg?lang={language}&v={version}"
        except (InputError, StopIteration, IndexError, KeyError):
            pass  # what is wrong with it is said at its line
        found.append(row)
    return found


def _asked(form: Form, names: Sequence[str] | None) -> list[Any]:
    return read_ask(form, names)


def symbol(quantity: Any, form: Form, language: str) -> Markup:
    """The symbol of a quantity as markup."""
    return Markup(to_html(load_language(language).quantity(quantity, form.symbols)))  # noqa: S704


def problem(
    document: Document, workspace: Workspace, number: int, name: str, form_name: str, language: str
) -> dict[str, Any]:
    """All that can be chosen of a problem, for one of its families and forms. Raises InputError."""
    table = table_of(document, number)
    names = names_of(table)
    name = name if name in names else names[0]
    family = load_family(name, own_folders(workspace, name))
    taken = [n for n in family.forms if not forms_of(table) or n in forms_of(table)] or list(family.forms)
    form_name = form_name if form_name in taken else taken[0]
    form = family.forms[form_name]
    titles = form_titles(name, language)
    return {
        "number": number,
        "name": name,
        "form": form_name,
        "title": family.title(language),
        "families": [{"name": n, "title": load_family(n, own_folders(workspace, n)).title(language)} for n in names],
        "forms": [{"name": n, "title": titles.get(n, n.replace("_", " ")), "on": n in taken} for n in family.forms],
        "ask": _askable(form, asked_names(table, form_name), language),
        "by_form": isinstance(table.get("ask"), dict),
        "ranges": _ranges(table, family, form, language),
        "nice": table.get("nice") is True,
        "can_be_nice": bool(family.nice_forms),
        "tolerance": _tolerance(table.get("tolerance")),
        "tolerance_key": "tolerance.floor" if isinstance(table.get("tolerance"), dict) else "tolerance",
    }


def _askable(form: Form, names: Sequence[str] | None, language: str) -> list[dict[str, Any]]:
    """What the form asks by itself and what the exam asks besides, each with whether it is asked."""
    asked = {quantity.name for quantity in read_ask(form, names)}
    own = read_ask(form, None)
    others = [quantity for quantity in read_ask(form, names) if quantity.name not in {q.name for q in own}]
    return [{"name": q.name, "symbol": symbol(q, form, language), "on": q.name in asked} for q in (*own, *others)]


def _ranges(table: Mapping[str, Any], family: Family, form: Form, language: str) -> list[dict[str, Any]]:
    """The parameters that are printed, with their grids and what the exam leaves of them."""
    spoken = load_language(language)
    fixed, ranges = _plain(table.get("set")), _plain(table.get("range"))
    found = []
    for name, parameter in form.parameters.items():
        if not parameter.given or len(parameter.printed) < 2 or parameter.unit is None:
            continue
        grid = sorted(parameter.printed)
        low, high = _limits(fixed.get(name), ranges.get(name), grid)
        found.append(
            {
                "name": name,
                "symbol": Markup(to_html(spoken.symbol(parameter.symbol, form.symbols))),  # noqa: S704
                "unit": Markup(to_html(spoken.unit(parameter.unit))),  # noqa: S704
                "values": [_number(value) for value in grid],
                "low": low,
                "high": high,
                "fixed": name in fixed,
                "free": low == 0 and high == len(grid) - 1,
            }
        )
    return found


def _limits(fixed: Any, limits: Any, grid: Sequence[Decimal]) -> tuple[int, int]:
    """The places in a grid of the lowest and the highest value that an exam leaves."""
    last = len(grid) - 1
    if isinstance(fixed, int | Decimal) and Decimal(fixed).is_finite():
        place = min(range(len(grid)), key=lambda i: abs(grid[i] - fixed))
        return place, place
    if not (isinstance(limits, list) and len(limits) == 2):
        return 0, last
    if not all(isinstance(x, int | Decimal) and Decimal(x).is_finite() for x in limits):
        return 0, last
    inside = [i for i, value in enumerate(grid) if limits[0] <= value <= limits[1]]
    return (inside[0], inside[-1]) if inside else (0, last)


def _number(value: Decimal) -> str:
    return f"{value.normalize():f}"


def _tolerance(found: Any) -> str:
    floor = found.get("floor") if isinstance(found, dict) else found
    return percent(floor)


def percent(value: Any) -> str:
    """A share as percent; '' for what is none."""
    share = Decimal(value) if isinstance(value, int | Decimal) else Decimal("nan")
    return _number(share * 100) if share.is_finite() and abs(share) < _LARGEST else ""


def model(family: Family, name: str) -> Variant:
    """The variant of a form that sliders start from, always the same one. Raises InputError where there is none."""
    from variantgen.exam.answer_tolerances import AnswerTolerances
    from variantgen.variants.draw import draw

    known = family.forms[name].remembered
    if "model" not in known:
        only = restrict(family, forms=(name,)) if name else family
        known["model"] = draw(only, None, [("studio", 0)], screening=AnswerTolerances())[0]
    found: Variant = known["model"]
    return found
