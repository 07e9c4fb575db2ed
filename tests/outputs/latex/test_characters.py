"""What the fonts of LaTeX are said to have, against the tables of LaTeX itself."""

from __future__ import annotations

import re
import subprocess
import unicodedata
from pathlib import Path

import pytest

from variantgen.errors import InputError
from variantgen.outputs.latex.characters import CYRILLIC, LATIN, alphabet, unprintable
from variantgen.outputs.latex.text import Tex, latex_text


def declared(encoding: str) -> set[str]:
    """The characters that an encoding of LaTeX defines."""
    name = f"{encoding}enc.dfu"
    found = subprocess.run(["kpsewhich", name], capture_output=True, text=True, check=True).stdout.strip()
    return {
        chr(int(code, 16)) for code in re.findall(r"DeclareUnicodeCharacter\{([0-9A-F]+)\}", Path(found).read_text())
    }


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize(("letters", "encoding"), [(LATIN, "t1"), (CYRILLIC, "t2a")])
def test_every_letter_is_in_the_encoding(letters: frozenset[str], encoding: str) -> None:
    assert letters <= declared(encoding)


def test_the_alphabets_of_europe_are_there() -> None:
    latin = (
        "ÄÖÜäöüß ÀÂÇÉÈÊËÎÏÔŒÙÛÜŸ ÁÉÍÑÓÚÜ¿¡ ÃÕãõ ÅÆØåæø ĄĆĘŁŃÓŚŹŻąćęłńóśźż ČĎĚŇŘŠŤŮŽčďěňřšťůž ĐĆČŠŽđ ĞİıŞğş ŐŰőű"
        " ĀĒĢĪĶĻŅŪāēģīķļņū ĖĮŲŪėįųū ĂÂÎȘȚăâîșț ÞÐþð ŴŶŵŷ ĊĠŻċġż"
    )
    cyrillic = "ЁЙЪЫЭё ЄІЇҐєіїґ ЎўІі ЂЈЉЊЋЏђјљњћџ ЃЅЌѓѕќ ӘҒҚҢӨҰҮҺәғқңөұүһ"
    assert unprintable(latin, "pdflatex") == []
    assert unprintable(cyrillic, "pdflatex") == []
    assert set(cyrillic) - {" "} <= CYRILLIC


@pytest.mark.parametrize(
    ("text", "letters"),
    [
        ("学生", "学生"),
        ("\N{PILE OF POO}", "\N{PILE OF POO}"),
        ("x\u0351\u0310", "\u0351\u0310"),
        ("Ива\u0301нов", "\u0301"),
        ("\u202eevil", "\u202e"),
        ("a\x00b\ue000\uffff", "\x00\ue000\uffff"),
    ],
)
def test_what_no_font_has_is_told(text: str, letters: str) -> None:
    assert unprintable(text, "pdflatex") == list(letters)
    with pytest.raises(InputError, match=f"U\\+{ord(letters[0]):04X}"):
        latex_text(text, alphabet("en", "pdflatex"))


def test_lualatex_is_left_what_a_font_may_have() -> None:
    assert unprintable("学生 Νίκος x\u0351 \N{PILE OF POO}", "lualatex") == []
    assert unprintable("שלום", "lualatex") == list("שלום")
    assert unprintable("محمد", "lualatex") == list("محد")
    assert unprintable("\u202ex\u202c\x07\ue000", "lualatex") == ["\u202e", "\u202c", "\x07", "\ue000"]


def test_a_letter_with_its_accent_apart_is_the_letter() -> None:
    apart = unicodedata.normalize("NFD", "Żółć Йод")
    assert apart != "Żółć Йод"
    assert latex_text(apart, alphabet("ru", "pdflatex")) == latex_text("Żółć Йод", alphabet("ru", "pdflatex"))


def test_words_of_the_other_encoding_are_marked_whole() -> None:
    assert latex_text("Łódź, Kraków", alphabet("ru", "pdflatex")) == r"\inlatin{Łódź}, \inlatin{Kraków}"
    assert latex_text("Anna Łódź Żak, Bob", alphabet("ru", "pdflatex")) == r"Anna \inlatin{Łódź Żak}, Bob"
    assert latex_text("Иванов Иван", alphabet("en", "pdflatex")) == r"\incyrillic{Иванов Иван}"
    assert latex_text("“Ира” Łx", alphabet("en", "pdflatex")) == r"“\incyrillic{Ира}” Łx"
    assert latex_text("Иванов Łódź", alphabet("en", "lualatex")) == "Иванов Łódź"


def test_invisible_characters_and_blanks() -> None:
    assert latex_text(" a\u200bb\ufeff \t\n c\u00add ", alphabet("en", "pdflatex")) == "ab cd"
    assert latex_text("a\u00a0b", alphabet("en", "pdflatex")) == "a~b"


def test_source_is_no_text() -> None:
    assert isinstance(latex_text("x", alphabet("en", "pdflatex")), Tex)
    assert latex_text(r"\x", alphabet("en", "pdflatex")) == r"\textbackslash{}x"
