"""README and docs cannot rot: commands parse, exam files are read, paths and names exist, links lead somewhere."""

from __future__ import annotations

import argparse
import re
import shlex
import tomllib
from itertools import chain, pairwise
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.cli.app import _parser
from variantgen.exam import allocation, sheets
from variantgen.families.method_names import METHODS
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.figure.views import view_names
from variantgen.outputs.figures import back_ends
from variantgen.outputs.formats import FORMATS, chosen, format_of, parse_exam
from variantgen.resources import catalog_dir
from variantgen.tables import Table
from variantgen.variants import draw, seeding

# Only a checkout has the files of the project.
ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "catalog" / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
BY_NAME = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in PAGES}
NAMES = sorted(BY_NAME)
GUIDES = [name for name in NAMES if name.startswith("docs/guide.")]

FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```", re.DOTALL | re.MULTILINE)
SPAN = re.compile(r"`([^`\n]+)`")
# Files of the project are named from its root; what a build makes is named otherwise.
PATH = re.compile(r"(?:variantgen|templates|catalog|tests|benchmarks|docs|\.ci)/[\w./<>*-]*")
MODULE = re.compile(r"[\w.]+(?:/\w+)+\.(?:py|typ)")  # in short, those of the program may be named from their package
PYTHON = re.compile(r"`(variantgen/[\w/]+\.py)`:((?:,? (?:and )?`[\w.]+`)+)")
LINK = re.compile(r"\]\(([^)\s]+)\)|<img src=\"([^\"]+)\"")


def blocks(text: str, *languages: str) -> list[str]:
    return [body for language, body in FENCE.findall(text) if language.split(" ")[0] in languages]


def prose(text: str) -> str:
    return FENCE.sub("", text)


def command_lines(text: str) -> list[str]:
    """What is typed after ``variantgen``, in blocks for a shell and between backticks."""
    lines = [line for block in blocks(text, "sh", "powershell") for line in block.splitlines()]
    lines += SPAN.findall(prose(text))
    found = [re.search(r"(?:^|&& |[/\\])variantgen (.+)$", line) for line in lines]
    return [match[1].partition(" && ")[0] for match in found if match]


def words_of(line: str) -> list[str]:
    return shlex.split(line.replace("\\", "/"), comments=True)


def parsers() -> dict[str, argparse.ArgumentParser]:
    action = next(a for a in _parser([])._actions if isinstance(a, argparse._SubParsersAction))
    return dict(action.choices)


def options_of(parser: argparse.ArgumentParser) -> set[str]:
    return {option for action in parser._actions for option in action.option_strings}


COMMANDS = parsers()
OPTIONS = set().union(*map(options_of, COMMANDS.values()), {"--version"})


@pytest.mark.parametrize("name", NAMES)
def test_commands_parse(name: str) -> None:
    for line in command_lines(BY_NAME[name]):
        words = words_of(line)
        if words[0] in COMMANDS and len(words) == 1:  # the command is spoken of
            continue
        try:
            _parser(words).parse_args(words)
        except SystemExit as end:  # --version and --help end so too
            assert end.code == 0, f"{name}: variantgen {line}"
        used = {word.partition("=")[0] for word in words if re.match(r"--[a-z]", word)}
        known = options_of(COMMANDS[words[0]]) if words[0] in COMMANDS else OPTIONS
        assert used <= known, f"{name}: variantgen {line}"  # no abbreviations


@pytest.mark.parametrize("name", NAMES)
def test_commands_name_families_and_formats_that_there_are(name: str) -> None:
    for line in command_lines(BY_NAME[name]):
        words = words_of(line)
        if words[0] in ("show", "solve") and words[1:] and re.fullmatch("[a-z_]+", words[1]):
            assert words[1] in (*family_names(), "my_mechanism", "wheel_and_rod"), line
        for option, value in pairwise(words):
            if option == "--format":
                assert chosen(value.split(","))


@pytest.mark.parametrize("name", NAMES)
def test_options_exist(name: str) -> None:
    """Those that are named alone, between backticks."""
    spans = [span for span in SPAN.findall(prose(BY_NAME[name])) if span.startswith("--")]
    assert {re.split("[ =]", span)[0] for span in spans} <= OPTIONS


def test_the_commands_are_there_to_be_tested() -> None:
    assert sum(len(command_lines(text)) for text in BY_NAME.values()) > 40
    used = {words_of(line)[0] for text in BY_NAME.values() for line in command_lines(text)}
    assert used >= COMMANDS.keys()


@pytest.mark.parametrize("name", NAMES)
def test_exam_files_are_read(name: str) -> None:
    """Every block of TOML that belongs to an exam file, completed by what it leaves out."""
    if name in ("catalog/README.md", "docs/marking.md"):  # of families, of policies: tested with these
        return
    for block in blocks(BY_NAME[name], "toml"):
        text = block
        for key, value in (("title", "x"), ("language", "en")):
            if not re.search(f"^{key} =", text.partition("\n[")[0], re.MULTILINE):
                text = f'{key} = "{value}"\n{text}'
        if "[[problem]]" not in text:
            text += '\n[[problem]]\nfamily = "four_bar"\n'
        assert parse_exam(text, Path("exam.toml"), ()).tasks


@pytest.mark.parametrize("name", NAMES)
def test_paths_exist(name: str) -> None:
    for span in SPAN.findall(BY_NAME[name]):
        if MODULE.fullmatch(span):
            assert any((folder / span).exists() for folder in (ROOT, ROOT / "variantgen")), f"{name}: {span}"
        if PATH.fullmatch(span):
            pattern = re.sub(r"<\w+>", "*", span).rstrip("/")
            assert any(ROOT.glob(pattern)), f"{name}: {span}"


@pytest.mark.parametrize("name", NAMES)
def test_python_names_exist(name: str) -> None:
    """``file.py``: ``name``, ``Class.method`` are defined in that file."""
    for path, listed in PYTHON.findall(BY_NAME[name]):
        source = (ROOT / path).read_text("utf-8")
        for wanted in SPAN.findall(listed):
            for part in wanted.split("."):
                assert re.search(rf"^\s*(?:def|class) {part}\b|^\s*{part}\b.*[:=]", source, re.MULTILINE), (
                    path,
                    wanted,
                )


def anchors(text: str) -> set[str]:
    """The anchors of headings, as they are made of them on the web."""
    heads = re.findall(r"^#+ (.+)$", prose(text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


OTHERS = [ROOT / "CHANGELOG.md", *sorted((ROOT / "benchmarks").rglob("*.md")), *sorted((ROOT / "tests").rglob("*.md"))]


@pytest.mark.parametrize("name", [*NAMES, *(path.relative_to(ROOT).as_posix() for path in OTHERS)])
def test_links_lead_somewhere(name: str) -> None:
    for groups in LINK.findall(prose((ROOT / name).read_text("utf-8"))):
        target = "".join(groups)
        if re.match("https?:", target):
            continue
        path, _, anchor = target.partition("#")
        goal = ((ROOT / name).parent / path).resolve() if path else ROOT / name
        assert goal.exists(), f"{name}: {target}"
        if anchor:
            assert anchor in anchors(goal.read_text("utf-8")), f"{name}: {target}"


def test_the_readme_is_short() -> None:
    """It says what the program is and where to read on."""
    assert len(BY_NAME["README.md"].splitlines()) <= 150


def test_every_page_is_reached_from_the_readme() -> None:
    found, left = set(), ["README.md"]
    while left:
        name = left.pop()
        if name in found or name not in BY_NAME:
            continue
        found.add(name)
        for target, _ in LINK.findall(prose(BY_NAME[name])):
            path = (ROOT / name).parent / target.partition("#")[0]
            if path.suffix == ".md" and path.resolve().is_relative_to(ROOT):
                left.append(path.resolve().relative_to(ROOT).as_posix())
    assert found >= set(NAMES)


def test_the_table_of_outputs_is_complete() -> None:
    """A row for each format, with every key that its table in an exam file may have."""
    rows = {}
    for first, rest in re.findall(r"^\| (`[^|]+`) \| (.*) \|$", BY_NAME["docs/outputs.md"], re.MULTILINE):
        for format_name in SPAN.findall(first):
            rows[format_name] = rest
    assert rows.keys() == set(FORMATS)
    for format_name, row in rows.items():
        table = Table({}, format_name, [])
        format_of(format_name).read_options(table)
        assert table._seen
        assert all(f"`{key}`" in row for key in table._seen), (format_name, table._seen)


def test_pictures_are_small() -> None:
    """Whoever reads the pages loads them; the diagrams of the accuracy report are made by the report."""
    from variantgen.accuracy.summary import PICTURES

    sizes = {path.name: path.stat().st_size for path in (ROOT / "docs" / "pictures").iterdir()}
    assert sizes.keys() > set(PICTURES)
    assert not {name for name, size in sizes.items() if size > 100_000} - set(PICTURES)


def test_commands_stand_in_blocks_for_a_shell() -> None:
    """Where they are tried by these tests."""
    for name, text in BY_NAME.items():
        assert not [block for block in blocks(text, "") if re.search("^(variantgen|pip) ", block, re.MULTILINE)], name


def test_the_families_are_counted() -> None:
    written = re.search(r"\*\*([A-Z][a-z]+)(?:-([a-z]+))? families\*\*", BY_NAME["README.md"])
    assert written
    tens = ("Twenty", "Thirty", "Forty", "Fifty", "Sixty", "Seventy", "Eighty", "Ninety")
    ones = (None, "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
    count = 10 * (tens.index(written[1]) + 2) + ones.index(written[2])
    assert count == sum((catalog_dir() / name).is_dir() for name in family_names())


def test_packages_and_extras_are_named() -> None:
    """All dependencies in the README; in the guides the extras that an instructor may want."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    ours = ("test", "dev", "bench")
    extras = {name: wanted for name, wanted in project["optional-dependencies"].items() if name not in ours}
    readme = BY_NAME["README.md"].partition("## Dependencies")[2].lower()
    for package in (*project["dependencies"], *chain.from_iterable(extras.values())):
        assert re.split("[>=<]", package)[0].lower() in readme, package
    for name in extras:
        assert f"`{name}`" in readme
        assert all(f"`{name}`" in BY_NAME[guide] for guide in GUIDES), name


def rows_of(name: str) -> dict[str, list[str]]:
    """The rows of the tables of a page by their first cell."""
    lines = (ROOT / "benchmarks" / name).read_text("utf-8").splitlines()
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("| ")]
    return {first: rest for first, *rest in cells}


def test_numbers_that_pages_tell_are_those_of_the_tables() -> None:
    """What a page says of a table that a benchmark has made anew since."""
    figures = (ROOT / "benchmarks" / "figures.md").read_text("utf-8")
    found = re.search(r"^(\d+) of (\d+) labels have a leader", figures, re.MULTILINE)
    assert found
    led, labels = map(int, found.groups())
    total = int(rows_of("figures.md")["all"][1])
    fair = rows_of("fairness.md")
    (median, fair_median), (most, fair_most) = (
        fair[f"sheets of five forms, negative numbers differ by, {what}"] for what in ("median", "most")
    )
    marking = (ROOT / "benchmarks" / "marking.md").read_text("utf-8")
    copied = re.search(r"neighbour is named: (\d+ of \d+);.* taken for a neighbour's: 0 of (\d+)", marking)
    assert copied
    chance, tried = map(int, rows_of("marking.md")["all"][-1].split(" of "))
    told = {
        "outputs": (f"{total:,} figures with {labels:,} labels".replace(",", " "), f"{led / labels:.1%} of the labels"),
        "fairness": (
            f"differ by {float(fair['operations max/min, median'][0]):.1f} in operations in the median of the",
            f"by {fair['operations max/min, worst'][0]} in the worst",
            f"up to {fair['negative numbers differ by, most'][0]} negative numbers",
            f"by {fair_median} in the median and {fair_most} in the worst, left to chance by {median} and {most}.",
        ),
        "marking": (f"{copied[1]}; none of {copied[2]} problems", f"{chance / tried:.1%} happen to agree"),
    }
    for page, sentences in told.items():
        text = " ".join(BY_NAME[f"docs/{page}.md"].split())
        for sentence in sentences:
            assert sentence.replace("%", " %") in text, (page, sentence)


@pytest.mark.parametrize("name", NAMES)
def test_no_page_has_two_versions(name: str) -> None:
    """Marks of a merge that nobody has resolved."""
    assert not re.search(r"^(<{7}|={7}|>{7})( |$)", BY_NAME[name], re.MULTILINE)


def test_the_walk_of_the_seed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """What architecture.md says that every random number and every code is made of."""
    streams: list[tuple[object, ...]] = []
    hashed: list[tuple[object, ...]] = []

    class Watched(draw.Stream):
        def __init__(self, *parts: object) -> None:
            streams.append(parts)
            super().__init__(*parts)

    def digest(*parts: object) -> bytes:
        hashed.append(parts)
        return seeding.digest(*parts)

    monkeypatch.setattr(draw, "Stream", Watched)
    monkeypatch.setattr(allocation, "digest", digest)
    monkeypatch.setattr(sheets, "digest", digest)
    arguments = ["sample_en", "--variants", "1", "--seed", "word", "--no-solutions", "--format", "html"]
    assert main(["build", *arguments, "--out", str(tmp_path / "out")]) == 0
    assert {parts[:3] for parts in streams} == {("word", "1", number) for number in range(1, 6)}
    assert ("word", "1", 1, "four_bar") in streams
    assert {("pool", "word", "1", number) for number in range(1, 6)} <= set(hashed)
    assert ("code", "word", "1") in hashed
    assert {parts[0] for parts in hashed} <= {"pool", "priority", "code"}


def test_the_walk_of_phi() -> None:
    """The numbers that architecture.md tells of it."""
    family = load_family("four_bar")
    printed = family.forms["crank"].parameters["phi"].printed
    assert (len(printed), printed[6]) == (31, 45)
    narrowed = restrict(family, ranges={"phi": [30, 60]}, forms=["crank"])
    assert narrowed.forms["crank"].parameters["phi"].printed == (30, 35, 40, 45, 50, 55, 60)


def test_lists_are_complete() -> None:
    """Methods in the guides, kinds and endings of single figures with the outputs, commands in the README."""
    for name in GUIDES:
        assert all(f"`{method}`" in BY_NAME[name] for method in METHODS), name
    assert all(f"`{kind}`" in BY_NAME["docs/outputs.md"] for kind in view_names())
    assert all(f"`{ending}`" in BY_NAME["docs/outputs.md"] for ending in back_ends())
    assert {words_of(line)[0] for line in command_lines(BY_NAME["README.md"])} >= COMMANDS.keys()


def test_the_map_names_every_room() -> None:
    folders = [*(ROOT / "variantgen").iterdir(), *(ROOT / "variantgen" / "methods").iterdir()]
    rooms = [path for path in folders if (path / "__init__.py").is_file()]
    assert len(rooms) > 20
    for room in rooms:
        assert f"`{room.relative_to(ROOT).as_posix()}/`" in BY_NAME["docs/architecture.md"]


def test_whoever_asks_for_kinds_of_joints_is_named() -> None:
    """Modules that know a joint or a driver by its class, outside folders with a module for each kind, or scenes."""
    own = (
        "mechanism/|figure/symbols/|figure/alt_text/kinds/|methods/coordinates/equations/|methods/groups/contact_laws/"
        "|accuracy/|testing/"
    )
    asking = re.compile(r"from variantgen\.mechanism\.(?:joints|drivers)\.")
    package = ROOT / "variantgen"
    found = {
        path.relative_to(ROOT).as_posix()
        for path in package.rglob("*.py")
        if not re.match(own, path.relative_to(package).as_posix()) and asking.search(path.read_text("utf-8"))
    }
    assert found
    assert {name for name in found if f"`{name}`" not in BY_NAME["docs/extending.md"]} == set()
