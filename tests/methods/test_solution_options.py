"""Options of a solution: checked names."""

from __future__ import annotations

import pytest

from variantgen.errors import InputError
from variantgen.families.method_names import METHODS
from variantgen.methods.solution_options import SolutionOptions


def test_ten_methods() -> None:
    assert len(set(METHODS)) == 10
    assert SolutionOptions(METHODS).methods == METHODS


@pytest.mark.parametrize(
    ("methods", "depth", "said"),
    [
        (("velocity_center",), "full", ["method: unknown method", "velocity_center", "did you mean velocity_centre"]),
        (("graphical", "graphical"), "full", ["named twice"]),
        ((), "fulll", ["depth: unknown depth", "fulll", "did you mean full?"]),
    ],
)
def test_wrong_names_are_told(methods: tuple[str, ...], depth: str, said: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        SolutionOptions(methods, depth)  # type: ignore[arg-type]  # what comes from a file is any word
    for words in said:
        assert words in str(caught.value)
