"""A language is added by files alone: German stubs in a copy of the package make sheets, key and solutions."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from tests.package_copy import PackageCopy
from tests.pdf_text import page_texts

FAMILY = "sleeve_on_crank"
# What the copies of the English files say in German: file, old, new.
WORDS, SOLUTION = "templates/words/de.toml", "templates/solution/de"
GERMAN = [
    (WORDS, 'decimal_mark = "."', 'decimal_mark = ","'),
    (WORDS, 'babel = "english"', 'babel = "ngerman"'),
    (WORDS, '\nproblem = "Problem"\ngiven', '\nproblem = "Aufgabe"\ngiven'),
    (WORDS, '"points.other" = "points"', '"points.other" = "Punkte"'),
    (WORDS, '\nid = "id, ', '\nid = "matrikelnummer, id, '),
    (WORDS, 'hinged = ", pinned to {bodies},"', 'hinged = ""\n"hinged.sie" = ", drehbar an {bodies.wem},"'),
    (WORDS, "on_fixed_hinge =", '"on_fixed_hinge.sie" = ""\non_fixed_hinge ='),
    (WORDS, 'slot = "collar {point}{hinged} slides', 'slot = "Hülse {point}{hinged.sie} slides'),
    (WORDS, 'body = "{body}"', 'body = "{body}"\n"body.wem" = "dem Glied {body}"'),
    (WORDS, 'disc = "disc {number}"', 'disc = "disc {number}"\n"disc.wem" = "der Scheibe {number}"'),
    (f"{SOLUTION}/words.toml", '[bodies.rod]\nname = "rod"', '[bodies.rod]\nname = "Stab"\nwessen = "des Stabes"'),
    (f"{SOLUTION}/words.toml", '[bodies.link]\nname = "link"', '[bodies.link]\nname = "Glied"\nwessen = "des Gliedes"'),
    (f"{SOLUTION}/words.toml", 'solutions = "Solutions"', 'solutions = "Lösungen"'),
]
EXAM = f'''title = "Klausur"
language = "de"
formats = ["pdf", "latex", "html"]
[latex]
compile = false
[[problem]]
family = "{FAMILY}"
points = 21
'''


@pytest.fixture(scope="module")
def german(tmp_path_factory: pytest.TempPathFactory) -> PackageCopy:
    copy = PackageCopy.of(tmp_path_factory.mktemp("package"), [FAMILY])
    root = copy.root
    for name in ("words/{}.toml", "reading/{}.toml"):
        shutil.copyfile(root / "templates" / name.format("en"), root / "templates" / name.format("de"))
    shutil.copytree(root / "templates/solution/en", root / SOLUTION)
    shutil.copyfile(root / f"catalog/{FAMILY}/statement.en.j2", root / f"catalog/{FAMILY}/statement.de.j2")
    for name, old, new in GERMAN:
        copy.replace(name, old, new, 1)
    for path in (root / SOLUTION).glob("*.toml"):
        text = re.sub(r"angular velocity of \{body\}", "Winkelgeschwindigkeit {body.wessen}", path.read_text("utf-8"))
        path.write_text(text, "utf-8")
    (root / "exam.toml").write_text(EXAM, "utf-8")
    (root / "class.csv").write_text("Matrikelnummer,name\n7,Zorn Ida\n8,Äppler Jan\n9,Busch Eva\n", "utf-8")
    return copy


@pytest.fixture(scope="module")
def built(german: PackageCopy) -> Path:
    made = german.run("build", "exam.toml", "--roster", "class.csv", "--seed", "1", "--out", "out")
    assert made.returncode == 0, made.stderr
    return german.root / "out"


def test_pdfs(built: Path) -> None:
    sheets, key, solutions = (" ".join(page_texts(built / f"{name}.pdf")) for name in ("sheets", "key", "solutions"))
    assert "Aufgabe 1" in sheets
    assert "21\N{NO-BREAK SPACE}Punkte" in sheets or "21 Punkte" in sheets
    assert re.search(r"\d,\d+ rad/s", sheets)
    assert sheets.index("Äppler") < sheets.index("Busch") < sheets.index("Zorn")
    assert re.search(r"\d,\d", key)
    assert "Lösungen" in solutions
    assert re.search(r"Winkelgeschwindigkeit\s+des\s+(Gliedes|Stabes)", solutions)


def test_latex(built: Path) -> None:
    for name in ("sheets", "key", "solutions"):
        assert r"\usepackage[ngerman]{babel}" in (built / "latex" / f"{name}.tex").read_text("utf-8")
    assert "Winkelgeschwindigkeit des" in (built / "latex" / "solutions.tex").read_text("utf-8")


def test_html(built: Path) -> None:
    pages = "".join(path.read_text("utf-8") for path in (built / "html").rglob("*.html"))
    assert '<html lang="de">' in pages
    assert re.search(r"Hülse \w+, drehbar an dem Glied \w+, slides", pages)
    assert "Winkelgeschwindigkeit des" in pages


def test_commands_know_it(german: PackageCopy) -> None:
    assert "language: de or en or ru" in german.run("show", "--help").stdout
    assert "des Gliedes" in german.run("solve", FAMILY, "--explain", "--lang", "de").stdout
    unknown = german.run("solve", FAMILY, "--lang", "dee")
    assert unknown.returncode == 2
    assert "unknown language (got dee)" in unknown.stderr
    assert "did you mean de?" in unknown.stderr


@pytest.mark.parametrize(
    ("name", "line", "key"),
    [
        (WORDS, r'\n"points\.other" = .*', "plurals.points.other"),
        (WORDS, r"\nbabel = .*", "language.babel"),
        (f"{SOLUTION}/words.toml", r"\nwessen = .*", "wessen"),
        (f"{SOLUTION}/relative.toml", r"\nvelocity = .*", "relative.velocity"),
    ],
)
def test_what_is_left_out_is_an_error_with_file_and_key(german: PackageCopy, name: str, line: str, key: str) -> None:
    path = german.root / name
    whole = path.read_text("utf-8")
    damaged, count = re.subn(line, "", whole)
    assert count
    path.write_text(damaged, "utf-8")
    try:
        made = german.run("build", "exam.toml", "--variants", "1", "--out", "damaged")
    finally:
        path.write_text(whole, "utf-8")
    assert made.returncode == 2, made.stderr
    assert "the language has no such entry" in made.stderr
    assert key in made.stderr
    assert str(path.parent) in made.stderr
    assert "Traceback" not in made.stderr
