"""The answers of a class from its scans: every page is named that gives none, and nothing is guessed."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import closing
from pathlib import Path

import numpy as np
from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.exam import answer_page
from variantgen.marking.answer_tables import HandedIn, NotMatched
from variantgen.marking.key import Key, is_right
from variantgen.marking.scan.confirming import Confirmed, confirmed
from variantgen.marking.scan.copies import DIFFER, ScannedAnswer, decided
from variantgen.marking.scan.excerpts import answer_png, thumbnail_png
from variantgen.marking.scan.pages import PageCode, ReadPage, read_page
from variantgen.marking.scan.pictures import Grey, ScanImage, check_packages, pictures
from variantgen.marking.scan.registration import Placed
from variantgen.marking.typed_number import read_number
from variantgen.outputs.qr import VERSION

Question = tuple[int, int, str]  # the place of the student, the number of the problem, the name of the quantity

_BLANK_SHARE = 2e-4  # of dark pixels: what has fewer is the empty back of a page
_MISSING, _NOT_READ = "page missing", "page not read"


class LostPage(Struct, frozen=True):
    """A page that may have answers and could not be read, with a picture (PNG) of it where there is one."""

    where: str
    why: str
    picture: bytes = b""


class SeenPage(Struct, frozen=True):
    """A page for answers of a student whose code was read: where it is, and how it lies there.

    ``number`` is that of the page for answers, ``within`` that of the page within its file, from 1; ``asked`` are its
    answers in their order. A page that could not be read has no ``placed``, but ``why``.
    """

    path: Path
    within: int
    where: str
    number: int
    asked: tuple[Question, ...]
    placed: Placed | None = None
    why: str = ""


class Scans(Struct):
    """What the scans of a class hold, by question; ``lost`` are pages that a person should look at.

    ``pages`` are those of each student, by the place of the student.
    """

    answers: dict[Question, ScannedAnswer] = field(default_factory=dict)
    pages: dict[int, list[SeenPage]] = field(default_factory=dict)
    not_matched: list[NotMatched] = field(default_factory=list)
    lost: list[LostPage] = field(default_factory=list)

    @property
    def doubtful(self) -> dict[Question, ScannedAnswer]:
        """The answers that a person should look at."""
        return {asked: answer for asked, answer in self.answers.items() if answer.read.why}

    def handed_in(self, key: Key) -> list[HandedIn]:
        """The answers for :func:`variantgen.marking.marks.mark`; doubtful ones wait and are numbers for nobody."""
        return [
            HandedIn(
                answer.where,
                (key.record.sheets[place].code,),
                problem,
                name,
                f"? {answer.read.text}".strip() if answer.read.why else answer.read.text,
                waiting=bool(answer.read.why),
            )
            for (place, problem, name), answer in self.answers.items()
        ]


def collect(
    paths: Sequence[Path],
    key: Key,
    names: Mapping[Path, str] | None = None,
    tell: Callable[[Path, int], None] = lambda *_: None,
    opened: Callable[[Path], Generator[ScanImage]] = pictures,
) -> Scans:
    """Read the pages of some files; ``names`` are words for them where their own may name students.

    ``tell`` is called for each page that has been read, with its file and how many of that have been.
    ``opened`` gives the pages of a file one by one.

    Raises InputError for a file that cannot be opened, and ToolMissingError where a package is missing.
    """
    check_packages()
    class_ = _Class(key)
    for path in paths:
        name = path.name if names is None else names[path]
        with closing(opened(path)) as found:
            for number, picture in enumerate(found, start=1):
                class_.add(replace(picture, where=name + picture.where.removeprefix(path.name)), path, number)
                tell(path, number)
        class_.end_of_file(name)
    class_.end()
    return class_.scans


class _Class:
    """The pages of a class as they come."""

    def __init__(self, key: Key) -> None:
        self.key, self.scans = key, Scans()
        self._exam = key.record.exam_id.upper()
        self._sheets = {sheet.code: place for place, sheet in enumerate(key.record.sheets)}
        self._pages: dict[tuple[int, int], list[str]] = {}  # where each page was read
        self._not_read: dict[tuple[int, int], str] = {}  # where one was seen and could not be read
        self._readings: dict[Question, list[ScannedAnswer]] = {}
        self._left_out: dict[str, list[str]] = {}

    def add(self, picture: ScanImage, path: Path, within: int) -> None:
        """Read a page, the one of this number within its file."""
        found = read_page(picture, lambda code: len(self._asked(code)))
        if found.code is None:
            self._without_code(found, picture.grey)
            return
        code = found.code
        if why := self._foreign(code):
            self.scans.not_matched.append(NotMatched(found.where, code.sheet, why))
        elif not code.number:
            self._left_out.setdefault("pages of problems", []).append(found.where)
        else:
            place = self._sheets[code.sheet]
            asked = tuple(self._asked(code))
            seen = SeenPage(path, within, found.where, code.number, asked, found.placed, found.why)
            self.scans.pages.setdefault(place, []).append(seen)
            if found.why:
                self._not_read.setdefault((place, code.number), found.where)
                self._lose(found, picture.grey, self._page(place, code.number))
            else:
                self._take(found, code, picture.grey)

    def _asked(self, code: PageCode) -> list[Question]:
        """What a page asks; nothing for one that is not of this exam."""
        if self._foreign(code) or not code.number:
            return []
        place = self._sheets[code.sheet]
        return list(self._questions(place)[code.number - 1])

    def _questions(self, place: int) -> list[Sequence[Question]]:
        """What the pages of a student ask."""
        every = [
            (place, number, answer.quantity)
            for number, problem in self.key.places[place].items()
            for answer in problem.answers
        ]
        return answer_page.in_pages(every)

    def _foreign(self, code: PageCode) -> str:
        """Why a page is not of this exam; '' if it is."""
        if code.version != VERSION:
            return "a page of another version of the program"
        if code.exam_id != self._exam:
            return f"a page of another exam or build: {code.exam_id}, this one is {self._exam}"
        if code.sheet not in self._sheets:
            return "the exam has no sheet with this code"
        if code.number > len(self._questions(self._sheets[code.sheet])):
            return "the sheet has no such page for answers"
        return ""

    def _without_code(self, found: ReadPage, grey: Grey | None) -> None:
        if grey is not None and float((grey < 0.6 * np.median(grey)).mean()) < _BLANK_SHARE:
            self._left_out.setdefault("blank pages", []).append(found.where)
        else:
            self._lose(found, grey, "")

    def _lose(self, found: ReadPage, grey: Grey | None, text: str) -> None:
        remedy = "scan it again, or type its answers into a table"
        self.scans.not_matched.append(NotMatched(found.where, text, found.why, remedy))
        self.scans.lost.append(LostPage(found.where, found.why, b"" if grey is None else thumbnail_png(grey)))

    def _take(self, found: ReadPage, code: PageCode, grey: Grey | None) -> None:
        """Take the answers of a page; one that is there twice is decided about in the end."""
        place = self._sheets[code.sheet]
        self._pages.setdefault((place, code.number), []).append(found.where)
        assert found.placed is not None
        assert grey is not None
        for block, (asked, read) in enumerate(zip(self._asked(code), found.answers, strict=True)):
            _, problem, name = asked
            answer = next(a for a in self.key.answers(place, problem) if a.quantity.name == name)

            def right(text: str, answer: object = answer) -> bool:
                number = read_number(text)
                return number is not None and any(is_right(answer, value) for value in number.values)  # type: ignore[arg-type]

            result = confirmed(read, right)
            readings = self._readings.setdefault(asked, [])
            picture = answer_png(grey, found.placed, block) if result.why or readings else b""
            readings.append(ScannedAnswer(found.where, result, picture, read.others, read.seen))

    def end_of_file(self, name: str) -> None:
        """Say what was left out of a file."""
        for what, places in self._left_out.items():
            pages = [int(number) for where in places if (number := where.removeprefix(f"{name}, page ")).isdecimal()]
            why = f"without answers to read, left out: {what}, {len(places)}"
            self.scans.not_matched.append(NotMatched(name, "", f"{why}: page {_ranges(pages)}" if pages else why))
        self._left_out.clear()

    def end(self) -> None:
        """Decide about pages that were scanned more than once, and say which are missing."""
        for asked, readings in self._readings.items():
            self.scans.answers[asked] = decided(readings)
        for (place, number), (first, *again) in self._pages.items():
            own = [self.scans.answers[asked].read for asked in self._questions(place)[number - 1]]
            differing = sum(DIFFER in read.why for read in own)
            says = f"other answers, for review: {differing}" if differing else "the answers agree"
            for where in again:
                why = f"the page has been scanned before, {first}: {says}"
                self.scans.not_matched.append(NotMatched(where, self._page(place, number), why))
        seen = {place for place, _ in (*self._pages, *self._not_read)}
        for place in sorted(seen):
            for number, asked_ in enumerate(self._questions(place), start=1):
                if (place, number) not in self._pages:
                    self._wait(place, number, asked_)
        sheets = self.key.record.sheets
        if absent := [sheet.code for place, sheet in enumerate(sheets) if place not in seen]:
            why = f"no page for answers of {len(absent)} of {len(sheets)} sheets"
            self.scans.not_matched.append(NotMatched("scans", ", ".join(absent), why))

    def _page(self, place: int, number: int) -> str:
        return f"{self.key.record.sheets[place].code}, page {number}"

    def _wait(self, place: int, number: int, questions: Sequence[Question]) -> None:
        """Let the answers of a page that is missing or could not be read wait until somebody types them."""
        where, why = self._not_read.get((place, number), ""), _NOT_READ
        if not where:
            where, why = "scans", _MISSING
            message = f"page {number} of the pages for answers of this sheet is missing"
            self.scans.not_matched.append(NotMatched(where, self.key.record.sheets[place].code, message))
            self.scans.lost.append(LostPage(self._page(place, number), "the page is missing"))
        for asked in questions:
            self.scans.answers[asked] = ScannedAnswer(where, Confirmed("", (why,)))


def _ranges(numbers: Sequence[int]) -> str:
    """Numbers of pages in short: ``1-3, 7``."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)
