"""What is built by the studio is what the command builds, byte for byte; it goes on when the page is closed."""

from __future__ import annotations

import asyncio
import hashlib
import html
import io
import json
import re
import shlex
import subprocess
import sys
import tomllib
import zipfile
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
import pypdfium2 as pdfium
import pytest
from PIL import Image, ImageFilter
from playwright.sync_api import expect

from tests.studio.asking import Asking
from tests.studio.conftest import EXAM, Visit
from tests.studio.test_pages import barriers
from variantgen.builder import unfinished_folder
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.outputs.formats import parse_exam
from variantgen.studio.pages.build import FORMATS, GROUPED
from variantgen.studio.studio import Studio
from variantgen.studio.summary import built_words
from variantgen.studio.words import ASSETS, page_words

SMALL = EXAM.replace("[[problem]]", '[solutions]\ndepth = "none"\n\n[[problem]]', 1)


def hashes(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir() if path.is_file()}


def shown_command(client: Asking) -> list[str]:
    found = re.search(r'id="command"[^>]*>([^<]*)', client.get("/exam/build").text)
    assert found
    return shlex.split(html.unescape(found[1]))


def test_an_exam_is_built_downloaded_and_checked(visit: Callable[..., Visit], folder: Path, client: Asking) -> None:
    window = visit(SMALL)
    page = window.open("/exam/build")
    page.get_by_label("Numbered variants").fill("2")
    command = page.locator("#command").inner_text()
    page.get_by_role("button", name="Build", exact=True).click()
    page.locator("#stop").wait_for()
    page.close()  # it goes on by itself
    window.page = page = window.page.context.new_page()
    window.open("/exam/build")
    expect(page.locator("[data-build]")).to_have_count(1, timeout=60_000)
    words = command.split()
    assert (
        words[:5] == ["variantgen", "build", str(window.folder / "exam.toml"), "--variants", "2"]
        and words[-2] == "--out"
    )
    built = Path(words[-1])
    (folder / "exam.toml").write_text(SMALL)  # a fresh folder, where nothing has been built
    by_hand = ["2" if word == "30" else word for word in shown_command(client)]
    assert main(by_hand[1:]) == 0
    assert hashes(built) == hashes(Path(by_hand[-1]))
    # What stands under the steps, and the command of the next build, have followed without loading the page again.
    today = built_words(page_words("en"), date.today())
    expect(page.locator("[data-under=build]")).to_have_text(today)
    expect(page.locator("[data-under=mark]")).to_have_text("not yet")
    expect(page.locator("#command")).to_contain_text(f"{built.name}-2")
    with page.expect_download() as download:
        page.get_by_role("link", name=re.compile("sheets.pdf")).click()
    assert download.value.path().read_bytes() == (built / "sheets.pdf").read_bytes()
    assert window.complaints == []


def test_the_preview_is_the_page_that_a_build_sets(visit: Callable[..., Visit], tmp_path: Path) -> None:
    """Line by line: as far as pixels of a PDF and of a browser can be the same. Pages of others differ by far more."""
    window = visit(SMALL)
    window.page.set_viewport_size({"width": 794, "height": 1123})  # an A4 page of points
    (window.folder / "roster.csv").write_text("id,name\n1,Ash\n2,Birch\n", "utf-8")
    words = ["--roster", str(window.folder / "roster.csv"), "--out", str(tmp_path / "out")]
    assert main(["build", str(window.folder / "exam.toml"), *words]) == 0
    built = pdfium.PdfDocument(tmp_path / "out" / "sheets.pdf")
    seen = []
    for student in (1, 2):
        found = window.page.request.get(f"{window.base}/exam/sheet/{student}").json()
        window.page.goto(f"{window.base}/exam/page/{found['name']}/1.svg")
        seen.append(darkness(Image.open(io.BytesIO(window.page.screenshot()))))
    pages = [darkness(built[place].render(scale=1).to_pil()) for place in range(len(built))]
    first = [
        pages[place] for place in range(len(pages)) if pages[place].mean() > 1
    ]  # blank ones stand behind odd numbers
    assert len(first) == 2
    apart = [[float(np.abs(one - other).mean()) for other in first] for one in seen]
    for i in (0, 1):
        assert apart[i][i] < 0.25 * apart[i][1 - i], apart


