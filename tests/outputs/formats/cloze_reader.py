"""Reads cloze questions as Moodle does, written anew from its description.

The notation: https://docs.moodle.org/en/Embedded_Answers_(Cloze)_question_type; how Moodle finds the parts:
question/type/multianswer/questiontype.php (ANSWER_REGEX, qtype_multianswer_extract_question); how it reads numbers:
question/type/numerical/questiontype.php (qtype_numerical_answer_processor::apply_units).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.parsers import expat

_START = re.compile(
    r"\{([0-9]*):((?:NUMERICAL|NM)|(?:MULTICHOICE|MC)(?:_?V|_?H|_?S|_?VS|_?HS)?|(?:SHORTANSWER|SA|MW)(?:_?C)?|"
    r"(?:MULTIRESPONSE|MR)(?:_?H|_?S|_?HS)?):"
)
_NUMBER = r"-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?"
_VALUE = re.compile(rf"({_NUMBER})(?::({_NUMBER}))?")
_PLACE = re.compile(r"\{#(\d+)\}")


@dataclass(frozen=True)
class Numerical:
    """A part: its weight, and right values with their tolerances."""

    weight: int
    right: tuple[tuple[float, float], ...]

    def accepts(self, value: float) -> bool:
        return any(abs(value - middle) <= tolerance * (1 + 1e-9) for middle, tolerance in self.right)


def read_cloze(html: str) -> list[Numerical]:
    """All parts of a text; every one has to be numerical, with right answers only and without feedback."""
    assert not _PLACE.search(html), "Moodle would put a part here"
    parts, at = [], 0
    while match := _START.search(html, at):
        assert match[2] in {"NUMERICAL", "NM"}, match[0]
        inside, at = _until_brace(html, match.end())
        right = []
        for one in inside.split("~"):
            assert one.startswith("="), one
            value = _VALUE.fullmatch(one[1:])
            assert value, one
            right.append((read_number(value[1]), read_number(value[2] or "0")))
        parts.append(Numerical(int(match[1] or "1"), tuple(right)))
    return parts


def _until_brace(html: str, start: int) -> tuple[str, int]:
    """What stands before the first closing brace that is not escaped, and the place after the brace."""
    end = start
    while html[end] != "}" or html[end - 1] == "\\":
        end += 1
    return html[start:end], end + 1


def read_number(text: str) -> float:
    """A number as Moodle reads it from a file, or from a student with an interface in English."""
    return float(text.replace(" ", "").replace(",", ""))


def read_texts(file: bytes) -> list[str]:
    """All texts as Moodle's importer keeps them (lib/xmlize.php): pieces of the parser that are but blanks are lost."""
    found: list[list[str]] = []
    inside = False

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal inside
        inside = name == "text"
        if inside:
            found.append([])

    def end(name: str) -> None:
        nonlocal inside
        inside = False

    def characters(piece: str) -> None:
        if inside and piece.strip():
            found[-1].append(piece)

    parser = expat.ParserCreate()
    parser.buffer_text = False
    parser.StartElementHandler, parser.EndElementHandler, parser.CharacterDataHandler = start, end, characters
    parser.Parse(file, True)
    return ["".join(pieces) for pieces in found]


def split_category(path: str) -> list[str]:
    """The names in a path of categories: single slashes separate, doubled ones are slashes of names."""
    return [name.replace("//", "/").strip() for name in re.split(r"(?<!/)/(?!/)", path)]
