"""The kept samples of work are those of the catalogue as it is, and are used for nothing else.

After a change of a family or of a method: ``python -m variantgen.exam.work.work_samples`` makes them anew.
"""

from __future__ import annotations

from collections import Counter

import pytest

from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.work import work_samples
from variantgen.exam.work.kept_work import KEPT, WorkSample
from variantgen.exam.work.work_samples import kept_forms, kept_line, work_sample
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.variants.examined import examined

MADE_BY = "stale: run  python -m variantgen.exam.work.work_samples"
LINES = KEPT.read_text("utf-8").splitlines()[1:-1]
SOME = [
    "arc_yoke",
    "four_bar directions",
    "planetary_pair outside",
    "slotted_rocker rotating",
    "spool",
    "ladder oblique",
]


def test_each_form_of_the_catalogue_and_of_its_exams_has_its_samples() -> None:
    drawn: list[object] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(work_samples, "drawn_sample", lambda *a: drawn.append((a[0].name, a[1].name)))
        forms = kept_forms()
        for family, form, asked in forms:
            work_sample(family, form, asked, AnswerTolerances())
    assert not drawn, MADE_BY
    assert len(forms) == len(LINES), MADE_BY


@pytest.mark.parametrize("name", SOME)
def test_a_sample_drawn_anew_is_the_kept_one(name: str) -> None:
    family, form, asked = next(own for own in kept_forms() if f"{own[0].name} {own[1].name}".strip() == name)
    line = kept_line(family, form, asked)
    assert line in [kept.rstrip(",") for kept in LINES], MADE_BY


def test_what_differs_from_the_catalogue_is_sampled(monkeypatch: pytest.MonkeyPatch) -> None:
    new = WorkSample(Counter({(1, 0, 0): 48}), 48)
    monkeypatch.setattr(work_samples, "drawn_sample", lambda *a: new)
    family = restrict(load_family("slider_crank"), forms=("central",))
    form = family.forms["central"]
    usual = examined(form, read_ask(form))
    assert work_sample(family, form, usual, AnswerTolerances()) is not new
    narrow = restrict(family, ranges={"phi": [30, 60]})
    assert work_sample(narrow, narrow.forms["central"], usual, AnswerTolerances()) is new
    other_unit = restrict(family, units="mm")
    assert work_sample(other_unit, other_unit.forms["central"], usual, AnswerTolerances()) is new
    assert work_sample(family, form, usual[:1], AnswerTolerances()) is new
    assert work_sample(family, form, usual, AnswerTolerances(Tolerance(mistakes=False))) is new
