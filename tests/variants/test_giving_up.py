"""What cannot be met is noticed after a fixed number of attempts, whatever the machine and the size of the class."""

from __future__ import annotations

import json
import tracemalloc
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.allocation import DrawRequest, ProblemSampler
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.exam_file import parse_exam
from variantgen.exam.roster import numbered
from variantgen.families.family import Family
from variantgen.families.reading.load import load_family, parse_family
from variantgen.families.restrict import restrict
from variantgen.resources import catalog_dir
from variantgen.tables import read_toml
from variantgen.variants import attempts
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.draw import FamilySampler, draw
from variantgen.variants.screening import position_screens
from variantgen.variants.variant import parameter_arrays, solve_variants

KEYS = [("giving up", i) for i in range(100)]


def strict(name: str, form: str, ceiling: float) -> Family:
    family = restrict(load_family(name), None, None, (form,) if form else ())
    return replace(
        family,
        forms={n: replace(f, screens=replace(f.screens, ceiling=ceiling)) for n, f in family.forms.items()},
    )


def test_a_ceiling_that_nothing_meets_ends_after_some_thousand_judged_attempts() -> None:
    tally = RejectionCounts()
    with pytest.raises(InputError) as caught:
        draw(strict("four_bar", "crank", 0.004), None, KEYS, tally, AnswerTolerances())
    text = str(caught.value)
    assert "rounding by hand within the ceiling" in text
    assert "raise the ceiling of its screens (0.004)" in text
    assert 1000 < sum(n for name, n in tally.rejected.items() if "rounding" in name or "mistakes" in name) < 4000
    assert tally.attempts < 20_000


def test_ranges_that_nothing_meets_cost_a_class_no_more_than_a_few_students() -> None:
    family = restrict(load_family("four_bar"), {"OA": 16, "AB": 30, "BC": 24, "OC": 100}, None, ["crank"])
    alone, together = RejectionCounts(), RejectionCounts()
    for keys, tally in ((KEYS[:1], alone), (KEYS, together)):
        with pytest.raises(InputError, match=r"OA \+ OC < AB \+ BC"):
            draw(family, None, keys, tally)
    assert alone.attempts < 2 * attempts.MAX_ATTEMPTS
    assert together.attempts < 10 * attempts.MAX_ATTEMPTS


def test_what_was_rejected_is_forgotten() -> None:
    answer_tolerances = AnswerTolerances()
    found = draw(strict("guided_plate", "", 0.02), None, KEYS[:20], screening=answer_tolerances)
    assert len(answer_tolerances._errors) <= 5 * len(found)  # accepted ones, and those that came too late
    answer_tolerances.forget()
    assert not answer_tolerances._errors
    assert not answer_tolerances._marks


