"""What stands around every page: the steps with their numbers, undo, the language, the command that does the same."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from functools import cache
from typing import Any

import jinja2
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from variantgen.studio.documents.document import Document
from variantgen.studio.documents.journal import FileChange
from variantgen.studio.messages import in_language
from variantgen.studio.studio import Studio
from variantgen.studio.summary import summary
from variantgen.studio.words import ASSETS, LANGUAGES, PageWords, page_words
from variantgen.studio.workspace import BUILDS, ROSTER, USUAL_CLASS

STEPS = ("choose", "compose", "roster", "build", "mark")
TOOLS = ("author", "play")
_COOKIE = "variantgen-language"


class _Environment(jinja2.Environment):
    """Templates in which ``words.copy`` is the word of that key, and not a method of dictionaries."""

    def getattr(self, obj: Any, attribute: str) -> Any:
        return obj[attribute] if isinstance(obj, dict) and attribute in obj else super().getattr(obj, attribute)


@cache
def _environment() -> jinja2.Environment:
    found = _Environment(
        loader=jinja2.FileSystemLoader(ASSETS / "pages"),
        undefined=jinja2.StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters["json"] = lambda value: json.dumps(value, ensure_ascii=False)
    return found


def language_of(request: Request) -> str:
    """The language of the pages: as the address says, else as was chosen, else what the browser likes best."""
    for wanted in (request.query_params.get("lang", ""), request.cookies.get(_COOKIE, "")):
        if wanted in LANGUAGES:
            return wanted
    liked = [part.split(";")[0].strip()[:2] for part in request.headers.get("accept-language", "").split(",")]
    return next((name for name in liked if name in LANGUAGES), "en")


def render(
    request: Request,
    page: str,
    studio: Studio,
    document: Document | None = None,
    command: str = "",
    status: int = 200,
    **context: Any,
) -> Response:
    """A page inside its frame; ``context`` is what its template needs besides the words.

    ``command`` is the command that does the same.
    """
    language = language_of(request)
    words = page_words(language)
    inside = {
        **context,
        "page": page,
        "lang": language,
        "other": next(name for name in LANGUAGES if name != language),
        "words": words.of(page),
        "frame": words.of("frame"),
        "counted": words.counted,
        "command": command,
        "exam": document and document.key,
        "steps": _steps(words, studio, document),
        "tools": _tools(words, document),
        **_state(words, studio, document),
    }
    answer = HTMLResponse(_environment().get_template(f"{page}.html.j2").render(inside), status)
    if request.query_params.get("lang") in LANGUAGES:
        answer.set_cookie(_COOKIE, language, max_age=400 * 86400, httponly=True, samesite="strict")
    return answer


def part(request: Request, template: str, page: str, **context: Any) -> str:
    """A piece of a page, for scripts that put it in."""
    words = page_words(language_of(request))
    inside = {**context, "lang": words.language, "words": words.of(page), "frame": words.of("frame")}
    return _environment().get_template(f"{template}.html.j2").render({**inside, "counted": words.counted})


def wants_page(request: Request) -> bool:
    """Whether somebody looks at the answer, and not a script."""
    return request.method == "GET" and "text/html" in request.headers.get("accept", "")


def error_page(request: Request, status: int, message: str) -> Response:
    """What is said of an address that leads nowhere, or of a file that cannot be read."""
    words = page_words(language_of(request))
    inside = {"lang": words.language, "frame": words.of("frame"), "message": message}
    return HTMLResponse(_environment().get_template("error.html.j2").render(inside), status)


def command(*words: str) -> str:
    """A command line, as a shell reads it."""
    return shlex.join(words)


def build_command(studio: Studio, document: Document) -> str:
    """The command that builds an exam as the studio does, for a terminal in the folder where the studio was started."""
    folder = studio.workspace.folder
    roster = (folder / ROSTER).exists()
    whom = ("--roster", str(folder / ROSTER)) if roster else ("--variants", str(USUAL_CLASS))
    out = folder / BUILDS / studio.builds.next_name(document.key)
    return command("variantgen", "build", str(folder / document.path.name), *whom, "--out", str(out))


def step_words(words: PageWords, step: FileChange | None) -> str:
    """What undo or redo takes back or does again; '' if there is nothing."""
    if step is None:
        return ""
    return words.of("steps").get(step.words, step.words).format_map(_Named(step.about))


class _Named(dict[str, str]):
    def __missing__(self, key: str) -> str:
        return ""


def _state(words: PageWords, studio: Studio, document: Document | None) -> Mapping[str, Any]:
    """The exam as the head of the page shows it."""
    exams = [{"key": key, "name": path.name} for key, path in studio.workspace.exams().items()]
    if document is None:
        empty = dict.fromkeys(("title", "file", "version", "position", "undo", "redo", "broken"), "")
        return {**empty, "exams": exams}
    state = document.state()
    title = state.data.get("title", "")
    return {
        "title": title if isinstance(title, str) and title else document.path.stem,
        "file": document.path.name,
        "version": state.version,
        "position": document.journal.position,
        "undo": step_words(words, document.journal.undoable),
        "redo": step_words(words, document.journal.redoable),
        "exams": exams,
        "broken": in_language(state.broken, words.language),
    }


def _steps(words: PageWords, studio: Studio, document: Document | None) -> list[dict[str, str]]:
    """The steps with the number under each."""
    if document is None:
        return []
    under = summary(words, studio, document)
    return [
        {
            "name": name,
            "address": f"/{document.key}/{name}",
            "word": words.of("frame")[name],
            "under": under.get(name, ""),
        }
        for name in STEPS
        if _is_there(name)
    ]


def _tools(words: PageWords, document: Document | None) -> list[dict[str, str]]:
    """The pages that need no exam; beside one they keep it."""
    found, beside = [name for name in TOOLS if _is_there(name)], f"/{document.key}" if document else ""
    return [{"name": name, "address": f"{beside}/{name}", "word": words.of("frame")[name]} for name in found]


@cache
def _is_there(page: str) -> bool:
    """Whether the studio has a page."""
    return (ASSETS / "pages" / f"{page}.html.j2").is_file()
