"""Scanned answers: how often filled pages are misread, how much a person has to look at, how long a page takes.

    python -m benchmarks.scanning [--pages N] [--seed N] [--show DIR]

Pages of a real build are filled in by a renderer of its own (:mod:`benchmarks.filled_pages`), scanned by one, and
read. A column is the minus, a digit, or the place of the decimal mark. It is misread silently if it was taken for
something else than what was meant and nobody is asked to look; that takes a mark if the answer was right and is no
longer read so. The key is used as the program uses it, without what follows from earlier answers. Prints Markdown and,
on the usual number of pages, writes it to ``benchmarks/scanning.md``.
"""

from __future__ import annotations

import argparse
import math
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pypdfium2
from PIL import Image

from benchmarks.filled_pages import SCANNERS, STYLES, Answered, Filled, fill
from benchmarks.measure import machine
from variantgen.cli import main as variantgen
from variantgen.exam import answer_page as page
from variantgen.exam.manifest import Manifest, read_manifest
from variantgen.marking.key import Key, is_right
from variantgen.marking.scan.confirming import Confirmed, confirmed
from variantgen.marking.scan.pages import ReadPage, read_page
from variantgen.marking.scan.pictures import pictures
from variantgen.marking.typed_number import read_number

HERE = Path(__file__).resolve()
PAGES = 600
EXAM = """title = "Plane motion"
course = "Theoretical mechanics"
language = "en"
seed = 7
[answers]
scan = true
[solutions]
depth = "none"
[[problem]]
family = "four_bar"
[[problem]]
family = "slider_crank"
form = "central"
[[problem]]
family = "sleeve_on_crank"
ask = ["v_B", "omega_BD", "v_rel_C"]
[[problem]]
family = "rolling_wheel"
[[problem]]
family = "spool"
ask = ["v_O", "omega_spool", "v_A", "a_O", "epsilon_spool"]
"""
_BASES = 12
_HIDDEN = "a corner covered"
_LIMITS = """The reader was tuned on other seeds (1, 2, 11, 12, 2026, 90417). A column for review is a doubtful one in
an answer that a person looks at; such an answer without doubtful columns counts as one. Pages with a
covered corner must not be read, and what is on them is not counted. Marks and scanners are simulated:
two thirds of the answers are right; of the bubbles beside those that are meant 0.12 % are filled in and
taken back; a page has three stray strokes on average. The table shows what rules and thresholds do, not
the rate on real paper.""".replace("\n", " ")
_ABOUT = (__doc__ or "").split("\n\n", 2)[2].split(" Prints")[0].replace("\n", " ").replace(":mod:", "")


@dataclass(frozen=True)
class Base:
    """A printed page: its grey levels at 300 dpi, the place of its student, its answers as (problem, place)."""

    image: Image.Image
    student: int
    answers: tuple[tuple[int, int], ...]


def printed(folder: Path) -> tuple[Manifest, list[Base]]:
    """A build with pages for answers, and those pages."""
    (folder / "exam.toml").write_text(EXAM, "utf-8")
    out = folder / "exam"
    assert variantgen(["build", str(folder / "exam.toml"), "--variants", str(_BASES), "--out", str(out)]) == 0
    record = read_manifest(out)
    document = pypdfium2.PdfDocument(out / "sheets.pdf")
    sheets = [i for i in range(len(document)) if "Fill" in (text := _text(document[i])) or "fill" in text]
    found = []
    pages = iter(sheets)
    for student, sheet in enumerate(record.sheets):
        every = [(p.number, k) for p in sheet.problems for k in range(len(p.answers))]
        for own in page.in_pages(every):
            image = document[next(pages)].render(scale=300 / 72, grayscale=True).to_pil().convert("L")
            found.append(Base(image, student, tuple(own)))
    return record, found


def _text(sheet: pypdfium2.PdfPage) -> str:
    text: str = sheet.get_textpage().get_text_bounded()
    return text


def meant(rng: np.random.Generator, value: float) -> Answered:
    """What a student answers: mostly the right number with three or four digits, or another one, or nothing."""
    kind = rng.random()
    if kind < 0.08:
        return Answered("")
    number = value
    if kind < 0.36:
        ways = [value * rng.uniform(0.3, 2.5), -value, value * 10.0 ** rng.integers(-1, 2), rng.uniform(-200, 200)]
        number = float(ways[int(rng.integers(len(ways)))])
    return Answered(_written(number, int(rng.integers(3, 5))))


def _written(number: float, digits: int) -> str:
    """A number with so many significant digits, as far as the boxes have room."""
    if number == 0 or abs(number) >= page.LARGEST:
        return "0"
    places = digits - 1 - math.floor(math.log10(abs(number)))
    places = max(0, min(places, page.DIGITS - max(1, math.floor(math.log10(abs(number))) + 1)))
    return f"{number:.{places}f}"


def filled_pages(record: Manifest, bases: list[Base], count: int, seed: int) -> Iterator[tuple[Base, Filled]]:
    """Pages filled in and scanned; each by its own random numbers."""
    key = Key(record)
    for number in range(count):
        rng = np.random.default_rng([seed, number])
        base = bases[int(rng.integers(len(bases)))]
        right = [key.answers(base.student, problem)[place] for problem, place in base.answers]
        yield base, fill(base.image, [meant(rng, answer.value) for answer in right], rng)


