"""Composed families: accepted by check, the same each time, in exams; what cannot be made is told."""

from __future__ import annotations

import json
import re
import shutil
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from variantgen.check.family import check_family
from variantgen.cli.app import main
from variantgen.errors import InputError
from variantgen.exam import composed_pools
from variantgen.families.asking import read_ask
from variantgen.families.family import Form
from variantgen.families.method_names import METHODS
from variantgen.families.reading.cases import load_cases
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc
from variantgen.figure.drawing import Path as Line
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.step import Balance, Sentence
from variantgen.synthesis.levels import level
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import parse_code
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain
from variantgen.wording.solution.plain import plain_solution


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("composed") / "one"
    assert main(["compose", "--structure", "RPR01-RRR23", "--seed", "8", "--out", str(folder)]) == 0
    return folder


def test_check_accepts_it_with_its_worked_case(made: Path) -> None:
    report = check_family(str(made), seeds=8)
    assert not report.failures
    assert report.cases == ["moved-1"]


def test_the_same_seed_gives_the_same_files(made: Path, tmp_path: Path) -> None:
    again = tmp_path / "again"
    assert main(["compose", "--structure", "RPR01-RRR23", "--seed", "8", "--out", str(again)]) == 0
    for path in made.iterdir():
        assert path.read_bytes() == (again / path.name).read_bytes()


def test_data_stay_few_and_the_last_dyad_is_asked(made: Path) -> None:
    family = load_family(made)
    form = next(iter(family.forms.values()))
    assert len([name for name, p in form.parameters.items() if p.given and p.unit]) <= 11  # ten, and epsilon_OA
    assert any(name.endswith(tuple(list(form.bodies)[-2:])) for name in form.ask)
    assert load_cases(family)[0].exact.keys() == set(form.ask)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--groups", "RRR,XYZ"], "unknown group"),
        (["--groups", ","], "a kind is empty"),
        (["--groups", "RRR,,RRP"], "a kind is empty"),
        (["--groups", "RRR,RRR,WR"], "a kind is named twice"),
        (["--links", "4"], "3, 5 or 7"),
        (["--links", "4"], "name one of WR, WP in groups"),
        (["--groups", "RRR,WR02"], "compose --structure RRR01-WR02 takes the links"),
        (["--structure", "RRR01", "--level", "hard"], "calculations"),
        (["--groups", "PRP,RPP", "--links", "5"], "no structure is like that"),
        (["--structure", "RRR"], "code of a structure"),
        (["--structure", "RRR01", "--links", "3"], "says all of them"),
        (["--exam", "exam.toml"], "has no place for --out"),
    ],
)
def test_what_cannot_be_made_is_told(
    options: list[str], told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["compose", *options, "--out", str(tmp_path / "new")]) == 2
    assert told in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


