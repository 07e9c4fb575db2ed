r"""Text from outside as LaTeX prints it: nothing of it is a command, a ligature or a shorthand."""

from __future__ import annotations

import re
from functools import lru_cache
from itertools import groupby

from variantgen.errors import InputError, Problem
from variantgen.outputs.latex.characters import MATH, Alphabet, cleaned, named, unprintable
from variantgen.tables import shown
from variantgen.wording.latex import ESCAPES

# Two of these beside each other would become a dash or a quotation mark.
_LIGATURES = re.compile(r"(?<=-)(?=-)|(?<=<)(?=<)|(?<=>)(?=>)|(?<=,)(?=,)")
_APOSTROPHE = re.compile(r"(?<=[^\W\d_])'(?=[^\W\d_])")
_APART, _BREAK, _CURLY = (
    "\ue000",
    "\ue001",
    "\ue002",
)  # marks on the way; text with characters of private use is refused
_LONG = re.compile(r"[^\s\ue000-\ue002]{31,}")
_PIECE = 20  # letters between which a very long word may be broken
_SPECIAL = {
    **ESCAPES, '"': r"\textquotedbl{}", "'": r"\textquotesingle{}", "`": r"\textasciigrave{}", "[": "{[}", "]": "{]}",
    "\N{NO-BREAK SPACE}": "~", "\N{NARROW NO-BREAK SPACE}": r"\,", "\N{THIN SPACE}": r"\,",
    _APART: r"{\kern0pt}", _BREAK: r"\hspace{0pt}", _CURLY: "'",
}  # fmt: skip
_RUN = re.compile(r"[^\W\d_]+|.", re.DOTALL)
_TOKEN = re.compile("[\u0370-\u03ff\u1f00-\u1fff]{2,}|.", re.DOTALL)  # a Greek word, or one letter


class Tex(str):
    """LaTeX source, which templates take as it is; any other string is text, which they escape."""

    __slots__ = ()


@lru_cache(maxsize=10_000)
def latex_text(text: str, alphabet: Alphabet) -> Tex:
    """Plain text as source. Raises InputError for characters that the document cannot print."""
    if found := unprintable(text, alphabet.engine):
        remedy = "leave the characters out, or the format"
        raise InputError(Problem(f"LaTeX cannot print {named(found)}", value=shown(text), remedy=remedy))
    marked = _APOSTROPHE.sub(_CURLY, _LIGATURES.sub(_APART, cleaned(text)))
    marked = _LONG.sub(lambda word: _breakable(word[0]), marked)
    return Tex(_joined(" ".join(_word(word, alphabet) for word in marked.split(" ")), alphabet.command))


def _joined(source: str, command: str) -> str:
    """Words of the other encoding after each other inside one command."""
    return re.sub(rf"(?<=[^\W\d_])\}} \\{command}\{{", " ", source) if command else source


def _breakable(word: str) -> str:
    """A very long word with places where a line may end."""
    return _BREAK.join(word[i : i + _PIECE] for i in range(0, len(word), _PIECE))


def _word(word: str, alphabet: Alphabet) -> str:
    """A word, its letters of the other encoding inside the command for it."""
    return "".join(_run(run, alphabet) for run in _RUN.findall(word))


def _run(run: str, alphabet: Alphabet) -> str:
    """Letters beside each other, or one sign; plain Latin letters stay with the others of their name."""
    if not any(letter in alphabet.other for letter in run):
        return "".join(_token(token, alphabet) for token in _TOKEN.findall(run))
    if all(letter in alphabet.other or letter.isascii() for letter in run):
        return rf"\{alphabet.command}{{{run}}}"
    groups = groupby(run, lambda letter: letter in alphabet.other)
    return "".join(_run("".join(letters), alphabet) for _, letters in groups)


def _token(token: str, alphabet: Alphabet) -> str:
    """A Greek letter alone is a quantity; words are left to the font, where there is one that may have them."""
    if len(token) > 1 and alphabet.engine == "lualatex":
        return token
    return "".join(f"${MATH[letter]}$" if letter in MATH else _SPECIAL.get(letter, letter) for letter in token)
