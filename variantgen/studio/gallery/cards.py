"""The cards of all forms of all families: what they are called, what they are about, what they ask."""

from __future__ import annotations

import hashlib
import json
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.families.method_names import METHODS
from variantgen.families.reading.files import FAMILY
from variantgen.limits import TOML_BYTES
from variantgen.resources import catalog_dir
from variantgen.studio.gallery.shipped import shipped_cards
from variantgen.studio.words import ASSETS, LANGUAGES
from variantgen.studio.workspace import Workspace, is_own, write_whole
from variantgen.version import VERSION

TOPICS = ("linkages", "plates", "rolling", "gears", "ropes", "slots", "compound")
KINDS = ("velocities", "accelerations", "coriolis")
ONLY = "-"  # the form of a family with one form, in an address
# What a joint or a driver makes a form be about.
_ABOUT = {
    "Rope": "ropes",
    "Gears": "gears",
    "Rolling": "rolling",
    "RollingOnCircle": "rolling",
    "Slot": "slots",
    "ArcSlot": "slots",
    "RelativeTravel": "compound",
    "Circling": "compound",
}

_SYMBOL = re.compile(r"(?:[^<>]|</?(?:i|sub|sup)>)*")
_FORMAT = 3  # of the cards in the cache

Card = dict[str, Any]


def family_files(workspace: Workspace) -> dict[str, Path]:
    """The files of all families by name: those of the folder, then those of the catalogue."""
    found = {path.parent.name: path for path in catalog_dir().glob(f"*/{FAMILY}")}
    for path in workspace.folder.glob(f"*/{FAMILY}"):
        if is_own(path, workspace.folder) and not path.parent.name.startswith("."):
            found[path.parent.name] = path
    return dict(sorted(found.items()))


def family_file(workspace: Workspace, family: str) -> Path:
    """The file of one family, as :func:`family_files` has it. Raises InputError for what there is not."""
    if Path(family).name == family and not family.startswith(".") and family.isprintable():
        own, known = (folder / family / FAMILY for folder in (workspace.folder, catalog_dir()))
        if is_own(own, workspace.folder):
            return own
        if known.is_file():
            return known
    raise InputError(Problem("unknown family", key="family", value=family))


def own_folders(workspace: Workspace, family: str) -> tuple[Path, ...]:
    """Where a family is looked for besides the catalogue: in the folder, unless it is only linked there."""
    try:
        own = catalog_dir() not in family_file(workspace, family).parents
    except InputError:
        own = False
    return (workspace.folder.resolve(),) if own else ()


def family_version(path: Path) -> str:
    """A hash of a family's file and of the program: figures of the same hash are the same."""
    digest = hashlib.sha256(f"{VERSION}\n".encode())
    with path.open("rb") as file:
        digest.update(file.read(TOML_BYTES))
    return digest.hexdigest()[:12]


def cards(workspace: Workspace) -> list[Card]:
    """All cards, from the cache where nothing has changed."""
    files = family_files(workspace)
    marks = [f"{name} {family_version(path)}" for name, path in files.items()]
    marks += [str(_FORMAT), hashlib.sha256((ASSETS / "catalogue.toml").read_bytes()).hexdigest()]
    name = hashlib.sha256("\n".join(marks).encode()).hexdigest()[:16]
    kept = workspace.state("cache", f"cards-{name}.json")
    try:
        found: list[Card] = json.loads(kept.read_text("utf-8"))
        if not found or not isinstance(found, list) or not all(map(_is_card, found)):
            raise ValueError(kept)
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        found = [card for family, path in files.items() for card in _known_cards(family, path, workspace)]
        for old in kept.parent.glob("cards-*.json"):
            old.unlink(missing_ok=True)
        write_whole(kept, json.dumps(found, ensure_ascii=False))
    return found


def _is_card(card: Card) -> bool:
    """Whether something read has the types of a card, and no markup but that of symbols."""
    texts = [card[name] for name in ("family", "version", "form", "error")]
    texts += [table[language] for table in (card["titles"], card["form_titles"]) for language in LANGUAGES]
    texts += [*card["topics"], *card["kinds"], *card["methods"]]
    texts += [symbol for part in card["ask"].values() for symbol in part]
    markup = all(_SYMBOL.fullmatch(symbol) for part in card["ask"].values() for symbol in part)
    numbers = isinstance(card["forms"], int) and isinstance(card["level"], int)
    known = {*card["topics"], *card["kinds"], *card["methods"]} <= {*TOPICS, *KINDS, *METHODS}
    return (
        all(isinstance(text, str) for text in texts) and numbers and known and markup and isinstance(card["own"], bool)
    )


