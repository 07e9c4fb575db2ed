"""What is known of a form: remembered in its process, shared by problems that are alike."""

from __future__ import annotations

import pickle

from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict


def test_what_a_form_remembers_stays_in_its_process() -> None:
    form = restrict(load_family("four_bar")).forms["crank"]
    read_ask(form)
    assert form.remembered
    again = pickle.loads(pickle.dumps(form))
    assert not again.remembered
    assert again.parameters == form.parameters


def test_the_same_wish_gives_the_same_family() -> None:
    family = load_family("four_bar")
    wished = restrict(family, {"OA": 30}, {"phi": [30, 60]})
    assert restrict(family, {"OA": 30}, {"phi": [30, 60]}) is wished
    assert restrict(family, {"OA": 30}, {"phi": [30, 55]}) is not wished
    assert restrict(family, {"OA": 30}, {"phi": [30, 60]}, ("crank",)) is not wished
