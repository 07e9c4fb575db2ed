"""A method for groups is added by a module with two functions, an entry in one table, its name and its sentences."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from msgspec.structs import replace

from tests.methods.forms import tasks
from variantgen.errors import InputError
from variantgen.families import method_names
from variantgen.methods import choice
from variantgen.methods.by_groups.group_methods import GROUP_METHODS, GroupMethod
from variantgen.methods.choice import WHOLE, applicable, choose
from variantgen.methods.compose import solution
from variantgen.methods.groups.group import Dyad
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.step import Body
from variantgen.methods.vectors import pole
from variantgen.variants.attempts import VerificationError
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import written
from variantgen.wording.solution.phrases import cut, load_phrases
from variantgen.wording.solution.plain import plain_solution

NAME = "by_example"


def applies(book: Book, group: Dyad) -> bool:
    """Where the end of the link is on a circle: to four_bar, and not to slider_crank."""
    del book
    return not group.point_path.straight


def solve_dyad(book: Book, group: Dyad) -> None:
    """With a sentence of its own; the equation itself is that of the pole."""
    pole.solve_dyad(book, group)
    book.say(f"{NAME}.link", body=Body(group.body))


@pytest.fixture
def added(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    method = GroupMethod((1,), (f"{NAME}.",), {Dyad: (applies, solve_dyad)})
    monkeypatch.setitem(GROUP_METHODS, NAME, method)
    monkeypatch.setattr(method_names, "METHODS", (*method_names.METHODS, NAME))
    monkeypatch.setitem(load_phrases("en").sentences, f"{NAME}.link", cut("An example of {body}."))  # type: ignore[arg-type]
    choice._fitting.cache_clear()
    yield
    choice._fitting.cache_clear()


@pytest.mark.usefixtures("added")
def test_it_is_chosen_told_and_confirmed() -> None:
    assert method_names.check_methods([NAME]) == (NAME,)
    (task,) = tasks("four_bar", "crank", 1)
    assert NAME in applicable(task)
    assert choose(task, [NAME]).style.velocities == NAME
    assert choose(task, ["acceleration_pole", NAME, "projections"]).style == MethodStyle(
        NAME, "acceleration_pole", strict=True
    )
    language = load_language("en")
    text = plain_solution(written(task, solution(task, [NAME]), language, False), language)
    assert "An example of link\N{NO-BREAK SPACE}AB." in text
    assert "An example" not in plain_solution(written(task, solution(task), language, False), language)


@pytest.mark.usefixtures("added")
def test_where_it_does_not_apply() -> None:
    (task,) = tasks("slider_crank", "central", 1)
    assert NAME not in applicable(task)
    with pytest.raises(InputError, match="the method does not apply to this problem"):
        choose(task, [NAME])


@pytest.mark.usefixtures("added")
def test_a_wrong_number_of_it_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(book: Book, group: Dyad) -> None:
        solve_dyad(book, group)
        book.omega[group.body] = replace(book.omega[group.body], sense=-book.omega[group.body].sense)

    monkeypatch.setitem(GROUP_METHODS, NAME, GroupMethod((1,), (f"{NAME}.",), {Dyad: (applies, wrong)}))
    (task,) = tasks("four_bar", "crank", 1)
    with pytest.raises(VerificationError, match="deviates from the solver"):
        solution(task, [NAME])


def test_every_name_is_a_method_and_every_method_has_a_name() -> None:
    assert set(method_names.METHODS) == {*GROUP_METHODS, *WHOLE}
