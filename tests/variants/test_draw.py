"""Drawing: what a variant depends on, uniformity over the valid grid, distinctness, bounded work."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence

import numpy as np
import pytest

from variantgen.errors import InputError
from variantgen.families.family import Family
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.distinct import TooFewError, assign_distinct
from variantgen.variants.draw import FamilySampler, draw, too_few
from variantgen.variants.seeding import Stream, digest, index_below
from variantgen.variants.similarity import Traits, traits
from variantgen.variants.variant import Variant, solve_variants

SMALL = restrict(load_family("spool"), {"thread": "above", "a_B": 100, "v_B": 40}, {"r": [18, 22], "R": [40, 44]})


def test_raw_words_are_the_promised_ones() -> None:
    # Philox 4x64 with the key of this digest; the words are promised by numpy for ever.
    words = Stream("seed", "student", 1, "four_bar").words(3)
    expected = np.random.Philox(key=int.from_bytes(digest("seed", "student", 1, "four_bar"), "big")).random_raw(3)
    assert np.array_equal(words, expected)
    assert digest("a", "bc") != digest("ab", "c")


def test_index_below_is_uniform() -> None:
    index = index_below(Stream("uniform").words(60_000), 6)
    counts = np.bincount(index, minlength=6)
    # Chi-square with 5 degrees of freedom: 20.5 is exceeded once in a thousand.
    assert np.sum((counts - 10_000) ** 2 / 10_000) < 20.5


def test_a_variant_depends_on_its_key_alone() -> None:
    family = load_family("four_bar")
    keys = [("s", f"student {i}", 1) for i in range(40)]
    together = draw(family, None, keys)
    shuffled = keys.copy()
    random.Random(1).shuffle(shuffled)
    again = dict(zip(shuffled, draw(family, None, shuffled), strict=True))
    assert [again[key].printed for key in keys] == [variant.printed for variant in together]
    alone = draw(family, None, [keys[7]])[0]
    assert alone == again[keys[7]]


def test_the_draw_is_uniform_over_the_valid_grid() -> None:
    # 9 pairs (r, R), all valid: each is drawn equally often.
    drawn = draw(SMALL, ["v_O"], [("uniform", i) for i in range(4500)])
    counts = Counter((v.printed["r"], v.printed["R"]) for v in drawn)
    assert len(counts) == 9
    # Chi-square with 8 degrees of freedom: 26.1 is exceeded once in a thousand.
    assert sum((n - 500) ** 2 / 500 for n in counts.values()) < 26.1


def distinct(family: Family, names: list[str], ask: list[str] | None = None) -> tuple[list[Variant], list[int]]:
    """Distinct variants of students of one group, and who had to draw again."""
    drawing = FamilySampler(family, ask)

    def draws(owners: Sequence[int], used: Sequence[int]) -> list[Variant]:
        return drawing.after([("s", names[i]) for i in owners], used)

    def traits_of(variants: Sequence[Variant]) -> Traits:
        asked = [drawing.asked[variant.form.name] for variant in variants]
        return traits(variants, asked, [""] * len(variants))

    def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
        return traits_of(draws(owners, used))

    found = draws(range(len(names)), [0] * len(names))
    try:
        settled = assign_distinct(traits_of(found), lambda i: digest("priority", names[i]), more)
    except TooFewError as error:
        raise too_few(error, [drawing] * len(names)) from None
    for i, attempt in settled.again.items():
        found[i] = draws([i], [attempt - 1])[0]
    return found, list(settled.again)


def test_distinct_variants_do_not_depend_on_the_order_of_students() -> None:
    names = [f"student {i}" for i in range(8)]
    found, again = distinct(SMALL, names, ["v_O"])
    assert len({v.identity for v in found}) == 8
    assert again, "eight of nine variants: somebody must have drawn again"
    by_name = dict(zip(names, found, strict=True))
    for seed in range(5):
        other = names.copy()
        random.Random(seed).shuffle(other)
        assert dict(zip(other, distinct(SMALL, other, ["v_O"])[0], strict=True)) == by_name


def test_adding_a_student_changes_nobody_without_a_collision() -> None:
    family = load_family("four_bar")
    names = [f"student {i}" for i in range(30)]
    assert distinct(family, [*names, "new student"])[0][:30] == distinct(family, names)[0]


def test_more_students_than_variants_is_an_error_that_says_so() -> None:
    with pytest.raises(InputError, match="spool") as caught:
        distinct(SMALL, [f"student {i}" for i in range(10)], ["v_O"])
    assert "distinct" in str(caught.value)


def test_impossible_ranges_end_with_a_report() -> None:
    # 16 + 100 > 30 + 24: no crank goes full circle, nor does it assemble.
    family = restrict(load_family("four_bar"), {"OA": 16, "AB": 30, "BC": 24, "OC": 100}, None, ["crank"])
    tally = RejectionCounts()
    with pytest.raises(InputError, match=r"OA \+ OC < AB \+ BC") as caught:
        draw(family, None, [("s", 1)], tally)
    text = str(caught.value)
    assert "no valid variant" in text
    assert "widen" in text
    assert "OC" in text


@pytest.mark.parametrize("name", ["four_bar", "slider_crank", "sleeve_on_crank", "rolling_wheel", "spool"])
def test_what_is_printed_is_what_is_solved(name: str) -> None:
    variants = draw(load_family(name), None, [("p", i) for i in range(20)])
    for variant in variants:
        for parameter in variant.form.parameters.values():
            assert variant.printed[parameter.name] in parameter.printed
    by_form: dict[str, list[int]] = {}
    for i, variant in enumerate(variants):
        by_form.setdefault(variant.form.name, []).append(i)
    for members in by_form.values():
        motion = solve_variants([variants[i] for i in members], 0)
        assert motion.solved.all()
        for place, i in enumerate(members):
            for link in ("OA", "AB", "BC"):
                if link in variants[i].printed and set(link) <= set(motion.z):
                    length = abs(motion.z[link[0]][place] - motion.z[link[1]][place])
                    assert length == pytest.approx(float(variants[i].printed[link]) / 100, rel=1e-12)


def test_attempts_are_recorded_from_one() -> None:
    variants = draw(load_family("four_bar"), None, [("a", i) for i in range(50)])
    attempts = [variant.attempt for variant in variants]
    assert min(attempts) >= 1
    assert max(attempts) > 1
