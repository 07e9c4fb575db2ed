"""Variants are distinct, and far from each other within a group, whoever draws them in whatever order."""

from __future__ import annotations

import random
from collections.abc import Sequence
from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.variants.distinct import TRIES, DistinctDraws, TooFewError, assign_distinct
from variantgen.variants.draw import draw
from variantgen.variants.printed_data import max_distinct_problems
from variantgen.variants.seeding import digest
from variantgen.variants.similarity import CLOSE, CLOSE_ANGLE, Traits, traits
from variantgen.variants.variant import Variant

Draw = tuple[int, int, float | tuple[float, ...]]  # identity, room, place


class Model:
    """Owners with prepared draws, and the rule followed one owner after the other, as the documentation says it."""

    def __init__(self, draws: Sequence[Sequence[Draw]], priorities: Sequence[int]) -> None:
        self.draws, self.priorities = draws, priorities

    def traits(self, owners: Sequence[int], tries: Sequence[int]) -> Traits:
        chosen = [self.draws[i][k] for i, k in zip(owners, tries, strict=True)]
        return Traits(
            np.array([identity for identity, _, _ in chosen], dtype=np.uint64),
            np.array([room for _, room, _ in chosen], dtype=np.uint64),
            np.array([np.atleast_1d(place) for *_, place in chosen], dtype=np.float32),
            np.array([k + 1 for k in tries]),
        )

    def assign_distinct(self) -> DistinctDraws:
        first = self.traits(range(len(self.draws)), [0] * len(self.draws))
        return assign_distinct(first, lambda i: self.priorities[i].to_bytes(8, "big"), self.traits)

    def one_by_one(self) -> dict[int, int]:
        held: dict[int, Draw] = {}
        taken = {}
        for owner in sorted(range(len(self.draws)), key=lambda i: self.priorities[i]):
            free = [k for k, d in enumerate(self.draws[owner]) if all(d[0] != other[0] for other in held.values())]
            apart = [k for k in free if k < TRIES and not any(near(self.draws[owner][k], d) for d in held.values())]
            taken[owner] = (apart or free)[0]
            held[owner] = self.draws[owner][taken[owner]]
        return {owner: k + 1 for owner, k in sorted(taken.items()) if k}


def near(one: Draw, other: Draw) -> bool:
    return one[1] == other[1] and bool(np.all(np.abs(np.subtract(one[2], other[2])) <= 1.0))


@st.composite
def models(make: st.DrawFn) -> Model:
    """Owners in few rooms, whose variants are points of a line."""
    owners = make(st.integers(1, 12))
    length = make(st.integers(1, 60))
    rooms = make(st.integers(1, 3))
    seed = random.Random(make(st.integers(0, 10**6)))
    draws = []
    for _ in range(owners):
        points = [seed.randrange(40 + 12 * rooms) for _ in range(400)]
        draws.append([(p, p % rooms, p * length / 100) for p in points])
    priorities = list(range(owners))
    seed.shuffle(priorities)
    return Model(draws, priorities)


@settings(max_examples=200, deadline=None)
@given(models())
def test_as_one_after_the_other(model: Model) -> None:
    assert model.assign_distinct().again == model.one_by_one()


def test_the_order_of_owners_changes_nothing() -> None:
    seed = random.Random(3)
    draws = [[(p, 0, float(p)) for p in [seed.randrange(30) for _ in range(200)]] for _ in range(12)]
    whole = Model(draws, range(12)).assign_distinct().again
    for _ in range(10):
        order = list(range(12))
        seed.shuffle(order)
        again = Model([draws[i] for i in order], order).assign_distinct().again
        assert {order[k]: attempt for k, attempt in again.items()} == whole


def test_too_few_variants_are_noticed_and_counted() -> None:
    seed = random.Random(1)
    draws = [[(p, p, 0.0) for p in [seed.randrange(7) for _ in range(2000)]] for _ in range(9)]
    with pytest.raises(TooFewError) as caught:
        Model(draws, range(9)).assign_distinct()
    assert caught.value.found(lambda owner: True) == 7


def test_a_crowd_is_told_and_only_kept_distinct() -> None:
    # 40 owners, all within reach of each other: nobody looks for what is not there.
    draws = [[(10 * i + k, 0, 0.01 * i) for k in range(50)] for i in range(40)]
    found = Model(draws, range(40)).assign_distinct()
    assert found.again == {}
    assert found.alike == tuple(range(40))


