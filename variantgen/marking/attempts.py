"""Reports of attempts from Moodle (quiz, Responses) and Canvas (quiz, Student Analysis) as answers that were handed in.

Both name a question by its text, in which stands whose sheet it is from and which problem
(:mod:`variantgen.outputs.platforms.reference`). Moodle has a column with the text of each question beside the one with
the response, ``part 1: 47.5; part 2: -0.54``; Canvas has the text in the head of the column with the answer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from msgspec import Struct

from variantgen.exam.roster.columns import cell_of
from variantgen.outputs.platforms.reference import Reference, reference_in

_NUMBERED = re.compile(r"(\D+?)\s*(\d{1,3})")
_PART = re.compile(r"(?:^|;\s)[^\d;]{1,30}?(\d{1,3}):(?:\s|$)")
NO_TEXTS = (
    "the report has responses without the texts of the questions, so that nobody can tell whose variant was drawn",
    "download the report again with  question text  ticked in its options",
)

Kind = Callable[[str], str]  # what a column holds, by the word in its head


class Attempted(Struct, frozen=True):
    """An answer of a report: the question it was asked by, a quantity or the place in a problem, what was written.

    ``question`` is None where the program has not made it, ``quantity`` '' where a response has no parts.
    """

    question: Reference | None
    quantity: str | int
    text: str


class AttemptReport(Struct, frozen=True):
    """The columns of a report: who a row is about, and how its answers are read."""

    who: Mapping[str, int]
    questions: Sequence[tuple[int, int]]  # Moodle: text and response
    answers: Mapping[int, Reference]  # Canvas

    def student(self, cells: Sequence[str]) -> tuple[str, ...]:
        """The id and the name in a row, whose parts may stand in any order."""
        found = {kind: cell_of(cells, place) for kind, place in self.who.items()}
        name = found.get("name") or " ".join(filter(None, (found.get("surname"), found.get("first"))))
        return tuple(filter(None, (found.get("id"), name)))

    def attempted(self, cells: Sequence[str]) -> Iterator[Attempted]:
        """The answers of a row."""
        for column, question in self.answers.items():
            if text := cell_of(cells, column):
                yield Attempted(question, question.quantity, text)
        for asked, response in self.questions:
            text, where = cell_of(cells, response), reference_in(cell_of(cells, asked))
            if where is None or (text.strip("-") and not parts(text)):
                yield Attempted(where, "", text.strip("-"))
            else:
                yield from (Attempted(where, place, part) for place, part in enumerate(parts(text)) if part)


def report_of(heads: Sequence[str], kind: Kind) -> AttemptReport | None:
    """The report that a row of heads belongs to; None for other tables, and for one of Moodle without texts."""
    answers = {column: found for column, head in enumerate(heads) if (found := reference_in(head)) and found.quantity}
    words = [_numbered(head, kind) for head in heads]
    responses = {number: column for column, (word, number) in enumerate(words) if word == "response"}
    texts = {number: column for column, (word, number) in enumerate(words) if word == "question"}
    questions = [(texts[number], column) for number, column in responses.items() if number in texts]
    if not answers and not questions:
        return None
    kinds = [
        "id" if head.casefold() == "sis_id" else "" if answers and kind(head) == "id" else kind(head) for head in heads
    ]
    return AttemptReport(
        {name: kinds.index(name) for name in ("id", "name", "surname", "first") if name in kinds}, questions, answers
    )


def lacks_texts(heads: Sequence[str], kind: Kind) -> bool:
    """Whether a row of heads is that of Moodle's report without the texts of the questions."""
    words = {word for word, _ in (_numbered(head, kind) for head in heads)}
    return "response" in words and "question" not in words


def parts(text: str) -> list[str]:
    """The parts of a response ``part 1: 47.5; part 2: -0.54``, '' for one that is blank."""
    found = list(_PART.finditer(text))
    if not found or [int(part[1]) for part in found] != list(range(1, len(found) + 1)):
        return []
    ends = [*(part.start() for part in found[1:]), len(text)]
    return [text[part.end() : end].strip() for part, end in zip(found, ends, strict=True)]


def _numbered(head: str, kind: Kind) -> tuple[str, str]:
    """A head like ``Response 1`` as what it is about, and the number."""
    found = _NUMBERED.fullmatch(head.strip())
    word = kind(found[1]) if found else ""
    return {"problem": "question", "answer": "response"}.get(word, ""), found[2] if found else ""
