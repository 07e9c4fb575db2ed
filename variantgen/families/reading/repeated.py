"""One mistake of a family file is one message, however many forms it is found in."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from variantgen.errors import Problem

_SHOWN = 3  # forms that are named


def reported_once(problems: Iterable[Problem], overlays: Mapping[str, Any]) -> list[Problem]:
    """The problems, those that forms share once each, under the key where the mistake stands.

    ``overlays`` are the tables of the forms. What no form writes itself stands in the tables of the family: it is read
    again with each form and noted as ``forms.NAME.bodies.OA``, and is reported as ``bodies.OA``.
    """
    groups: dict[tuple[str, ...], list[tuple[str, Problem]]] = {}
    for problem in problems:
        form = _form_of(problem.key, overlays)
        rest = problem.key.removeprefix(f"forms.{form}.") if form else problem.key
        groups.setdefault((rest, problem.message, problem.value, "" if form else "family"), []).append((form, problem))
    return [_one(copies, key[0], overlays) for key, copies in groups.items()]


def _form_of(key: str, overlays: Mapping[str, Any]) -> str:
    """The form that a key belongs to, or ''."""
    return max((name for name in overlays if name and key.startswith(f"forms.{name}.")), key=len, default="")


def _one(copies: Sequence[tuple[str, Problem]], rest: str, overlays: Mapping[str, Any]) -> Problem:
    """The problem that copies of a mistake become."""
    forms, problem = list(dict.fromkeys(form for form, _ in copies)), copies[0][1]
    if not forms[0]:
        return problem
    if any(_writes(overlays[form], rest) for form in forms):
        return replace(problem, message=problem.message + _more("also in", forms[1:]))
    everywhere = len(forms) == len(overlays)
    return replace(problem, key=rest, message=problem.message + ("" if everywhere else _more("in", forms)))


def _more(how: str, forms: Sequence[str]) -> str:
    """``, in the forms a, b, c and 14 more forms``."""
    if not forms:
        return ""
    named = ", ".join(forms[:_SHOWN]) + (f" and {len(forms) - _SHOWN} more forms" if len(forms) > _SHOWN else "")
    return f", {how} the form{'s' if len(forms) > 1 else ''} {named}"


def _writes(overlay: Any, rest: str) -> bool:
    """Whether a form itself writes the entry of a key: ``bodies.OA``, ``joints[2].gears.radius``."""
    section, entry = [*re.split(r"[.\[]", rest, maxsplit=2), ""][:2]
    if not isinstance(overlay, dict) or section not in overlay:
        return False
    content = overlay[section]
    return not isinstance(content, dict) or not entry or entry in content