def darkness(page: Image.Image) -> Any:
    """How dark a page is about each point, from 0 to 255; letters are spread over their neighbourhood."""
    grey = page.convert("L").resize((595, 842)).filter(ImageFilter.GaussianBlur(1.5))
    return 255 - np.asarray(grey, dtype=float)


def test_a_build_tells_phases_that_pages_know(folder: Path) -> None:
    """Each that the process tells stands in the list of phases, in their order; none is passed over."""
    (folder / "exam.toml").write_text(SMALL)
    wanted = {"exam": str(folder / "exam.toml"), "roster": "", "variants": 1, "out": str(folder / "out"), "jobs": 1}
    command = [sys.executable, "-m", "variantgen.studio.building.process"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdin and process.stdout
        process.stdin.write(json.dumps(wanted) + "\n")
        process.stdin.flush()
        told = [json.loads(line)["phase"] for line in process.stdout]
    page = (ASSETS / "pages" / "build.html.j2").read_text("utf-8")
    assert list(dict.fromkeys(told)) == re.findall(r'data-phase="(\w+)"', page)


def test_every_group_has_its_own_downloads(visit: Callable[..., Visit]) -> None:
    """Two groups: a tick makes a file for each; the table of downloads has a row for each, one more for nobody's."""
    window = visit(SMALL)
    new = window.folder / "roster.new"  # at once, as editors do: the studio looks at the folder every second
    new.write_text("id,name,group\n1,Ash,ME-21\n2,Birch,ME 22\n3,Cedar,\n")
    new.replace(window.folder / "roster.csv")
    page = window.open("/exam/build")
    groups = page.get_by_label("A file for each group")
    with page.expect_response("**/exam/edit*"):
        groups.check()
    with page.expect_response("**/exam/edit*"):
        page.get_by_label("Grading workbook").check()
    exam = tomllib.loads((window.folder / "exam.toml").read_text("utf-8"))
    assert exam["pdf"] == exam["xlsx"] == {"files": "groups"} and exam["formats"] == ["pdf", "xlsx"]
    page.get_by_role("button", name="Build", exact=True).click()
    table = page.get_by_role("table")
    expect(table.get_by_role("row")).to_have_count(5, timeout=60_000)
    assert table.locator("thead th").all_inner_texts() == ["Group", "Sheets", "Key", "Grading"]
    assert table.locator("tbody th").all_inner_texts() == ["All", "without a group", "ME-21", "ME 22"]
    [built] = (window.folder / "builds").iterdir()
    with page.expect_download() as download:
        table.get_by_role("row", name="ME-21").get_by_role("link", name=re.compile("^sheets.+PDF")).click()
    assert download.value.path().read_bytes() == (built / "sheets" / "ME-21.pdf").read_bytes()
    assert barriers(page) == []
    page.set_viewport_size({"width": 360, "height": 740})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360  # the table scrolls by itself
    with page.expect_response("**/exam/edit*"):
        groups.uncheck()
    exam = tomllib.loads((window.folder / "exam.toml").read_text("utf-8"))
    assert "pdf" not in exam and "xlsx" not in exam
    assert window.complaints == []


def test_formats_that_have_files_for_groups_are_known() -> None:
    """Those whose table in an exam takes ``files = "groups"``, and no others."""
    taking = set()
    for name in FORMATS:
        text = f'formats = ["{name}"]\n{name}.files = "groups"\n' + SMALL
        try:
            parse_exam(text, Path("exam.toml"), ())
            taking.add(name)
        except InputError as error:
            assert "files" in str(error), name
    assert taking == set(GROUPED)


def test_letters_that_no_font_has_are_told(visit: Callable[..., Visit]) -> None:
    """Before a build with PDF on the page of the roster, after it on that of the build, in the language of the page."""
    window = visit(SMALL)
    (window.folder / "roster.csv").write_text("id,name\n1,Ash\n2,\u674e Li\n", "utf-8")
    page = window.open("/exam/roster")
    expect(page.locator(".report")).to_contain_text("The fonts for paper lack letters of names (1): \u674e Li.")
    (window.folder / "roster.csv").write_text("id,name\n1,Ash\n2,\u0141\u0119cki\n", "utf-8")  # Polish ones are there
    page.reload()
    expect(page.locator(".report")).to_contain_text("All names can be printed")
    (window.folder / "roster.csv").write_text("id,name\n1,Ash\n2,\u674e Li\n", "utf-8")
    page = window.open("/exam/build", "ru")
    page.get_by_role("button", name="Собрать", exact=True).click()
    failed = page.locator("#failed")
    expect(failed).to_contain_text("в шрифтах для PDF нет буквы: имя студента 2 (получено \u674e U+674E)")
    expect(failed).to_contain_text("соберите страницы HTML")


def test_a_format_without_its_package_is_greyed(client: Asking, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "disabled" not in re.findall(r'<input[^>]*value="latex"[^>]*>', client.get("/exam/build").text)[0]
    monkeypatch.setattr("variantgen.studio.pages.build.find_spec", lambda name: None if name == "pylatex" else name)
    page = client.get("/exam/build").text
    [latex], [xlsx] = (re.findall(rf'<input[^>]*value="{name}"[^>]*>', page) for name in ("latex", "xlsx"))
    assert "disabled" in latex and "disabled" not in xlsx
    assert 'pip install ".[latex]"' in html.unescape(page)


def test_builds_are_found_by_key_and_stay_inside(client: Asking, folder: Path) -> None:
    assert "Nothing has been built" in client.get("/exam/archive").text
    secret = folder.parent / "secret.pdf"
    secret.write_bytes(b"secret")
    build = folder / "builds" / "exam-2026-01-02"
    build.mkdir(parents=True)
    (build / "sheets.pdf").write_bytes(b"%PDF")
    (build / "key.pdf").symlink_to(secret)
    manifest = '{"files": {"sheets.pdf": "", "key.pdf": "", "../../../secret.pdf": ""}, "students": [1], "seed": "1"}'
    (build / "manifest.json").write_text(manifest)
    (folder / "builds" / "broken").mkdir()
    (folder / "builds" / "broken" / "manifest.json").write_text("{")
    shown = client.get("/exam/archive").text
    assert "sheets.pdf" in shown and "key.pdf" not in shown and "secret" not in shown and "broken" not in shown
    found = [client.get(f"/builds/exam-2026-01-02/file/{number}") for number in range(5)]
    assert [answer.status for answer in found] == [200, 200, 400, 400, 400]
    assert all(b"secret" not in answer.content for answer in found[2:]) and found[1].content == b"%PDF"
    assert "attachment" in found[1].headers["content-disposition"]
    for path in ("../exam-2026-01-02", "nothing", "..", "exam"):
        assert client.get(f"/builds/{path}/file/0").status == 404


def test_builds_of_another_exam_are_not_its_own(client: Asking, folder: Path) -> None:
    for name in ("exam-2026-01-02", "exam-2026-01-02-2", "exam-2027-2026-01-02", "exam-x-2026-01-02"):
        (folder / "builds" / name).mkdir(parents=True)
        (folder / "builds" / name / "manifest.json").write_text('{"files": {}, "students": [1], "seed": "1"}')
    found = re.findall(r'data-build="([^"]*)', client.get("/exam/archive").text)
    assert found == ["exam-2026-01-02-2", "exam-2026-01-02"]
    (folder / "exam-2027.toml").write_text(EXAM)
    assert re.findall(r'data-build="([^"]*)', client.get("/exam-2027/archive").text) == ["exam-2027-2026-01-02"]
    (folder / "builds" / "exam-2026-01-02" / "manifest.json").write_text("[" * 100_000)
    assert client.get("/exam/archive").status == 200
    for address in ("search?who=x", "sheet.pdf?who=--help"):
        assert client.get(f"/builds/exam-2026-01-02-2/{address}").status == 400
    answer = client.get("/builds/exam-2026-01-02-2/all.zip")
    assert zipfile.ZipFile(io.BytesIO(answer.content)).namelist() == ["exam-2026-01-02-2/manifest.json"]
    assert client.post("/exam/stop", {}).json() == {}


def test_a_roster_counts_as_a_build_reads_it(client: Asking, folder: Path) -> None:
    roster = folder / "roster.csv"
    roster.write_bytes("id;name\n1;Иванов\n2;Петров\n".encode("cp1251"))  # as a spreadsheet writes it
    page = client.get("/exam/build").text
    assert "For 2\N{NO-BREAK SPACE}students of the roster" in page and "--roster" in page
    assert client.get("/exam/students").json()["names"] == ["Иванов", "Петров"]
    roster.write_text("id,name\n1,Ivanov\n1,Petrov\n")
    page = client.get("/exam/build").text
    assert 'class="error" role="alert"' in page and 'id="start"' not in page and "--roster" in page
    assert client.post("/exam/start", {"variants": "2"}).status == 400
    assert client.get("/exam/compose").status == 200 and client.get("/exam/sheet/1").status == 400
    roster.unlink()
    (folder / "elsewhere").write_text("id,name\n1,Ivanov\n")
    roster.symlink_to(folder / "elsewhere")
    assert "is a link" in client.get("/exam/build").text
    assert client.post("/exam/start", {"variants": "2"}).status == 400


def test_a_build_that_ended_with_its_studio_goes_on(client: Asking, folder: Path) -> None:
    """Parts of today's build are there and nothing runs; those of other exams and of other days do not count."""
    name = f"exam-{date.today().isoformat()}"
    assert client.get("/exam/progress").json()["state"] == {}
    for other in ("exam-2026-01-02", "exam-x-2026-01-02"):
        unfinished_folder(folder / "builds" / other).mkdir(parents=True)
    assert client.get("/exam/progress").json()["state"] == {}
    unfinished_folder(folder / "builds" / name).mkdir()
    assert client.get("/exam/progress").json()["state"] == {"exam": "exam", "name": name, "phase": "stopped"}
    assert "not yet" in client.get("/exam/choose").text


def test_two_starts_at_once_are_one(studio: Studio, monkeypatch: pytest.MonkeyPatch) -> None:
    async def never(*_: object, **__: object) -> None:
        await asyncio.sleep(0)
        raise OSError("no process")

    monkeypatch.setattr(asyncio, "create_subprocess_exec", never)

    async def twice() -> list[BaseException | None]:
        starts = [studio.builds.start("exam", studio.workspace.folder / "exam.toml", 2) for _ in range(2)]
        return list(await asyncio.gather(*starts, return_exceptions=True))

    with ThreadPoolExecutor(1) as pool:  # a browser that is open keeps the loop of this thread
        results = pool.submit(lambda: asyncio.run(twice())).result()
    assert [type(found) for found in results] == [OSError, InputError]
    assert studio.builds.state("exam") == {}


def test_next_year_is_a_file_of_its_own(client: Asking, folder: Path) -> None:
    answer = client.post("/exam/next", {"seed": "2027"}).json()
    assert answer == {"address": "/exam-2027/compose", "file": "exam-2027.toml"}
    assert (folder / "exam-2027.toml").read_text() == EXAM.replace("seed = 2026", "seed = 2027")
    assert (folder / "exam.toml").read_text() == EXAM
    assert client.post("/exam/next", {"seed": "../2028"}).json()["file"] == "exam-2028.toml"
