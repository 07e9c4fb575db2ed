"""The table ``[nice]``: what may be written in it, and what a family becomes by it."""

from __future__ import annotations

import tomllib
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

from variantgen.errors import InputError
from variantgen.families.family import Family
from variantgen.families.reading.load import load_family, parse_family
from variantgen.families.restrict import restrict
from variantgen.variants.draw import draw

CRANK = """
length_unit = "cm"
ask = ["v_A"]
[parameters]
OA = { unit = "cm", from = 10, to = 30, step = 1 }
AB = { unit = "cm", from = 10, to = 30, step = 1 }
phi = { unit = "deg", from = 25, to = 65, step = 5 }
psi = { unit = "deg", from = 20, to = 25, step = 5 }
rest = { unit = "deg", from = 5, to = 65, step = 5, silent = true }
omega = { unit = "rad/s", values = [1, 2, 3] }
sense = { choices = { left = 1, right = -1 } }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "phi" } }
B = { polar = { origin = "A", distance = "AB", angle = "phi + psi" } }
[bodies]
OA = ["O", "A", "B"]
[[joints]]
pivot = { point = "O" }
[[drivers]]
rotation = { body = "OA", omega = "sense * omega" }
"""


def family(nice: str = "") -> Family:
    return parse_family(tomllib.loads(CRANK + nice, parse_float=Decimal), Path("crank/family.toml"))


def grid(found: Family, name: str) -> list[float]:
    (form,) = found.forms.values()
    return [float(value) for value in form.parameters[name].printed]


def test_without_a_table_angles_are_the_usual_ones_and_answers_count() -> None:
    found = restrict(family(), nice=True)
    assert grid(found, "phi") == [30, 45, 60]
    assert grid(found, "psi") == [20, 25], "none of its values is usual: they stay"
    assert len(grid(found, "rest")) == 13, "what only varies the picture stays"
    assert len(grid(found, "OA")) == 21
    assert found.forms[""].friendly
    assert found.forms[""].ties is None


def test_without_nice_nothing_changes() -> None:
    table = '[nice]\nparameters = { phi = [30] }\ncolumns = ["OA", "AB"]\nrows = [[12, 16]]\nrequire = ["OA < AB"]\n'
    plain, said = family(), family(table)
    assert restrict(said).forms[""].parameters == plain.forms[""].parameters
    assert restrict(said).forms[""].screens == plain.forms[""].screens
    assert restrict(said).forms[""].ties is None
    assert not restrict(said).forms[""].friendly


def test_other_grids_and_comparisons() -> None:
    table = """[nice]
answers = false
require = ["OA < AB"]
[nice.parameters]
phi = [90, 22.5]
omega = { unit = "rpm", values = [30, 60] }
OA = { from = 3, to = 9, step = 3 }
sense = ["right"]
"""
    found = restrict(family(table), nice=True)
    assert grid(found, "phi") == [90, 22.5]
    assert grid(found, "OA") == [3, 6, 9]
    assert found.forms[""].parameters["sense"].words == ("right",)
    omega = found.forms[""].parameters["omega"]
    assert omega.unit is not None
    assert omega.unit.name == "rpm"
    assert omega.symbol == "omega"
    assert omega.si == pytest.approx([np.pi, 2 * np.pi])
    assert [item.text for item in found.forms[""].screens.require] == ["OA < AB"]
    assert not found.forms[""].friendly
    variant = draw(found, None, [("n", i) for i in range(20)])[7]
    assert variant.printed["OA"] < variant.printed["AB"]


ROWS = '[nice]\ncolumns = ["OA", "AB", "sense"]\nrows = [[12, 16, "left"], [15, 20, "left"], [12, 5, "right"]]\n'


def test_rows_are_drawn_whole() -> None:
    found = restrict(family(ROWS), nice=True)
    assert found.forms[""].grid_size == 3 * 3 * 2 * 3  # rows, phi, psi, omega
    drawn = draw(found, None, [("n", i) for i in range(200)])
    assert {(v.printed["OA"], v.printed["AB"], v.word("sense")) for v in drawn} == {
        (12, 16, "left"),
        (15, 20, "left"),
        (12, 5, "right"),
    }
    assert {v.printed["phi"] for v in drawn} == {30, 45, 60}


