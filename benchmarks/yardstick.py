"""A yardstick for another machine: a document of the engine that has been measured beside R/exams there.

    python -m benchmarks.yardstick [FILE.pdf]     # measure it here; keep the document

R/exams was measured with the job of the first exam (sheet and key as PDF for each student, five four-bar problems,
three answers, a figure of 41 primitives) on a machine with two cores (AMD EPYC, Typst 0.15.0). On the same machine
Typst alone was measured on a document of 100 students, two pages each, with five problems in Russian and five figures
of 41 primitives. That document is not known letter by letter: the one below was written to its description and
fitted to the size of its PDF with and without figures. The ratio of the times of the two documents is taken for the
ratio of the machines.
"""

from __future__ import annotations

import json
import math
import os
import random
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks import processes
from benchmarks.measure import Table

STUDENTS = 100
PROBLEMS, PRIMITIVES = 5, 41


@dataclass(frozen=True)
class Mark:
    """The document for a hundred students: CPU and wall with one thread, wall with all threads (s), PDF (MB).

    The same without figures: CPU with one thread and PDF.
    """

    cpu: float
    wall: float
    threaded_wall: float
    pdf: float
    plain_cpu: float
    plain_pdf: float


# Medians; noise 2 to 7 %. The 9 ms per student that are quoted for Typst are its wall time with two threads. The CPU
# without figures, 0.80 s, was measured with two threads, where that of the whole document was 1.32 s.
THERE = Mark(cpu=1.31, wall=1.25, threaded_wall=0.91, pdf=4.50, plain_cpu=1.31 * 0.80 / 1.32, plain_pdf=3.27)

# R/exams per student: wall of a single process, and the user part of its CPU (R 4.2 s, TeX 33.5 s for 50 students).
R_EXAMS_WALL, R_EXAMS_USER = 0.836, (4.2 + 33.5) / 50

_HEAD = """\
#set page(paper: "a4", margin: (x: 18mm, y: 10mm))
#set text(font: ("New Computer Modern", "New Computer Modern Math"), size: 10pt, lang: "ru")
#set par(justify: true)
#show math.equation: set text(font: ("New Computer Modern Math", "New Computer Modern"))
#let ink = 0.5pt + black
#let dash = (paint: black, thickness: 0.35pt, dash: "dashed")
"""


def markup(students: int, figures: bool = True) -> str:
    """The document."""
    return _HEAD + "\n#pagebreak()\n".join(_pages(number, figures) for number in range(students)) + "\n"


def _pages(student: int, figures: bool) -> str:
    chance = random.Random(student)
    parts = [
        "= Кинематика плоского движения",
        f"Студент {student + 1:03}, группа {student % 4 + 1} #h(1fr) вариант {chance.randrange(10**6):06}",
    ]
    for number in range(1, PROBLEMS + 1):
        a, b, c, d = (chance.randrange(*span) for span in ((16, 30), (60, 80), (55, 70), (60, 80)))
        phi, w = chance.randrange(30, 150, 5), chance.randrange(2, 12) / 2
        parts += [f"== Задача {number}", _text(a, b, c, d, phi, w)]
        if figures:
            parts.append(_figure(a, b, c, d, math.radians(phi)))
        elif number == 3:
            # Two pages for each student, with figures or without.
            parts.append("#pagebreak()")
    return "\n\n".join(parts)


def _text(a: int, b: int, c: int, d: int, phi: int, w: float) -> str:
    rate = f"{w:.1f}".replace(".", ",")
    return f"""\
Кривошип $O A$ шарнирного четырёхзвенника $O A B C$ вращается вокруг неподвижной оси $O$ с угловой скоростью
$omega_(O A) = {rate} space upright("рад/с")$. Длины звеньев: $O A = {a} space upright("см")$,
$A B = {b} space upright("см")$, $B C = {c} space upright("см")$, расстояние между неподвижными осями
$O C = {d} space upright("см")$. Для положения механизма, в котором $phi = {phi} degree$, найти угловую скорость
шатуна $omega_(A B)$, угловую скорость коромысла $omega_(B C)$ и скорость точки $B$.

Положительным считается вращение против хода часовой стрелки. Ответы записать с тремя значащими цифрами:
$omega_(A B)$ в $upright("рад/с")$, $omega_(B C)$ в $upright("рад/с")$, $v_B$ в $upright("см/с")$. Построить план
скоростей и указать на рисунке мгновенный центр скоростей шатуна.

Ответы: $omega_(A B) = $ #h(2cm), $omega_(B C) = $ #h(2cm), $v_B = $ #h(2cm)."""


