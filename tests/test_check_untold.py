"""A number that an answer depends on and no sheet tells is found by the check, and nothing else is."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.check.family import check_family
from variantgen.check.untold import untold_numbers
from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.reading.files import FAMILY
from variantgen.families.reading.load import load_family
from variantgen.single import asked_quantities, one_variant
from variantgen.skeletons import new_family
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

_ON_NO_SHEET = "is on no sheet"
_ROD = '{ line_circle = { through = "O", centre = "A", distance = "AB" } }'


def _own(folder: Path, *changes: tuple[str, str, str]) -> Path:
    """A new family, a slider-crank mechanism, after changes of its files: file, what stands there, what shall."""
    path = new_family("own", folder)
    for file, old, new in changes:
        text = (path / file).read_text("utf-8")
        assert old in text
        (path / file).write_text(text.replace(old, new), "utf-8")
    return path


def _found(path: Path) -> list[str]:
    return [failure for failure in check_family(str(path), seeds=10).failures if _ON_NO_SHEET in failure]


# A guide that is inclined; one that passes the axis at a distance; a rod as long as the file says; a crank that is
# turned further than its angle says; one that is a part of the printed length; a rate that only the file has.
@pytest.mark.parametrize(
    ("old", "new", "place", "number", "asked"),
    [
        (_ROD, _ROD.replace("}", ', angle = "35*deg" }', 1), 'points.B.line_circle.angle', "35 deg", "v_B"),
        ('through = "O"', 'through = "G"', "points.G.coordinates.y", "3 cm", "v_B, omega_AB, a_B, epsilon_AB"),
        ('distance = "AB"', "distance = 65", "points.B.line_circle.distance", "65 cm", "v_B, omega_AB"),
        ('angle = "phi"', 'angle = "phi + 7*deg"', 'points.A.polar.angle = "phi + 7*deg"', "7 deg", "v_B"),
        ('distance = "OA"', 'distance = "0.9*OA"', 'points.A.polar.distance = "0.9*OA"', "0.9", "v_B"),
        ('"sense * omega_OA"', '"7 rad/s"', "drivers.1.rotation.omega", "7 rad/s", "v_B, omega_AB, a_B"),
    ],
)  # fmt: skip
def test_a_number_of_the_file_alone_is_found(
    old: str, new: str, place: str, number: str, asked: str, tmp_path: Path
) -> None:
    further = ("G = { coordinates = { x = -40, y = 3 } }\n" if '"G"' in new else "") + "B = "
    (failure,) = _found(_own(tmp_path, (FAMILY, old, new), (FAMILY, "\nB = ", f"\n{further}")))
    assert place in failure
    assert f"the number {number} {_ON_NO_SHEET}, and {asked}" in failure
    assert "make it a parameter, which is printed, derive it from parameters, or let the statement tell it" in failure


_OFFSET = (
    (FAMILY, 'through = "O"', 'through = "G"'),
    (FAMILY, "\nB = ", "\nG = { coordinates = { x = -40, y = 3 } }\nB = "),
)
_ENGLISH = ("statement.en.j2", "slider {{ B }}.", "slider {{ B }}. The guide passes O at a distance of 3 cm.")
_RUSSIAN = ("statement.ru.j2", "ползуном {{ B }}.", "ползуном {{ B }}. Направляющая проходит на расстоянии 3 см от O.")


def test_what_the_statement_tells_in_both_languages_is_told(tmp_path: Path) -> None:
    assert not _found(_own(tmp_path / "both", *_OFFSET, _ENGLISH, _RUSSIAN))
    assert _found(_own(tmp_path / "one", *_OFFSET, _ENGLISH))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        # Where a point of the guide lies, by a parameter or a number; a point that nothing hangs on.
        (_ROD, _ROD.replace('"O"', '"G"') + '\nG = { coordinates = { x = "-2*OA", y = 0 } }'),
        (_ROD, _ROD + '\nG = { coordinates = { x = "130*cm", y = 0 } }'),
        (_ROD, _ROD.replace('"O"', '"G"') + '\nG = { coordinates = { x = "17*cm", y = 0 } }'),
        # The same number in two places that must agree: nothing depends on it.
        (_ROD, _ROD.replace('"AB" }', '"AB + 13*cm - 13*cm" }')),
    ],
)
def test_numbers_that_no_answer_depends_on_need_not_be_told(old: str, new: str, tmp_path: Path) -> None:
    assert not _found(_own(tmp_path, (FAMILY, old, new)))


def test_what_only_may_be_asked_is_a_remark(tmp_path: Path) -> None:
    point = "\nB = ", '\nD = { fraction = { start = "A", end = "B", part = 0.35 } }\nB = '
    path = _own(tmp_path, (FAMILY, *point), (FAMILY, 'AB = ["A", "B"]', 'AB = ["A", "B", "D"]'))
    report = check_family(str(path), seeds=10)
    assert not [failure for failure in report.failures if _ON_NO_SHEET in failure]
    (remark,) = [remark for remark in report.remarks if _ON_NO_SHEET in remark]
    assert "points.D.fraction.part" in remark
    assert "v_D, a_D depend on it, which may be asked; name in may_ask" in remark


_SCENE = """
length_unit = "cm"
ask = ["v_B"]
[parameters]
OA = { unit = "cm", values = [20] }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = 50 } }
B = { line_circle = { through = "O", centre = "A", distance = DISTANCE } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = 3 }
"""


@pytest.mark.parametrize("distance", ["60", '"2*OA"', '"OA + 37*cm"'])
def test_a_scene_tells_its_own_numbers(distance: str, tmp_path: Path) -> None:
    path = scene_file(tmp_path, _SCENE.replace("DISTANCE", distance))
    assert not _found(path)


_INCLINED = """
length_unit = "mm"
ask = ["v_B"]
[points]
O = { coordinates = { x = 0, y = 0 } }
C = { coordinates = { x = -40, y = 60 } }
A = { polar = { origin = "C", distance = 40, angle = 40 } }
B = { line_circle = { through = "O", angle = PLACED, centre = "A", distance = 90 } }
[bodies]
CA = ["C", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "C" }
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B", angle = 35 }
[[drivers]]
rotation = { body = "CA", omega = 2 }
"""


def test_a_sheet_tells_through_which_point_the_line_of_a_guide_passes(tmp_path: Path) -> None:
    """Where B is placed on the line of its guide; on another line through O the sheet leaves that one open."""
    path = tmp_path / "scene.toml"
    for placed, told in (("35", True), ("36", False)):
        path.write_text(_INCLINED.replace("PLACED", placed), "utf-8")
        variant = one_variant(str(path))
        for language, said in (("en", "its line passes through O"), ("ru", "её линия проходит через точку O")):
            text = statement(variant, asked_quantities(variant), load_language(language)).text
            words = "".join(part if isinstance(part, str) else to_plain(part) for part in text)
            assert (said in words) is told
        assert bool(_found(path)) is not told


@pytest.mark.parametrize("folder", ["textbook_kinds", "kind_scenes", "books"])
def test_the_scenes_of_the_tests_tell_every_number(folder: str) -> None:
    paths = [path for path in Path(__file__).parent.joinpath(folder).glob("*.toml") if ".book." not in path.name]
    assert len(paths) > 20
    for path in paths:
        variant = one_variant(str(path))
        assert not list(untold_numbers([variant], asked_quantities(variant))), path.name


# What the sheet cannot tell, because the figure does not show the point.
@pytest.mark.parametrize(
    ("scene", "hidden", "numbers"),
    [
        ("textbook_kinds/boat_rope", "K", {"points.K.coordinates.x", "points.K.coordinates.y"}),
        ("textbook_kinds/crank_shaper", "C", {"points.C.coordinates.x", "points.C.coordinates.y"}),
        ("textbook_kinds/excavator", "H", {"points.H.on_body.across"}),
        ("kind_scenes/crank_turned", "A", {"points.A.polar.distance", "points.B.line_circle.distance"}),
        ("kind_scenes/stephenson", "E", {"points.E.on_body.along", "points.E.on_body.across"}),
    ],
)
def test_a_number_that_the_sheet_of_a_scene_leaves_open_is_found(
    scene: str, hidden: str, numbers: set[str], tmp_path: Path
) -> None:
    text = Path(__file__).parent.joinpath(f"{scene}.toml").read_text("utf-8")
    path = scene_file(tmp_path, f'{text}\n[figure]\nhidden = ["{hidden}"]\n')
    variant = one_variant(str(path))
    found = {found.places: found for found in untold_numbers([variant], asked_quantities(variant))}
    assert numbers <= found.keys()
    if hidden == "H":  # the same number with another sign stands in another place
        assert "the number 0.4 m is on no sheet" in found["points.H.on_body.across"].message
    assert _found(path)


def test_what_hangs_on_the_end_of_the_rod_cannot_be_asked() -> None:
    """The end D of the rod beyond the collar is told by no sheet: neither its motion nor motion as seen from it."""
    form = next(iter(load_family("sleeve_on_crank").forms.values()))
    assert read_ask(form, ["v_B", "v_C.x"])
    for name in ("v_D", "a_D", "v_A/D"):
        with pytest.raises(InputError, match="do not determine it"):
            read_ask(form, [name])
