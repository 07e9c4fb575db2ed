"""A joint, a driver and a construction are added by files of their own; no list and no other module has to be edited.

They are copies of kinds that there are, under other names, so that nothing in the package can know them.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.package_copy import PackageCopy

# Of each new kind: its folders, the file that is copied, its own name, the names of the classes.
_WHEEL = ("mechanism/joints", "figure/symbols", "figure/alt_text/kinds", "methods/coordinates/equations")
ADDED = [
    ((*_WHEEL, "methods/groups/contact_laws"), "rolling", "trundling", "Rolling", "Trundling"),
    (("mechanism/joints", "figure/symbols", "methods/coordinates/equations"), "guide", "rail", "Guide", "Rail"),
    (("mechanism/drivers", "figure/symbols", "methods/coordinates/equations"), "rotation", "spin", "Rotation", "Spin"),
    (("mechanism/constructions", "methods/geometry/placing"), "fraction", "middle", "SegmentFraction", "Middle"),
]
PHRASES = {
    "en": 'rail = "block {point} is on a rail"\nspin = "{body} is driven"\n',
    "ru": 'rail = "камень {point} на рельсе"\nspin = "{body} — ведущее звено"\n',
}


@pytest.fixture(scope="module")
def added(tmp_path_factory: pytest.TempPathFactory) -> PackageCopy:
    copy = PackageCopy.of(tmp_path_factory.mktemp("package"), ["slider_crank", "four_bar", "wheel_with_rod"])
    for folders, old, new, old_class, new_class in ADDED:
        for folder in folders:
            text = (copy.root / "variantgen" / folder / f"{old}.py").read_text("utf-8")
            text = re.sub(rf"\b{old_class}\b", new_class, re.sub(rf"\.{old} import", f".{new} import", text))
            (copy.root / "variantgen" / folder / f"{new}.py").write_text(text, "utf-8")
    for lang, phrases in PHRASES.items():
        copy.replace(f"templates/words/{lang}.toml", "\npivot = ", f"\n{phrases}pivot = ")
    copy.replace("catalog/slider_crank/family.toml", "{ guide =", "{ rail =")
    copy.replace("catalog/slider_crank/family.toml", "{ rotation =", "{ spin =")
    copy.replace("catalog/four_bar/family.toml", "{ fraction =", "{ middle =")
    copy.replace("catalog/wheel_with_rod/family.toml", "\nrolling =", "\ntrundling =")
    return copy


@pytest.mark.parametrize("family", ["slider_crank", "four_bar", "wheel_with_rod"])
def test_families_that_use_them_are_right(added: PackageCopy, family: str) -> None:
    checked = added.run("check", family)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    assert f"{family}: ok" in checked.stdout


def test_solutions_go_from_group_to_group(added: PackageCopy) -> None:
    solved = added.run("solve", "slider_crank", "--form", "central", "--seed", "1", "--explain")
    assert "The perpendiculars to v⃗_A and v⃗_B (along" in " ".join(solved.stdout.split()), solved.stderr
    halved = added.run(
        "solve",
        "four_bar",
        "--form",
        "crank",
        "--seed",
        "1",
        "--ask",
        "v_M",
        "--method",
        "velocity_centre",
        "--explain",
    )
    assert re.search(r"AM = AB ?/ ?2", halved.stdout), halved.stdout + halved.stderr


def test_a_wheel_on_the_ground_turns_about_its_contact(added: PackageCopy) -> None:
    solved = added.run("solve", "wheel_with_rod", "--seed", "1", "--explain")
    assert "The wheel rolls without slip; the contact P is its instantaneous centre" in solved.stdout, solved.stderr


def test_sheets_show_and_tell_them(added: PackageCopy) -> None:
    exam = 'title = "T"\nlanguage = "en"\nformats = ["html"]\n[[problem]]\nfamily = "slider_crank"\nform = "central"\n'
    (added.root / "exam.toml").write_text(exam, "utf-8")
    made = added.run("build", "exam.toml", "--variants", "1", "--out", "out")
    assert made.returncode == 0, made.stderr
    pages = "".join(path.read_text("utf-8") for path in (added.root / "out" / "html").rglob("*.html"))
    assert "Block B is on a rail" in pages
    assert "OA is driven" in pages.replace("Oa", "OA")


@pytest.mark.parametrize(
    ("folder", "name", "command"),
    [
        ("figure/symbols", "rail", ("show", "slider_crank", "--form", "central", "--figure", "figure.svg")),
        ("figure/symbols", "spin", ("show", "slider_crank", "--form", "central", "--figure", "figure.svg")),
        (
            "methods/coordinates/equations",
            "spin",
            ("solve", "slider_crank", "--form", "central", "--explain", "--method", "coordinates"),
        ),
        (
            "methods/geometry/placing",
            "middle",
            ("solve", "four_bar", "--ask", "v_M", "--method", "velocity_centre", "--explain"),
        ),
    ],
)
def test_what_is_left_out_is_named(
    added: PackageCopy, tmp_path: Path, folder: str, name: str, command: tuple[str, ...]
) -> None:
    path = added.root / "variantgen" / folder / f"{name}.py"
    aside = path.rename(tmp_path / path.name)
    try:
        done = added.run(*command)
    finally:
        aside.rename(path)
    assert done.returncode != 0
    assert f"variantgen.{folder.replace('/', '.')}.{name}" in done.stderr


def test_a_kind_that_nobody_added_is_an_error(added: PackageCopy) -> None:
    added.replace("catalog/slider_crank/family.toml", "{ rail =", "{ rial =")
    try:
        done = added.run("show", "slider_crank")
    finally:
        added.replace("catalog/slider_crank/family.toml", "{ rial =", "{ rail =")
    assert done.returncode == 2
    assert "rial" in done.stderr
    assert "did you mean rail?" in done.stderr
