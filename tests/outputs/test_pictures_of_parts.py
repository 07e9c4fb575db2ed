"""Figures of parts of a solution: all of a kind, one by its number, vectors to one scale."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.figure.reading import arrows
from variantgen.cli.app import main
from variantgen.errors import InputError
from variantgen.figure.drawing import Layer
from variantgen.outputs.single.picture import picture, pictures
from variantgen.single import one_variant
from variantgen.wording.formula import to_plain

WHEEL = one_variant("rolling_wheel", seed="135")  # accelerations of two points: two equations


def named(drawing: object) -> set[str]:
    return {to_plain(label.formula) for label in drawing.labels}  # type: ignore[attr-defined]


def test_all_figures_of_a_kind_or_one_of_them() -> None:
    found = pictures(WHEEL, "acceleration_equation")
    assert len(found) == 2
    assert named(found[0].drawing) != named(found[1].drawing)
    assert pictures(WHEEL, "acceleration_equation:2")[0].svg == found[1].svg
    assert picture(WHEEL, "acceleration_equation").svg == found[0].svg


@pytest.mark.parametrize("view", ["acceleration_equation:3", "statement:2", "rate_chain"])
def test_a_figure_that_there_is_not(view: str) -> None:
    with pytest.raises(InputError, match="view"):
        pictures(WHEEL, view)


def test_a_method_changes_the_figures() -> None:
    variant = one_variant("four_bar", form="crank", seed="7")
    assert len(pictures(variant, "rate_chain", methods=["three_rates"])) == 1
    with pytest.raises(InputError):
        pictures(variant, "velocity_centre", methods=["three_rates"])


def test_show_writes_a_file_for_each(tmp_path: Path) -> None:
    common = ["show", "rolling_wheel", "--seed", "135", "--view"]
    assert main([*common, "acceleration_equation", "--figure", str(tmp_path / "a.svg")]) == 0
    assert {path.name for path in tmp_path.iterdir()} == {"a-1.svg", "a-2.svg"}
    assert main([*common, "acceleration_equation:2", "--figure", str(tmp_path / "b.svg")]) == 0
    assert (tmp_path / "b.svg").read_bytes() == (tmp_path / "a-2.svg").read_bytes()


def test_true_scale_keeps_the_ratio_of_all_vectors() -> None:
    """At the end A of the horizontal diameter: a_O and the normal part v_O^2/R along it, the tangential part a_O."""
    normal, tangential = WHEEL.si("v_O") ** 2 / WHEEL.si("R"), WHEEL.si("a_O")
    usual, true = (pictures(WHEEL, "acceleration_equation:1", true_scale=scale)[0].drawing for scale in (False, True))
    assert usual.lengthened
    assert not true.lengthened
    lengths = sorted(abs(tip - start) for start, tip in arrows(true, Layer.SLIDER))
    # A is behind: what speeds the wheel up points away from O there, against the normal part, or with it.
    sums = [abs(complex(normal + tangential, tangential)), abs(complex(normal - tangential, tangential))]
    expected = [sorted([normal, abs(tangential), abs(tangential), whole]) for whole in sums]
    ratios = [[length / lengths[0] for length in lengths], *([v / each[0] for v in each] for each in expected)]
    assert any(ratios[0] == pytest.approx(each, rel=1e-4) for each in ratios[1:])
