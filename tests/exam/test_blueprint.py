"""A wrong exam file gets a message that names file, key, value and remedy; nothing is written."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import pytest

from variantgen.cli import main

HEAD = 'title = "Quiz"\nlanguage = "en"\n'
BAR = '[[problem]]\nfamily = "four_bar"\nform = "crank"\n'
GOOD = HEAD + BAR
FILES = ["key.csv", "key.pdf", "manifest.json", "sheets.pdf", "solutions.pdf"]


@contextlib.contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Fail instead of running for ever."""

    def late(number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"not done after {seconds} s")

    previous = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)


class Bench:
    """Builds exams in a folder of its own."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.folder, self.capsys = folder, capsys
        self.exam, self.out = folder / "exam.toml", folder / "out"

    def build(self, content: str | bytes, *options: str, variants: int = 2) -> tuple[int, str]:
        self.exam.write_bytes(content if isinstance(content, bytes) else content.encode())
        return self.run(str(self.exam), "--variants", str(variants), *options)

    def run(self, *arguments: str) -> tuple[int, str]:
        with at_most(5):
            code = main(["build", *arguments, "--out", str(self.out)])
        return code, self.capsys.readouterr().err

    def refused(self, content: str | bytes, *options: str, variants: int = 2) -> str:
        code, message = self.build(content, *options, variants=variants)
        assert code == 2, message
        assert "Traceback" not in message
        assert "Warning" not in message
        assert [path.name for path in self.folder.iterdir()] == ["exam.toml"]
        return message


@pytest.fixture
def bench(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Bench:
    return Bench(tmp_path, capsys)


def test_missing_file(bench: Bench) -> None:
    code, message = bench.run(str(bench.exam), "--variants", "1")
    assert code == 2
    assert str(bench.exam) in message
    assert "No such file" in message
    assert not bench.out.exists()


def test_folder(bench: Bench) -> None:
    code, message = bench.run(str(bench.folder), "--variants", "1")
    assert code == 2
    assert "directory" in message


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"\x89PNG\r\n\x1a\n\x00", "UTF-8"),
        (GOOD.encode("utf-16"), "UTF-8"),
        ('title = "Экзамен"\n'.encode("cp1251"), "UTF-8"),
        ("title = \n", "line 1"),
        ("title = 'a'\ntitle = 'b'\n", "line 2"),
        (HEAD + "x = " + "[" * 5000, "not valid TOML"),
        (HEAD + "seed = " + "9" * 5000, "a number of more than 1000 digits in line 3"),
        (GOOD + "#" * 1_000_001, "larger than"),
    ],
    ids=["png", "utf-16", "cp1251", "no value", "twice", "deep", "long number", "large"],
)
def test_not_a_toml_text(content: str | bytes, said: str, bench: Bench) -> None:
    message = bench.refused(content)
    assert str(bench.exam) in message
    assert said in message


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", ["title: missing", "language: missing", "at least one problem", "[[problem]]"]),
        (HEAD, ["at least one problem", "[[problem]]"]),
        (HEAD + "problem = 5\n", ["problem: expected a list of tables", "5"]),
        (HEAD + "problem = [1]\n", ["problem[1]: expected a table"]),
        (HEAD + '[problem]\nfamily = "spool"\n', ["problem: expected a list of tables"]),
        ('title = 5\nlanguage = "en"\n' + BAR, ["title: expected a string", "5"]),
        ('title = "a"\nlanguage = 5\n' + BAR, ['language: expected "en" or "ru"', "5"]),
        ('title = "a"\nlanguage = "rus"\n' + BAR, ["language", "rus", "did you mean ru?"]),
        ('title = "a"\nlanguage = "../words/en"\n' + BAR, ["language", "known: en, ru"]),
        (HEAD + "tolerence = 0.1\n" + BAR, ["tolerence: unknown key", "did you mean tolerance?"]),
        (HEAD + "[page]\nduplx = true\n" + BAR, ["page.duplx", "did you mean duplex?"]),
        (HEAD + "[page]\nduplex = 1\n" + BAR, ["page.duplex: expected true or false"]),
        (HEAD + "page = 1\n" + BAR, ["page: expected a table"]),
        (HEAD + "course = []\n" + BAR, ["course: expected a string"]),
        (HEAD + "seed = 1.5\n" + BAR, ["seed: expected a whole number or a word"]),
        (HEAD + "schema = 2\n" + BAR, ["expected schema 1", "another version"]),
        (HEAD + 'schema = "1"\n' + BAR, ["schema: expected a whole number"]),
        (HEAD + 'solutions = "full"\n' + BAR, ["solutions: expected a table"]),
        (HEAD + '[solutions]\ndepth = "fulll"\n' + BAR, ["solutions.depth: expected one of", "did you mean full?"]),
        (HEAD + '[solutions]\ndepht = "full"\n' + BAR, ["solutions.depht: unknown key", "did you mean depth?"]),
        (HEAD + '[solutions]\nlanguage = "rus"\n' + BAR, ["solutions.language", "rus", "did you mean ru?"]),
        (HEAD + '[solutions]\nfiles = "student"\n' + BAR, ["solutions.files: expected one of", "mean students?"]),
        (HEAD + '[notation]\nangular_acceleration = "alfa"\n' + BAR, ["notation.angular_acceleration", "mean alpha?"]),
        (HEAD + "[notation]\ncomponents = 1\n" + BAR, ["notation.components: expected a string"]),
        (GOOD + 'method = "velocity_center"\n', ["problem[1].method: unknown method", "did you mean velocity_centre"]),
        (GOOD + 'method = ["graphical", "graphical"]\n', ["problem[1].method: a method is named twice"]),
        (GOOD + "method = 3\n", ["problem[1].method: expected a list of strings"]),
        (GOOD + 'familly = "x"\n', ["problem[1].familly: unknown key", "did you mean family"]),
        (HEAD + "[[problem]]\n", ["problem[1].family: missing"]),
        (HEAD + '[[problem]]\nfamily = "for_bar"\n', ["problem[1]", "for_bar", "did you mean four_bar?"]),
        (HEAD + '[[problem]]\nfamilies = ["spool", "spol"]\n', ["problem[1]", "spol", "did you mean spool?"]),
        (HEAD + "[[problem]]\nfamilies = []\n", ["problem[1].family: missing"]),
        (HEAD + '[[problem]]\nfamilies = "spool"\n', ["problem[1].families: expected a list of strings"]),
        (GOOD + 'families = ["spool"]\n', ["problem[1].families", "keep one"]),
        (GOOD + 'ask = ["v_Q"]\n', ["problem[1].ask[1]", "v_Q", "did you mean"]),
        (GOOD + 'ask = ["v_B", "v_B"]\n', ["problem[1].ask", "asked twice"]),
        (GOOD + "ask = []\n", ["problem[1].ask", "at least one"]),
        (GOOD + 'ask = "v_Q"\n', ["problem[1].ask[1]", "v_Q", "did you mean"]),
        (GOOD + 'ask = ["v_B", 5]\n', ["problem[1].ask: expected a list of quantities", '"velocities"']),
        (GOOD + "points = -1\n", ["problem[1].points", "from 0 to 1000", "-1"]),
        (GOOD + 'points = "10"\n', ["problem[1].points: expected a whole number"]),
        (GOOD + "points = true\n", ["problem[1].points: expected a whole number"]),
        (GOOD.replace("crank", "krank"), ["problem[1].form", "krank", "did you mean crank?"]),
        (GOOD.replace('"crank"', '["crank", "rokker"]'), ["problem[1].form", "did you mean rocker?"]),
        (GOOD.replace('"crank"', "{}"), ["problem[1].form"]),
        (GOOD + "set = 5\n", ["problem[1].set: expected a table"]),
        (GOOD + "range = []\n", ["problem[1].range: expected a table"]),
    ],
)
def test_wrong_key_or_value(content: str, said: list[str], bench: Bench) -> None:
    message = bench.refused(content)
    assert str(bench.exam) in message
    assert all(part in message for part in said), message


@pytest.mark.parametrize("value", ["0", "-1", "5", "nan", "inf", '"1"', "true", "1e400", "1e-400", "[]"])
def test_bad_tolerance(value: str, bench: Bench) -> None:
    assert "tolerance: expected a number" in bench.refused(HEAD + f"tolerance = {value}\n" + BAR)


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ('OA = "30 kg"', ["set.OA", "unknown unit", "kg"]),
        ('OA = "30 deg"', ["set.OA", "deg measures angle", "length is due", "use cm"]),
        ('phi = "30 cm"', ["set.phi", "cm measures length", "angle is due", "use deg"]),
        ('OA = "thirty"', ["set.OA", "thirty", 'like "30"']),
        ('OA = ""', ["set.OA", "expected a number"]),
        ("OA = nan", ["set.OA", "expected a number", "NaN", "the family draws 16, 18"]),
        ("OA = inf", ["set.OA", "expected a number"]),
        ("OA = true", ["set.OA", "expected a number"]),
        ("OA = [1]", ["set.OA", "expected a number"]),
        ("OA = {}", ["set.OA", "expected a number"]),
        ("OA = 1979-05-27", ["set.OA", "expected a number"]),
        ("OB = 30", ["set.OB", "unknown parameter", "did you mean"]),
        ('sense = "clokwise"', ["set.sense", "clokwise", "did you mean clockwise"]),
        ("sense = 1", ["set.sense", "unknown word", "clockwise"]),
        ("sense = []", ["set.sense", "unknown word"]),
    ],
)
def test_bad_fixed_value(setting: str, said: list[str], bench: Bench) -> None:
    message = bench.refused(GOOD + f"set = {{ {setting} }}\n")
    assert all(part in message for part in ["problem[1]", str(bench.exam), *said]), message


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("OA", "1e30"),
        ("OA", "1e400"),
        ("OA", "1e999999999999999999"),
        ("OA", "9" * 400),
        ("OA", '"1e999 cm"'),
        ("OA", '"1e99999999999999999999999 m"'),
        ("OA", "0"),
        ("OA", "-5"),
        ("OA", '"-5 cm"'),
        ("OA", "1e-400"),
        ("phi", "1e400"),
        ("omega_OA", "1e300"),
        ("omega_OA", "1e999999999999999999"),
    ],
)
def test_value_of_impossible_size(name: str, value: str, bench: Bench) -> None:
    message = bench.refused(GOOD + f"set = {{ {name} = {value} }}\n")
    assert name in message


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("OA = [17, 17]", ["range.OA", "grid", "[17, 17]", "the family draws 16, 18"]),
        ("OA = [500, 600]", ["range.OA", "grid", "the family draws 16, 18"]),
        ("OA = [20, 16]", ["range.OA", "[20, 16]"]),
        ("OA = [16]", ["range.OA", "expected [lowest, highest]"]),
        ("OA = [16, 20, 30]", ["range.OA", "expected [lowest, highest]"]),
        ("OA = 16", ["range.OA", "expected [lowest, highest]"]),
        ("OA = {}", ["range.OA", "expected [lowest, highest]"]),
        ('OA = ["16 kg", 20]', ["range.OA", "unknown unit", "kg"]),
        ('OA = ["16 deg", 20]', ["range.OA", "length is due"]),
        ("OA = [nan, inf]", ["range.OA", "expected a number"]),
        ("OA = [[1], 20]", ["range.OA", "expected a number"]),
        ("OAA = [16, 20]", ["range.OAA", "unknown parameter", "did you mean OA?"]),
        ('sense = ["up"]', ["range.sense", "unknown word", "up"]),
        ("sense = []", ["range.sense"]),
    ],
)
def test_bad_range(setting: str, said: list[str], bench: Bench) -> None:
    message = bench.refused(GOOD + f"range = {{ {setting} }}\n")
    assert all(part in message for part in ["problem[1]", *said]), message


def test_fixed_and_ranged_at_once(bench: Bench) -> None:
    message = bench.refused(GOOD + "set = { OA = 30 }\nrange = { OA = [20, 40] }\n")
    assert all(part in message for part in ("problem[1].set.OA", "both fixed and given a range", "remove one"))


IMPOSSIBLE = GOOD + "set = { OA = 16, AB = 30, BC = 24, OC = 100 }\n"


def test_mechanism_that_cannot_assemble(bench: Bench) -> None:
    message = bench.refused(IMPOSSIBLE)
    # 16 + 100 cm against 30 + 24 cm: not even the crank's condition is met.
    assert all(part in message for part in ("four_bar/crank", "no valid variant", "OA + OC < AB + BC", "widen"))
    assert all(name in message for name in ("OA", "AB", "BC", "OC"))


def test_impossible_ranges_name_file_and_problem(bench: Bench) -> None:
    message = bench.refused(IMPOSSIBLE.replace(BAR, '[[problem]]\nfamily = "spool"\n' + BAR))
    assert str(bench.exam) in message
    assert "problem[2]" in message


@pytest.mark.parametrize(
    ("ask", "students"),
    [('ask = ["v_B", "a_B"]\n', 2), ("", 3), ("", 300)],
    ids=["magnitudes", "the mirror image has rates of other signs", "many"],
)
def test_more_students_than_variants(ask: str, students: int, bench: Bench) -> None:
    """Everything is fixed, so there is one variant and its mirror image."""
    fixed = "OA = 30, AB = 60, BC = 50, OC = 70, phi = 60, omega_OA = 2, epsilon_OA = 2"
    exam = GOOD + ask + f'set = {{ {fixed}, sense = "clockwise", side = "left" }}\n'
    message = bench.refused(exam, variants=students)
    assert all(part in message for part in ("four_bar", "too few", str(students), "widen"))


@pytest.mark.parametrize("ask", ["", 'ask = ["v_B", "omega_AB"]\n'], ids=["default", "velocities"])
def test_mechanism_at_rest_is_no_problem(ask: str, bench: Bench) -> None:
    """Velocities that are all zero are no answers."""
    assert "omega_OA" in bench.refused(GOOD + ask + "set = { omega_OA = 0 }\n")


def test_many_mistakes_are_all_reported(bench: Bench) -> None:
    message = bench.refused(
        'title = 5\nlanguage = "fr"\ntolerance = 9\ncorse = "x"\n[page]\nduplx = 1\n'
        '[[problem]]\nfamily = "four_baz"\n'
        '[[problem]]\nfamily = "spool"\npoints = -4\nask = ["v_ZZ"]\n'
        '[[problem]]\nfamily = "four_bar"\nset = { OA = "3 kg", phi = "3 cm" }\n'
    )
    keys = ("title", "language", "tolerance", "corse", "page.duplx", "four_baz", "problem[2].points")
    keys += ("problem[2].ask[1]", "problem[3].set.OA", "problem[3].set.phi")
    assert [key for key in keys if key not in message] == []


def test_unknown_key_offers_a_key_that_is_not_in_the_file(bench: Bench) -> None:
    assert "did you mean ask?" in bench.refused(GOOD + 'asks = ["v_B"]\n')


@pytest.mark.parametrize("line", ["points = 1.5", "points = nan", "ask = 2020-01-01"])
def test_values_are_shown_as_in_the_file(line: str, bench: Bench) -> None:
    message = bench.refused(GOOD + line + "\n")
    assert line.split(" = ")[1].casefold() in message.casefold()
    assert "Decimal" not in message
    assert "datetime" not in message


@pytest.mark.parametrize("value", ["5", "1.5", "true", "[1]", "{}"])
@pytest.mark.parametrize("key", ["family", "families", "form", "ask"])
def test_wrong_types_in_a_problem(key: str, value: str, bench: Bench) -> None:
    problem = f"[[problem]]\n{key} = {value}\n"
    if not key.startswith("famil"):
        problem += 'family = "four_bar"\n'
    message = bench.refused(HEAD + problem)
    assert f"problem[1].{key}" in message


@pytest.mark.parametrize("name", ["", ".", "/", "a" * 300, "a\\u0000b", "../exams", "no/such/file.toml"])
def test_strange_family_names(name: str, bench: Bench) -> None:
    message = bench.refused(HEAD + f'[[problem]]\nfamily = "{name}"\n')
    assert "problem[1]" in message or name in message
    assert not message.startswith("variantgen: .:")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--jobs", "0"), "--jobs"),
        (("--jobs", "-3"), "--jobs"),
    ],
)
def test_bad_jobs(options: tuple[str, ...], said: str, bench: Bench) -> None:
    assert said in bench.refused(GOOD, *options)


@pytest.mark.parametrize("count", [0, -1, 1_000_001])
def test_bad_number_of_variants(count: int, bench: Bench) -> None:
    message = bench.refused(GOOD, variants=count)
    assert "--variants" in message
    assert str(count) in message


@pytest.mark.parametrize("extra", [("--variants", "1", "--roster", "x.csv"), (), ("--variants", "many")])
def test_wrong_arguments(extra: tuple[str, ...], bench: Bench) -> None:
    with pytest.raises(SystemExit) as stop:
        bench.run("sample_en", *extra)
    message = bench.capsys.readouterr().err
    assert stop.value.code == 2
    assert "usage" in message
    assert not bench.out.exists()


def test_existing_folder_needs_force(bench: Bench) -> None:
    bench.out.mkdir()
    (bench.out / "mine.txt").write_text("keep")
    code, message = bench.build(GOOD)
    assert code == 2
    assert all(part in message for part in ("--out", str(bench.out), "exists", "--force"))
    assert [path.name for path in bench.out.iterdir()] == ["mine.txt"]


def test_force_replaces_the_whole_folder(bench: Bench) -> None:
    bench.out.mkdir()
    (bench.out / "key.csv").write_text("old")
    code, message = bench.build(GOOD, "--force")
    assert code == 0, message
    assert sorted(p.name for p in bench.out.iterdir()) == sorted([*FILES, "edited"])
    assert (bench.out / "edited" / "1" / "key.csv").read_text() == "old", "nothing says that it is ours"
    assert sorted(path.name for path in bench.folder.iterdir()) == ["exam.toml", "out"]


def test_wrong_input_with_force_keeps_the_old_folder(bench: Bench) -> None:
    bench.out.mkdir()
    (bench.out / "mine.txt").write_text("keep")
    code, _ = bench.build(IMPOSSIBLE, "--force")
    assert code == 2
    assert [path.name for path in bench.out.iterdir()] == ["mine.txt"]


@pytest.mark.parametrize("force", [(), ("--force",)], ids=["", "force"])
def test_output_is_a_file(force: tuple[str, ...], bench: Bench) -> None:
    bench.out.write_text("keep")
    code, message = bench.build(GOOD, *force)
    assert code == 2
    assert "--out" in message
    assert bench.out.read_text() == "keep"


@pytest.mark.parametrize("inside", ["none/out", "exam.toml/out"], ids=["no parent", "parent is a file"])
def test_parent_is_no_folder(inside: str, bench: Bench) -> None:
    bench.out = bench.folder / inside
    message = bench.refused(GOOD)
    assert all(part in message for part in ("--out", "parent", "make it first"))


def test_output_through_a_link_to_nowhere(bench: Bench) -> None:
    bench.out.symlink_to(bench.folder / "none" / "deeper")
    code, message = bench.build(GOOD)
    assert code == 2, message
    assert "--out" in message