def test_a_structure_that_is_not_of_textbooks_gets_a_notice(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(tmp_path / "new")
    assert main(["compose", "--structure", "RRR01-RRR01", "--out", out]) == 0  # two outputs
    assert "no textbook" in capsys.readouterr().err


def test_levels() -> None:
    assert level(parse_code("RRR01")) == level(parse_code("RPR01")) == "easy"
    assert level(parse_code("RRR01-RRP20")) == "medium"
    assert level(parse_code("RRR01-RPR02")) == level(parse_code("RRR01-RRR23")) == "hard"
    assert level(parse_code("RRR01-RRR02-RRR04")) == "hard"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("pool")
    (folder / "exam.toml").write_text(
        'title = "Composed"\nlanguage = "en"\n[[problem]]\n'
        'compose = { groups = ["RRP"], links = 3, structures = 2, seed = 2 }\n'
    )
    assert main(["build", str(folder / "exam.toml"), "--variants", "2", "--out", str(folder / "out")]) == 0
    return folder


def _nothing_is_composed(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise AssertionError("composed again")

    monkeypatch.setattr(composed_pools, "write", refuse)
    monkeypatch.setattr(composed_pools, "_pools", {})


def test_an_exam_of_composed_problems_is_verified_from_its_manifest(
    built: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    _nothing_is_composed(monkeypatch)
    assert main(["verify", str(built / "out")]) == 0
    assert "all right" in capsys.readouterr().err
    recorded = json.loads((built / "out" / "manifest.json").read_text("utf-8"))["composed"]
    assert sorted(name[:6] for name in recorded) == ["rrp01_", "rrp10_"]


def test_a_manifest_leads_to_no_other_folder(built: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (built / "out" / "manifest.json").read_text("utf-8")
    (tmp_path / "manifest.json").write_text(text.replace('"rrp01_', '"../rrp01_'), "utf-8")
    assert main(["verify", str(tmp_path)]) == 2
    assert "expected the name of a family" in capsys.readouterr().err


def test_a_pool_beside_the_exam_is_taken_as_a_whole(
    built: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text((built / "exam.toml").read_text())
    assert main(["compose", "--exam", str(exam)]) == 0
    told = [line for line in capsys.readouterr().err.splitlines() if line.startswith("composing")]
    if told:  # unless a test before has made the same pool
        assert told[0] == "composing problem 1: 0 of 2 families"
        assert told[-1] == "composing problem 1: 2 of 2 families"
    kept = sorted(path for path in tmp_path.iterdir() if path.is_dir())
    assert [path.name[:6] for path in kept] == ["rrp01_", "rrp10_"]
    _nothing_is_composed(monkeypatch)
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "out")]) == 0
    for name in ("key.csv", "sheets.pdf"):  # the same sheets wherever the pool lies
        assert (tmp_path / "out" / name).read_bytes() == (built / "out" / name).read_bytes()
    capsys.readouterr()
    shutil.rmtree(kept[0])
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "out2")]) == 2
    assert "has 1 families of this pool" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("compose", "told"),
    [
        ('{ groups = ["RRP"], links = 4 }', "3, 5 or 7 moving links"),
        ('{ groups = ["RRP"], links = 3, structures = 3 }', "there are only 2 such structures"),
        ("{ structures = 0 }", "from 1 to 60"),
        ('{ group = ["RRP"] }', "did you mean"),
        ('{ groups = ["RRP", "RRP"] }', "a kind is named twice"),
    ],
)
def test_a_pool_that_cannot_be_is_told(
    compose: str, told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(f'title = "Composed"\nlanguage = "en"\n[[problem]]\ncompose = {compose}\n')
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "no")]) == 2
    assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ("pionts = 5", "did you mean points"),
        ('[[problem]]\nfamily = "four_barr"', "did you mean four_bar"),
        ("[marking]\ntolerance = -1", "above 0"),
        ('[marking]\nstruck = ["1.v_B", "7"]', "the exam has no such problem"),
        ("[page]\nduplx = true", "did you mean duplex"),
    ],
)
def test_everything_else_is_checked_before_families_are_composed(
    more: str, told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    _nothing_is_composed(monkeypatch)
    exam = tmp_path / "exam.toml"
    head = 'title = "Composed"\nlanguage = "en"\n[[problem]]\ncompose = { links = 3, structures = 2 }\n'
    exam.write_text(f"{head}{more}\n")
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "no")]) == 2
    message = capsys.readouterr().err
    assert told in message
    assert "composing" not in message


def test_members_of_a_pool_ask_for_the_same_and_take_nearly_the_same(tmp_path: Path) -> None:
    codes = ("RRR01", "RRP01", "RRP10", "RPR01", "RPP10")
    made = [
        composed_pools._Member(calculations, accelerations, parse_code(name), tmp_path / name)
        for name, calculations, accelerations in zip(
            codes, (30, 37, 36, 33, 35), (True, True, True, True, False), strict=True
        )
    ]
    assert {member.calculations for member in composed_pools._alike(made, 9)} == {30, 36, 33}  # 36 is 1.2 times 30


