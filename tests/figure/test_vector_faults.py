"""Arrows too short to be seen and names beside other arrows are found, also by the check of a family."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from variantgen.check import explained
from variantgen.check.report import Report
from variantgen.exam import solution_figures
from variantgen.figure.drawing import Drawing, Label, Layer
from variantgen.figure.inspection.faults import buried_heads, vector_faults
from variantgen.figure.sketch import Sketch
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Symbol


def arrow(start: complex, tip: complex) -> Drawing:
    """A drawing with one arrow whose head is 2.6 units long."""
    sketch = Sketch({}, 1.0)
    sketch.arrow(start, tip, Layer.SLIDER, head=2.6)
    return sketch.finish({})


@pytest.mark.parametrize(("length", "faulty"), [(5.0, True), (5.4, False), (12.0, False)])
def test_an_arrow_is_at_least_twice_its_head(length: float, faulty: bool) -> None:
    assert bool(vector_faults(arrow(0j, complex(length)))) == faulty


def test_the_head_of_an_arc_of_rotation_is_no_short_arrow() -> None:
    sketch = Sketch({}, 1.0)
    sketch.path((8 + 0j, 20 + 0j), Layer.VECTOR)
    sketch.arc_arrow(0j, 8.0, -1.0, 1.0)  # its head begins where the line does
    assert not vector_faults(sketch.finish({}))


def test_heads_on_what_belongs_to_other_points_are_found() -> None:
    def drawing(tip: complex) -> Drawing:
        sketch = Sketch({}, 1.0)
        sketch.circle(20 + 0j, 1.1, Layer.HINGE, fill="paper")
        for start, end in ((0j, tip), (0j, 12j), (10 + 20j, 30 + 20j)):
            sketch.arrow(start, end, Layer.SLIDER)
        return sketch.finish({})

    for tip in (20.5 + 0j, 20 + 19.5j):  # on the hinge; on the arrow that begins elsewhere
        (found,) = buried_heads(drawing(tip).lines)
        assert abs(found[1] - found[0] - tip) < 1e-9
    for tip in (17 + 0j, 20 + 17j, 1 + 11j):  # before both; beside an arrow of the same point
        assert not buried_heads(drawing(tip).lines)


def test_a_name_nearer_to_another_arrow_is_misread() -> None:
    own, other = (0j, 20 + 0j), (10j, 20 + 10j)
    size = (3.0, 3.0)
    near_other = Label(Symbol("v"), 10 + 8j, size, arrow=own)
    its = Label(Symbol("u"), 10 + 13j, size, arrow=other)
    found = vector_faults(replace(arrow(*own), labels=(near_other, its)))
    assert found == ["the label v stands nearer to another arrow than to its own"]
    assert not vector_faults(replace(arrow(*own), labels=(near_other._replace(at=10 + 3j), its)))


def test_a_centre_outside_the_figure_is_a_fault() -> None:
    (found,) = vector_faults(replace(arrow(0j, 20 + 0j), beyond=(Symbol("P"),)))
    assert "P lies outside" in found


def test_the_check_names_the_figure_and_its_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    variant = one_variant("spool", seed="1")
    asked = asked_quantities(variant)
    motion = solve_variants([variant], 2)
    report = Report("spool")
    explained.check_explained(variant, motion, asked, report)
    assert not report.failures
    monkeypatch.setattr(solution_figures, "vector_faults", lambda drawing: ["an arrow is missing"])
    explained.check_explained(variant, motion, asked, report)
    assert any("velocity_centre:spool" in failure and "an arrow is missing" in failure for failure in report.failures)
