"""What makes the figure of a composed mechanism hard to read is seen before anybody draws it."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.families.family import TOOTHED_RACK
from variantgen.synthesis.chance import Chance
from variantgen.synthesis.crowding import crossed, crowded
from variantgen.synthesis.draft import Datum, Draft


def _draft(**places: complex) -> Draft:
    draft = Draft(Chance("crowding"), z={"O": 0j, **places}, pivots=["O"])
    draft.data["OA"] = Datum("cm", 40, 2, 6)
    return draft


@pytest.mark.parametrize(
    ("far", "said"),
    [
        (175 + 60j, "CD across the guide of B"),  # 20 cm beside B; the guide is an eighth of 175 cm to either side
        (290 + 60j, ""),
    ],
)
def test_no_link_lies_across_the_guide_of_a_slider(far: complex, said: str) -> None:
    draft = _draft(A=40 + 30j, B=140 + 0j, C=far.real - 30 - 60j, D=far)
    draft.joint("guide", point="B")
    for start, end in ("OA", "AB", "CD"):
        draft.bodies[start + end] = [start, end]
        draft.bars.append((start, end))
    assert crowded(draft) == said


@pytest.mark.parametrize(("base", "said"), [("", ""), ("C", "the guide of B on the line OC")])
def test_no_guide_lies_along_the_line_from_which_an_angle_is_told(base: str, said: str) -> None:
    draft = _draft(A=40 - 60j, C=140j, B=9 + 70j, D=60 + 60j)  # B beside the middle of OC, its guide along it
    draft.joint("guide", point="B", angle="90")
    draft.base = base
    for start, end in ("OA", "AD", "DB"):
        draft.bodies[start + end] = [start, end]
        draft.bars.append((start, end))
    assert crowded(draft) == said


def test_a_rod_ends_at_its_slider_and_does_not_go_on_through_the_guide() -> None:
    draft = _draft(A=40 + 30j, B=140 + 0j, C=190 - 15j)
    draft.joint("guide", point="B")
    draft.bodies |= {"OA": ["O", "A"], "AB": ["A", "C", "B"]}
    draft.bars += [("O", "A"), ("A", "C")]
    assert crowded(draft) == "AC across the guide of B"


def test_variants_are_seen_on_which_a_link_lies_across_a_guide() -> None:
    draft = _draft(A=40 + 30j, B=140 + 0j, C=185 - 60j, D=185 + 60j)
    draft.joint("guide", point="B")
    for start, end in ("OA", "AB", "CD"):
        draft.bodies[start + end] = [start, end]
        draft.bars.append((start, end))
    places = {name: np.array([z, z]) for name, z in draft.z.items()}
    places |= {name: np.array([places[name][0], places[name][0] - 25]) for name in "CD"}
    assert crossed(draft, places).tolist() == [False, True]  # 45 and 20 cm beside B; the guide is 24 cm to either side


@pytest.mark.parametrize(("rise", "said"), [(16, "EC along the guide of D"), (40, "")])
def test_a_rod_to_a_block_is_not_along_the_link_on_which_it_slides(rise: float, said: str) -> None:
    # D slides on AB; the rod DC goes on to E, so that the bar is drawn from E to C.
    draft = _draft(A=40 + 0j, B=160 + 0j, D=90 + 0j, C=145 + rise * 1j)
    draft.z["E"] = draft.z["D"] + 0.7 * (draft.z["D"] - draft.z["C"])
    draft.bodies |= {"OA": ["O", "A"], "AB": ["A", "B"], "DC": ["E", "C", "D"]}
    draft.bars += [("A", "B"), ("E", "C")]
    draft.inside.append(("D", "A", "B"))
    assert crowded(draft) == said


@pytest.mark.parametrize(("size", "said"), [(20, "angles at A and O"), (40, "")])
def test_arcs_of_neighbouring_angles_have_room(size: float, said: str) -> None:
    draft = _draft(A=size + 0j, B=size + 120j)
    draft.marks += [
        {"name": "phi", "at": "O", "from": "+y", "to": "A"},
        {"name": "beta", "at": "A", "from": "O", "to": "B"},
    ]
    assert crowded(draft) == said


@pytest.mark.parametrize(("end", "said"), [(32 + 8j, "CD across the angle at A"), (24 + 16j, "")])
def test_no_link_lies_across_the_arc_of_an_angle(end: complex, said: str) -> None:
    # 11 and 23 cm from the corner; the arc is drawn at 13 % of the whole, which is 120 cm high: some 16 cm.
    draft = _draft(A=40 + 0j, B=40 + 120j, C=end, D=-40 + 80j)
    draft.marks.append({"name": "beta", "at": "A", "from": "O", "to": "B"})
    for start, far in ("OA", "AB", "CD"):
        draft.bodies[start + far] = [start, far]
        draft.bars.append((start, far))
    assert crowded(draft) == said


@pytest.mark.parametrize(("far", "said"), [(30, "the driving link at the wheel"), (40, "")])
def test_a_wheel_leaves_room_for_what_is_drawn_about_the_driving_link(far: float, said: str) -> None:
    draft = _draft(O1=far + 0j)  # its wheel of 20 cm comes as near as 10 and 20 cm; 13 % of 80 cm are some 10.4 cm
    draft.wheel("O1", draft.radius("r", 20))
    assert crowded(draft) == said


def test_variants_are_seen_on_which_a_link_lies_across_a_wheel() -> None:
    draft = _draft(O1=140 + 0j, C=100 + 60j, D=180 + 60j)
    draft.wheel("O1", draft.radius("r", 20))
    draft.bars += [("O", "O1"), ("C", "D")]
    places = {name: np.array([z, z]) for name, z in draft.z.items()}
    places |= {name: np.array([places[name][0], places[name][0] - 39j]) for name in "CD"}
    assert crossed(draft, places).tolist() == [False, True]  # 60 and 21 cm off the centre; the wheel has up to 22 cm


def test_variants_are_seen_on_which_a_link_touches_the_rim_of_a_wheel() -> None:
    draft = _draft(O1=140 + 0j, C=100 + 60j, D=180 + 60j)
    draft.wheel("O1", draft.radius("r", 20))
    draft.bars += [("O", "O1"), ("C", "D")]
    places = {name: np.array([z, z]) for name, z in draft.z.items()}
    places |= {name: np.array([places[name][0] - 33j, places[name][0] - 36j]) for name in "CD"}
    # 27 and 24 cm off the centre; the wheel has up to 22 cm, and 2 % of 180 cm are 3.6 cm.
    assert crossed(draft, places).tolist() == [False, True]


def _with_rack(**places: complex) -> Draft:
    """The slider E, whose rack ends at F (140 cm right, 40 cm up), and the link CD."""
    draft = _draft(E=60 + 40j, F=140 + 40j, **places)
    draft.hint("hidden", "F")
    draft.bodies |= {"rackE": ["E", "F"], "CD": ["C", "D"]}
    draft.nouns["rackE"] = TOOTHED_RACK
    draft.bars += [("E", "F"), ("C", "D")]
    return draft


@pytest.mark.parametrize(("x", "said"), [(145, "CD at the end of a rack"), (155, "")])
def test_no_link_is_at_the_end_of_a_rack(x: float, said: str) -> None:
    # 5 and 15 cm beside the end; 6 % of the whole, which is 155 cm wide, are some 9 cm.
    assert crowded(_with_rack(C=x - 60j, D=x + 70j)) == said


def test_variants_are_seen_on_which_a_link_is_at_the_end_of_a_rack() -> None:
    draft = _with_rack(C=155 - 60j, D=155 + 70j)
    places = {name: np.array([z, z]) for name, z in draft.z.items()}
    places |= {name: np.array([places[name][0], places[name][0] - 12]) for name in "CD"}
    assert crossed(draft, places).tolist() == [False, True]  # 15 and 3 cm beside the end; 4 % of 155 cm are 6 cm


@pytest.mark.parametrize(("rise", "said"), [(50, "AE over the start of a rack"), (80, "")])
def test_no_rod_lies_over_the_start_of_a_rack(rise: float, said: str) -> None:
    # From the slider, the rack to the right and a rod 60 cm right and 50 or 80 cm up: at 40 and 53 degrees.
    draft = _with_rack(C=0 - 60j, D=30 - 60j)
    draft.z["A"] = draft.z["E"] + 60 + rise * 1j
    draft.bodies["AE"] = ["A", "E"]
    draft.bars.append(("A", "E"))
    assert crowded(draft) == said


def test_variants_are_seen_on_which_a_rod_lies_over_the_start_of_a_rack() -> None:
    draft = _with_rack(C=0 - 60j, D=30 - 60j, A=-40 + 120j)
    draft.bodies["AE"] = ["A", "E"]
    draft.bars.append(("A", "E"))
    places = {name: np.array([z, z, z]) for name, z in draft.z.items()}
    places["A"] = places["E"] + np.array([60 + 70j, 60 + 40j, -60 + 10j])  # at 49, 34, 170 degrees with the rack
    assert crossed(draft, places).tolist() == [False, True, False]


@pytest.mark.parametrize(("x", "said"), [(94, "G at the bearing of a yoke"), (105, "")])
def test_nothing_is_at_the_bearing_of_a_yoke(x: float, said: str) -> None:
    # The bearing is at S, 80 cm right; 10 % of the whole, which is 180 cm wide, are 18 cm: G is 14 and 25 cm off.
    draft = _draft(A=0 - 40j, F=40 + 30j, B=180 + 30j, S=80 + 30j, G=x + 30j)
    draft.bodies |= {"OA": ["O", "A"], "yokeB": ["F", "B", "S"]}
    draft.bars += [("O", "A")]
    draft.hint("hidden", "S")
    draft.hint("stems", "S")
    assert crowded(draft) == said


@pytest.mark.parametrize(("rise", "said"), [(18, "D beside B in a slot"), (30, "")])
def test_a_block_in_the_slot_of_a_slider_is_not_beside_the_slider(rise: float, said: str) -> None:
    # 11 % of the whole, which is 180 cm wide, are 19.8 cm.
    draft = _draft(A=0 - 40j, B=180 + 0j, K=180 - 60j, L=180 + 60j, D=180 + rise * 1j)
    draft.bodies |= {"OA": ["O", "A"], "sliderB": ["B", "K", "L"]}
    draft.bars += [("O", "A"), ("K", "L")]
    draft.hints |= {"hidden": ["K", "L"], "grooves": [["K", "L"]]}
    draft.inside.append(("D", "K", "L"))
    assert crowded(draft) == said


@pytest.mark.parametrize(("place", "said"), [(0 + 0j, "links cross"), (0 + 80j, "")])
def test_the_link_of_a_block_does_not_cross_the_bar_of_its_yoke(place: complex, said: str) -> None:
    """A is in the slot KL, whose yoke goes on from F to the right; O is below the bar or above it, A is above it."""
    draft = _draft(A=100 + 60j, F=100 + 25j, B=0 + 25j, K=100 + 140j, L=100 - 90j)
    draft.z["O"] = place
    draft.bodies |= {"OA": ["O", "A"], "yokeB": ["F", "B", "K", "L"]}
    draft.bars += [("O", "A"), ("F", "B"), ("L", "K")]
    draft.hint("hidden", "K")
    draft.hint("hidden", "L")
    draft.inside.append(("A", "L", "K"))
    assert crowded(draft) == said