def test_it_has_the_structure_that_it_was_made_for(made: Path) -> None:
    form = next(iter(load_family(made).forms.values()))
    assert parse_code("RPR01-RRR23") in structures_of(form.sample)


def test_a_wheel_rolls_at_the_end(tmp_path: Path) -> None:
    """Its centre moves as a slider would, and it turns by v over r: by hand, from what the key says."""
    folder = tmp_path / "wheel"
    assert main(["compose", "--groups", "RRR,RRW", "--seed", "3", "--out", str(folder)]) == 0
    family = load_family(folder)
    form = next(iter(family.forms.values()))
    assert parse_code(family.source.rpartition(" ")[2]) in structures_of(form.sample)
    variant = draw(family, None, [("wheel", 1)])[0]
    motion = variant.motion()
    centre = form.bodies["wheel1"][0]
    radius = float(variant.printed["r"]) / 100
    assert abs(motion.omega["wheel1"][0]) * radius == pytest.approx(abs(motion.v[centre][0]), rel=1e-9)
    assert motion.v[centre][0].imag == pytest.approx(0, abs=1e-12)


def test_a_gear_at_the_end_is_turned_by_the_gear_on_a_link(tmp_path: Path) -> None:
    """The other way round, in the ratio of the radii: by hand, from the data of the sheet."""
    folder = tmp_path / "gear"
    assert main(["compose", "--groups", "RRR,WR", "--seed", "1", "--out", str(folder)]) == 0
    family = load_family(folder)
    form = next(iter(family.forms.values()))
    assert structures_of(form.sample) == {parse_code("RRR01-WR20")}
    variant = draw(family, None, [("gear", 1)])[0]
    motion = variant.motion()
    radii = {name: float(variant.printed[name]) for name in ("R", "r")}
    own = radii[str(form.figure.discs[1].name)]
    other = sum(radii.values()) - own
    assert motion.omega["gear1"][0] * own == pytest.approx(-motion.omega[_driving(form)][0] * other, rel=1e-9)


@pytest.mark.parametrize("name", ["RRR01-WR02", "RRP01-WR02"])
def test_a_gear_on_a_moving_axle_rolls_on_a_fixed_one(name: str, tmp_path: Path) -> None:
    """Its pitch point is at rest: by hand, from the speed of the axle and the data of the sheet."""
    form, variant = _terminal(name, tmp_path)
    motion, arm = variant.motion(), next(iter(form.bodies["gear1"]))
    radius = float(variant.printed["r"] if "R" not in variant.printed else variant.printed[_own(form)]) / 100
    turned = motion.omega["gear1"][0]
    assert abs(turned) * radius == pytest.approx(abs(motion.v[arm][0]), rel=1e-9)
    axis = next(joint.fields["other_centre"] for joint in form.joints if joint.component is Gears)
    link = next(body for body, points in form.bodies.items() if arm in points and axis in points)
    assert np.sign(turned) == np.sign(motion.omega[link][0])  # outside a fixed gear: in the sense of its arm
    if len(form.bodies["gear1"]) > 1:  # a point of the rim across the line of centres
        rim = form.bodies["gear1"][1]
        assert abs(motion.v[rim][0]) == pytest.approx(abs(motion.v[arm][0]) * 2**0.5, rel=1e-9)


def test_a_gear_drives_a_rack(tmp_path: Path) -> None:
    form, variant = _terminal("RRR01-WP20", tmp_path)
    motion = variant.motion()
    slider = next(points[0] for body, points in form.bodies.items() if body.startswith("rack"))
    radius = float(variant.printed["r"]) / 100
    assert abs(motion.v[slider][0]) == pytest.approx(abs(motion.omega[_driving(form)][0]) * radius, rel=1e-9)
    assert abs(motion.a[slider][0]) == pytest.approx(abs(motion.epsilon[_driving(form)][0]) * radius, rel=1e-9)


