"""What an exam file may ask in a problem: names, words for all of a kind, either of them form by form."""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.roster import numbered
from variantgen.families.asking import read_ask
from variantgen.outputs.formats import read_exam

HEAD = 'title = "Quiz"\nlanguage = "en"\n[[problem]]\n'


def exam(folder: Path, problem: str) -> Exam:
    path = folder / "exam.toml"
    path.write_text(HEAD + problem, "utf-8")
    return read_exam(path)


def asked(found: Exam) -> dict[str, list[str]]:
    """The names of what is asked, by family and form."""
    task = found.tasks[0]
    return {
        f"{family.name} {form.name}".strip(): [quantity.name for quantity in read_ask(form, task.ask)]
        for family in task.families
        for form in family.forms.values()
    }


def refused(folder: Path, problem: str) -> str:
    with pytest.raises(InputError) as error:
        exam(folder, problem)
    return str(error.value)


# The lists are those of the families' files, divided by hand.
@pytest.mark.parametrize(
    ("ask", "names"),
    [
        ('"velocities"', ["v_B", "omega_AB", "omega_BC"]),
        ('"accelerations"', ["a_B", "epsilon_AB", "epsilon_BC"]),
        ('"all"', ["v_B", "omega_AB", "omega_BC", "a_B", "epsilon_AB", "epsilon_BC"]),
        ('["velocities", "a_B.x"]', ["v_B", "omega_AB", "omega_BC", "a_B.x"]),
        ('["omega_BC", "velocities"]', ["omega_BC", "v_B", "omega_AB"]),
        ('["velocities", "v_B"]', ["v_B", "omega_AB", "omega_BC"]),
        ('"v_B"', ["v_B"]),
        ('{ crank = "velocities" }', ["v_B", "omega_AB", "omega_BC"]),
        ('{ crank = ["a_B", "v_B"] }', ["a_B", "v_B"]),
    ],
)
def test_words_and_names(ask: str, names: list[str], tmp_path: Path) -> None:
    assert asked(exam(tmp_path, f'family = "four_bar"\nform = "crank"\nask = {ask}\n')) == {"four_bar crank": names}


def test_a_word_fits_every_family_of_a_pool(tmp_path: Path) -> None:
    found = asked(exam(tmp_path, 'families = ["spool", "rolling_wheel", "four_bar"]\nask = "velocities"\n'))
    assert found == {
        "spool": ["v_O", "omega_spool", "v_A"],
        "rolling_wheel": ["omega_wheel", "v_A", "v_M"],
        "four_bar crank": ["v_B", "omega_AB", "omega_BC"],
        "four_bar rocker": ["v_A", "omega_AB", "omega_OA"],
        "four_bar directions": ["v_B", "omega_AB", "omega_BC"],
    }


def test_each_form_by_itself(tmp_path: Path) -> None:
    ask = '{ central = ["v_B"], driven_by_slider = ["omega_OA", "omega_AB"] }'
    found = exam(tmp_path, f'family = "slider_crank"\nask = {ask}\n')
    assert asked(found) == {
        "slider_crank central": ["v_B"],
        "slider_crank offset": ["v_B", "omega_AB", "a_B", "epsilon_AB"],
        "slider_crank driven_by_slider": ["omega_OA", "omega_AB"],
    }
    sheets = drawn_sheets(replace(found, seed="7"), numbered(12))
    for item in (sheet.items[0] for sheet in sheets):
        names = [answer.quantity.name for answer in item.answers]
        assert names == asked(found)[f"slider_crank {item.variant.form.name}"]
    assert len({sheet.items[0].variant.form.name for sheet in sheets}) == 3


def test_a_quantity_that_is_given_in_one_form_names_the_others(tmp_path: Path) -> None:
    message = refused(tmp_path, 'family = "slider_crank"\nask = ["v_B"]\n')
    assert "problem[1].ask[1]: is given, so it cannot be asked in the form driven_by_slider (got v_B)" in message
    assert 'choose  form = "central" or "offset"' in message
    assert 'ask = { central = ["v_B"] }' in message
    assert "remove it" not in message


def test_forms_are_named_that_the_exam_has_left_out(tmp_path: Path) -> None:
    message = refused(tmp_path, 'family = "slider_crank"\nform = "driven_by_slider"\nask = ["v_B"]\n')
    assert 'choose  form = "central" or "offset"' in message


def test_an_answer_that_no_form_has(tmp_path: Path) -> None:
    message = refused(tmp_path, 'family = "slider_crank"\nask = ["v_Q"]\n')
    assert "problem[1].ask[1]: unknown quantity (got v_Q)" in message
    assert "choose" not in message


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        ('family = "slider_crank"\nask = { centrl = ["v_B"] }', ["problem[1].ask.centrl: unknown form", "central"]),
        ('family = "spool"\nask = { x = ["v_O"] }', ["problem[1].ask.x: unknown form", 'ask = ["v_B"]']),
        ('family = "four_bar"\nask = { crank = ["v_Q"] }', ["problem[1].ask.crank[1]: unknown quantity", "v_Q"]),
        ('family = "four_bar"\nask = { crank = 5 }', ["problem[1].ask.crank: expected a list of quantities"]),
        ('family = "four_bar"\nask = { crank = [] }', ["problem[1].ask.crank: expected at least one quantity"]),
        ('family = "four_bar"\nask = "velocites"', ["problem[1].ask[1]: unknown quantity", "velocities?"]),
        (
            'family = "triangle_plate"\nform = "scalene"\nask = "velocities"',
            ["problem[1].ask[1]: a problem like this asks for no velocities by itself", 'form = "velocities"'],
        ),
    ],
)
def test_mistakes(problem: str, said: list[str], tmp_path: Path) -> None:
    message = refused(tmp_path, f"{problem}\n")
    assert all(part in message for part in said), message
    assert str(tmp_path / "exam.toml") in message
