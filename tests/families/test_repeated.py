"""A mistake that forms share is told once, under the key where it stands."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_files import scene_file
from tests.scene_texts import FREE_CRANK
from variantgen.errors import InputError, Problem
from variantgen.families.reading.load import read_family

FORM = '[forms.f%d]\ndrivers = [{ rotation = { body = "OA", omega = %d } }]\n'


def problems(folder: Path, text: str) -> list[Problem]:
    path = scene_file(folder, text)
    with pytest.raises(InputError) as caught:
        read_family(path)
    return list(caught.value.problems)


def test_seventeen_forms_with_one_mistake(tmp_path: Path) -> None:
    forms = "".join(FORM % (number, number) for number in range(1, 18))
    (found,) = problems(tmp_path, FREE_CRANK.replace('"O", "A"]', '"O", "X"]') + forms)
    assert (found.key, found.message, found.value) == ("bodies.OA", "unknown point", "X")


def test_a_mistake_of_some_forms_names_them(tmp_path: Path) -> None:
    """The family's body has a point that only the first of the forms has."""
    forms = "".join(FORM % (number, number) for number in range(1, 7))
    forms += '[forms.f1.points]\nX = { polar = { origin = "O", distance = 10, angle = 60 } }\n'
    (found,) = problems(tmp_path, FREE_CRANK.replace('"O", "A"]', '"O", "X"]') + forms)
    assert found.key == "bodies.OA"
    assert found.message == "unknown point, in the forms f2, f3, f4 and 2 more forms"


def test_copies_in_the_forms_themselves_are_one(tmp_path: Path) -> None:
    forms = "".join(FORM % (number, number) for number in range(1, 4)).replace('body = "OA"', 'body = "XY"')
    (found,) = problems(tmp_path, FREE_CRANK + forms)
    assert found.key == "forms.f1.drivers.rotation of XY"
    assert found.message == "unknown body, also in the forms f2, f3"


def test_mistakes_of_single_forms_keep_their_place(tmp_path: Path) -> None:
    forms = FORM % (1, 2) + (FORM % (2, 3)).replace("omega = 3", "omega = true")
    (found,) = problems(tmp_path, FREE_CRANK + forms)
    assert found.key == "forms.f2.drivers[1].rotation.omega"