def test_a_rack_is_called_a_rack_and_does_not_hide_its_slider(tmp_path: Path) -> None:
    form, variant = _terminal("RRR01-WP20", tmp_path)
    motion, asked, english = variant.motion(), read_ask(form), load_language("en")
    text = plain_solution(explain(variant, motion, 0, asked, english), english)
    text = " ".join(text.split())
    assert "has the velocity of the rack" in text
    assert " bar" not in text
    assert "rod AB" in text  # as in the statement
    assert "link AB" not in text
    drawing = statement_figure(variant, motion, 0, asked, english)
    paths = [line for line in drawing.lines if isinstance(line, Line)]
    (rack,) = (line for line in paths if line.fill == "shade")
    box = next(line for line in paths if line.closed and line.fill == "paper" and len(line.points) == 4)
    assert rack.layer < box.layer
    assert sum(isinstance(line, Arc) and line.dash == "dashdot" for line in drawing.lines) == 1  # the pitch circle


@pytest.mark.parametrize("name", ["RRP01-WR20", "RRP10-WR30"])
def test_what_shows_the_sense_of_an_angular_acceleration_is_said(name: str, tmp_path: Path) -> None:
    form, variant = _terminal(name, tmp_path)
    for language, said in (("en", r"\(a⃗_\w+\)_t shows that α_1 is"), ("ru", r"Судя по a⃗\^τ_\w+, ε_1 направлено")):
        spoken = load_language(language)
        text = plain_solution(explain(variant, variant.motion(), 0, read_ask(form), spoken), spoken)
        assert re.search(said, " ".join(text.split()))


def test_a_rack_on_a_slider_drives_a_gear(tmp_path: Path) -> None:
    _, variant = _terminal("RRP10-WR30", tmp_path)
    motion, radius = variant.motion(), float(variant.printed["r"]) / 100
    assert abs(motion.omega["gear1"][0]) * radius == pytest.approx(abs(motion.v["B"][0]), rel=1e-9)


def _terminal(name: str, folder: Path) -> tuple[Form, Variant]:
    """A variant of a composed structure, which is that of its family and is solved by three methods."""
    assert main(["compose", "--structure", name, "--seed", "1", "--out", str(folder / "made")]) == 0
    family = load_family(folder / "made")
    form = next(iter(family.forms.values()))
    assert parse_code(name) in structures_of(form.sample)
    assert not check_family(str(folder / "made"), seeds=4).failures
    variant = draw(family, None, [("end", 1)])[0]
    asked = read_ask(variant.form)
    task = task_of(variant, variant.motion(), 0, asked)
    solved = 0
    for method in METHODS:
        with suppress(InputError):
            solved += len(solution(task, [method]).answers) == len(asked)
    assert solved >= 3
    return form, variant


def _driving(form: Form) -> str:
    """The link with a gear that drives another gear or a rack."""
    meshes = (joint for joint in form.joints if joint.component in (Gears, Rolling))
    return next(joint.fields["other" if joint.component is Gears else "body"] for joint in meshes)


def _own(form: Form) -> str:
    """The name of the radius of the last gear."""
    return next(str(disc.name) for disc in form.figure.discs if disc.body == "gear1")


@pytest.mark.parametrize(
    "text", ["RRR01-WR30", "RRP10-WR20", "RRR01-WR20-RRR04", "RRR01-WR01", "RRR01-WP02", "RRP10-WP30"]
)
def test_a_gear_hangs_on_a_link_about_a_fixed_axis(text: str) -> None:
    with pytest.raises(InputError, match="code of a structure"):
        parse_code(text)


@pytest.mark.parametrize("text", ["RRW01", "RRW12", "RRW10-RRR02-RRR30", "RRR01-RRW20-RPR50"])
def test_a_wheel_hangs_on_a_rod_and_carries_nothing(text: str) -> None:
    with pytest.raises(InputError, match="code of a structure"):
        parse_code(text)


