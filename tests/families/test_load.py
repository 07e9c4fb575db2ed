"""A wrong family or scene file gets a message that names file, key, value and remedy."""

from __future__ import annotations

import json
import resource
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.families.reading.load import load_family
from variantgen.resources import catalog_dir
from variantgen.single import one_variant

HEAD = 'length_unit = "cm"\n'
POINTS = """
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 45 } }
"""
BODIES = '[bodies]\nOA = ["O", "A"]\n'
JOINT = '[[joints]]\npivot = { point = "O" }\n'
DRIVER = '[[drivers]]\nrotation = { body = "OA", omega = 2 }\n'
CRANK = HEAD + POINTS + BODIES + JOINT + DRIVER
APART = """
[points]
O = { coordinates = { x = 0, y = 0 } }
C = { coordinates = { x = 10, y = 0 } }
A = { polar = { origin = "O", distance = 1, angle = 30 } }
B = { circle_circle = { first = "A", first_distance = 1, second = "C", second_distance = 1, side = "left" } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
BC = ["C", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
pivot = { point = "C" }
[[drivers]]
rotation = { body = "OA", omega = 1 }
"""


def crank(old: str, new: str) -> str:
    assert old in CRANK
    return CRANK.replace(old, new)


class Bench:
    """Runs commands on a scene file in a folder of its own."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.folder, self.capsys = folder, capsys
        self.file = folder / "scene.toml"

    def run(self, content: str | bytes, command: str, *options: str) -> tuple[int, str, str]:
        self.file.write_bytes(content if isinstance(content, bytes) else content.encode())
        code = main([command, str(self.file), *options])
        out, message = self.capsys.readouterr()
        assert "Traceback" not in message
        return code, out, message

    def refused(self, content: str | bytes) -> str:
        """The message of ``check``, which is the one of ``solve`` too."""
        code, _, message = self.run(content, "check", "--seeds", "3")
        assert code == 2, message
        assert str(self.file) in message
        again = self.run(content, "solve", "--json")
        assert again == (2, "", message)
        assert list(self.folder.iterdir()) == [self.file]
        return message


@pytest.fixture
def bench(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Bench:
    """A bench: a file in an empty folder."""
    return Bench(tmp_path, capsys)


def test_the_sound_scene_is_solved(bench: Bench) -> None:
    code, out, message = bench.run(CRANK, "solve", "--json")
    assert code == 0, message
    assert json.loads(out)["outcome"] == "solved"


def test_an_edited_file_is_read_anew(tmp_path: Path) -> None:
    """A crank of 0.2 m turns with 2, then with 4 rad/s; both texts have the same length."""
    path = tmp_path / "crank.toml"
    for omega, speed in ((2, 0.4), (4, 0.8), (2, 0.4)):
        path.write_text(CRANK.replace("omega = 2", f"omega = {omega}"), "utf-8")
        assert abs(one_variant(str(path)).motion(1).v["A"][0]) == pytest.approx(speed)
        assert load_family(path) is load_family(str(path))


def test_folders_are_given_as_paths_or_texts(tmp_path: Path) -> None:
    shutil.copytree(catalog_dir() / "four_bar", tmp_path / "my_bars")
    for folders in ([tmp_path], (str(tmp_path),), tmp_path):
        assert load_family("my_bars", folders).name == "my_bars"
    for wrong in (5, [5]):
        with pytest.raises(InputError, match="folders: expected a list of folders"):
            load_family("my_bars", wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"\x89PNG\x00\xff", ["UTF-8"]),
        ("points = \n", ["not valid TOML", "line 1"]),
        (crank("length_unit", "lenght_unit"), ["lenght_unit: unknown key", "did you mean length_unit?"]),
        (crank('"cm"', '"kg"'), ["length_unit", "unknown unit", "kg"]),
        (crank('"cm"', '"deg"'), ["length_unit", "expected a unit of length", "deg"]),
        ("schema = 2\n" + CRANK, ["expected schema 1", "2"]),
        (CRANK + "[drivrs]\n", ["drivrs: unknown key", "drivers"]),
        (crank('origin = "O", ', ""), ["points.A.polar.origin: missing", "name of a point"]),
        (crank("distance = 20, ", ""), ["points.A.polar.distance: missing", "length"]),
        (crank("polar", "pollar"), ["points.A", "unknown kind", "pollar", "did you mean polar?"]),
        (crank("pivot", "pivo"), ["joints[1]", "unknown kind", "did you mean pivot?"]),
        (crank("rotation", "rotate"), ["drivers[1]", "unknown kind", "did you mean rotation"]),
        (CRANK + "[[joints]]\n", ["joints[2]", "expected one kind", "pivot"]),
        (CRANK + '[[joints]]\npivot = { point = "A" }\nguide = { point = "A" }\n', ["joints[2]", "one kind"]),
        (CRANK + "[[joints]]\npivot = 3\n", ["joints[2].pivot: expected a table", "3"]),
        (HEAD + POINTS + BODIES + '[joints]\npivot = { point = "O" }\n', ["joints: expected a list of tables"]),
        ("points = [1]\n" + BODIES, ["points: expected a table"]),
        ("bodies = 5\n" + POINTS, ["bodies: expected a table"]),
        (crank('["O", "A"]', "[1, 2]"), ["bodies.OA: expected a list of strings"]),
        (crank('origin = "O"', "origin = 1"), ["points.A.polar.origin", "expected the name of a point"]),
        (crank('["O", "A"]', '["A"]'), ["not determined", "velocity of A along x"]),
        (crank('["O", "A"]', "[]"), ["bodies.OA", "at least one point"]),
        (crank('["O", "A"]', '["A", "A"]'), ["bodies.OA", "lists a point twice", "A"]),
        (crank('["O", "A"]', '["O", "A1"]'), ["bodies.OA", "unknown point", "A1", "did you mean A?"]),
        (crank('point = "O"', 'point = "O1"'), ["joints", "unknown point", "O1", "did you mean O?"]),
        (crank('body = "OA"', 'body = "OB"'), ["drivers", "unknown body", "OB", "did you mean OA?"]),
        (crank('origin = "O"', 'origin = "A"'), ["points", "in a circle", "A"]),
        (crank("coordinates = { x = 0, y = 0 }", 'fraction = { start = "A", end = "A" }'), ["in a circle", "O -> A"]),
        (crank("angle = 45", 'angle = "20 cm"'), ["polar.angle", "20 cm", "angle is due", "deg"]),
        (crank("angle = 45", 'angle = "20 * cm"'), ["polar.angle", "is a length", "20 * cm"]),
        (crank("distance = 20", 'distance = "45 deg"'), ["polar.distance", "45 deg", "length is due", "cm"]),
        (crank("distance = 20", 'distance = "45 * deg"'), ["polar.distance", "expected a length", "45 * deg"]),
        (crank("distance = 20", "distance = []"), ["polar.distance", "expected a number or an expression"]),
        ("ask = ['v_Q']\n" + CRANK, ["ask[1]", "unknown quantity", "v_Q", "did you mean"]),
        ("ask = ['v_A', 'v_A']\n" + CRANK, ["ask", "asked twice"]),
        (HEAD + POINTS + BODIES + JOINT, ["not determined", "omega of OA", "add a driver"]),
        (HEAD + POINTS + BODIES + DRIVER, ["not determined", "velocity of O", "add a driver or a joint"]),
        (CRANK + DRIVER, ["repeat or contradict", "rotation of OA", "remove one"]),
        (CRANK + '[[joints]]\npivot = { point = "A" }\n', ["repeat or contradict", "rotation of OA", "A of OA"]),
        (CRANK + "[parameters]\nR = 5\n", ["parameters.R: expected a table"]),
        (CRANK + "[parameters]\nR = { unit = 'kg', values = [1] }\n", ["parameters.R.unit", "kg"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', from = 5, to = 1, step = 1 }\n", ["parameters.R", "empty range"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', from = 1, to = 5, step = 0 }\n", ["parameters.R", "step"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', from = 1, to = 5 }\n", ["parameters.R.step: missing"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', from = 1, to = 1e9, step = 1 }\n", ["parameters.R", "larger step"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', from = 1, to = inf, step = 1 }\n", ["R.to", "finite number"]),
        (CRANK + "[parameters]\nR = { unit = 'cm', values = [] }\n", ["parameters.R.values", "list of numbers"]),
        (CRANK + "[parameters]\nR = { choices = {} }\n", ["parameters.R.choices", "number for each word"]),
        (CRANK + "[parameters]\n'a b' = { unit = 'cm', values = [1] }\n", ["letter followed by letters", "a b"]),
        (CRANK + "[derived]\nx = 5\n", ["derived.x", "expression in quotes"]),
        (CRANK + "[derived]\nx = 'y'\ny = 'x'\n", ["derived", "in a circle", "x, y"]),
        (CRANK + "[screens]\nrequire = ['1 = 2']\n", ["screens.require[1]", "expected a comparison", "OA < AB"]),
        (CRANK + "[screens]\nspacing = -1\n", ["screens.spacing", "above 0"]),
        (CRANK + "[pose]\nquarter_turns = [7]\n", ["pose.quarter_turns", "0 to 3"]),
        (CRANK + "[figure]\nhidden = ['Q']\n", ["figure.hidden", "unknown point", "Q"]),
        (CRANK + "[nouns]\nOB = 'rod'\n", ["nouns.OB: unknown body", "OB", "did you mean OA?"]),
    ],
)
def test_wrong_scene(content: str | bytes, said: list[str], bench: Bench) -> None:
    message = bench.refused(content)
    assert all(part in message for part in said), message


@pytest.mark.parametrize(
    ("expression", "said"),
    [
        ("R", "unknown name"),
        ("__import__('os').system('x')", "not allowed"),
        ("().__class__", "not allowed"),
        ("cm.real", "not allowed"),
        ("9**9**9", "not allowed"),
        ("2**99999", "not allowed"),
        ("1e999", "ordinary size"),
        ("1+" * 2000 + "1", "longer than 200"),
        ("(" * 190 + "1", "not an arithmetic expression"),
        ("-" * 190 + "1", "length"),
        ("lambda: 1", "not allowed"),
        ("[x for x in y]", "not allowed"),
        ("1 if 2 else 3", "not allowed"),
        ("cm < 2", "not allowed"),
        ("(x := 1)", "not allowed"),
        ("f'{1}'", "not allowed"),
        ("'a' * 9", "not allowed"),
        ("True", "not allowed"),
        ("1j", "unknown unit"),
        ("sqrt()", "not allowed"),
        ("max(cm, cm, cm)", "not allowed"),
        ("sqrt(x=1)", "not allowed"),
        ("exec(1)", "unknown function"),
        ("sine(1)", "did you mean sin"),
        ("sin(20 * cm)", "adds or compares"),
        ("1 + cm", "adds or compares"),
        ("cm // 2", "not allowed"),
        ("", "not an arithmetic expression"),
        ("import os", "not an arithmetic expression"),
        ("cm; cm", "not an arithmetic expression"),
        ("10 parsec", "unknown unit"),
    ],
)
def test_wrong_or_hostile_expression(expression: str, said: str, bench: Bench) -> None:
    message = bench.refused(crank("distance = 20", f'distance = "{expression}"'))
    assert said in message
    assert "points.A.polar.distance" in message


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("distance = 20", 'distance = "20 cm"'),
        ("distance = 20", 'distance = "0.2 m"'),
        ("distance = 20", 'distance = "20 * cm"'),
        ("distance = 20", 'distance = "10 * cm + 10 * cm"'),
        ("angle = 45", 'angle = "45 deg"'),
        ("angle = 45", 'angle = "90 * deg - 45 * deg"'),
    ],
)
def test_units_and_expressions_may_both_be_written(old: str, new: str, bench: Bench) -> None:
    code, out, message = bench.run(crank(old, new), "solve", "--json")
    assert code == 0, message
    x, y = json.loads(out)["points"]["A"]["position"]
    assert (x, y) == pytest.approx((0.02**0.5, 0.02**0.5), rel=1e-12)


@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "1e400", "1e999999999999999999", "9" * 400, '"1e99999999 cm"'])
@pytest.mark.parametrize("field", ["distance = 20", "omega = 2", "angle = 45"])
def test_number_of_impossible_size(field: str, value: str, bench: Bench) -> None:
    name = field.split(" = ", maxsplit=1)[0]
    assert name in bench.refused(crank(field, f"{name} = {value}"))


@pytest.mark.parametrize(("field", "kind"), [("distance = 20", "a number"), ("omega = 2", "a number")])
def test_truth_value_for_a_number(field: str, kind: str, bench: Bench) -> None:
    message = bench.refused(crank(field, field.split(" = ", maxsplit=1)[0] + " = true"))
    assert kind in message
    assert "object" not in message
    assert "None" not in message


def test_unknown_field_offers_a_field_that_is_not_in_the_file(bench: Bench) -> None:
    message = bench.refused(crank("angle", "angel"))
    assert "points.A.polar.angel: unknown key" in message
    assert "did you mean angle?" in message


def test_unknown_screen_offers_a_screen_that_is_not_in_the_file(bench: Bench) -> None:
    assert "did you mean spacing" in bench.refused(CRANK + "[screens]\nspaceing = 1\n")


@pytest.mark.parametrize("content", ["", HEAD + POINTS, HEAD + POINTS + JOINT], ids=["empty", "points", "fixed point"])
def test_scene_without_motion(content: str, bench: Bench) -> None:
    bench.refused(content)


def test_every_mistake_is_reported(bench: Bench) -> None:
    message = bench.refused(
        CRANK.replace("polar", "pollar").replace('"O", "A"]', "1]").replace("omega = 2", 'omega = "2 m"')
        + "[figure]\nhidden = ['Q']\n"
    )
    assert all(key in message for key in ("points.A", "bodies.OA", "drivers[1].rotation.omega", "figure.hidden"))


def test_scene_that_does_not_assemble(bench: Bench) -> None:
    code, out, message = bench.run(APART, "solve", "--json")
    assert code == 2
    document = json.loads(out)
    assert document["outcome"] == "not_assembled"
    assert "points" not in document
    assert "answers" not in document
    assert all(part in message for part in (str(bench.file), "does not assemble", "change a length"))


def test_scene_that_does_not_assemble_fails_its_check(bench: Bench) -> None:
    code, out, message = bench.run(APART, "check")
    assert code != 0
    assert "assemble" in out + message


@pytest.mark.parametrize("command", ["check", "solve", "show"])
@pytest.mark.parametrize("name", ["no/such.toml", "for_bar", ".", ""])
def test_family_that_is_not_there(
    name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([command, name]) == 2
    message = capsys.readouterr().err
    assert "Traceback" not in message
    assert name in message
    if name == "for_bar":
        assert "did you mean four_bar?" in message


def family(folder: Path, template: str) -> Path:
    """A copy of a family of the catalogue with another English statement."""
    target = folder / "own_bar"
    shutil.copytree(catalog_dir() / "four_bar", target)
    (target / "statement.en.j2").write_text(template, encoding="utf-8")
    return target


BAD_TEMPLATES = [
    ("First line\n{% if form %}\nno end", "line 2", "statement.en.j2"),
    ("a\nb\n{{ OA ", "line 3", "statement.en.j2"),
    ("{{ nothing }}", "nothing", "unknown name"),
    ("{{ OAX }}", "OAX", "unknown name"),
    ("a\n{{ ''.__class__.__mro__ }}", "line 2: the attribute __mro__ is not allowed", "statement.en.j2"),
    ("{{ ().__class__.__base__.__subclasses__() }}", "line 1: call is not allowed", "statement.en.j2"),
    ("{{ zero.__globals__ }}", "line 1: the attribute __globals__ is not allowed", "statement.en.j2"),
    ("a\nb {{ choice.clear() }}", "line 2: call is not allowed", "statement.en.j2"),
    ("{% for i in range(10**9) %}x{% endfor %}", "for is not allowed", "only symbols, if, set"),
    ("{{ 1 / 0 }}", "div is not allowed", "statement.en.j2"),
    ("{% set a = 'x' %}{% set a = a ~ a %}", "concat is not allowed", "statement.en.j2"),
    ("{% macro f() %}{{ f() }}{% endmacro %}", "macro is not allowed", "statement.en.j2"),
    ("{{ zero('nothing') }}", "template fails", "statement.en.j2"),
    ("a\n\n{{ zero() }}", "line 3: the template fails", "statement.en.j2"),
    ("{{ choice.nothing }}", "template fails", "statement.en.j2"),
    ("{% include '/etc/passwd' %}", "include is not allowed", "statement.en.j2"),
    ("{% set x = [1] %}{{ x[5] }}", "line 1: set of a list is not allowed", "statement.en.j2"),
    ("{{ form | nosuchfilter }}", "filter is not allowed", "line 1"),
    ("{{ '%d' | format('x') }}", "filter is not allowed", "statement.en.j2"),
]


@pytest.mark.parametrize(("template", "said", "also"), BAD_TEMPLATES)
def test_bad_template(template: str, said: str, also: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = family(tmp_path, template)
    assert main(["show", str(folder)]) == 2
    message = capsys.readouterr().err
    assert all(part in message for part in (said, also, str(folder / "statement.en.j2"))), message
    assert "Traceback" not in message


@pytest.mark.parametrize(("template", "said", "also"), BAD_TEMPLATES[::3])  # each kind of fault, and the include
def test_check_tells_of_a_bad_template(
    template: str, said: str, also: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = family(tmp_path, template)
    assert main(["check", str(folder), "--seeds", "2"]) in {1, 2}
    found = capsys.readouterr()
    assert said in found.out + found.err
    assert also in found.out + found.err
    assert "root:" not in found.out + found.err


@pytest.mark.parametrize(("template", "said", "also"), BAD_TEMPLATES[:5])
def test_bad_template_of_an_exam_writes_nothing(
    template: str, said: str, also: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = family(tmp_path, template)
    exam = tmp_path / "exam.toml"
    exam.write_text(f'title = "T"\nlanguage = "en"\n[[problem]]\nfamily = "{folder.as_posix()}"\n', encoding="utf-8")
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "out")]) == 2
    message = capsys.readouterr().err
    assert said in message
    assert also in message
    assert sorted(path.name for path in tmp_path.iterdir()) == ["exam.toml", "own_bar"]


NESTED = "{% for i in range(99999) %}" * 9 + "{% endfor %}" * 9


@pytest.mark.parametrize(
    "template", ["{{ 9**9**9**9 }}", "{{ 'a' * 10**10 }}", "{{ [0] * 10**10 }}", NESTED, "x" * 10**7]
)
def test_template_that_eats_time_or_memory(template: str, tmp_path: Path) -> None:
    folder = family(tmp_path, template)
    done = subprocess.run(
        [sys.executable, "-m", "variantgen", "show", str(folder)],
        capture_output=True,
        text=True,
        timeout=5,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30)),
    )
    assert done.returncode == 2, done.stderr
    assert "Traceback" not in done.stderr
    assert "statement.en.j2" in done.stderr


def test_missing_language_of_a_family(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = family(tmp_path, "{{ OABC }}")
    (folder / "statement.ru.j2").unlink()
    assert main(["show", str(folder), "--lang", "ru"]) == 2
    message = capsys.readouterr().err
    assert all(part in message for part in ("no statement in the language ru", "statement.ru.j2", "write this file"))


def test_template_that_is_not_utf8(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = family(tmp_path, "")
    (folder / "statement.en.j2").write_bytes("Кривошип".encode("cp1251"))
    assert main(["show", str(folder)]) == 2
    message = capsys.readouterr().err
    assert "statement.en.j2" in message
    assert "Traceback" not in message


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--set", "OA"], "NAME=VALUE"),
        (["--set", "=3"], "NAME=VALUE"),
        (["--set", "OA="], "NAME=VALUE"),
        (["--set", "OA=30 kg"], "unknown unit"),
        (["--set", "OB=30"], "unknown parameter"),
        (["--set", "side=up"], "unknown word"),
        (["--form", "krank"], "did you mean crank?"),
        (["--ask", "v_Q"], "unknown quantity"),
    ],
)
@pytest.mark.parametrize("command", ["solve", "show"])
def test_bad_options(command: str, options: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "four_bar", *options]) == 2
    out, message = capsys.readouterr()
    assert said in message
    assert out == ""


@pytest.mark.parametrize("name", ["page.txt", "page", "none/page.pdf"])
def test_show_to_an_impossible_file(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", "spool", "--out", str(tmp_path / name)]) == 2
    message = capsys.readouterr().err
    assert "--out" in message
    assert "Traceback" not in message
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("old", "new", "key", "number"),
    [
        ('en = "Four-bar linkage"', r'en = "Four\u0001bar"', "title.en", "U+0001"),
        ('en = "Four-bar linkage"', r'en = "Four\ue000bar"', "title.en", "U+E000"),
        ('en = "Four-bar linkage"', r'en = "Four\u202ebar"', "title.en", "U+202E RIGHT-TO-LEFT OVERRIDE"),
        ("[forms.crank]", r'[forms."crank\u200b"]', "U+200B", "U+200B ZERO WIDTH SPACE"),
    ],
)
def test_names_and_texts_that_cannot_be_seen(
    old: str, new: str, key: str, number: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = family(tmp_path, "{{ OABC }}")
    text = (folder / "family.toml").read_text("utf-8")
    assert old in text
    (folder / "family.toml").write_text(text.replace(old, new), "utf-8")
    assert main(["show", str(folder)]) == 2
    message = capsys.readouterr().err
    assert number in message
    assert key in message
    assert str(folder / "family.toml") in message


def test_a_choice_cannot_bring_marks_of_formulas(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Words of choices may stand in a statement, where such characters enclose the number of a formula."""
    folder = family(tmp_path, "{{ OABC }} {{ choice.side }}")
    path = folder / "family.toml"
    text = path.read_text("utf-8")
    assert "choices = { left = 1, right = -1 }" in text
    path.write_text(text.replace("{ left = 1,", r'{ "\ue0009\ue001" = 1,'), "utf-8")
    assert main(["show", str(folder)]) == 2
    assert "holds a character of private use (got U+E000)" in capsys.readouterr().err
