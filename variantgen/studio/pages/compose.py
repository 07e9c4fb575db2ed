"""Compose: the problems of an exam, what each may draw and asks, the sheet of any student, the text of the file."""

from __future__ import annotations

import json
from decimal import Decimal
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError
from variantgen.limits import TOML_BYTES
from variantgen.studio.documents.document import Document
from variantgen.studio.documents.edits import plain
from variantgen.studio.frame import build_command, language_of, part, render
from variantgen.studio.gallery.cards import cards
from variantgen.studio.messages import explained
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.studio import Studio
from variantgen.studio.summary import summary
from variantgen.studio.words import page_words
from variantgen.studio.workspace import write_whole

DEPTHS = ("full", "short", "answers", "none")
_MOST = 100  # problems of an exam
_SUGGESTED = (("slider_crank", "central"), ("rolling_wheel", ""), ("four_bar", "crank"))  # to begin with


async def compose(request: Request) -> Response:
    """The page."""
    studio, document = studio_of(request), document_of(request)
    line = build_command(studio, document)
    whom = summary(page_words(language_of(request)), studio, document)["roster"] if studio.workspace.roster() else ""
    shown: dict[str, Any] = {"settings": _settings(document), "depths": DEPTHS, "whom": whom}
    shown["suggested"] = await run_in_threadpool(_suggested, studio, language_of(request))
    return render(request, "compose", studio, document, line, **shown)


def _suggested(studio: Studio, language: str) -> list[dict[str, str]]:
    """Problems that an exam may begin with."""
    known = {(card["family"], card["form"]): card for card in cards(studio.workspace)}
    found = [known[name] for name in _SUGGESTED if name in known]
    return [{"family": one["family"], "form": one["form"], "title": one["titles"][language]} for one in found]


async def outline(request: Request) -> Response:
    """The list of the problems and the text of the file."""
    from variantgen.studio.composition import listed

    studio, document, language = studio_of(request), document_of(request), language_of(request)
    rows = await run_in_threadpool(listed, document, studio.workspace, language)
    words = page_words(language)
    answers = sum(row["answers"] for row in rows)
    line = f"{words.counted(len(rows), 'problem')} · {words.counted(answers, 'answer')}"
    points = summary(words, studio, document)["compose"]
    html = part(request, "outline", "compose", problems=rows)
    return JSONResponse({"html": html, "count": len(rows), "line": f"{line} · {points}", **_source(document, language)})


async def problem(request: Request) -> Response:
    """All that can be chosen of one problem."""
    from variantgen.studio.composition import problem as described

    number = number_of(request.path_params["number"], "problem", 1, _MOST)
    workspace, query, language = studio_of(request).workspace, request.query_params, language_of(request)
    name, form = query.get("family", ""), query.get("form", "")
    found = await run_in_threadpool(described, document_of(request), workspace, number, name, form, language)
    return HTMLResponse(part(request, "problem", "compose", **found))


async def check(request: Request) -> Response:
    """The mistakes of a text that is being written, which is kept as a draft."""
    workspace, document, data = studio_of(request).workspace, document_of(request), await read_json(request)
    text, version = text_of(data, "text", TOML_BYTES), text_of(data, "version")
    found = await run_in_threadpool(document.check, text)
    kept = workspace.state("drafts", f"{document.key}.json")
    if text != document.state().text:
        write_whole(kept, json.dumps({"text": text, "version": version}))
    else:
        kept.unlink(missing_ok=True)
    return JSONResponse({"mistakes": [explained(mistake, language_of(request)) for mistake in found]})


async def draft(request: Request) -> Response:
    """The draft that was left, if it differs from the file."""
    studio, document = studio_of(request), document_of(request)
    try:
        found = json.loads(studio.workspace.state("drafts", f"{document.key}.json").read_text("utf-8"))
        text, version = text_of(found, "text", TOML_BYTES), text_of(found, "version")
    except (OSError, ValueError, AttributeError, RecursionError, InputError):
        text = version = ""
    return JSONResponse({"text": "" if text == document.state().text else text, "version": version})


async def table(request: Request) -> Response:
    """The table of a problem, as the file has it."""
    from variantgen.studio.composition import table_of

    number = number_of(request.path_params["number"], "problem", 1, _MOST)
    return JSONResponse({"table": plain(table_of(document_of(request), number))})


async def families(request: Request) -> Response:
    """The families that a pool can take."""
    found = await run_in_threadpool(cards, studio_of(request).workspace)
    titles = {card["family"]: card["titles"][language_of(request)] for card in found if not card["error"]}
    return JSONResponse({"families": [{"name": name, "title": title} for name, title in titles.items()]})


def _source(document: Document, language: str) -> dict[str, Any]:
    """The text of the file, its mistakes, and the line at which each problem begins."""
    from variantgen.studio.documents.toml_lines import places

    state = document.state()
    heads = [] if state.broken else [h for h in places(state.text).headers if h.path[:1] == ("problem",)]
    lines = [state.text.count("\n", 0, head.start) + 1 for head in heads if len(head.path) == 2]
    return {
        "text": state.text,
        "version": state.version,
        "lines": lines,
        "mistakes": [explained(mistake, language) for mistake in document.mistakes()],
    }


def _settings(document: Document) -> dict[str, Any]:
    """What the exam says of itself, as fields show it."""
    from variantgen.studio.composition import percent

    data = document.state().data
    tolerance = data.get("tolerance", Decimal("0.01"))
    inside = tolerance if isinstance(tolerance, dict) else {"floor": tolerance}
    tables = (data[name] if isinstance(data.get(name), dict) else {} for name in ("page", "solutions", "answers"))
    page, solutions, answers = tables
    found = {name: data.get(name, "") for name in ("title", "course", "date", "duration", "instructions", "language")}
    found |= {"seed": data.get("seed", 0), "depth": solutions.get("depth", "full")}
    found |= {"duplex": page.get("duplex", True), "qr": page.get("qr", True), "scan": answers.get("scan", False)}
    found |= {"floor": percent(inside.get("floor")), "ceiling": percent(inside.get("ceiling"))}
    found["table"] = isinstance(tolerance, dict)
    return {name: "" if isinstance(value, dict) else value for name, value in found.items()}


ROUTES = [
    Route("/families", families),
    Route("/{exam}/table/{number}", table),
    Route("/{exam}/compose", compose),
    Route("/{exam}/outline", outline),
    Route("/{exam}/problem/{number}", problem),
    Route("/{exam}/check", check, methods=["POST"]),
    Route("/{exam}/draft", draft),
]