def test_all_coordinates_of_a_place_count() -> None:
    # Places in whole steps, so that many differ by exactly as much as is still near; few owners for the room there is.
    seed = random.Random(5)
    for width in (1, 2, 4):
        side = 200 if width == 1 else 25
        draws = []
        for owner in range(40):
            places = [tuple(float(seed.randrange(side)) for _ in range(width)) for _ in range(30)]
            draws.append([(owner * 30 + k, 0, place) for k, place in enumerate(places)])
        model = Model(draws, range(40))
        assert model.assign_distinct().again == model.one_by_one()


def test_what_has_no_number_is_near_everything_in_its_room() -> None:
    draws = [[(10 * i + k, 0, ()) for k in range(50)] for i in range(5)]
    assert Model(draws, range(5)).assign_distinct().alike == (1, 2, 3, 4)


@pytest.mark.parametrize("few", [10, 10_000])
def test_large_rooms_are_searched_as_small_ones_are(few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("variantgen.variants.distinct._FEW", few)
    # 1000 owners in one room, spaced by twice the distance, and a second owner near each tenth.
    draws = [[(i, 0, 2.5 * i), (5000 + i, 1, 50.0 * i)] for i in range(1000)]
    draws += [[(9000 + i, 0, 25.0 * i + 0.5), (20_000 + i, 2, 50.0 * i)] for i in range(100)]
    assert Model(draws, range(1100)).assign_distinct().again == {1000 + i: 2 for i in range(100)}


BASE = draw(load_family("four_bar"), ["v_B"], [("s", 1, 1)])[0]
VELOCITIES, ACCELERATIONS = read_ask(BASE.form, ["v_B"]), read_ask(BASE.form, ["a_B"])


def changed(**values: str) -> Variant:
    return replace(BASE, printed={**BASE.printed, **{name: Decimal(value) for name, value in values.items()}})


def close(one: Variant, other: Variant, groups: Sequence[str] = ("", "")) -> bool:
    found = traits([one, other], [ACCELERATIONS] * 2, groups)
    return bool(found.room[0] == found.room[1] and np.all(np.abs(found.place[0] - found.place[1]) <= 1.0001))


def test_what_is_nearly_the_same() -> None:
    base = changed(OA="20", AB="60", phi="120")
    assert close(base, base)
    assert close(base, changed(OA="20.5", AB="58.5", phi="121.9"))  # 2.5 %, 2.6 %, less than two degrees
    assert not close(base, changed(OA="20.7", AB="60", phi="120"))  # 3.5 %
    assert not close(base, changed(OA="20", AB="60", phi="122.1"))
    assert not close(base, base, ("A", "B")), "only within a group"
    # The figure shows another branch: the answers are others.
    assert not close(base, changed(OA="20", AB="60", phi="120", side=str(-base.printed["side"])))


def test_the_other_sense_has_the_same_words_and_numbers() -> None:
    base, other = changed(OA="20", AB="60", phi="120"), changed(sense=str(-BASE.printed["sense"]))
    found = traits([base, other], [VELOCITIES] * 2, ["", ""])
    assert found.room[0] == found.room[1]
    assert np.array_equal(found.place[0], found.place[1])
    assert found.identity[0] == found.identity[1], "v_B has no sign"
    rates = traits([base, other], [read_ask(BASE.form, ["omega_BC"])] * 2, ["", ""])
    assert rates.identity[0] != rates.identity[1], "omega_BC has the other sign"
    assert CLOSE == 0.03
    assert CLOSE_ANGLE == 2.0


def test_what_is_the_same() -> None:
    mirrored = replace(BASE, sense=-BASE.sense, turns=2, attempt=99)
    found = traits([BASE, mirrored, changed(OA="20.5")], [ACCELERATIONS] * 3, ["A", "B", "A"])
    assert found.identity[0] == found.identity[1] != found.identity[2]


def test_what_no_sheet_tells_makes_no_difference() -> None:
    # Where velocities alone are asked, the angular acceleration of the crank is not given.
    rate = next(name for name, p in BASE.form.parameters.items() if p.of_second_order)
    other = changed(**{rate: str(BASE.printed[rate] + 1)})
    velocities = traits([BASE, other], [VELOCITIES] * 2, ["", ""])
    assert velocities.identity[0] == velocities.identity[1]
    accelerations = traits([BASE, other], [ACCELERATIONS] * 2, ["", ""])
    assert accelerations.identity[0] != accelerations.identity[1]
    assert max_distinct_problems(BASE.form, ACCELERATIONS) == max_distinct_problems(BASE.form, VELOCITIES) * len(
        BASE.form.parameters[rate].printed
    )


def test_hashes_of_many_variants_do_not_meet() -> None:
    numbers = {int.from_bytes(digest("identity", i)[:8], "big") for i in range(200_000)}
    assert len(numbers) == 200_000
