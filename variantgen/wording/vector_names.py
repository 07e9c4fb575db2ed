"""The symbols of vectors and of the points of plans: ``v_BA``, ``a^n_BA``, ``v_rel D``, ``a'``."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from variantgen.wording.formula import Index, Symbol
from variantgen.wording.language import Language

COMPONENTS = ("n", "tau")  # of an acceleration: towards the centre, along the path
_PRIME = (Index("prime"),)


def component_marks(language: Language) -> tuple[tuple[Index, ...], tuple[Index, ...]]:
    """What stands above the index of the normal and of the tangential component of an acceleration."""
    normal, tangential = COMPONENTS
    return (language.component(normal),), (language.component(tangential),)


def absolute(kind: str, point: str, upper: tuple[Index, ...] = ()) -> Symbol:
    """The vector of a point, ``v_B``, or its component, ``a^n_B``."""
    return Symbol(kind, (Index(point),), upper)


def relative_to_pole(kind: str, point: str, pole: str, upper: tuple[Index, ...] = ()) -> Symbol:
    """The vector of a point in the rotation about a pole, ``v_BA``, or its component, ``a^n_BA``."""
    return Symbol(kind, (Index(point + pole),), upper)


def compound_part(kind: str, word: str, point: str, language: Language, upper: tuple[Index, ...] = ()) -> Symbol:
    """A part of a compound motion: ``word`` is ``rel``, ``tr`` or ``cor``."""
    return Symbol(kind, (Index(language.words("index")[word], True), Index(point)), upper)


def image(point: str, primed: bool) -> Symbol:
    """The end of the vector of a point in a plan: a small letter, with a prime in the plan of accelerations."""
    return Symbol(point.lower(), (), _PRIME if primed else ())


def transport_image(point: str, primed: bool, language: Language) -> Symbol:
    """The end of the transport vector: the image of the point of the carrier below a sliding point."""
    return Symbol(point.lower(), (Index(language.words("index")["tr"], True),), _PRIME if primed else ())


def centre_letters(bodies: Mapping[str, str], taken: Collection[str]) -> dict[str, Symbol]:
    """The letters of velocity centres by body; ``bodies`` gives the index of each, ``taken`` are names of points."""
    if len(bodies) == 1 and "P" not in taken:
        return dict.fromkeys(bodies, Symbol("P"))
    unnamed = Symbol("P", (Index("v"),)) if "P" in taken else Symbol("P")
    return {body: Symbol("P", (Index(name),)) if name else unnamed for body, name in bodies.items()}
