"""What has to be said to who reads answers: what letters and indices stand for, conventions of sign."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from variantgen.families.quantities import Quantity
from variantgen.wording.formula import letters
from variantgen.wording.language import NATURAL, Language

_NO_SYMBOLS: Mapping[str, str] = MappingProxyType({})


def sign_notes(asked: Sequence[Quantity], language: Language) -> list[str]:
    """The conventions of sign that these answers need, a sentence each."""
    words = language.words("sheet")
    needed = {
        "signs": any(q.is_rotation and not q.component for q in asked),
        "magnitudes": any(q.is_vector and not q.component for q in asked),
        "components": any(q.component in ("x", "y") or q.is_coordinate for q in asked),
        "coordinates": any(q.is_coordinate for q in asked),
        "angles": any(q.component == "angle" for q in asked),
        "senses": any(q.component == "sense" for q in asked),
        "tangential": any(q.kind == "a" and q.component == "t" for q in asked),
        "ratios": any(q.group == "ratio" for q in asked),
    }
    notes = [words[key] for key, wanted in needed.items() if wanted]
    lines = dict.fromkeys((q.component.partition("_")[0], q.line) for q in asked if q.line)
    lines |= dict.fromkeys(("inclination", q.target) for q in asked if q.kind == "angle" and not q.component)
    return notes + [words[key].format(line=line, **_ends(line)) for key, line in lines]


def _ends(line: str) -> dict[str, str]:
    """The two points of a line by the letters of its name: ``O1A`` goes from O1 to A."""
    start, *rest = (letter + number for letter, number in letters(line))
    return {"start": start, "end": "".join(rest)}


def letter_notes(asked: Sequence[Quantity], language: Language, symbols: Mapping[str, str] = _NO_SYMBOLS) -> list[str]:
    """What the letters of centres stand for in what is asked, a sentence each; ``symbols`` are those of the form."""
    words = language.words("sheet")
    needed = {
        "velocity_centre": any(q.kind == "P" for q in asked),
        "acceleration_centre": any(q.kind in ("Q", "mu") for q in asked),
        "curvature": any(q.kind == "rho" for q in asked),
        "natural": any(q.kind == "a" and q.component in NATURAL for q in asked),
        "extremes": any(q.is_of_turn and ("max_" in q.kind or "min_" in q.kind) for q in asked),
        "mean": any(q.is_of_turn and q.kind.startswith("mean_") for q in asked),
        "crank_angle": any(q.kind.startswith("phi_") for q in asked),
        **{name: any(q.kind == name for q in asked) for name in ("stroke", "swing", "time_ratio")},
        "whole_turn": any(q.is_of_turn for q in asked),
        "interval_extremes": any(_of_interval(q, "max_t_", "min_t_") for q in asked),
        "interval_mean": any(_of_interval(q, "mean_t_") for q in asked),
        "instant": any(_of_interval(q, "t_max_", "t_min_") for q in asked),
        "zero_instant": any(_of_interval(q, "t_zero_") for q in asked),
        "return_instant": any(_of_interval(q, "t_back") for q in asked),
        "average": any(_of_interval(q, "average_") for q in asked),
        **{name: any(_of_interval(q, name) for q in asked) for name in ("way", "shift", "turned", "duration")},
    }
    notes = [words[key] for key, wanted in needed.items() if wanted]
    pairs = dict.fromkeys(
        (symbols.get(q.name, "rope") if q.group == "rope" else q.kind, q.target, q.component)
        for q in asked
        if q.kind == "distance" or q.group == "rope"
    )
    seen = dict.fromkeys(q.pair for q in (q.of_instant or q for q in asked) if q.group == "difference")
    notes += [
        words["seen"].format(index=language.relative_to(*pair).text, point=pair[0], base=pair[1]) for pair in seen
    ]
    return notes + [words[key].format(start=start, end=end) for key, start, end in pairs]


def _of_interval(quantity: Quantity, *kinds: str) -> bool:
    """Whether a quantity is one of these kinds of an interval of time."""
    return quantity.is_of_interval and quantity.kind.startswith(kinds)


def answer_notes(asked: Sequence[Quantity], language: Language, symbols: Mapping[str, str] = _NO_SYMBOLS) -> list[str]:
    """All that has to be said to who reads these answers: letters and conventions of sign, a sentence each."""
    return [*sign_notes(asked, language), *letter_notes(asked, language, symbols)]