@cache
def _described() -> Mapping[str, Mapping[str, Mapping[str, Any]]]:
    """Titles and levels of forms, by family and form."""
    return tomllib.loads((ASSETS / "catalogue.toml").read_text("utf-8"))


def _known_cards(name: str, path: Path, workspace: Workspace) -> list[Card]:
    """The cards of a family, made in advance where they are."""
    shipped = shipped_cards(name, path) if catalog_dir() in path.parents else None
    if shipped is None:
        return cards_of(name, path, workspace)
    return [{**card, "version": family_version(path)} for card in shipped]


def cards_of(name: str, path: Path, workspace: Workspace) -> list[Card]:
    """The cards of a family; of one that cannot be read a card that says why."""
    from variantgen.families.reading.load import load_family

    common = {"family": name, "version": family_version(path), "own": catalog_dir() not in path.parents}
    try:
        family = load_family(name, own_folders(workspace, name))
    except InputError as error:
        text = dict.fromkeys(LANGUAGES, name)
        nothing = {"forms": 1, "titles": text, "form_titles": text, "topics": [], "kinds": [], "level": 0, "ask": {}}
        nothing |= {"methods": []}
        return [{**common, **nothing, "form": "", "error": str(error.problems[0])}]
    described = {} if common["own"] else _described().get(name, {})
    found = []
    for form in family.forms.values():
        own = described.get(form.name, {})
        found.append(
            {
                **common,
                "form": form.name,
                "forms": len(family.forms),
                "titles": {language: family.title(language) for language in LANGUAGES},
                "form_titles": {language: own.get(language, form.name.replace("_", " ")) for language in LANGUAGES},
                "level": own.get("level", 0),
                "topics": _topics(form),
                "kinds": _kinds(form),
                "methods": _methods(name, form.name, workspace),
                "ask": {language: _asked(form, language) for language in LANGUAGES},
                "error": "",
            }
        )
    return found


def form_titles(family: str, language: str) -> dict[str, str]:
    """The titles of the forms of a family of the catalogue, as far as they have any."""
    return {name: own[language] for name, own in _described().get(family, {}).items() if own.get(language)}


def _topics(form: Any) -> list[str]:
    """What a form is about, by its joints and drivers."""
    parts = [template.component.__name__ for template in (*form.joints, *form.drivers)]
    found = {_ABOUT[part] for part in parts if part in _ABOUT}
    if any(name.startswith(("v_rel", "a_rel", "a_cor")) for name in form.ask):
        found.add("compound")
    if not found:
        turning = "Pivot" in parts and "VectorMotion" not in parts
        found.add("linkages" if turning else "plates")
    if form.figure.plates:
        found.add("plates")
    return [topic for topic in TOPICS if topic in found]


def _kinds(form: Any) -> list[str]:
    """Which kinds of quantities a form asks by itself."""
    asked = [name.partition(".")[0] for name in form.ask]
    found = []
    if any(name.startswith(("v_", "omega_", "P_")) for name in asked):
        found.append("velocities")
    if any(name.startswith(("a_", "epsilon_", "Q_")) for name in asked):
        found.append("accelerations")
    if any(name.startswith("a_cor") for name in asked):
        found.append("coriolis")
    return found


def _methods(family: str, form: str, workspace: Workspace) -> list[str]:
    """The methods by which what a form asks can be found, from its first variant; they are the same for all."""
    from variantgen.methods.choice import applicable
    from variantgen.methods.linkage.problem import task_of
    from variantgen.single import asked_quantities, one_variant
    from variantgen.variants.variant import solve_variants

    try:
        variant = one_variant(family, form=form, folders=own_folders(workspace, family))
    except VariantgenError:
        return []  # it has no variants yet
    found = applicable(task_of(variant, solve_variants([variant], 2), 0, asked_quantities(variant)))
    return [name for name in METHODS if name in found]


def _asked(form: Any, language: str) -> list[str]:
    """The symbols of what a form asks, as markup."""
    from variantgen.families.asking import read_ask
    from variantgen.wording.html import to_html
    from variantgen.wording.language import load_language

    spoken = load_language(language)
    return [to_html(spoken.quantity(quantity, form.symbols)) for quantity in read_ask(form, None)]
