"""The statement of a mechanism that is laid out, as the template of a family, from sentences of a language."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from variantgen.resources import languages, templates_dir
from variantgen.synthesis.draft import CRANK, Draft, Facts
from variantgen.synthesis.family_text import changes_speed

_ONE_GROUP = 3  # moving links of a driving link and a group of two


def composed_languages() -> list[str]:
    """The languages in which statements can be composed: those that have the sentences."""
    return [name for name in languages() if (templates_dir() / "synthesis" / f"{name}.toml").is_file()]


@cache
def sentences(language: str) -> Mapping[str, Any]:
    """The sentences and phrases of a language (``templates/synthesis/<language>.toml``)."""
    return tomllib.loads((templates_dir() / "synthesis" / f"{language}.toml").read_text("utf-8"))


def title(language: str, draft: Draft, links: int) -> str:
    """The title of a composed family: the usual name of a mechanism with one group, or how many links move."""
    words, (key, _) = sentences(language), draft.sentences[0]
    name = words["titles_of"].get(key) if len(draft.asked) == 1 and links == _ONE_GROUP else ""
    return str(name or words["titles"][str(links)])


def statement_text(draft: Draft, language: str) -> str:
    """``statement.<language>.j2``: the mechanism in the order of growth, position, given motion, relative motion; the
    given motion may come first.
    """
    words = sentences(language)
    parts = [_motion_first(draft, words)] if draft.opening == "turning" else []
    parts += _mechanism(draft, words)
    if len(draft.pivots) > 1:
        parts.append(_worded(draft, words["position"]["fixed"]).format(names=_joined(draft.pivots, words)))
    parts.append(_position(draft, words))
    relative = [words["relative"][key].format(**_forms(facts, words)) for key, facts in draft.relative]
    return " ".join(parts) + "".join(relative) + "\n"


def _mechanism(draft: Draft, words: Mapping[str, Any]) -> list[str]:
    """A sentence for each dyad, and one for an arm before it; two in a row that begin alike are joined."""
    found: list[str] = []
    driver_named = draft.opening == "turning"
    for place, (key, said) in enumerate(draft.sentences):
        facts = _as_called(said, draft, driver_named)
        driver_named = driver_named or CRANK in said.values()
        for index in ("", "_to"):
            if facts.get(f"at{index}") in words["arms"]:
                found.append(words["arms"][facts[f"at{index}"]].format(**_forms(_place(facts, index), words)))
        at_end = not place and facts.get("at") == "end" and facts["at_link"] == CRANK
        has_letter = facts.get("at") in ("end", *words["arms"]) and key in words["at_end"]
        table = words["at_end" if has_letter else "sentences"]
        if draft.opening == "driven" and at_end and key in words["driven"]:
            table = words["driven"]
        if draft.opening == "driven" and at_end and draft.called.get(CRANK) == "crank" and key in words["named"]:
            table = words["named"]
        found.append(_worded(draft, table[key]).format(**_filled(facts, words)))
    joined = found[:1]
    for sentence in found[1:]:
        if sentence.split()[:2] == joined[-1].split()[:2] and ";" not in joined[-1]:
            joined[-1] = f"{joined[-1][:-1]}; {sentence[0].lower()}{sentence[1:]}"
        else:
            joined.append(sentence)
    return joined


def _motion_first(draft: Draft, words: Mapping[str, Any]) -> str:
    """The given motion, and what the mechanism is called where the first group has a usual name."""
    key, facts = draft.sentences[0]
    noun = words["nouns"][draft.called.get(CRANK, "link")]
    name = words["mechanisms"].get(key, "") if facts.get("at_point") == "A" and not draft.brief else ""
    motion = words["position"]["turning_changing" if changes_speed(draft) else "turning_constant"]
    said = name.format(**_forms(facts, words)) + str(motion).replace("{driver}", noun)
    return said[0].upper() + said[1:]


def _position(draft: Draft, words: Mapping[str, Any]) -> str:
    """What the position is given by, and the given motion; links that lie alike stand together."""
    phrases, said = words["position"], draft.position
    upright = draft.upright
    called = draft.called.get(CRANK, "link")
    inclined = [(facts["angle"], facts["link"]) for key, facts in said if key == "incline"]
    angles = []
    if inclined and not upright and not draft.base:
        inclined = [("phi", CRANK), *inclined]
    else:
        along = "upright" if upright else "level"
        key = ("beyond" if draft.base.startswith("-") else "base") if draft.base else along
        angles.append(phrases[key].format(base=draft.base.lstrip("-"), driver_here=words["here"][called].format()))
    if inclined:
        names, links = (_joined(part, words) for part in zip(*inclined, strict=True))
        angles.append(
            phrases["incline_one" if len(inclined) == 1 else "incline_many"].format(angles=names, names=links)
        )
    angles += [phrases[key].format(**facts) for key, facts in said if key == "angle"]
    if not draft.brief:  # they are among the data
        angles += [phrases[key].format(**facts) for key, facts in said if key == "instant_length"]
    clauses, middles = _squares(draft, words), [phrases[key].format(**f) for key, f in said if key == "halfway"]
    for key in ("level", "upright"):
        alike = [f["link"] for k, f in said if k == key]
        if not draft.base or _tells_axes(draft):
            alike += [f["one"] + f["other"] for k, f in said if k == f"pivots_{key}"]
        if alike:
            form = phrases[f"{key}_{'one' if len(set(alike)) == 1 else 'many'}"]
            clauses.append(form.format(names=_joined(list(dict.fromkeys(alike)), words)))
    there = _listed([*clauses, *middles], words)  # "C is in the middle of AB and O1D is" would be read wrongly
    if draft.opening == "turning":
        there = f"; {there}" if there else ""
        return str(_worded(draft, phrases["shown"]).format(angles=_listed(angles, words), clauses=there))
    driver = words["nouns"][called]
    opening = "given" if draft.opening == "given" and not draft.relative else "in_position"  # the shorter one
    if there:
        there = f"; {there}" if opening == "given" else f"{there}; "
    motion = phrases["changing" if changes_speed(draft) else "constant"]
    return (
        str(_worded(draft, phrases[opening]).format(angles=_listed(angles, words), clauses=there, driver=driver))
        + str(motion)
        + "."
    )


def _squares(draft: Draft, words: Mapping[str, Any]) -> list[str]:
    """What is perpendicular to what; links that are so to the same one stand together."""
    pairs = [(facts["one"], facts["link"]) for key, facts in draft.position if key == "square"]
    clauses = []
    while pairs:
        found = [link for pair in pairs for link in pair]
        shared = max(found, key=found.count)
        links = [one if link == shared else link for one, link in pairs if shared in (one, link)]
        pairs = [pair for pair in pairs if shared not in pair]
        form = words["position"][f"square_{'one' if len(links) == 1 else 'many'}"]
        clauses.append(form.format(names=_joined(links, words), one=shared))
    return clauses


def _tells_axes(draft: Draft) -> bool:
    """Whether a statement says what is horizontal or vertical, or what angle something makes with it."""
    alone = ("level", "upright", "incline")
    return any("way" in facts for _, facts in draft.sentences) or any(key in alone for key, _ in draft.position)


def _worded(draft: Draft, said: str | Sequence[str]) -> str:
    """A sentence, or of several ways to say it the one that goes with the statement."""
    if isinstance(said, str):
        return said
    return min(said, key=len) if draft.brief else said[draft.style("words") % len(said)]


def _as_called(facts: Facts, draft: Draft, driver_named: bool) -> Facts:
    """The facts with links called what they are: cranks and rockers; ``turning``: what a rod drives, ``driver``: OA.

    ``driver_named``: it has been said that OA drives.
    """
    bodies = {"noun": "bar", "at_noun": "at_link", "at_to_noun": "at_to_link"}
    known = draft.called
    driver = known.get(CRANK, "link" if driver_named or draft.brief else "driver")
    called = {**known, CRANK: driver}
    nouns = {noun: called[facts[body]] for noun, body in bodies.items() if facts.get(body) in called}
    coupler = "coupler" if facts.get("at_point") == "A" and not draft.brief else "rod"
    return {
        **facts, **nouns, "driver": driver, "turning": known.get(facts.get("rocker", ""), "link"), "coupler": coupler,
    }  # fmt: skip


def _joined(names: Sequence[str], words: Mapping[str, Any]) -> str:
    """Symbols of the template: A, B and C."""
    return _listed([f"{{{{ {name} }}}}" for name in names], words)


def _listed(parts: Sequence[str], words: Mapping[str, Any]) -> str:
    """Parts with commas between, the last one with "and"."""
    return str(words["and"]).join(filter(None, (", ".join(parts[:-1]), *parts[-1:])))


def _both(facts: Facts, at: str, to: str, words: Mapping[str, Any]) -> str:
    """The phrase for two places in a row: of two links that are called alike the noun stands once."""
    (noun, one), (other_noun, other) = (_link_at(facts, index, words) for index in ("", "_to"))
    if not noun or noun != other_noun:
        return str(words["pairs"]["apart"].format(at=at, to=to))
    return str(words["pairs"]["alike"].format(nouns=words["nouns_many"][noun], one=one, other=other))


def _link_at(facts: Facts, index: str, words: Mapping[str, Any]) -> tuple[str, str]:
    """What the link is called at whose end a hinge is, and the link; nothing for other places."""
    place = _place(facts, index)
    if facts[f"at{index}"] in words["arms"]:
        return "rod", place["link"]
    return (place["noun"], place["link"]) if facts[f"at{index}"] == "end" else ("", "")


def _place(facts: Facts, index: str) -> Facts:
    """What is known of where a hinge is: of the first end ("") or of the other ("_to")."""
    return {key.removeprefix(f"at{index}_"): value for key, value in facts.items() if key.startswith(f"at{index}_")}


def _forms(facts: Facts, words: Mapping[str, Any]) -> Facts:
    """The facts with what a block, a link, a direction is called, in the forms that the language has."""
    found = {**facts, "slider_of": facts.get("bar", "").removeprefix("slider")}
    tables = (
        ("block", "blocks"),
        ("noun", "nouns"),
        ("way", "ways"),
        ("across", "ways"),
        ("driver", "nouns"),
        ("turning", "nouns"),
        ("coupler", "rods"),
    )
    for fact, table in tables:
        for name in words:
            if fact in facts and name.partition("_")[0] == table:
                found[name.replace(table, fact)] = words[name].get(facts[fact], "")
    for fact in ("driver", "coupler"):
        if noun := found.get(fact):
            found[fact.capitalize()] = noun[0].upper() + noun[1:]
    return found


def _filled(facts: Facts, words: Mapping[str, Any]) -> Facts:
    """The facts of a sentence with its phrases: ``at`` and ``to`` for hinges, ``on`` for what a block slides on."""
    found = _forms(facts, words)
    for index, field in (("", "at"), ("_to", "to")):
        if f"at{index}" in facts:
            key = "arm" if facts[f"at{index}"] in words["arms"] else facts[f"at{index}"]
            place = _forms(_place(facts, index), words)
            found[field] = words["places"][key].format(**place)
            found[f"{field}_to"] = words["places_to" if "places_to" in words else "places"][key].format(**place)
    if "at" in found and "to" in found:
        found["both"] = _both(facts, found["at_to"], found["to_to"], words)
    if "bar" in facts:
        found["on"] = words["on"]["groove" if facts["noun"] == "groove" else "bar"].format(**found)
    return found
