"""Choose: cards of all forms, filtered and searched; another variant, a star, into the exam or out of it."""

from __future__ import annotations

import json
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.families.method_names import METHODS
from variantgen.studio.documents.document import Document
from variantgen.studio.frame import command, language_of, part, render
from variantgen.studio.gallery.cards import KINDS, ONLY, TOPICS, cards
from variantgen.studio.gallery.figures import FIRST_SEED, MOST_SEEDS, card_figure, known_figure, specimen
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.security import FIGURE_POLICY
from variantgen.studio.studio import Studio
from variantgen.studio.summary import problems_of
from variantgen.studio.words import LANGUAGES, page_words
from variantgen.studio.workspace import write_whole

LEVELS = (1, 2, 3)
_STARS = "stars.json"


async def choose(request: Request) -> Response:
    """The page."""
    document = document_of(request)
    line = command("variantgen", "list", "--lang", language_of(request))
    filters: dict[str, Any] = {"topics": TOPICS, "kinds": KINDS, "levels": LEVELS, "methods": METHODS}
    return render(request, "choose", studio_of(request), document, line, chosen=chosen(document), **filters)


async def shown_cards(request: Request) -> Response:
    """All cards as markup, with how many each filter would leave."""
    studio, language = studio_of(request), language_of(request)
    found = await run_in_threadpool(cards, studio.workspace)
    starred = stars(studio)
    shown = [shown_card(card, language, starred) for card in found]
    counts = {name: sum(name in _about(card) for card in shown) for name in (*TOPICS, *KINDS, *METHODS)}
    counts |= {f"level{level}": sum(card["level"] == level for card in shown) for level in LEVELS}
    html = part(request, "cards", "choose", cards=shown, first=FIRST_SEED, levels=LEVELS)
    words = page_words(language)
    families = len({card["family"] for card in shown})
    line_of_counts = words.of("choose")["counts"].format(
        forms=words.counted(len(shown), "form"), families=words.counted(families, "of_families")
    )
    return JSONResponse({"html": html, "counts": counts, "counted": line_of_counts})


async def figure(request: Request) -> Response:
    """The figure of a variant of a form, as an image."""
    studio, path = studio_of(request), request.path_params
    seed = number_of(path["seed"], "seed", 0, MOST_SEEDS)
    language = language_of(request)
    wanted = (studio.workspace, path["family"], path["form"], seed, language)
    text = await run_in_threadpool(known_figure, *wanted) or await studio.draw(lambda: card_figure(*wanted))
    lasting = "private, max-age=31536000, immutable" if "v" in request.query_params else "no-store"
    headers = {"cache-control": lasting, "content-security-policy": FIGURE_POLICY}
    return Response(text, media_type="image/svg+xml", headers=headers)


async def in_exam(request: Request) -> Response:
    """What the exam has of each family, after another window has changed it."""
    return JSONResponse({"chosen": chosen(document_of(request))})


async def example(request: Request) -> Response:
    """An open card: statement, answers."""
    studio, path, language = studio_of(request), request.path_params, language_of(request)
    seed = number_of(request.query_params.get("seed", "11"), "seed", 0, MOST_SEEDS)
    shown = await studio.draw(lambda: specimen(studio.workspace, path["family"], path["form"], seed, language))
    return HTMLResponse(part(request, "example", "choose", **shown))


async def star(request: Request) -> Response:
    """Give a card a star, or take it."""
    studio, data = studio_of(request), await read_json(request)
    card, on = text_of(data, "card"), data.get("on") is True
    known = {_name(card) for card in await run_in_threadpool(cards, studio.workspace)}
    if card not in known:
        raise InputError(Problem("unknown card", value=card))
    found = stars(studio) - {card} | ({card} if on else set())
    write_whole(studio.workspace.state(_STARS), json.dumps(sorted(found)))
    return JSONResponse({"on": on})


def stars(studio: Studio) -> set[str]:
    """The cards with a star."""
    try:
        found = json.loads(studio.workspace.state(_STARS).read_text("utf-8"))
    except (OSError, ValueError):
        return set()
    return {name for name in found if isinstance(name, str)} if isinstance(found, list) else set()


def chosen(document: Document) -> list[dict[str, Any]]:
    """The families and forms of each problem of an exam."""
    found = []
    for item in problems_of(document):
        families = item.get("families") or [item.get("family")]
        forms = item.get("form") or []
        found.append({"families": families, "forms": [forms] if isinstance(forms, str) else forms})
    return found


def _name(card: dict[str, Any]) -> str:
    return f"{card['family']}/{card['form'] or ONLY}"


def _about(card: dict[str, Any]) -> list[str]:
    """What a card is found by: its topics, the kinds of what it asks, the methods that lead to it."""
    return [*card["topics"], *card["kinds"], *card["methods"]]


def shown_card(card: dict[str, Any], language: str, starred: set[str]) -> dict[str, Any]:
    """A card in a language, with the words that it is found by in all of them."""
    several = card["forms"] > 1
    texts = [card["family"].replace("_", " "), card["form"].replace("_", " ")]
    for name in LANGUAGES:
        words = page_words(name).of("choose")
        texts += [card["titles"][name], *([card["form_titles"][name]] if several else [])]
        texts += [words[part] for part in (*card["topics"], *card["kinds"])]
        texts += [words.get(f"also_{part}", "") for part in (*card["topics"], *card["kinds"])]
    return {
        **card,
        "name": _name(card),
        "address": f"/figure/{card['family']}/{card['form'] or ONLY}",
        "title": card["titles"][language],
        "form_title": card["form_titles"][language] if several else "",
        "symbols": card["ask"].get(language, []),
        "star": _name(card) in starred,
        "text": " ".join(texts).lower().replace("ё", "е"),
    }


ROUTES = [
    Route("/{exam}/choose", choose),
    Route("/{exam}/cards", shown_cards),
    Route("/{exam}/chosen", in_exam),
    Route("/example/{family}/{form}", example),
    Route("/figure/{family}/{form}/{seed}.svg", figure),
    Route("/stars", star, methods=["POST"]),
]
