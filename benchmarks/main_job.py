"""Cost of the main job, measured side by side in one run; prints a table and writes it to a file.

    python benchmarks/main_job.py [--out FILE] [--students N]

Ratios within one run are meaningful, absolute times depend on the machine. References from the same kind of machine
(2 cores): R/exams needs 836 ms CPU per student for sheet and key of five four-bar problems; Typst alone typesets two
pages with five figures of 41 primitives in 9 ms; pylinkage with one object per variant solves a four-bar in 27 us, a
compiled closed form in 0.028 us.
"""

from __future__ import annotations

import argparse
import json
import platform
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from variantgen.exam.assembly import assemble
from variantgen.exam.blueprint import Exam, read_exam
from variantgen.exam.content import Content
from variantgen.exam.roster import numbered
from variantgen.mechanism.solve import solve
from variantgen.mechanism.structure import analyse
from variantgen.outputs.formats import STUDENTS_PER_PART
from variantgen.outputs.sheet_data import sheets_data
from variantgen.outputs.typesetter import typesetter

# Sheets and key; what solutions cost is measured by solutions.py.
_HEAD = 'title = "T"\nlanguage = "ru"\n[solutions]\ndepth = "none"\n'
FOUR_BARS = _HEAD + ('[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = ["v_B", "omega_AB", "omega_BC"]\n' * 5)
ALL_FIVE = _HEAD + "".join(
    f'[[problem]]\nfamily = "{name}"\n'
    for name in ("four_bar", "slider_crank", "sleeve_on_crank", "rolling_wheel", "spool")
)


def cpu(children: bool = False) -> float:
    """CPU seconds of this process or of its finished children."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN if children else resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def build_cost(exam: str, students: int, jobs: int, folder: Path) -> tuple[float, float]:
    """CPU and wall seconds of a whole build in a fresh process."""
    path = folder / "exam.toml"
    path.write_text(exam, "utf-8")
    out = folder / f"out-{time.perf_counter_ns()}"
    command = [sys.executable, "-m", "variantgen", "build", str(path), "--variants", str(students), "--out", str(out)]
    before, start = cpu(children=True), time.perf_counter()
    subprocess.run([*command, "--jobs", str(jobs)], check=True, capture_output=True)
    return cpu(children=True) - before, time.perf_counter() - start


def floor_cost(exam: str, students: int, folder: Path) -> float:
    """CPU seconds of the typesetting engine alone on the same sheets, in a fresh process (the engine remembers)."""
    path = folder / "exam.toml"
    path.write_text(exam, "utf-8")
    done = subprocess.run(
        [sys.executable, __file__, "--floor-of", str(path), "--students", str(students)],
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    return float(done.stdout)


def typeset_only(path: Path, students: int) -> float:
    """CPU seconds of typesetting the sheets of an exam, everything else being prepared."""
    plan: Exam = read_exam(path)
    sheets = assemble(plan, numbered(students), "0").sheets
    data = [
        sheets_data(Content(plan, sheets[i : i + STUDENTS_PER_PART])) for i in range(0, students, STUDENTS_PER_PART)
    ]
    with typesetter() as engine:
        before = cpu()
        for part in data:
            engine.compile("sheets.typ", part)
        return cpu() - before


def best(action: Callable[[], object], rounds: int) -> float:
    """Least wall seconds of several rounds."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)


def solver_rows(count: int = 10_000) -> list[tuple[str, float]]:
    """Microseconds per four-bar: this program by order, and the closed form of the textbooks in plain numpy."""
    from variantgen.families.load import load_family

    form = load_family("four_bar").forms["crank"]
    rng = np.random.default_rng(0)
    ranges = {"OA": (0.2, 0.3), "AB": (0.8, 1.0), "BC": (0.8, 1.0), "OC": (0.8, 1.0), "phi": (0.0, 6.28)}
    values = {name: rng.uniform(*span, count) for name, span in ranges.items()}
    rates = {"omega_OA": rng.uniform(1, 3, count), "epsilon_OA": rng.uniform(-3, 3, count)}
    signs = {"sense": np.ones(count), "side": np.ones(count)}
    scene = form.scene(form.values({**values, **rates, **signs}))
    plan = analyse(scene)
    rows = []
    for order, name in enumerate(("positions", "and velocities", "and accelerations")):
        rows.append((f"variantgen, {name}", best(lambda order=order: solve(scene, order, plan), 30)))
    rows.append(("plain numpy closed form, accelerations", best(lambda: closed_form(values, rates), 30)))
    return [(name, seconds / count * 1e6) for name, seconds in rows]


def closed_form(values: dict[str, np.ndarray], rates: dict[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """The four-bar by hand: law of cosines, two linear systems by Cramer's rule."""
    a, b, c, d, phi = (values[name] for name in ("OA", "AB", "BC", "OC", "phi"))
    w, e = rates["omega_OA"], rates["epsilon_OA"]
    point = a * np.exp(1j * phi)
    diagonal = d - point
    length = np.abs(diagonal)
    angle = np.arccos((b**2 + length**2 - c**2) / (2 * b * length))
    coupler = b * diagonal / length * np.exp(1j * angle)
    rocker = point + coupler - d
    det = coupler.imag * rocker.real - coupler.real * rocker.imag
    v = 1j * w * point
    w2 = -(v.real * rocker.real + v.imag * rocker.imag) / -det
    w3 = (coupler.real * v.real + coupler.imag * v.imag) / det
    acceleration = (1j * e - w**2) * point - w2**2 * coupler + w3**2 * rocker
    e3 = (coupler.real * acceleration.real + coupler.imag * acceleration.imag) / det
    return w3, e3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("benchmarks/main_job.json"))
    parser.add_argument("--students", type=int, default=100)
    parser.add_argument("--floor-of", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.floor_of:
        print(typeset_only(options.floor_of, options.students))
        return
    n = options.students
    lines: list[tuple[str, float, str]] = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for title, exam in (("five four-bars, 3 answers each", FOUR_BARS), ("five families, all answers", ALL_FIVE)):
            used = min(build_cost(exam, n, 1, folder) for _ in range(3))
            floor = min(floor_cost(exam, n, folder) for _ in range(3))
            lines.append((f"build, {title}: CPU per student", used[0] / n * 1e3, "ms"))
            lines.append((f"build, {title}: typesetting the sheets alone", floor / n * 1e3, "ms"))
            lines.append((f"build, {title}: ratio", used[0] / floor, ""))
            wall = min(build_cost(exam, n, 2, folder)[1] for _ in range(3))
            lines.append((f"build, {title}: throughput of 2 processes over 1", used[1] / wall, ""))
        help_time = best(
            lambda: subprocess.run([sys.executable, "-m", "variantgen", "--help"], capture_output=True, check=True), 5
        )
        lines.append(("variantgen --help, wall", help_time * 1e3, "ms"))
    lines += [(f"10 000 four-bars: {title}, per variant", value, "us") for title, value in solver_rows()]
    width = max(len(title) for title, _, _ in lines)
    for title, value, measure in lines:
        print(f"{title:{width}}  {value:8.3f} {measure}")
    record = {
        "machine": platform.processor() or platform.machine(),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "students": n,
        "rows": [{"what": title, "value": round(value, 4), "unit": measure} for title, value, measure in lines],
    }
    options.out.write_text(json.dumps(record, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    main()
