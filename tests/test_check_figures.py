"""``check --figures`` draws every form, and replaces only what an earlier check has drawn."""

from __future__ import annotations

import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.resources import catalog_dir

# A load on a thread over a fixed pulley on the right of the drum that winds it up.
SCENE = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
K = { coordinates = { x = 60, y = 10 } }
B = { coordinates = { x = 65, y = -30 } }
M = { coordinates = { x = 0, y = 20 } }
[bodies]
drum = ["O", "M"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B", angle = 90 }
[[joints]]
rope.path = [
    { point = "O", radius = 10, side = "left", body = "drum" },
    { point = "K", radius = 5, side = "left", fixed = true },
    { point = "B" },
]
[[drivers]]
rotation = { body = "drum", omega = 2 }
"""


def check(folder: Path, *names: str) -> int:
    return main(["check", *names, "--seeds", "3", "--figures", str(folder)])


def test_every_form_is_drawn_and_can_be_drawn_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "look"
    assert check(folder, "scotch_yoke") == 0
    assert sorted(path.name for path in folder.iterdir()) == ["scotch_yoke-oblique.svg", "scotch_yoke-straight.svg"]
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    for content in before.values():
        assert ET.fromstring(content).tag == "{http://www.w3.org/2000/svg}svg"
    assert f"2 figures in {folder}" in capsys.readouterr().err
    assert check(folder, "scotch_yoke") == 0
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_scene_is_drawn_with_its_rope(tmp_path: Path) -> None:
    """Which side a rope has is seen: it comes to the pulley elsewhere if it leaves the drum on the other side."""
    drawn = {}
    for side in ("left", "right"):
        scene = tmp_path / f"{side}.toml"
        scene.write_text(SCENE.replace('radius = 10, side = "left"', f'radius = 10, side = "{side}"'), "utf-8")
        assert check(tmp_path / "look", str(scene)) == 0
        drawn[side] = (tmp_path / "look" / f"{side}.svg").read_text("utf-8").split("\n", 2)[2]
    assert drawn["left"] != drawn["right"]


@pytest.mark.parametrize("how", ["foreign", "edited", "link", "folder"])
def test_what_no_check_has_drawn_is_not_replaced(how: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "look"
    assert check(folder, "scotch_yoke") == 0
    mine, other = folder / "scotch_yoke-straight.svg", folder / "scotch_yoke-oblique.svg"
    target = tmp_path / "target.svg"
    shutil.copyfile(mine, target)
    content = mine.read_bytes()
    mine.unlink()
    other.unlink()
    match how:
        case "foreign":
            mine.write_text("<svg/>", "utf-8")
        case "edited":
            mine.write_bytes(content.replace(b"</svg>", b"<text>look here</text></svg>"))
        case "link":
            mine.symlink_to(target)
        case "folder":
            mine.mkdir()
    kept = mine.read_bytes() if mine.is_file() else b""
    capsys.readouterr()
    assert check(folder, "scotch_yoke") == 2
    message = capsys.readouterr()
    assert f"--figures: is no figure of a check (got {mine})" in message.err
    assert message.out == ""
    assert not other.exists()
    assert (mine.read_bytes() if mine.is_file() else b"") == kept
    assert target.read_bytes() == content


def test_the_folder_must_have_a_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("", "utf-8")
    assert check(tmp_path / "file", "spool") == 2
    assert "--figures: is a file, not a folder" in capsys.readouterr().err
    assert check(tmp_path / "none" / "look", "spool") == 2
    assert "--figures: the parent folder does not exist" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file"]


def test_names_of_forms_stay_in_the_folder(tmp_path: Path) -> None:
    """Forms are named in the file of the family; two families may have the same name."""
    for place in ("one", "two"):
        shutil.copytree(catalog_dir() / "scotch_yoke", tmp_path / place / "yoke")
        path = tmp_path / place / "yoke" / "family.toml"
        path.write_text(path.read_text("utf-8").replace("[forms.straight", '[forms."../../straight"'), "utf-8")
        for file in (tmp_path / place / "yoke").glob("statement.*"):
            file.write_text(file.read_text("utf-8").replace('"straight"', '"../../straight"'), "utf-8")
        (tmp_path / place / "yoke" / "cases.toml").unlink()
    check(tmp_path / "look", str(tmp_path / "one" / "yoke"), str(tmp_path / "two" / "yoke"))
    assert sorted(path.name for path in (tmp_path / "look").iterdir()) == [
        "yoke-oblique-2.svg",
        "yoke-oblique.svg",
        "yoke-straight-2.svg",
        "yoke-straight.svg",
    ]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["look", "one", "two"]


def test_a_form_without_variants_is_drawn_as_it_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An author sees what a form looks like of which no variant can be drawn."""
    shutil.copytree(catalog_dir() / "spool", tmp_path / "spool")
    path = tmp_path / "spool" / "family.toml"
    path.write_text(path.read_text("utf-8").replace('"r < 0.75 * R"', '"r > 5 * R"'), "utf-8")
    assert check(tmp_path / "look", str(tmp_path / "spool")) == 1
    assert "no valid variant found" in capsys.readouterr().out
    assert [file.name for file in (tmp_path / "look").iterdir()] == ["spool.svg"]