def test_fixed_values_and_ranges_choose_among_the_rows() -> None:
    found = restrict(family(ROWS), {"OA": 12}, {"AB": [6, 20]}, nice=True)
    drawn = draw(found, None, [("n", i) for i in range(20)])
    assert {(v.printed["OA"], v.printed["AB"]) for v in drawn} == {(12, 16)}
    with pytest.raises(InputError, match="no hand-friendly variant has these values") as caught:
        restrict(family(ROWS), {"OA": 13}, nice=True)
    assert "leave nice out, or leave one of OA, AB, sense free" in str(caught.value)


def test_forms_without_are_left_out() -> None:
    family = load_family("wheel_with_rod")
    assert set(restrict(family, nice=True).forms) == {"central", "offset"}
    with pytest.raises(InputError, match="has no hand-friendly variants") as caught:
        restrict(family, forms=["driven_by_slider"], nice=True)
    assert "wheel_with_rod (driven_by_slider)" in str(caught.value)
    assert "leave nice out, or take another form or family" in str(caught.value)
    # Of two forms with rows one has this length.
    assert set(restrict(load_family("slider_crank"), {"OA": 28}, nice=True).forms) == {"offset", "driven_by_slider"}


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("[nice]\nparameters = { OB = [1] }", ["nice.parameters.OB", "unknown parameter", "OA"]),
        ("[nice]\nparameters = { OA = [] }", ["nice.parameters.OA", "expected a list of numbers"]),
        ('[nice]\nparameters = { OA = ["1"] }', ["nice.parameters.OA", "expected a list of numbers"]),
        ("[nice]\nparameters = { OA = 3 }", ["nice.parameters.OA", "expected a table"]),
        ('[nice]\nparameters = { OA = { unit = "deg", values = [1] } }', ["nice.parameters.OA.unit", "length"]),
        ('[nice]\nparameters = { sense = ["up"] }', ["nice.parameters.sense", "unknown word"]),
        ("[nice]\nparameters = { sense = [1] }", ["nice.parameters.sense", "unknown word"]),
        ('[nice]\nrequire = ["OA < phi"]', ["nice.require[1]"]),
        ('[nice]\ncolumns = ["OA", "AC"]\nrows = [[1, 2]]', ["nice.columns", "AC", "AB"]),
        ('[nice]\ncolumns = ["OA", "rest"]\nrows = [[1, 2]]', ["nice.columns", "expected a printed parameter"]),
        ('[nice]\ncolumns = ["OA"]\nrows = [[1]]', ["nice.columns", "two or more"]),
        ('[nice]\ncolumns = ["OA", "OA"]\nrows = [[1, 1]]', ["nice.columns", "each once"]),
        ('[nice]\ncolumns = ["OA", "AB"]', ["nice.rows", "expected lists of 2 values"]),
        ('[nice]\ncolumns = ["OA", "AB"]\nrows = [[1, 2], [3]]', ["nice.rows", "expected lists of 2 values"]),
        ('[nice]\ncolumns = ["OA", "AB"]\nrows = [[1, [2]]]', ["nice.rows", "expected lists of 2 values"]),
        ('[nice]\ncolumns = ["OA", "AB"]\nrows = [[1, "2"]]', ["AB", "expected a list of numbers"]),
        ('[nice]\ncolumns = ["OA", "sense"]\nrows = [[1, "up"]]', ["sense", "unknown word"]),
        (
            '[nice]\nparameters = { OA = [1, 2] }\ncolumns = ["OA", "AB"]\nrows = [[3, 2]]',
            ["nice.rows", "is not on the grid of OA", "3"],
        ),
        ("[nice]\nrows = [[1, 2]]", ["nice.columns", "two or more"]),
        ("[nice]\nposible = false", ["nice.posible", "unknown key", "possible"]),
        ('[nice]\npossible = "no"', ["nice.possible", "true or false"]),
    ],
)
def test_mistakes_are_named(table: str, said: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        family(table)
    for word in said:
        assert word in str(caught.value), str(caught.value)
