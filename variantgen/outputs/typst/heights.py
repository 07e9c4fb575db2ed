"""Heights of what stands on sheets, measured by the engine: statements, heads, lines, formulas. In millimetres."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from variantgen.outputs.typst.set_formulas import set_formulas, set_width
from variantgen.outputs.typst.typesetter import Typesetter

EM = 10.5 * 25.4 / 72  # the size of the text of sheets
_SHARED = ("lang", "title", "course", "words", "notices")
_LINE, _GIVEN = {"line": True}, {"given": True}


class Heights:
    """What the engine has measured for the sheets of an exam.

    A request names what is measured: ``said`` a statement in a column of some ``width``, ``head`` what stands above
    the problems of a page, ``line`` a line of text, ``formula`` and ``given`` the width of one and of the word before
    the data. Sheets have the most of them in common: what an engine has measured it is not asked again.
    """

    def __init__(self, engine: Typesetter, data: Mapping[str, Any]) -> None:
        self._engine = engine
        self._shared = {name: data[name] for name in _SHARED if name in data}
        self._known = engine.measured.setdefault(_key(self._shared), {})
        self.measure([_LINE, _GIVEN])

    def measure(self, requests: Iterable[dict[str, Any]]) -> None:
        """Measure what is not known yet."""
        new = {key: request for request in requests if (key := _key(request)) not in self._known}
        if new:
            asked = list(new.values())
            data = {**self._shared, "requests": asked}
            self._known.update(zip(new, self._engine.query("heights.typ", data, set_formulas(asked)), strict=True))

    def of(self, request: dict[str, Any]) -> float:
        """What was measured for a request."""
        return self._known[_key(request)]

    @property
    def line(self) -> float:
        """What a line of text more adds."""
        return self.of(_LINE)

    @property
    def given_width(self) -> float:
        """The width of the word that the data begin with."""
        return self.of(_GIVEN)

    def width(self, markup: Any) -> float:
        """The width of a formula in a line of text."""
        known = set_width(markup)
        return self.of({"formula": markup}) if known is None else known * EM


def _key(request: Mapping[str, Any]) -> str:
    return json.dumps(request, ensure_ascii=False, separators=(",", ":"))
