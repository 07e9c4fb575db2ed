"""The check of a family finds sheets that do not fit their key: each family of the catalogue here has one mistake."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from variantgen.check import Report, check_family
from variantgen.check.vocabulary import vocabulary
from variantgen.cli import main
from variantgen.resources import catalog_dir, languages

SEEDS, MORE = 5, 8  # of a form: so few tell a mistake, and of more nothing is told where there is none


def damaged(folder: Path, family: str, *changes: tuple[str, str, str]) -> Path:
    """A copy of a family with other words in its files, at every place where they stand."""
    copied = folder / family
    shutil.copytree(catalog_dir() / family, copied)
    for file, old, new in changes:
        path = copied / file
        text = path.read_text("utf-8")
        assert old in text
        path.write_text(text.replace(old, new), "utf-8")
    return copied


def failures(path: Path, seeds: int = SEEDS) -> list[str]:
    return list(check_family(str(path), seeds).failures)


def exchanged(file: str, one: str, two: str) -> list[tuple[str, str, str]]:
    """The changes that exchange two texts in a file."""
    return [(file, one, "@@"), (file, two, one), (file, "@@", two)]


@pytest.mark.parametrize("family", ["oscillating_cylinder", "two_cranks_and_rod", "spool"])
def test_a_family_without_damage_passes(family: str, tmp_path: Path) -> None:
    assert failures(damaged(tmp_path, family), MORE) == []


# Length that is not as printed: family, what is written, what is written instead, the length.
LENGTHS = [
    ("oscillating_cylinder", 'distance = "OA"', 'distance = "2*OA"', "OA"),
    ("oscillating_cylinder", 'distance = "AB"', 'distance = "AB + 10 * cm"', "AB"),
    (
        "two_cranks_and_rod",
        'first_distance = "AM", second = "B", second_distance = "BM"',
        'first_distance = "BM", second = "B", second_distance = "AM"',
        "AM",
    ),
    ("three_rod_plate", 'end = "C", length = "CD"', 'end = "C", length = "0.95 * CD"', "CD"),
]


@pytest.mark.parametrize(("family", "old", "new", "length"), LENGTHS)
def test_a_printed_length_is_the_distance_of_its_points(
    family: str, old: str, new: str, length: str, tmp_path: Path
) -> None:
    path = damaged(tmp_path, family, ("family.toml", old, new))
    (path / "cases.toml").unlink()  # they notice some of it; without them nothing else would
    found = [failure for failure in failures(path) if f"the sheet says {length} = " in failure]
    assert len(found) == 1
    assert "but these points are" in found[0]


def test_a_length_is_read_as_it_is_printed(tmp_path: Path) -> None:
    """The crank OA has its own length, and it is printed as that of the fixed link OC."""
    was, now = 'OA = { unit = "cm",', 'OA = { symbol = "OC", unit = "cm",'
    other, name = 'OC = { unit = "cm",', 'OC = { symbol = "OA", unit = "cm",'
    path = damaged(tmp_path, "oscillating_cylinder", ("family.toml", was, now), ("family.toml", other, name))
    assert sum("the sheet says OA = " in failure for failure in failures(path)) == 1


def test_the_message_names_both_lengths(tmp_path: Path) -> None:
    """The crank is printed with 14 to 40 cm, and is twice as long."""
    path = damaged(tmp_path, "oscillating_cylinder", ("family.toml", 'distance = "OA"', 'distance = "2*OA"'))
    (found,) = [failure for failure in failures(path) if "the sheet says OA" in failure]
    match = re.search(r"the sheet says OA = (\d+) cm, but these points are (\d+) cm apart", found.replace("\xa0", " "))
    assert match
    assert 14 <= int(match[1]) <= 40
    assert int(match[2]) == 2 * int(match[1])


OTHERS = [
    ("gear_pair_with_crank", 'radius = "r_2", other', 'radius = "0.8 * r_2", other', "circle of gear2 about A to have"),
    ("planetary_pair", 'distance = "r_1 + r_2"', 'distance = "r_1 + 1.1 * r_2"', "circle of a wheel about O to have"),
    ("spool", 'point = "O", radius = "r"', 'point = "O", radius = "1.2 * r"', "the circle of spool about O to have"),
    ("rolling_wheel", 'O = { coordinates = { x = 0, y = "R" } }', 'O = { coordinates = { x = 0, y = "1.2*R" } }',
     "the circle of wheel about O to have"),
    ("rolling_wheel", 'radius = "R", name', 'radius = "1.2 * R", name', "the radius marked R is not the given one"),
    ("oscillating_cylinder", 'from = "C", to', 'from = "+y", to', "the angle marked phi is not the given one"),
    ("oscillating_cylinder", 'omega = "sense', 'omega = "2 * sense', "the sheet says omega_OA = "),
]  # fmt: skip


@pytest.mark.parametrize(("family", "old", "new", "said"), OTHERS)
def test_printed_radii_angles_and_rates_are_those_of_the_motion(
    family: str, old: str, new: str, said: str, tmp_path: Path
) -> None:
    path = damaged(tmp_path, family, ("family.toml", old, new))
    (path / "cases.toml").unlink()
    assert sum(said in failure for failure in failures(path)) == 1


@pytest.mark.parametrize(
    ("family", "language", "faster", "slower", "said"),
    [
        ("oscillating_cylinder", "en", "increasing", "decreasing", "the text says 'decreasing' of epsilon_OA"),
        ("oscillating_cylinder", "ru", "ускоренно", "замедленно", "the text says 'замедленно' of epsilon_OA"),
        ("two_cranks_and_rod", "ru", "ускоренно", "замедленно", "the text says 'ускоренно' of epsilon_BC"),
        ("roller_on_drum", "en", "increasing", "decreasing", "the text says 'increasing' of epsilon_2"),
    ],
)
def test_words_for_senses_agree_with_the_numbers_in_each_language(
    family: str, language: str, faster: str, slower: str, said: str, tmp_path: Path
) -> None:
    found = failures(damaged(tmp_path, family, *exchanged(f"statement.{language}.j2", faster, slower)))
    assert all(failure.startswith(f"statement.{language}.j2") for failure in found)
    assert any(said in failure for failure in found)


HOIST = '{% if choice.motion == "extends" %}increases{% else %}decreases{% endif %}'
# What is said of directions. Pictures are mirrored, so that no side and no sense of turning is right for all of them.
DIRECTIONS = [
    ("spool", "en", "which is moving down", "which is moving up", "'moving up' of B"),
    ("spool", "ru", "который опускается", "который поднимается", "'поднимается' of B"),
    ("spool", "en", "A spool", "The axle {{ O }} moves to the left. A spool", "'moves to the left' of O"),
    ("oscillating_cylinder", "en", "The rod", "The crank {{ OA }} turns clockwise. The rod", "'clockwise' of OA"),
    ("oscillating_cylinder", "ru", "Шток", "Кривошип {{ OA }} вращается против часовой стрелки. Шток",
     "'против часовой стрелки' of OA"),
    ("hydraulic_hoist", "en", HOIST, "increases", "'increases' of u"),
]  # fmt: skip


@pytest.mark.parametrize(("family", "language", "old", "new", "said"), DIRECTIONS)
def test_words_for_directions_agree_with_the_motion(
    family: str, language: str, old: str, new: str, said: str, tmp_path: Path
) -> None:
    found = failures(damaged(tmp_path, family, (f"statement.{language}.j2", old, new)))
    assert any(f"the text says {said}, which the numbers contradict" in failure for failure in found)


@pytest.mark.parametrize(
    ("family", "language", "one", "two"),
    [
        ("three_rod_plate", "ru", "BC", "CD"),
        ("two_cranks_and_rod", "en", "AM", "BM"),
        ("two_cranks_and_rod", "ru", "phi", "psi"),
        ("spool", "ru", "R", "r"),
    ],
)
def test_names_exchanged_in_one_language(family: str, language: str, one: str, two: str, tmp_path: Path) -> None:
    changes = exchanged(f"statement.{language}.j2", f"{{{{ {one} }}}}", f"{{{{ {two} }}}}")
    found = failures(damaged(tmp_path, family, *changes))
    assert any(f"{min(one, two)} and {max(one, two)} stand exchanged" in failure for failure in found)


def test_names_exchanged_at_one_place(tmp_path: Path) -> None:
    """The links of the last sentence, which each have their own rate there; elsewhere they stand right."""
    one, two = "звено {{ OA }} имеет", "звено {{ BC }} — угловую"
    changes = [("{{ OA }} имеет", "{{ BC }} имеет"), ("{{ BC }} — угловую", "{{ OA }} — угловую")]
    text = (catalog_dir() / "two_cranks_and_rod" / "statement.ru.j2").read_text("utf-8")
    assert one in text
    assert two in text
    found = failures(damaged(tmp_path, "two_cranks_and_rod", *(("statement.ru.j2", old, new) for old, new in changes)))
    assert any("BC and OA stand exchanged" in failure for failure in found)


def test_the_order_of_points_is_only_remarked(tmp_path: Path) -> None:
    """Both orders may be right: the ends A and B of a rod, on the wall and on the floor."""
    change = ("statement.ru.j2", "осей {{ O }} и {{ C }}", "осей {{ C }} и {{ O }}")
    report = check_family(str(damaged(tmp_path, "two_cranks_and_rod", change)), SEEDS)
    assert list(report.failures) == []
    assert report.remarks == ["statement.ru.j2: C and O stand exchanged, compared with the text in en; is it meant?"]


# What one language says and the other does not.
UNSAID = [
    ("slider_crank", "ru", "отстоит от оси {{ O }} на {{ e }}", "не проходит через ось {{ O }}",
     "the text says nothing of e, that in en does"),
    ("planetary_pair", "en", "of radius {{ r_1 }}", "", "the text says nothing of r_1, that in ru does"),
    ("oscillating_cylinder", "en", "The rod", "It is 3 cm. The rod", "the text says 3 cm, that in ru does not"),
    ("oscillating_cylinder", "ru", "Шток", "{{ OA }} = 2,5 м. Шток", "the text says 2,5 м, that in en does not"),
]  # fmt: skip


@pytest.mark.parametrize(("family", "language", "old", "new", "said"), UNSAID)
def test_the_languages_say_the_same(family: str, language: str, old: str, new: str, said: str, tmp_path: Path) -> None:
    found = failures(damaged(tmp_path, family, (f"statement.{language}.j2", old, new)))
    assert any(said in failure for failure in found)


@pytest.mark.parametrize(
    ("language", "old", "new", "said"),
    [
        ("en", "The rod", "{{ OA }} is 2.5 m long. The rod", "OA = 2.5 m"),
        ("ru", "Шток", "{{ OA }} = 2,5 м. Шток", "OA = 2,5 м"),
    ],
)
def test_a_length_that_a_text_gives_is_checked_too(
    language: str, old: str, new: str, said: str, tmp_path: Path
) -> None:
    """Cranks are 14 to 40 cm long, so 2.5 m is none."""
    found = failures(damaged(tmp_path, "oscillating_cylinder", (f"statement.{language}.j2", old, new)))
    assert any(f"the sheet says {said}, but these points are" in failure.replace("\xa0", " ") for failure in found)


def test_copies_of_one_mistake_are_one_message(tmp_path: Path) -> None:
    change = ("statement.ru.j2", "отстоит от оси {{ O }} на {{ e }}", "проходит мимо {{ O }}")
    (found,) = failures(damaged(tmp_path, "slider_crank", change))
    first, second = found.split("\n")
    assert first == "statement.ru.j2, form 'offset', seed 0: the text says nothing of e, that in en does"
    shown = "; ".join(f"statement.ru.j2, form 'offset', seed {seed}" for seed in (1, 2, 3))
    assert second == f"      and {SEEDS - 1} more forms/variants: {shown}; ..."


def test_seventeen_copies_are_counted_and_three_named() -> None:
    report = Report("own")
    for number in range(17):
        report.fail(f"the length is {number} cm", f"form {number}", "length OA")
    report.fail("something else", "form 3")
    assert report.failures == [
        "form 0: the length is 0 cm\n      and 16 more forms/variants: form 1; form 2; form 3; ...",
        "form 3: something else",
    ]
    assert report.as_json()["failures"] == report.failures
    assert report.as_text().count("    ! ") == 2


def test_a_family_without_worked_cases_is_told_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = damaged(tmp_path, "rolling_wheel")
    assert check_family(str(path), SEEDS).remarks == []
    (path / "cases.toml").unlink()
    assert main(["check", str(path), "--seeds", str(SEEDS)]) == 0
    assert "(no worked cases: nothing from outside confirms the answers" in capsys.readouterr().out


@pytest.mark.parametrize("family", ["point_on_rotating_disc", "sliding_block_on_rotating_rod"])
def test_a_rate_of_nothing_is_as_exact_as_the_others(family: str) -> None:
    """A given relative acceleration of 0 is solved to within the rounding of the other accelerations."""
    assert not [failure for failure in check_family(family, 20).failures if "the sheet says" in failure]


def test_words_that_are_right_pass(tmp_path: Path) -> None:
    """A picture that is never mirrored: the crank turns clockwise, the wheel rolls to the right, in both languages."""
    crank = damaged(
        tmp_path,
        "oscillating_cylinder",
        ("family.toml", "mirror = true", "mirror = false"),
        ("family.toml", "sense = { choices = { counter_clockwise = 1, clockwise = -1 } }\n", ""),
        ("family.toml", "sense * omega_OA", "-omega_OA"),
        ("statement.en.j2", "The rod", "The crank {{ OA }} turns clockwise, not to the left of {{ C }}. The rod"),
        ("statement.ru.j2", "Шток", "Кривошип {{ OA }} вращается по часовой стрелке. Шток"),
    )
    (crank / "cases.toml").unlink()
    assert failures(crank, MORE) == []
    wheel = damaged(
        tmp_path,
        "rolling_wheel",
        ("family.toml", "[screens]", "[pose]\nmirror = false\n[screens]"),
        ("statement.en.j2", "At the given instant its centre {{ O }}", "Its centre {{ O }} moves to the right and"),
        ("statement.ru.j2", "В данный момент его центр {{ O }}", "Его центр {{ O }} движется вправо и"),
    )
    assert failures(wheel, MORE) == []


def test_every_language_can_be_read() -> None:
    """The same senses and nouns in each language, so that texts can be compared."""
    words = [vocabulary(name) for name in languages()]
    assert len(words) >= 2
    assert all(word.senses.keys() == words[0].senses.keys() for word in words)
    assert all(word.nouns.keys() == words[0].nouns.keys() for word in words)
    assert {"faster", "slower", "clockwise", "counter_clockwise", "up", "down", "left", "right"} <= words[
        0
    ].senses.keys()


@pytest.mark.parametrize(
    ("language", "key", "yes", "no"),
    [
        ("en", "clockwise", "turns clockwise", "turns counterclockwise"),
        ("en", "clockwise", "turns clockwise", "turns counter-clockwise"),
        ("en", "slower", "which is decreasing at", "which is increasing at"),
        ("en", "counter_clockwise", "turns anticlockwise", "turns clockwise"),
        ("en", "up", "moves vertically upwards", "speeds up"),
        ("en", "down", "is moving down", "slows down"),
        ("en", "left", "moves to the left", "moves to the left of the wall"),
        ("ru", "clockwise", "по часовой стрелке", "против часовой стрелки"),
        ("ru", "counter_clockwise", "против хода часовой стрелки", "по ходу часовой стрелки"),
        ("ru", "down", "движется вертикально вниз", "движется вверх"),
        ("ru", "faster", "вращается ускоренно", "угловое ускорение"),
        ("ru", "right", "движется вправо", "справа от стены"),
    ],
)
def test_words_are_told_apart(language: str, key: str, yes: str, no: str) -> None:
    pattern = vocabulary(language).senses[key]
    assert pattern.search(yes)
    assert not pattern.search(no)


# What is called a crank and cannot go full circle, or a rocker and can: family, language, what is written, what is
# written instead, what is told. The screens of four_bar are Grashof's conditions.
CALLED = [
    ("sleeve_on_crank", "en", "the driving link {{ OA }}", "the crank {{ OA }}", "the text calls OA a crank"),
    ("sleeve_on_crank", "ru", "на ведущем звене {{ OA }}", "на кривошипе {{ OA }}", "the text calls OA a crank"),
    ("slotted_rocker", "en", "of the arm {{ CB }}", "of the rocker {{ CB }}", "the text calls CB a rocker"),
]


@pytest.mark.parametrize(("family", "language", "old", "new", "told"), CALLED)
def test_a_crank_goes_full_circle_and_a_rocker_does_not(
    family: str, language: str, old: str, new: str, told: str, tmp_path: Path
) -> None:
    found = [
        text for text in failures(damaged(tmp_path, family, (f"statement.{language}.j2", old, new))) if told in text
    ]
    assert len(found) == 1
    assert f"statement.{language}.j2" in found[0]
    assert "call it a link" in found[0]


def test_a_crank_needs_the_lengths_for_it(tmp_path: Path) -> None:
    condition = '"OA + OC < AB + BC", "abs(AB - BC) < abs(OC - OA)"'
    found = failures(damaged(tmp_path, "four_bar", ("family.toml", f"[{condition}]", "[]")))
    assert any("the text calls OA a crank, but it cannot go full circle" in text for text in found)
