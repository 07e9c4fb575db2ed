"""Reference drawings: a figure that changes is looked at before its new transcript is accepted.

``python -m pytest tests/figure/test_references.py --renew`` writes the transcripts anew; the change is then read (and
the figures looked at) in the diff.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.figure.transcript import transcript
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.variants.draw import FamilySampler as Draws
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language

FOLDER = Path(__file__).parent / "references"
FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]
_NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*")
# Rounding of places to a tenth of u, of angles to a degree.
_TOLERANCE = 0.15
_ANGLE_TOLERANCE = 1.1


def drawn(name: str, form_name: str) -> str:
    family = load_family(name)
    form = family.forms[form_name]
    variants = Draws(replace(family, forms={form_name: form}), None).after([("reference", 0)], [0])
    asked = [parse_quantity(text, form.sample) for text in form.ask]
    return transcript(statement_figure(variants[0], solve_variants(variants, 0), 0, asked, load_language("ru")))


def same(line: str, other: str) -> bool:
    if _NUMBER.sub("#", line) != _NUMBER.sub("#", other):
        return False
    pairs = zip(_NUMBER.findall(line), _NUMBER.findall(other), strict=True)
    loose = _ANGLE_TOLERANCE if line.startswith("arc") else _TOLERANCE
    return all(abs(float(a) - float(b)) <= (_TOLERANCE if "." in a else loose) for a, b in pairs)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_figure_is_as_it_was_when_looked_at(name: str, form: str, request: pytest.FixtureRequest) -> None:
    path, now = FOLDER / f"{name}-{form}.txt", drawn(name, form)
    if request.config.getoption("--renew"):
        path.write_text(now, "utf-8")
    before = path.read_text("utf-8").splitlines()
    after = now.splitlines()
    changed = [(a, b) for a, b in zip(before, after, strict=False) if not same(a, b)]
    assert not changed
    assert len(before) == len(after)


def test_no_reference_is_left_over() -> None:
    assert {path.stem for path in FOLDER.glob("*.txt")} == {f"{name}-{form}" for name, form in FORMS}


def test_a_change_is_noticed() -> None:
    line = "arc mark 0.3 at 10.1,20.0 radius 8.0 from 5 over 90"
    assert same(line, "arc mark 0.3 at 10.2,20.0 radius 8.0 from 6 over 90")
    assert not same(line, "arc mark 0.3 at 10.5,20.0 radius 8.0 from 5 over 90")
    assert not same(line, "arc mark 0.3 dashed at 10.1,20.0 radius 8.0 from 5 over 90")
    assert not same("label A at 1.0,2.0", "label B at 1.0,2.0")