@pytest.mark.parametrize(
    ("family", "low", "students"), [("four_bar", "0.004", 100), ("guided_plate", "0.0001", 20)], ids=["bar", "plate"]
)
def test_an_exam_with_an_impossible_tolerance_says_so(
    family: str, low: str, students: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(
        f'title = "T"\nlanguage = "en"\ntolerance = {{ floor = {low}, ceiling = {low} }}\n'
        f'[[problem]]\nfamily = "{family}"\n',
        "utf-8",
    )
    out = tmp_path / "out"
    assert main(["build", str(exam), "--variants", str(students), "--out", str(out)]) == 2
    said = capsys.readouterr().err
    assert "tolerance.ceiling" in said
    assert f"draws of problem 1 ({family})" in said
    assert "raise the ceiling, or leave it out" in said
    assert str(exam) in said
    assert not out.exists()


def test_the_draws_for_a_ceiling_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    text = (
        'title = "T"\nlanguage = "en"\ntolerance = { floor = 0.004, ceiling = 0.004 }\n'
        '[[problem]]\nfamily = "four_bar"\n'
    )
    exam = parse_exam(text, Path("exam.toml"), ())
    drawer, drawn = ProblemSampler(replace(exam, seed="1")), list[int]()
    after = FamilySampler.after

    def counted(self: FamilySampler, keys: list[tuple[object, ...]], done: list[int]) -> object:
        drawn.append(len(keys))
        return after(self, keys, done)

    monkeypatch.setattr(FamilySampler, "after", counted)
    with pytest.raises(InputError):
        drawer.variants([DrawRequest(student, 0) for student in numbered(100)])
    assert 200 < sum(drawn) <= 700


def test_the_build_says_how_many_were_drawn_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    head = 'title = "T"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "four_bar"\n'
    exam.write_text(head, "utf-8")
    assert main(["build", str(exam), "--variants", "20", "--out", str(tmp_path / "free")]) == 0
    assert "drawn again for" not in capsys.readouterr().err
    exam.write_text(f"tolerance = {{ ceiling = 0.011 }}\n{head}", "utf-8")
    assert main(["build", str(exam), "--variants", "20", "--out", str(tmp_path / "cut")]) == 0
    said = capsys.readouterr().err
    free, cut = (json.loads((tmp_path / n / "manifest.json").read_text("utf-8"))["students"] for n in ("free", "cut"))
    data = [[s["problems"][0]["parameters"] for s in students] for students in (free, cut)]
    moved = sum(one != other for one, other in zip(*data, strict=True))
    assert moved > 0
    assert f"drawn again for tolerance.ceiling: {moved} problem" in said


def large(points: int) -> Family:
    """A crank with a long chain of points on a body: every pair of them has a distance."""
    path = catalog_dir() / "slider_crank" / "family.toml"
    content = read_toml(path)
    own = content["forms"]["central"]
    extra = {
        f"K{i}": {"fraction": {"start": "O", "end": "A", "part": Decimal(i) / (points + 1)}}
        for i in range(1, points + 1)
    }
    own["points"] = {**own.get("points", {}), **extra}
    return parse_family({**content, "forms": {"central": own}}, path)


def test_scenes_of_many_points_need_little_memory() -> None:
    family = large(180)
    form = family.forms["central"]
    variants = draw(restrict(load_family("slider_crank"), None, None, ("central",)), None, KEYS[:20])
    many = [replace(v, family=family, form=form) for v in variants for _ in range(40)]
    values = form.values(parameter_arrays(many))
    motion = solve_variants(many, 0)
    tracemalloc.start()
    found = position_screens(form, motion, values)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # 180 points have 16 000 pairs: 800 variants would have 200 MB of complex differences alone.
    assert peak < 100e6
    # Neighbours are at most a 180th of the crank apart, far below the spacing of hinges.
    assert not np.any(found["hinges apart"])


def test_attempts_of_large_scenes_are_made_in_small_batches(monkeypatch: pytest.MonkeyPatch) -> None:
    sizes = []
    promising = attempts.FormSampler._promising

    def measured(self: attempts.FormSampler, made: attempts.Attempts) -> attempts.Attempts:
        sizes.append(made.owner.size)
        return promising(self, made)

    monkeypatch.setattr(attempts.FormSampler, "_promising", measured)
    with pytest.raises(InputError, match="hinges apart"):
        draw(large(180), None, KEYS[:30])
    assert max(sizes) * 184 < 2_000_000
    assert sum(sizes) < 2 * attempts.MAX_ATTEMPTS + 20_000


def test_the_values_of_all_parameters_are_bounded() -> None:
    path = catalog_dir() / "slider_crank" / "family.toml"
    content = read_toml(path)
    many = {f"p{i}": {"unit": "cm", "from": 1, "to": 9000, "step": 1} for i in range(30)}
    with pytest.raises(InputError) as caught:
        parse_family({**content, "parameters": {**content["parameters"], **many}}, path)
    first, *_ = caught.value.problems
    assert first.message == "more than 50000 values of parameters together"
    assert first.key.endswith("parameters.p5")
    assert "larger steps" in first.remedy