class Counts(Counter[str]):
    """What was counted, of all pages, of each style and of each way of scanning."""

    def add(self, what: str, filled: Filled, count: int = 1) -> None:
        """Count for the page and its kinds."""
        for kind in ("all", filled.style, filled.scanner, *([_HIDDEN] if filled.hidden is not None else [])):
            self[f"{kind}: {what}"] += count


def count_page(counts: Counts, key: Key, base: Base, filled: Filled, found: ReadPage | None) -> list[str]:
    """Compare what was read with what was meant; words for what went wrong."""
    counts.add("pages", filled)
    columns = page.READ_COLUMNS * len(filled.texts)
    if found is None or not found.answers:
        counts.add("pages not read", filled)
        return [f"page not read {filled.style} {filled.scanner}"]
    counts.add("columns", filled, columns)
    counts.add("answers", filled, len(filled.texts))
    wrong = []
    for (problem, place), text, read in zip(base.answers, filled.texts, found.answers, strict=True):
        answer = key.answers(base.student, problem)[place]

        def right(text: str, answer=answer) -> bool:
            number = read_number(text)
            return number is not None and any(is_right(answer, value) for value in number.values)

        result: Confirmed = confirmed(read, right)
        if result.why:
            counts.add("answers to review", filled)
            counts.add("columns to review", filled, max(1, read.doubtful))
            for why in result.why:
                counts.add(f"because of {why}", filled)
            continue
        if result.text == text:
            continue
        differ = sum(a != b for a, b in zip(_columns(result.text), _columns(text), strict=True))
        counts.add("silent", filled, max(differ, 1))
        takes = bool(text) and right(text) and not (result.text and right(result.text))
        if takes:
            counts.add("marks taken", filled)
        what = f"{text!r} read {result.text!r}, key {answer.value:.4g} {read.doubts}"
        wrong.append(f"{'MARK ' if takes else ''}{filled.style} {filled.scanner}: {what}")
    return wrong


def _columns(text: str) -> list[int | None]:
    return page.columns_of(text) if text else [None] * page.READ_COLUMNS


def measure(count: int, seed: int, show: Path | None = None) -> tuple[Counts, float]:
    """Count on so many pages; with the CPU seconds of a page."""
    counts, spent = Counts(), 0.0
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        record, bases = printed(folder)
        key = Key(record)
        for number, (base, filled) in enumerate(filled_pages(record, bases, count, seed)):
            path = folder / "scan.jpg"
            path.write_bytes(filled.jpeg)
            start = time.process_time()
            picture = next(iter(pictures(path)))
            found = read_page(picture, lambda _: len(base.answers))  # noqa: B023
            spent += time.process_time() - start
            wrong = count_page(counts, key, base, filled, found)
            for text in wrong:
                print(f"page {number}: {text}", flush=True)
            if show is not None and (wrong or number < 6):
                (show / f"{seed}-{number}.jpg").write_bytes(filled.jpeg)
    return counts, spent / count


def table(counts: Counts, spent: float) -> Iterator[str]:
    """The rows of the table."""
    yield (
        "| pages | read | columns | columns misread silently | answers with a mark taken | columns for review, % "
        "| answers | answers for review, % |"
    )
    yield "|---" * 8 + "|"
    for kind in ("all", *STYLES, *SCANNERS, _HIDDEN):

        def of(what: str, kind: str = kind) -> int:
            return counts[f"{kind}: {what}"]

        if not of("pages"):
            continue
        yield (
            f"| {kind}: {of('pages')} | {of('pages') - of('pages not read')} | {of('columns')} | {of('silent')} "
            f"| {of('marks taken')} | {100 * of('columns to review') / max(of('columns'), 1):.2f} "
            f"| {of('answers')} | {100 * of('answers to review') / max(of('answers'), 1):.2f} |"
        )
    yield ""
    whys = {name: n for name, n in counts.items() if name.startswith("all: because of")}
    yield (
        "Why a person looks, answers (some for several reasons): "
        + ", ".join(f"{name[16:]} {n}" for name, n in sorted(whys.items()))
        + "."
    )
    yield ""
    processor = machine()["processor"]
    yield f"{1000 * spent:.0f} ms of CPU a page, from the JPEG file to the columns ({processor}, other work beside it)."


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--pages", type=int, default=PAGES)
    parser.add_argument("--seed", type=int, default=1000)
    parser.add_argument("--show", type=Path, help="folder for pictures of the first pages and of misread ones")
    arguments = parser.parse_args()
    if arguments.show:
        arguments.show.mkdir(exist_ok=True)
    counts, spent = measure(arguments.pages, arguments.seed, arguments.show)
    text = "\n".join(
        [
            "# Scanned answers",
            "",
            f"`python -m benchmarks.scanning --pages {arguments.pages} --seed {arguments.seed}`. {_ABOUT}",
            "",
            *table(counts, spent),
            "",
            _LIMITS,
        ]
    )
    print(text)
    if arguments.pages >= PAGES:
        (HERE.parent / "scanning.md").write_text(text + "\n", "utf-8")


if __name__ == "__main__":
    main()