def _figure(a: float, b: float, c: float, d: float, phi: float) -> str:
    """A four-bar of 41 native primitives, in millimetres, y down."""
    place_a = complex(a * math.cos(phi), a * math.sin(phi))
    diagonal = d - place_a
    turn = math.acos((b * b + abs(diagonal) ** 2 - c * c) / (2 * b * abs(diagonal)))
    place_b = place_a + b * diagonal / abs(diagonal) * complex(math.cos(turn), math.sin(turn))
    scale = 0.5
    o, p, q, r = (complex(12, 34) + scale * z.conjugate() for z in (0j, place_a, place_b, complex(d)))
    drawn = [_line(*ends, "2pt + black") for ends in ((o, p), (p, q), (q, r))]
    drawn.append(_line(o, r, "dash"))
    for foot in (o, r):
        drawn.append(_polygon((foot, foot + 3 + 4j, foot - 3 + 4j)))
        drawn.append(_line(foot + 4j - 5, foot + 4j + 5, "ink"))
        drawn += [_line(foot + 4j + x, foot + 6j + x - 2, "0.35pt + black") for x in (-3.5, -2, -0.5, 1, 2.5, 4)]
    drawn += [_circle(z, 1.0) for z in (o, p, q, r)]
    tips = [o + 8 * complex(math.cos(t), -math.sin(t)) for t in (phi / 3, 2 * phi / 3, phi)]
    drawn += [_line(start, end, "dash") for start, end in ((o + 8, tips[0]), (tips[0], tips[1]), (tips[1], tips[2]))]
    drawn += [_line(p, p + 6 - 6j, "ink"), _polygon((p + 6 - 6j, p + 4 - 5j, p + 5 - 4j))]
    labels = (
        ("O", o - 4), ("A", p - 4 - 4j), ("B", q + 2 - 4j), ("C", r + 2), ("φ", o + 9 - 4j), ("ω", p + 5 - 9j)
    )  # fmt: skip
    drawn += [_label(*label) for label in labels]
    drawn += [_label(f"{value:.0f}", (z + y) / 2 + 1) for value, z, y in ((a, o, p), (b, p, q), (c, q, r), (d, o, r))]
    drawn += [_circle(complex(12, 34), 0.4), _circle(complex(12 + scale * d, 34), 0.4)]
    assert len(drawn) == PRIMITIVES, len(drawn)
    body = "\n".join(f"  {one}" for one in drawn)
    return f"#figure(box(width: 80mm, height: 41mm, {{\n{body}\n}}))"


def _at(z: complex) -> str:
    return f"dx: {z.real:.3f}mm, dy: {z.imag:.3f}mm"


def _point(z: complex) -> str:
    return f"({z.real:.3f}mm, {z.imag:.3f}mm)"


def _line(start: complex, end: complex, stroke: str) -> str:
    return f"place(top + left, line(start: {_point(start)}, end: {_point(end)}, stroke: {stroke}))"


def _circle(centre: complex, radius: float) -> str:
    corner = _at(centre - complex(radius, radius))
    return f"place(top + left, {corner}, circle(radius: {radius}mm, fill: white, stroke: ink))"


def _polygon(corners: Sequence[complex]) -> str:
    return f"place(top + left, polygon({', '.join(_point(z) for z in corners)}, fill: white, stroke: ink))"


def _label(text: str, at: complex) -> str:
    return f"place(top + left, {_at(at)}, [_{text}_])"