def test_structures_are_listed_and_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "--structures"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 6 + 68 + 9 + 10  # those that end with a rolling wheel, and with a gear or a rack
    assert next(line for line in lines if line.startswith("RRR01 ")).split()[1:4] == ["easy", "four_bar", "crank,"]
    page = tmp_path / "structures.html"
    assert main(["list", "--structures", "--links", "3", "--figure", str(page)]) == 0
    assert page.read_text("utf-8").count("<svg") == 6 + 1
    assert main(["list", "--structures", "--figure", str(tmp_path / "page.png")]) == 2


def test_its_solution_is_written_by_three_methods(made: Path) -> None:
    """Its second group hangs on an arm that is fixed to the block of a slotted arm and turns with that."""
    variant = draw(load_family(made), None, [("methods", 1)])[0]
    asked = read_ask(variant.form)
    task = task_of(variant, variant.motion(), 0, asked)
    written = [solution(task, [method]) for method in ("velocity_centre", "graphical", "coordinates")]
    assert all(len(found.answers) == len(asked) for found in written)
    said = [item.key for step in written[0].steps for item in step.items if isinstance(item, Sentence)]
    assert "turning.same_omega" in said


def _texts(name: str, folder: Path) -> list[str]:
    """The English solutions of some variants of a composed family, each on one line."""
    assert main(["compose", "--structure", name, "--seed", "2026", "--out", str(folder)]) == 0
    english = load_language("en")
    variants = draw(load_family(folder), None, [("text", place) for place in range(6)])
    found = [explain(v, v.motion(), 0, read_ask(v.form), english) for v in variants]
    return [" ".join(plain_solution(text, english).split()) for text in found]


def test_where_a_centre_of_a_wheel_accelerates_to_is_said_with_the_reason_alone(tmp_path: Path) -> None:
    for text in _texts("RRP10-RRW20", tmp_path / "made"):
        assert re.search(r"Directions: a⃗_D along the path of D[;.]", text)
        assert re.search(r"so a⃗_D points to the (left|right):", text)


def test_the_direction_of_a_velocity_by_components_is_found_once_in_letters(tmp_path: Path) -> None:
    for text in _texts("RRR01-RRR03", tmp_path / "made"):
        (law,) = re.findall(r"θ_C = (φ[^=]* arctan\(\|v_C η / v_C ξ\|\)) =", text)
        assert text.count(law) == 1


@pytest.mark.parametrize("name", ["RRP10-RRP03-RRR45", "RRR01-RRP12-RRR45"])
def test_links_that_hang_on_a_sliding_block_are_reached(name: str, tmp_path: Path) -> None:
    """Its last rods are pinned to a rod that carries a block and to an arm of this block, link by link."""
    assert main(["compose", "--structure", name, "--seed", "1", "--out", str(tmp_path / "made")]) == 0
    variant = draw(load_family(tmp_path / "made"), None, [("methods", 1)])[0]
    asked = read_ask(variant.form)
    task = task_of(variant, variant.motion(), 0, asked)
    for method in ("velocity_centre", "graphical"):
        assert len(solution(task, [method]).answers) == len(asked)


def test_a_rod_through_a_sleeve_about_a_fixed_axis_has_a_check(tmp_path: Path) -> None:
    """The velocities at the sleeve add up to zero: on another axis, those that were found balance that of A."""
    folder = tmp_path / "sleeve"
    assert main(["compose", "--structure", "RPR01", "--seed", "3", "--out", str(folder)]) == 0
    for variant in draw(load_family(folder), None, [("check", place) for place in range(5)]):
        motion = variant.motion()
        sentence, balance = solution(task_of(variant, motion, 0, read_ask(variant.form))).check
        assert isinstance(sentence, Sentence)
        assert isinstance(balance, Balance)
        v = 100 * motion.v["A"][0]  # cm/s
        by_axis = {"check.third_axis": (abs(v.real), abs(v.imag))}.get(sentence.key, (abs(v),))
        for side in (balance.left, balance.right):
            assert min(abs(abs(side.exact) - size) for size in by_axis) < 1e-6
