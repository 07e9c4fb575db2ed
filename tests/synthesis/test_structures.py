"""Counts of structures, against an enumeration by matrices of joints and all permutations of links."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest

from variantgen.errors import InputError
from variantgen.families.reading.load import load_family
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import code, is_textbook, moving_links, parse_code, structures, textbook_structures
from variantgen.synthesis.terminal import geared_structures, rolling_structures

R, P, W = 1, 2, 3
ALL = ("RRR", "RRP", "RPR", "PRP", "RPP")


def _grown(matrix: np.ndarray, kind: str, on: int, to: int) -> np.ndarray:
    """The matrix of joints (0 none, 1 hinge, 2 sliding pair) with two links more."""
    size = len(matrix)
    found = np.zeros((size + 2, size + 2), dtype=np.int8)
    found[:size, :size] = matrix
    ends = ((on, size), (size, size + 1), (size + 1, to))
    for letter, (one, other) in zip(kind, ends, strict=True):
        found[one, other] = found[other, one] = R if letter == "R" else P
    return found


def _certificate(matrix: np.ndarray) -> bytes:
    """The largest of the matrices with the links but frame and crank in any order."""
    orders = np.array([(0, 1, *rest) for rest in permutations(range(2, len(matrix)))])
    every = matrix[orders[:, :, None], orders[:, None, :]].reshape(len(orders), -1)
    return max(row.tobytes() for row in every)


def _slides_only(matrix: np.ndarray, on: int, to: int) -> bool:
    """Whether a way of sliding pairs leads from one link to the other."""
    reach = np.linalg.matrix_power((matrix == P).astype(int) + np.eye(len(matrix), dtype=int), len(matrix))
    return bool(reach[on, to])


def _textbook(matrix: np.ndarray) -> bool:
    """The screens of the docstring, read off the matrix; a last dyad is two joined links without a third neighbour."""
    joints = (matrix > 0).sum(axis=0)
    pairs = [(i, j) for i in range(2, len(matrix)) for j in range(i) if matrix[i, j] == P]
    last = [
        (i, j) for j in range(2, len(matrix), 2) for i in [j + 1]
        if joints[i] == 2 and joints[j] == 2
    ]  # fmt: skip
    moving = sum(j > 0 for _, j in pairs)
    return len(last) == 1 and joints[1:].max() <= 3 and joints[0] <= 4 and len(pairs) <= 2 and moving <= 1


def _enumerated(dyads: int, kinds: tuple[str, ...], most: int = 10**9) -> list[np.ndarray]:
    """The matrices of all structures; ``most``: from this number of dyads on only those of textbooks."""
    start = np.zeros((2, 2), dtype=np.int8)
    start[0, 1] = start[1, 0] = R
    found = [start]
    for size in range(1, dyads + 1):
        seen: dict[bytes, np.ndarray] = {}
        for matrix in found:
            for kind in kinds:
                for on, to in permutations(range(len(matrix)), 2):
                    if kind in ("PRP", "RPP") and _slides_only(matrix, on, to):
                        continue
                    grown = _grown(matrix, kind, on, to)
                    if size < most or _textbook(grown):
                        seen.setdefault(_certificate(grown), grown)
        found = list(seen.values())
    return found


@pytest.mark.parametrize(
    ("kinds", "counts"),
    [(ALL[:1], (1, 6, 69)), (ALL[:2], (3, 51)), (ALL[:3], (4, 90)), (ALL, (7, 240))],
)
def test_counts_by_permutations(kinds: tuple[str, ...], counts: tuple[int, ...]) -> None:
    for dyads, count in enumerate(counts, start=1):
        assert len(structures(dyads, kinds)) == len(_enumerated(dyads, kinds)) == count


def test_textbook_structures() -> None:
    assert [sum(map(is_textbook, structures(n, ALL[:3]))) for n in (1, 2, 3)] == [4, 54, 625]
    assert [sum(map(is_textbook, structures(n))) for n in (1, 2, 3)] == [6, 68, 739]
    assert len(textbook_structures()) == 6 + 68 + 739


def _ends(matrix: np.ndarray) -> tuple[int, int]:
    """The two links of the group that drives nothing else."""
    joints = (matrix > 0).sum(axis=0)
    return next((j, j + 1) for j in range(2, len(matrix), 2) if joints[j] == joints[j + 1] == 2)


def _sliders(matrix: np.ndarray) -> list[int]:
    """Of these the slider in a fixed guide, pinned to a rod that is pinned to a moving link."""
    found = []
    for slider, rod in (_ends(matrix), _ends(matrix)[::-1]):
        others = [link for link in range(1, len(matrix)) if matrix[rod, link] and link != slider]
        if matrix[slider, 0] == P and matrix[slider, rod] == R and others and matrix[rod, others[0]] == R:
            found.append(slider)
    return found


def _with_link(matrix: np.ndarray, joints: dict[int, int]) -> np.ndarray:
    """The matrix with one link more that has these joints."""
    size = len(matrix)
    found = np.zeros((size + 1, size + 1), dtype=np.int8)
    found[:size, :size] = matrix
    for link, joint in joints.items():
        found[link, size] = found[size, link] = joint
    return found


def _geared(matrix: np.ndarray) -> list[np.ndarray]:
    """Gears and racks on a last group: driven by a gear of a link about a fixed axis, carried by it round a fixed gear,
    driven by the rack of a slider; with the screens of textbooks for joints of the frame and slides.
    """
    turning = [link for link in _ends(matrix) if matrix[link, 0] == R]
    ends = [{link: W, 0: R} for link in turning + _sliders(matrix)]
    ends += [{link: R, 0: W} for link in turning] + [{link: W, 0: P} for link in turning]
    found = [_with_link(matrix, joints) for joints in ends]
    return [m for m in found if (m[0] > 0).sum() <= 4 and (m == P).sum() // 2 <= 2]


def test_textbook_structures_by_permutations() -> None:
    """With those that end with a wheel, a gear or a rack."""
    every = [[m for m in _enumerated(size, ALL) if _textbook(m)] for size in (1, 2)] + [_enumerated(3, ALL, most=3)]
    assert [len(found) for found in every] == [6, 68, 739]
    rolling = []
    for found in every:
        seen = set()
        for matrix in found:
            for slider in _sliders(matrix):
                wheel = matrix.copy()
                wheel[0, slider] = wheel[slider, 0] = W
                seen.add(_certificate(wheel))
        rolling.append(len(seen))
    assert rolling == [1, 8, 70]
    assert len(rolling_structures(7)) == sum(rolling)
    geared = [len({_certificate(new) for matrix in found for new in _geared(matrix)}) for found in every[:2]]
    assert geared == [10, 60]
    assert [sum(moving_links(s) == n for s in geared_structures(6)) for n in (4, 6)] == geared


def test_a_code_is_that_of_all_orders_of_growth() -> None:
    assert code(parse_code("RRP10-RRR32")) == code(parse_code("RRP10-RRR23")) == "RRP10-RRR23"
    # Two dyads that do not know of each other, in either order.
    assert parse_code("RRR10-RRP10") == parse_code("RRP10-RRR01")


@pytest.mark.parametrize("text", ["", "RRR", "RRX10", "RRR00", "RRR19", "RPP10-RPP30", "RRR01-"])
def test_what_is_no_code_is_told(text: str) -> None:
    with pytest.raises(InputError, match="list --structures"):
        parse_code(text)


def test_families_of_the_catalogue_have_the_structures_that_their_names_say() -> None:
    """A four-bar linkage, slider-crank, shaper, ... ; wheels and ropes have none."""
    known = {
        "four_bar": {"RRR01"},
        "slider_crank": {"RRP10"},
        "slotted_rocker": {"RPR01"},
        "scotch_yoke": {"RPP10"},
        "quick_return_shaper": {"RPR01-RRP20"},
        "two_loop_mechanism": {"RRP10-RRR02"},
        "rolling_wheel": set(),
        "movable_pulley": set(),
    }
    for name, codes in known.items():
        form = next(iter(load_family(name).forms.values()))
        assert {code(structure) for structure in structures_of(form.sample)} == codes


def test_a_pin_of_three_links_is_read_both_ways() -> None:
    (form,) = load_family("sleeve_on_crank").forms.values()
    assert {code(structure) for structure in structures_of(form.sample)} == {"RRP10-RPR12", "RRP10-RPR13"}
