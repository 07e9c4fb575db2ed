"""Play: a mechanism in motion, of the catalogue or of a sheet of the exam, to be shown in a lecture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.building.preview import class_of
from variantgen.studio.documents.document import Document
from variantgen.studio.frame import command, language_of, part, render
from variantgen.studio.gallery.cards import ONLY, cards, family_files, own_folders
from variantgen.studio.gallery.figures import FIRST_SEED, MOST_SEEDS
from variantgen.studio.pages.choose import shown_card
from variantgen.studio.requests import document_of, number_of, studio_of
from variantgen.studio.studio import Studio
from variantgen.studio.summary import problems_of
from variantgen.studio.words import page_words
from variantgen.studio.workspace import ROSTER

_FIRST = ("quick_return_shaper", "four_bar")  # what is shown where nothing is chosen
_MOST = 100  # problems of an exam


async def play(request: Request) -> Response:
    """The page, without an exam."""
    return _page(request, None)


async def play_exam(request: Request) -> Response:
    """The page beside an exam: its first problem, where nothing is chosen."""
    return _page(request, document_of(request))


def _page(request: Request, document: Document | None) -> Response:
    return render(request, "play", studio_of(request), document, motion=_address(request, document))


def _address(request: Request, document: Document | None) -> str:
    """Where the motion is that the page begins with. Raises InputError."""
    query = request.query_params
    if document is not None and "family" not in query and problems_of(document):
        problem = number_of(query.get("problem", "1"), "problem", 1, _MOST)
        return f"/{document.key}/motion/{problem}/{number_of(query.get('student', '1'), 'student', 1, 1_000_000)}"
    files = family_files(studio_of(request).workspace)
    family = query.get("family", next((name for name in _FIRST if name in files), next(iter(files))))
    if family not in files:
        raise InputError(Problem("unknown family", key="family", value=family))
    form = query.get("form") or ONLY
    if not form.replace("_", "").isalnum() and form != ONLY:
        raise InputError(Problem("unknown form", key="form", value=form))
    return f"/motion/{family}/{form}/{number_of(query.get('seed', str(FIRST_SEED)), 'seed', 0, MOST_SEEDS)}"


async def mechanisms(request: Request) -> Response:
    """What can be played: all forms, before them the problems of the exam."""
    studio, language = studio_of(request), language_of(request)
    found = await run_in_threadpool(cards, studio.workspace)
    rows: list[dict[str, Any]] = []
    if "exam" in request.path_params:
        from variantgen.studio.composition import listed

        rows = await run_in_threadpool(listed, document_of(request), studio.workspace, language)
    shown = [shown_card(card, language, set()) for card in found if not card["error"]]
    key = request.path_params.get("exam", "")
    context = {"address": f"/{key}/play" if key else "/play", "seed": FIRST_SEED}
    return HTMLResponse(part(request, "mechanisms", "play", cards=shown, problems=rows, **context))


async def motion(request: Request) -> Response:
    """The motion of a variant of a form."""
    studio, path, language = studio_of(request), request.path_params, language_of(request)
    seed = number_of(path["seed"], "seed", 0, MOST_SEEDS)
    found = await studio.draw(lambda: _of_form(studio, path["family"], path["form"], seed, language))
    return JSONResponse(found)


async def motion_of_problem(request: Request) -> Response:
    """The motion of a problem of a student's sheet."""
    studio, document, language = studio_of(request), document_of(request), language_of(request)
    problem = number_of(request.path_params["problem"], "problem", 1, _MOST)
    place = number_of(request.path_params["student"], "student", 1, 1_000_000)
    return JSONResponse(await studio.typeset(lambda: _of_problem(studio, document, problem, place, language)))


def _of_form(studio: Studio, family: str, form: str, seed: int, language: str) -> dict[str, Any]:
    from variantgen.single import asked_quantities, one_variant
    from variantgen.studio.motion import motion_of

    if family not in family_files(studio.workspace):
        raise InputError(Problem("unknown family", key="family", value=family))
    folders, name = own_folders(studio.workspace, family), "" if form == ONLY else form
    variant = one_variant(family, seed=str(seed), form=name, folders=folders)
    words = ["variantgen", "show", family, *(["--form", name] if name else []), "--seed", str(seed)]
    words += [*(["--families", str(folders[0])] if folders else []), "--lang", language, "--motion", "motion.pdf"]
    return {
        **motion_of(variant, asked_quantities(variant), language),
        "label": page_words(language).of("play")["variant"].format(number=seed),
        "address": f"?family={family}&form={name}&seed={seed}",
        "command": command(*words),
        **_beside(f"/motion/{family}/{form}", seed, 0, MOST_SEEDS),
    }


def _of_problem(studio: Studio, document: Document, problem: int, place: int, language: str) -> dict[str, Any]:
    from variantgen.studio.motion import motion_of

    exam, everybody = document.exam(), class_of(studio.workspace)
    if place > len(everybody):
        raise InputError(Problem("there is no such student", value=str(place)))
    items = studio.previews.sheet(exam, everybody, place - 1).items
    if problem > len(items):
        raise InputError(Problem("there is no such problem", key="problem", value=str(problem)))
    item, student = items[problem - 1], everybody[place - 1]
    roster = ["--roster", str(studio.workspace.folder / ROSTER)] if studio.workspace.roster() else []
    file = str(studio.workspace.folder / document.path.name)
    which = ["--student", str(student.id), "--problem", str(problem)]
    words = page_words(language).of("play")
    return {
        **motion_of(item.variant, item.asked, language),
        "label": words["of_student"].format(
            number=problem, student=student.name or words["variant"].format(number=student.id)
        ),
        "address": f"?problem={problem}&student={place}",
        "command": command("variantgen", "show", file, *roster, *which, "--motion", "motion.pdf"),
        **_beside(f"/{document.key}/motion/{problem}", place, 1, len(everybody)),
    }


def _beside(address: str, number: int, low: int, high: int) -> Mapping[str, str]:
    """Where the variants before and after one are; '' where there is none."""
    return {
        "before": f"{address}/{number - 1}" if number > low else "",
        "after": f"{address}/{number + 1}" if number < high else "",
    }


ROUTES = [
    Route("/play", play),
    Route("/play/mechanisms", mechanisms),
    Route("/motion/{family}/{form}/{seed}", motion),
    Route("/{exam}/play", play_exam),
    Route("/{exam}/play/mechanisms", mechanisms),
    Route("/{exam}/motion/{problem}/{student}", motion_of_problem),
]
