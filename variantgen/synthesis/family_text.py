"""The files of a family from a mechanism that is laid out: ``family.toml``."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from variantgen.synthesis.draft import Datum, Draft

_EPSILON = (-6, -5, -4, -3, -2, 2, 3, 4, 5, 6)


def family_text(
    draft: Draft, titles: Mapping[str, str], structure: str, asked: Sequence[str], width: float = 1.0
) -> str:
    """``family.toml`` of a mechanism; ``structure`` is its code.

    Values vary about those of the draft, as far as their spread times ``width``.
    """
    fine = draft.style("lengths") > 0
    lines = [
        "schema = 1",
        f"title = {_inline(titles)}",
        f'source = "composed, structure {structure}"',
        'length_unit = "cm"',
        'machine = { size = "workshop" }',
        f"ask = {_value(list(asked))}",
        "",
        "[parameters]",
        *(f"{name} = {_grid(datum, width, fine)}" for name, datum in draft.data.items()),
        *([f'epsilon_OA = {{ unit = "rad/s^2", values = {list(_EPSILON)} }}'] if changes_speed(draft) else []),
        "sense = { choices = { counter_clockwise = 1, clockwise = -1 } }",
        "",
        "[points]",
        *(f"{name} = {{ {kind} = {_inline(fields)} }}" for name, (kind, fields) in draft.points.items()),
        "",
        "[bodies]",
        *(f"{name} = {_value(points)}" for name, points in draft.bodies.items()),
        "",
    ]
    for kind, fields in draft.joints:
        lines += ["[[joints]]", f"{kind} = {_inline(fields)}"]
    epsilon = ', epsilon = "epsilon_OA"' if changes_speed(draft) else ""
    lines += ["", "[[drivers]]", f'rotation = {{ body = "OA", omega = "sense * omega_OA"{epsilon} }}']
    lines += ["", "[screens]", "transmission = 25", "slant = 4", f"spacing = {_spacing(draft)}"]
    if draft.inside:
        lines.append(f"inside = {_value([list(item) for item in draft.inside])}")
    if draft.require:
        lines.append(f"require = {_value(draft.require)}")
    turns = "[0]" if draft.wheels else "[0, 2]"  # wheels roll on what is below them
    lines += ["", "[pose]", "mirror = true", f"quarter_turns = {turns}", "", "[figure]"]
    lines.append(f"angles = [{', '.join(_inline(mark) for mark in draft.marks)}]")
    for key, values in draft.hints.items():
        lines.append(f"{key} = [{', '.join(_value(value) for value in values)}]")
    for table, entries in (("symbols", draft.symbols), ("nouns", _nouns(draft))):
        if entries:
            lines += ["", f"[{table}]", *(f"{name} = {_value(value)}" for name, value in entries.items())]
    return "\n".join(lines) + "\n"


def _nouns(draft: Draft) -> dict[str, str]:
    """What bodies are called in solutions, as in the statement; without one they are links, gears, wheels."""
    found = {}
    for link in draft.links.values():
        noun = draft.called.get(link.body) or (link.noun if link.end else "rod")  # or an arm fixed to a block
        if link.body in draft.bodies and noun not in ("driver", "link"):
            found[link.body] = noun
    return found | draft.nouns


def changes_speed(draft: Draft) -> bool:
    """Whether the driving link has an angular acceleration: where the data leave room, and accelerations are short."""
    return len(draft.data) < 10 and len(draft.asked) < 3


def _spacing(draft: Draft) -> float:
    return 0.1 if len(draft.asked) < 2 else 0.075


def _grid(datum: Datum, width: float, fine: bool) -> str:
    """The values of a datum: those of its grid as near as its spread says; ``fine``: lengths by centimetres."""
    step = 1 if fine and datum.unit == "cm" else datum.step
    half = datum.step * (width * datum.spread // datum.step)
    low, high = datum.value - half, datum.value + half
    return f'{{ unit = "{datum.unit}", from = {low:g}, to = {high:g}, step = {step:g} }}'


def _inline(fields: Mapping[str, Any]) -> str:
    """An inline table."""
    return "{ " + ", ".join(f"{key} = {_value(value)}" for key, value in fields.items()) + " }"


def _value(value: Any) -> str:
    """A value as TOML writes it."""
    if isinstance(value, Mapping):
        return _inline(value)
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else f"{value:g}"
