"""Content as source text of the typesetting engine, which evaluates it faster than templates walk through data.

Everything is written as calls and names; whatever comes from outside stands in string literals, in which nothing but
the backslash and the quote has a meaning. What a document has several times is made once and has a name. Formulas
are letters at their places, or equations where there are no letters for them or a document is read out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from variantgen.outputs.typst.fragments import Fragment, Mark, Text
from variantgen.outputs.typst.markup import TypstMarkup
from variantgen.outputs.typst.set_formulas import set_longer


class TypstSource:
    """Source text with the values that have names.

    ``letters``: formulas are letters at their places; ``spoken``: equations have the words that are read out.
    """

    def __init__(self, letters: bool, spoken: bool) -> None:
        self.letters = letters
        self.spoken = spoken
        self._named: list[str] = []
        self._names: dict[str, str] = {}
        self._fragments = _FragmentNames(self._fragment)
        self._formulas: dict[str, tuple[str, bool]] = {}

    def value(self, result: str) -> str:
        """The whole text, whose value is the ``result``."""
        return ";".join([*self._named, result])

    def name(self, code: str) -> str:
        """The name of a value."""
        found = self._names.get(code)
        if found is None:
            found = self._names[code] = f"a{len(self._names)}"
            self._named.append(f"let {found}={code}")
        return found

    def line(self, fragments: Iterable[Fragment]) -> str:
        """Fragments after each other."""
        known = self._fragments
        return ";".join([known[fragment] for fragment in fragments])

    def formula(self, markup: str, boxed: bool = False, bold: bool = False) -> str:
        """A formula inside a line; ``boxed``: it is not broken. Letters are never bold."""
        if bold:
            return f"box({self.name(self._equation(markup))})"
        made, is_equation = self._formula(markup)
        return f"box({made})" if is_equation and boxed else made

    def steady(self, items: Sequence[Any], bold: bool = False) -> str:
        """Text in which no formula is broken."""
        parts = [string(i) if isinstance(i, str) else self.formula(i[0], boxed=True, bold=bold) for i in items]
        return f"{{{';'.join(parts)}}}" if parts else "none"

    def equals(self, data: dict[str, Any]) -> str:
        """An equation as ``TypstWriting.equals`` tells it, which is not broken."""
        parts = [self.formula(data["symbol"])]
        if data["exact"]:
            parts += ["equal", self.formula(data["exact"])]
        if data["value"]:
            parts += ["wide", "about" if data["exact"] else "same", "wide", string(data["value"])]
            if data["unit"]:
                parts += ["narrow", self.formula(data["unit"])]
        return f"box({{{';'.join(parts)}}})"

    def _formula(self, markup: str) -> tuple[str, bool]:
        """The name of a formula, and whether it is an equation."""
        found = self._formulas.get(markup)
        if found is None:
            made = set_longer(markup) if self.letters and type(markup) is TypstMarkup else None
            if made:
                found = self.name(f"letters({length(made.width)},{{{self.line(made.fragments)}}})"), False
            else:
                found = self.name(self._equation(markup)), True
            self._formulas[markup] = found
        return found

    def _equation(self, markup: str) -> str:
        alt = f",alt:{string(markup.plain)}" if self.spoken and isinstance(markup, TypstMarkup) else ""
        return f"equation({string(markup)}{alt})"

    def _fragment(self, fragment: Fragment) -> str:
        """The name of a fragment."""
        if isinstance(fragment, tuple) and len(fragment) == 1:
            return self.name(f"box({self._equation(fragment[0])})")
        return self.name(_fragment(fragment))


class _FragmentNames(dict[Fragment, str]):
    """The names of fragments, of which most are found again."""

    def __init__(self, make: Callable[[Fragment], str]) -> None:
        self._make = make

    def __missing__(self, fragment: Fragment) -> str:
        found = self[fragment] = self._make(fragment)
        return found


def string(text: str) -> str:
    """A string literal."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def length(number: float) -> str:
    """A length in em."""
    return f"{number!r}em"


def array(items: Iterable[str]) -> str:
    """An array; one item is an array too."""
    return f"({''.join([f'{item},' for item in items])})"


def _fragment(fragment: str | float | Text | Mark) -> str:
    """A fragment that is no markup."""
    if isinstance(fragment, str):
        return string(fragment)
    if not isinstance(fragment, tuple):
        return f"h({length(fragment)})"
    if len(fragment) == 4:
        up, size, cut, letters = fragment
        features = f"features:(ssty:{cut})," if cut else ""
        return f"text(size:{length(size)},baseline:{length(-up / size)},{features}{string(letters)})"
    up, what = fragment
    drawn = f"sign({string(what)})" if isinstance(what, str) else f"line(length:{length(what)},stroke:bar)"
    return f"box(width:0em,height:0em,place(top+left,dy:{length(-up)},{drawn}))"
