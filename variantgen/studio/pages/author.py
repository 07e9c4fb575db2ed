"""Author: the families of the folder, written beside what they look like; a check of them; new ones."""

from __future__ import annotations

import json
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.limits import TOML_BYTES
from variantgen.studio.authoring import (
    FILES,
    begin,
    drafts,
    folder_of,
    look,
    own_families,
    save,
    solution_page,
    texts,
    versions,
)
from variantgen.studio.documents.document import Document
from variantgen.studio.frame import command, language_of, render
from variantgen.studio.gallery.cards import ONLY, Card, cards
from variantgen.studio.gallery.figures import FIRST_SEED, MOST_SEEDS
from variantgen.studio.pages.archive import run_command
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.security import FIGURE_POLICY
from variantgen.studio.words import PageWords, page_words

# Families of the catalogue to begin with: a linkage, a slot, rolling, gears, a rope; the first form is their figure.
TEMPLATES = ("slider_crank", "slotted_rocker", "wheel_with_rod", "planetary_pair", "spool")
_SEEDS = 200  # variants of a check


async def author(request: Request) -> Response:
    """The page, without an exam."""
    return await _page(request, None)


async def author_exam(request: Request) -> Response:
    """The page beside an exam that can use the family."""
    return await _page(request, document_of(request))


async def _page(request: Request, document: Document | None) -> Response:
    studio, language = studio_of(request), language_of(request)
    own, name = own_families(studio.workspace), request.query_params.get("family", "")
    if name:
        folder_of(studio.workspace, name)
    line = (
        command("variantgen", "check", name, "--families", str(studio.workspace.folder), "--seeds", str(_SEEDS))
        if name
        else command("variantgen", "new", "family", "my_family", "--out", str(studio.workspace.folder))
    )
    context: dict[str, Any] = {"family": name, "own": list(own), "files": FILES}
    if not name:
        first: dict[str, Card] = {}
        for card in await run_in_threadpool(cards, studio.workspace):
            if not card["own"]:
                first.setdefault(card["family"], card)
        titles = {family: card["titles"][language] for family, card in first.items()}
        context["templates"] = [_template(first[family], language) for family in TEMPLATES if family in first]
        context["catalogue"] = sorted(titles.items(), key=lambda item: item[1])
    return render(request, "author", studio, document, line, **context)


def _template(card: Card, language: str) -> dict[str, str]:
    """A family to begin with: name, title, figure."""
    figure = f"/figure/{card['family']}/{card['form'] or ONLY}/{FIRST_SEED}.svg?lang={language}&v={card['version']}"
    return {"name": card["family"], "title": card["titles"][language], "figure": figure}


async def create(request: Request) -> Response:
    """A new family in the folder."""
    workspace, data = studio_of(request).workspace, await read_json(request)
    name, start = text_of(data, "name", 60), text_of(data, "start", 60)
    await run_in_threadpool(begin, workspace, name, start)
    return JSONResponse({"address": f"?family={name}"})


async def state(request: Request) -> Response:
    """The texts of a family with their versions, and the drafts that wait for a choice."""
    workspace, family = studio_of(request).workspace, request.path_params["family"]
    found = await run_in_threadpool(texts, folder_of(workspace, family))
    waiting = await run_in_threadpool(drafts, workspace, family, found)
    return JSONResponse({"texts": found, "versions": versions(found), "drafts": waiting})


async def write(request: Request) -> Response:
    """Write one file of a family, if nobody else has changed it since."""
    workspace, family = studio_of(request).workspace, request.path_params["family"]
    folder_of(workspace, family)
    data = await read_json(request)
    text = text_of(data, "text", TOML_BYTES)
    if len(text.encode()) > TOML_BYTES:
        raise InputError(Problem("is too long", key="text"))
    file, version, settles = text_of(data, "file"), text_of(data, "version"), data.get("settles") is True
    version = await run_in_threadpool(save, workspace, family, file, text, version, settles)
    return JSONResponse({"version": version})


async def seen(request: Request) -> Response:
    """A variant of a family as its files say it now, or what is wrong with them."""
    studio, family, query = studio_of(request), request.path_params["family"], request.query_params
    seed, language = number_of(query.get("seed", "11"), "seed", 0, MOST_SEEDS), language_of(request)
    form = query.get("form", "")
    return JSONResponse(await studio.draw(lambda: look(studio.workspace, family, form, seed, language)))


async def solution(request: Request) -> Response:
    """The worked solution of a variant, as an image."""
    studio, path, language = studio_of(request), request.path_params, language_of(request)
    seed = number_of(path["seed"], "seed", 0, MOST_SEEDS)
    form = "" if path["form"] == ONLY else path["form"]
    page = await studio.typeset(lambda: solution_page(studio.workspace, path["family"], form, seed, language))
    return Response(page, media_type="image/svg+xml", headers={"content-security-policy": FIGURE_POLICY})


async def check(request: Request) -> Response:
    """What the command check finds in a family."""
    studio, family, language = studio_of(request), request.path_params["family"], language_of(request)
    workspace = studio.workspace
    folder_of(workspace, family)
    await read_json(request)
    code, said, wrong = await run_command(
        "check", family, "--families", str(workspace.folder), "--seeds", str(_SEEDS), "--json"
    )
    try:
        (report,) = json.loads(said)
    except ValueError:
        found = await studio.draw(lambda: look(workspace, family, "", FIRST_SEED, language))
        mistaken = [
            ": ".join(filter(None, (m["file"], m["key"], m["message"], m["remedy"]))) for m in found["mistakes"]
        ]
        rows = mistaken or [(wrong or said).decode("utf-8", "replace").strip()[-2000:]]
        return JSONResponse({"ok": False, "rows": [{"ok": False, "text": text} for text in rows]})
    return JSONResponse({"ok": code == 0, "rows": _rows(report, page_words(language))})


def _rows(report: dict[str, Any], words: PageWords) -> list[dict[str, Any]]:
    """A report in lines: what is well, then what is wrong or should be looked at."""
    own, found = words.of("author"), []
    for form in report["forms"]:
        head = f"{form['name']}: " if form["name"] else ""
        found.append(head + own["drawn"].format(drawn=form["variants"], distinct=form["distinct"]))
        found.append(head + own["room"].format(number=words.number(_round(form["valid"]))))
        share = form["acceptance"] * 100
        found.append(head + own["pass"].format(share=f"{share:.0f}" if share >= 1 else "< 1"))
        most = [name for name, count in sorted(form["rejected"].items(), key=lambda item: -item[1])[:1] if count]
        found += [head + own["most"].format(what=most[0])] if most else []
    if report["cases"]:
        found.append(own["cases"].format(names=", ".join(report["cases"])))
    rows = [{"ok": True, "text": text} for text in found]
    rows += [{"ok": False, "text": text} for text in report["failures"]]
    return rows + [{"ok": None, "text": text} for text in report["remarks"]]


def _round(number: int) -> int:
    """A number of which two digits are known."""
    return number if number < 100 else round(number, 2 - len(str(number)))


ROUTES = [
    Route("/author", author),
    Route("/author/new", create, methods=["POST"]),
    Route("/author/{family}/state", state),
    Route("/author/{family}/save", write, methods=["POST"]),
    Route("/author/{family}/look", seen),
    Route("/author/{family}/check", check, methods=["POST"]),
    Route("/author/{family}/solution/{form}/{seed}.svg", solution),
    Route("/{exam}/author", author_exam),
]
