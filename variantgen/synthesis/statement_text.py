"""The statement of a mechanism that is laid out, as the template of a family, from sentences of a language."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from typing import Any

from variantgen.resources import languages, templates_dir
from variantgen.synthesis.draft import Draft, Facts
from variantgen.synthesis.family_text import changes_speed

_ONE_BY_ONE = ("angle", "incline", "square", "halfway")


def composed_languages() -> list[str]:
    """The languages in which statements can be composed: those that have the sentences."""
    return [name for name in languages() if (templates_dir() / "synthesis" / f"{name}.toml").is_file()]


@cache
def sentences(language: str) -> Mapping[str, Any]:
    """The sentences and phrases of a language (``templates/synthesis/<language>.toml``)."""
    return tomllib.loads((templates_dir() / "synthesis" / f"{language}.toml").read_text("utf-8"))


def title(language: str, links: int) -> str:
    """The title of a composed family with so many moving links."""
    return str(sentences(language)["titles"][str(links)])


def statement_text(draft: Draft, language: str) -> str:
    """``statement.<language>.j2``: the given motion, dyads in the order of growth, position, relative motion."""
    words = sentences(language)
    phrases = words["position"]
    opening = phrases[draft.opening].format() + phrases["changing" if changes_speed(draft) else "constant"] + "."
    parts = [opening, *(words["sentences"][key].format(**_filled(facts, words)) for key, facts in draft.sentences)]
    parts += [phrases["rest"] + rest + "."] if (rest := _position(draft, words)) else []
    relative = [words["relative"][key].format(**_of_block(facts, words)) for key, facts in draft.relative]
    text = " ".join(parts) + "".join(relative) + "\n"
    return text.replace(",,", ",").replace(",.", ".")  # a phrase that ends with a comma, at the end of a clause


def _of_block(facts: Facts, words: Mapping[str, Any]) -> Facts:
    """The facts with what a block is called, in the forms that the language has."""
    forms = {
        name.replace("blocks", "block"): words[name][facts["block"]] for name in words if name.startswith("blocks")
    }
    return {**facts, "slider_of": facts.get("bar", "").removeprefix("slider"), **forms}


def _filled(facts: Facts, words: Mapping[str, Any]) -> Facts:
    """The facts of a sentence with its phrases: ``at`` and ``to`` for hinges, ``on`` for what a block slides on."""
    found = dict(facts)
    for index, field in (("", "at"), ("_to", "to")):
        if f"at{index}" in facts:
            place = {key.removeprefix(f"at{index}_"): value for key, value in facts.items()}
            place["noun"] = words["nouns"].get(place.get("noun", ""), "")
            place |= _of_block(place, words) if "block" in place else {}
            found[field] = words["places"][facts[f"at{index}"]].format(**place)
    if "bar" in facts:
        key = "groove" if facts["noun"] == "groove" else "bar"
        names = {"bar": facts["bar"], "noun": words["nouns"].get(facts["noun"], "")}
        found["on"] = words["on"][key].format(**names, slider_of=facts["bar"].removeprefix("slider"))
    if "way" in facts:
        found["way"] = words["ways"][facts["way"]]
    return found


def _position(draft: Draft, words: Mapping[str, Any]) -> str:
    """What the position is given by besides the driving link; links that lie alike stand together."""
    phrases = words["position"]
    parts = [phrases[key].format(**facts) for key, facts in draft.position if key in _ONE_BY_ONE]
    for key in ("level", "upright"):
        alike = [
            f["link"] if k == key else f["one"] + f["other"] for k, f in draft.position if k in (key, f"pivots_{key}")
        ]
        names = [f"{{{{ {name} }}}}" for name in dict.fromkeys(alike)]
        if names:
            joined = words["and"].join(filter(None, (", ".join(names[:-1]), names[-1])))
            parts.append(phrases[f"{key}_{'one' if len(names) == 1 else 'many'}"].format(names=joined))
    return str(phrases["more"]).join(parts)
