"""What the page Compose shows while something is chosen: figures of sliders, room of ranges, sheets of students."""

from __future__ import annotations

from decimal import Decimal, InvalidOperation
from typing import Any

from msgspec.structs import replace
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.building.preview import KINDS, class_of
from variantgen.studio.documents.document import Document
from variantgen.studio.frame import language_of
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.security import FIGURE_POLICY
from variantgen.studio.studio import Studio
from variantgen.studio.summary import students
from variantgen.studio.words import page_words

_MOST = 100  # problems of an exam
_NAMES = 5000  # that are listed


async def attempt(request: Request) -> Response:
    """The figure of a problem with the values at which sliders stand."""
    studio, data, language = studio_of(request), await read_json(request), language_of(request)
    document = document_of(request)
    found = await studio.draw(lambda: _tried(studio, document, data, language))
    return JSONResponse({**found, "n": data.get("n", 0)})


async def room(request: Request) -> Response:
    """How many variants a problem has, and which conditions reject the others."""
    number = number_of(request.path_params["number"], "problem", 1, _MOST)
    studio, document = studio_of(request), document_of(request)
    query, language = request.query_params, language_of(request)
    wanted = (query.get("family", ""), query.get("form", ""))
    return JSONResponse(await studio.typeset(lambda: _room(studio, document, number, wanted, language)))


async def sheet(request: Request) -> Response:
    """Set the sheet, or the solution, of a student: its name and number of pages."""
    studio, document = studio_of(request), document_of(request)
    kind = request.query_params.get("kind", "sheet")
    if kind not in KINDS:
        raise InputError(Problem("unknown kind", key="kind", value=kind[:20]))
    place = number_of(request.path_params["student"], "student", 1, 1_000_000)

    def made() -> dict[str, Any]:
        exam, everybody = document.exam(), class_of(studio.workspace)
        if place > len(everybody):
            raise InputError(Problem("there is no such student", value=str(place)))
        name, count = studio.previews.pages(exam, everybody, place - 1, kind)
        return {"name": name, "pages": count}

    return JSONResponse(await studio.typeset(made))


async def page(request: Request) -> Response:
    """One page that was set."""
    number = number_of(request.path_params["page"], "page", 1, 1000)
    content = studio_of(request).previews.page(request.path_params["name"], number)
    headers = {"cache-control": "private, max-age=31536000, immutable", "content-security-policy": FIGURE_POLICY}
    return Response(content, media_type="image/svg+xml", headers=headers)


async def everybody(request: Request) -> Response:
    """The names of the class."""
    workspace = studio_of(request).workspace
    students = await run_in_threadpool(class_of, workspace)
    names = [student.name or f"{student.id}" for student in students[:_NAMES]]
    return JSONResponse({"names": names, "roster": workspace.roster() is not None})


def _tried(studio: Studio, document: Document, data: dict[str, Any], language: str) -> dict[str, Any]:
    """The figure of a problem with values at which sliders stand, or why there is none."""
    from variantgen.families.asking import read_ask
    from variantgen.figure.build import statement_figure
    from variantgen.outputs.figures.svg import svg
    from variantgen.studio.composition import asked_names, model, names_of, narrowed, table_of
    from variantgen.studio.room import reason
    from variantgen.variants.variant import solve_variants
    from variantgen.wording.language import load_language

    number, words = number_of(data.get("problem"), "problem", 1, _MOST), page_words(language).of("compose")
    table = table_of(document, number)
    names = names_of(table)
    name, form = text_of(data, "family"), text_of(data, "form")
    name = name if name in names else names[0]
    family = narrowed(table, name, studio.workspace)
    form = form if form in family.forms else next(iter(family.forms))
    try:
        base = model(family, form)
    except InputError:  # too narrow: a figure of the whole family, with the values of the sliders
        base = model(narrowed(table, name, studio.workspace, whole=True), form)
    variant = replace(base, printed={**base.printed, **_values(data.get("at"), base.printed)})
    asked = read_ask(variant.form, asked_names(table, form))
    why = reason(family, variant, asked)
    if why == "impossible":
        return {"svg": "", "reason": words["impossible"], "values": {}}
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked, load_language(language))
    values = {parameter: f"{value.normalize():f}" for parameter, value in variant.printed.items()}
    return {"svg": svg(drawing), "reason": words[f"screen_{why}"] if why else "", "values": values}


def _values(given: Any, known: dict[str, Decimal]) -> dict[str, Decimal]:
    """The values at which sliders stand, by parameter. Raises InputError for what is no number."""
    if not isinstance(given, dict) or not given.keys() <= known.keys():
        raise InputError(Problem("expected values of parameters", key="at"))
    try:
        found = {name: Decimal(str(value)[:30]) for name, value in given.items()}
    except InvalidOperation:
        raise InputError(Problem("expected a number", key="at")) from None
    if not all(value.is_finite() and abs(value) < 10**9 for value in found.values()):
        raise InputError(Problem("expected a number", key="at"))
    return found


def _room(studio: Studio, document: Document, number: int, wanted: tuple[str, str], language: str) -> dict[str, Any]:
    """How many variants a problem has, which screens reject how many, and where the values of one form pass."""
    from variantgen.studio.composition import asked_names, names_of, narrowed, table_of
    from variantgen.studio.room import room

    words, table = page_words(language), table_of(document, number)
    found = []
    for name in names_of(table):
        family = narrowed(table, name, studio.workspace)
        found += [room(family, form, asked_names(table, form.name)) for form in family.forms.values()]
    draws, passed = sum(one.draws for one in found), sum(one.passed for one in found)
    rejected: dict[str, int] = {}
    for one in found:
        for kind, count in one.rejected.items():
            rejected[kind] = rejected.get(kind, 0) + count
    whole = narrowed(table, wanted[0] if wanted[0] in names_of(table) else names_of(table)[0], studio.workspace, True)
    form = whole.forms.get(wanted[1]) or next(iter(whole.forms.values()))
    everywhere = room(whole, form, asked_names(table, form.name))
    count = sum(one.variants for one in found)
    needed = students(studio) or 0
    own = words.of("compose")
    return {
        "count": _about(count, words),
        "few": count < max(needed, 1) * 2,
        "needed": own["needed"].format(students=words.counted(needed, "student")) if needed else "",
        "share": passed / draws if draws else 0,
        "screens": [
            {"word": own[f"screen_{kind}"], "share": count / draws}
            for kind, count in sorted(rejected.items(), key=lambda item: -item[1])
        ],
        "accepted": everywhere.accepted,
    }


def _about(count: int, words: Any) -> str:
    """About so many variants, in words."""
    own = words.of("compose")
    for size, key in ((10**9, "billions"), (10**6, "millions")):
        if count >= size:
            text = str(round(count / size)) if count >= 10 * size else f"{count / size:.1f}"
            return str(own[key]).format(number=text.replace(".", "," if words.language == "ru" else "."))
    rounded = count if count < 100 else round(count, 2 - len(str(count)))
    return f"≈ {words.counted(rounded, 'variant')}"


ROUTES = [
    Route("/{exam}/students", everybody),
    Route("/{exam}/room/{number}", room),
    Route("/{exam}/try", attempt, methods=["POST"]),
    Route("/{exam}/sheet/{student}", sheet),
    Route("/{exam}/page/{name}/{page}.svg", page),
]