def compile_once(text: str, pdf: Path | None = None) -> dict[str, float]:
    """CPU and wall seconds of the engine on a document, and the PDF in MB."""
    import typst

    start, wall = time.process_time(), time.perf_counter()
    made = typst.compile(text.encode(), font_paths=[], ignore_system_fonts=True)
    found = {"cpu": time.process_time() - start, "wall": time.perf_counter() - wall, "pdf": len(made) / 1e6}
    if pdf:
        pdf.write_bytes(made)
    return found


def measure(students: int = STUDENTS) -> Mark:
    """The document for so many students in fresh processes, scaled to a hundred."""
    one = _in_process(students, True, one_thread=True)
    free = _in_process(students, True, one_thread=False)
    plain = _in_process(students, False, one_thread=True)
    part = STUDENTS / students
    numbers = (one["cpu"], one["wall"], free["wall"], one["pdf"], plain["cpu"], plain["pdf"])
    return Mark(*(part * number for number in numbers))


def _in_process(students: int, figures: bool, one_thread: bool) -> dict[str, float]:
    with tempfile.TemporaryDirectory() as name:
        result = Path(name) / "found.json"
        command = [sys.executable, "-m", "benchmarks.yardstick", "--", str(students), str(int(figures)), str(result)]
        processes.run(command, processes.environment(one_thread))
        found: dict[str, float] = json.loads(result.read_text("utf-8"))
        return found


def least(marks: Sequence[Mark]) -> Mark:
    """The least of several rounds."""
    return Mark(*(min(column) for column in zip(*(vars(mark).values() for mark in marks), strict=True)))


def table(mark: Mark) -> Table:
    """The document there and here."""
    found = Table(
        "The yardstick: Typst on 100 students, two pages and five figures of 41 primitives each",
        ("what", "there", "here", "here / there"),
        "There: Typst 0.15.0 on the machine on which R/exams was measured (medians). The size of the PDF and the share "
        "without figures say how alike the two documents are.",
    )
    for what, there, here in (
        ("CPU, one thread, s", THERE.cpu, mark.cpu),
        ("wall, one thread, s", THERE.wall, mark.wall),
        (f"wall, threads on all cores (2 there, {os.cpu_count()} here), s", THERE.threaded_wall, mark.threaded_wall),
        ("PDF, MB", THERE.pdf, mark.pdf),
        ("PDF without figures, MB", THERE.plain_pdf, mark.plain_pdf),
        ("share of CPU without figures", THERE.plain_cpu / THERE.cpu, mark.plain_cpu / mark.cpu),
    ):
        found.add(what, there, here, here / there)
    return found


def comparison(mark: Mark, builds: Sequence[tuple[int, float]]) -> Table:
    """Times less CPU than R/exams, converted; ``builds`` are sizes of classes and CPU seconds per student here."""
    found = Table(
        "Times less than R/exams (converted by the yardstick)",
        ("students", "CPU per student here, ms", "R/exams by wall, converted, ms", "times less",
         "R/exams by user CPU, converted, ms", "times less than that"),
        "R/exams (one process, R and pdfLaTeX, sheet and key for each student) took 836 ms of wall per student there. "
        "Of its CPU the user part is known, 754 ms: the whole lies between. Both are converted by the ratio of the "
        f"yardstick's CPU with one thread, {mark.cpu / THERE.cpu:.3f}. R/exams has not been run on this machine.",
    )  # fmt: skip
    for students, seconds in builds:
        wall, user = (1e3 * there * mark.cpu / THERE.cpu for there in (R_EXAMS_WALL, R_EXAMS_USER))
        found.add(students, 1e3 * seconds, wall, wall / (1e3 * seconds), user, user / (1e3 * seconds))
    return found


def main(arguments: Sequence[str]) -> None:
    """Measure here, or do the work of a measured process."""
    if arguments[:1] == ["--"]:
        _, students, figures, result = arguments
        Path(result).write_text(json.dumps(compile_once(markup(int(students), figures == "1"))), "utf-8")
        return
    for path in map(Path, arguments):
        compile_once(markup(STUDENTS), path)
    print(table(least([measure() for _ in range(3)])).markdown())


if __name__ == "__main__":
    main(sys.argv[1:])
