"""A class is marked by sight: tables, typing, scans; whatever is written is what the command writes, byte for byte."""

from __future__ import annotations

import csv
import io
import json
import re
import shlex
import shutil
import threading
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from playwright.sync_api import expect
from starlette.requests import Request

from tests.marking.test_scan import STUDENTS, Built, build, filled, written
from tests.studio.asking import PORT, Answer, Asking
from tests.studio.conftest import TOKEN, Visit
from tests.studio.test_pages import barriers
from variantgen.cli import main
from variantgen.exam import answer_page
from variantgen.exam.manifest import Manifest, read_manifest
from variantgen.studio.app import make_app
from variantgen.studio.marking.folder import MarkingFolder
from variantgen.studio.marking.marked import MarkedBuild
from variantgen.studio.pages import mark_changes
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import Workspace

BUILD = "exam-2026-01-02"


@pytest.fixture(scope="session")
def scan_exam(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """A build for three students with pages for answers."""
    return build(tmp_path_factory.mktemp("scan"), "en")


@pytest.fixture
def course(scan_exam: Built, tmp_path: Path) -> Path:
    """A folder with this exam and its build."""
    folder = tmp_path / "course"
    (folder / "builds").mkdir(parents=True)
    shutil.copy(scan_exam.folder.parent / "exam.toml", folder)
    shutil.copytree(scan_exam.folder, folder / "builds" / BUILD)
    return folder


@pytest.fixture
def asking(course: Path) -> Iterator[Asking]:
    studio = Studio(Workspace(course))
    yield Asking(make_app(studio, TOKEN, PORT), f"variantgen-{PORT}={TOKEN}")
    studio.close()


def bring(asking: Asking, content: bytes, name: str = "answers.csv") -> Answer:
    return asking.ask("PUT", f"/exam/mark/answers?build={BUILD}&name={name}", (content,))


def say(asking: Asking, code: str, problem: int, quantity: str, text: str) -> Answer:
    data = {"code": code, "problem": problem, "quantity": quantity, "text": text}
    return asking.post(f"/exam/mark/say?build={BUILD}", data)


def shown(asking: Asking, **query: str) -> str:
    words = "&".join(f"{name}={value}" for name, value in {"build": BUILD, **query}.items())
    return asking.get(f"/exam/mark/shown?{words}").text


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def by_command(command: str, out: Path) -> dict[str, bytes]:
    """What the command that the page shows writes into another folder."""
    words = shlex.split(command)[1:]
    words[words.index("--out") + 1] = str(out)
    assert main(words) == 0
    return files(out)


def compose_exam(window: Visit) -> None:
    """The exam of a class, composed from pictures: one problem, what it asks, points; tables are its only files."""
    page = window.open("/")
    page.get_by_label("Title").fill("Homework")
    page.get_by_role("button", name="Choose problems").click()
    page.wait_for_url("**/Homework/choose")
    page.get_by_role("searchbox").fill("slider-crank central")
    page.locator('[data-card="slider_crank/central"] [data-do=add]').click(timeout=30_000)
    page.get_by_text("Problem 1 added", exact=True).wait_for()
    page = window.open("/Homework/compose")
    page.wait_for_selector("#live svg")
    for n, name in ((1, "omega_AB"), (3, "epsilon_AB")):  # asked at first, as v_B and a_B are
        chip = page.get_by_role("group", name="Find").get_by_role("button").nth(n)
        expect(chip).to_have_attribute("value", name)
        chip.click()
        expect(chip).to_have_attribute("aria-pressed", "false")
    shown = page.locator("#source")
    expect(shown).to_have_value(re.compile(r'ask = \["v_B", "a_B"\]'))
    page.get_by_label("Points of problem 1").fill("12")
    page.get_by_label("Points of problem 1").press("Enter")
    expect(shown).to_have_value(re.compile("points = 12"))
    page.get_by_text("The whole exam").click()
    page.get_by_label("Solutions").select_option("none")
    expect(shown).to_have_value(re.compile('depth = "none"'))
    assert barriers(page) == []
    page = window.open("/Homework/build")
    formats = page.get_by_role("group", name="Formats")
    for value, wanted in (("xlsx", True), ("pdf", False)):  # one always stays
        with page.expect_response("**/Homework/edit*"):
            formats.locator(f"[value={value}]").set_checked(wanted)
    exam = tomllib.loads((window.folder / "Homework.toml").read_text("utf-8"))
    assert exam["formats"] == ["xlsx"] and exam["solutions"] == {"depth": "none"}
    [problem] = exam["problem"]
    assert problem == {
        "family": "slider_crank", "form": "central", "ask": ["v_B", "a_B"], "points": 12,
    }  # fmt: skip


def paste_class(window: Visit) -> None:
    """A class of 108 students, pasted."""
    page = window.open("/Homework/roster")
    page.get_by_role("button", name="Paste a table").click()
    listed = "\n".join(f"Student {chr(65 + i // 26)}{chr(97 + i % 26)},S{i},G{i % 3}" for i in range(108))
    page.get_by_role("textbox").fill("name,id,group\n" + listed)
    page.get_by_role("button", name="Read").click()
    page.get_by_role("button", name="Use: 108").click()
    page.get_by_text("The class list is written.").wait_for()


def build_class(window: Visit, by_hand: Path) -> Path:
    """The build of the class, downloaded whole: file by file what the command that the page shows builds."""
    page = window.open("/Homework/build")
    command = page.locator("#command").inner_text()
    page.get_by_role("button", name="Build", exact=True).click()
    expect(page.locator("[data-build]")).to_have_count(1, timeout=90_000)
    [built] = (window.folder / "builds").iterdir()
    with page.expect_download() as download:
        page.locator("a[href$='all.zip']").click()
    packed = zipfile.ZipFile(download.value.path())
    downloaded = {name.partition("/")[2]: packed.read(name) for name in packed.namelist()}
    assert downloaded.keys() == {"grading.xlsx", "key.csv", "key.xlsx", "manifest.json"}
    assert downloaded == by_command(command, by_hand)
    return built


def answers_of(record: Manifest) -> bytes:
    """A table of all students but the last: the first twenty have a wrong sign, every ninth has left one out."""
    out = io.StringIO()
    table = csv.writer(out)
    table.writerow(("student", "1.v_B", "1.a_B"))
    for i, sheet in enumerate(record.sheets[:107]):
        v, a = (answer.value for answer in sheet.problems[0].answers)
        table.writerow((sheet.code, f"{-v if i < 20 else v:.5g}", f"{a:.5g}" if i % 9 else ""))
    return out.getvalue().encode()


def test_a_class_of_108_goes_the_whole_way(visit: Callable[..., Visit], tmp_path: Path) -> None:
    """An exam composed by sight, a roster pasted, the exam built, a class marked; all is what the commands write."""
    window = visit("", name="empty")
    compose_exam(window)
    paste_class(window)
    built = build_class(window, tmp_path / "built")
    record = read_manifest(built)
    page = window.open("/Homework/mark")
    page.locator("#file").set_input_files([{"name": "quiz.csv", "mimeType": "text/csv", "buffer": answers_of(record)}])
    page.get_by_text("Handed in: 107 of 108").wait_for()
    # The last one is typed, by keyboard alone: the code, Enter, the answers.
    last = record.sheets[107]
    page.get_by_role("searchbox").fill(f"variantgen:1:{record.exam_id}:{last.code}")
    page.keyboard.press("Enter")
    page.get_by_role("heading", name=last.student.name).wait_for()
    for n, answer in enumerate(last.problems[0].answers):
        if n:
            page.keyboard.press("Enter")
        page.keyboard.type(f"{answer.value:.5g}")
    page.reload()  # while the last one is being typed: it is kept
    page.get_by_text("Handed in: 108 of 108").wait_for()
    assert barriers(page) == []
    expect(page.locator("[data-under=mark]")).to_have_text("108 of 108")
    # Other rules, with their effect before they are used.
    page.get_by_role("button", name="Class and rules").click()
    page.get_by_label("Sign").fill("50")
    page.keyboard.press("Tab")
    page.get_by_text("Points rise for 20, fall for 0; other grades: 0.").wait_for()
    page.get_by_role("button", name="Use these rules").click()
    page.get_by_text("The rules are written.").wait_for()
    page.locator("#toast").get_by_role("button", name="Undo").click()  # the undo of the exam, from another page, too
    expect(page.locator("#redo")).to_have_attribute("aria-label", "Redo: rules of marking")
    window.open("/Homework/choose").locator("#redo").click()
    page.wait_for_url("**/Homework/mark?*")
    page.get_by_text("Done again: rules of marking").wait_for()
    page.get_by_role("button", name="Write the marks").click()
    page.get_by_text("The marks are written.").wait_for(timeout=60_000)
    result = window.folder / "marks" / built.name / "result"
    assert files(result) == by_command(page.locator("#command").inner_text(), tmp_path / "marks")
    totals = list(csv.DictReader((result / "totals.csv").read_text("utf-8-sig").splitlines()))
    assert [row["points"] for row in totals if row["code"] == last.code] == ["12"]
    assert [row["points"] for row in totals if row["code"] == record.sheets[1].code] == ["9"]  # 6 * 0.5 + 6
    assert barriers(page) == []
    page.get_by_role("button", name="By question").click()
    page.get_by_text("One answer across the class").wait_for()
    assert barriers(page) == []
    page.set_viewport_size({"width": 360, "height": 740})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    assert window.complaints == []


def test_doubtful_readings_are_decided(
    asking: Asking, course: Path, scan_exam: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A faint digit waits with its picture; what somebody reads is in review.csv and stands for the command, too."""
    told: list[dict[str, object]] = []
    monkeypatch.setattr("variantgen.studio.events.Events.tell", lambda _, event, **data: told.append(data))
    own = scan_exam.key[1]
    page = filled(scan_exam.pages[1], [*(written(value) for _, value in own[:-1]), "77"], [(4, 3, 5, 200)])
    torn = scan_exam.pages[2].copy()
    torn.paste(255, (0, 0, torn.width, 400))  # its code is gone
    page.save(tmp_path / "scan.pdf", resolution=150, save_all=True, append_images=[torn])
    assert bring(asking, (tmp_path / "scan.pdf").read_bytes(), "My scan.pdf").status == 200
    code = scan_exam.code(1)
    found = shown(asking, code=code)
    assert found.count('class="doubtrow"') == 1 and "a faint mark" in found
    assert told[0]["exam"] == "exam"  # that a file was brought
    assert told[1:] == [{"build": BUILD, "file": "My scan.pdf", "done": n, "total": 2} for n in (1, 2)]
    # What it may say, what that would be worth, how dark the bubble is, what the student has at least and at most.
    assert re.findall(r'data-reading="([^"]*)"', found) == ["775", "77", "-"]
    # The third digit is outlined: its column is 3.75 + 3 * 4.7 mm from the left, its bubbles 3.6 mm wide.
    [left, width] = map(
        float, re.findall(r'<svg viewBox="0 0 31 57".*?<rect x="([\d.]+)".*? width="([\d.]+)"', found)[0]
    )
    assert left < 17.85 - 1.8 and left + width > 17.85 + 1.8 and width < 4.7
    assert found.count("digit 3: 5") == 1 and 10 < int(re.search(r"(\d+) %</span>", found)[1]) < 50  # type: ignore[index]
    assert re.search(r"<strong>8–9 <small>of 9", found)
    rules = {"problem_step": "0.75"}  # 8 of 8 are 8.25, which is more than there are; 1 of 1 is 0.75
    asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": rules, "use": True})
    assert re.search(r"<strong>8–8.75 <small>of 9", shown(asking, code=code))
    asking.post("/exam/undo", {"version": asking.get("/exam/state").json()["version"]})
    listed = asking.get(f"/exam/mark/list?build={BUILD}&lang=ru").text
    assert (
        "Не прочитаны страницы: 1" in listed and "My scan.pdf, страница 2" in listed and "код листа не виден" in listed
    )
    assert asking.get(f"/exam/mark/lost/0?build={BUILD}").content[1:4] == b"PNG"
    assert asking.get(f"/exam/mark/lost/1?build={BUILD}").status == 404
    picture = asking.get(f"/exam/mark/picture?build={BUILD}&code={code}&problem=2&quantity=v_O")
    assert picture.headers["content-type"] == "image/png" and picture.content[1:4] == b"PNG"
    assert 'class="doubtrow"' in shown(asking, view="questions", problem="2", quantity="v_O")
    assert "Doubtful 1" in asking.get(f"/exam/mark/list?build={BUILD}").text
    said = say(asking, code, 2, "v_O", written(own[-1][1])).json()
    assert (said["verdict"], said["before"]) == ("right", "") and f"{BUILD}/review.csv" in said["command"]
    assert 'class="doubtrow"' not in shown(asking, code=code)
    marks = course / "marks" / BUILD
    assert list(csv.reader((marks / "review.csv").read_text().splitlines())) == [
        ["student", "problem", "quantity", "reading"],
        [code, "2", "v_O", written(own[-1][1])],
    ]
    assert asking.post(f"/exam/mark/write?build={BUILD}", {}).status == 200
    command = re.search(r'id="command"[^>]*>([^<]*)', asking.get("/exam/mark").text)
    assert command and "result/review.csv" in command[1]
    assert files(marks / "result") == by_command(command[1], tmp_path / "marks")
    marks_csv = csv.DictReader((marks / "result" / "marks.csv").read_text("utf-8-sig").splitlines())
    [row] = [row for row in marks_csv if row["code"] == code and row["quantity"] == "v_O"]
    assert row["verdict"] == "right"
    assert asking.get(f"/exam/mark/sheet?build={BUILD}&code={code}&kind=solution").json()["pages"] >= 1


def scan_of_two(scan_exam: Built, folder: Path) -> Path:
    """The scan of two students as a PDF: one with a faint digit, one with a corner mark covered."""
    own = scan_exam.key[1]
    page = filled(scan_exam.pages[1], [*(written(value) for _, value in own[:-1]), "77"], [(4, 3, 5, 200)])
    torn = scan_exam.pages[2].copy()
    torn.paste(255, (0, torn.height - 200, 200, torn.height))
    page.save(folder / "scan.pdf", resolution=150, save_all=True, append_images=[torn])
    return folder / "scan.pdf"


def test_the_scan_of_a_student_is_seen(asking: Asking, scan_exam: Built, course: Path, tmp_path: Path) -> None:
    """Its pages come one by one, upright and to scale, with the boxes that were read; nothing names a path."""
    path = scan_of_two(scan_exam, tmp_path)
    assert bring(asking, path.read_bytes(), "../My scan.pdf").status == 200
    code, torn = scan_exam.code(1), scan_exam.code(2)
    query = f"build={BUILD}&code={code}"
    seen = asking.get(f"/exam/mark/scan?{query}").text
    boxes = re.findall(r'<g class="(\w+)" data-box="([^"]*)">(.*?)</g>', seen)
    assert [name for _, name, _ in boxes] == [f"{code}.{name}" for name, _ in scan_exam.key[1]]
    assert [kind for kind, _, _ in boxes] == ["right"] * 4 + ["doubt"] and boxes[4][2].count('class="column"') == 1
    assert "My scan.pdf, page 1" in seen
    assert "My scan.pdf, страница 1" in asking.get(f"/exam/mark/scan?{query}&lang=ru").text
    [address] = re.findall(r'<img src="([^"]*)"', seen)
    answer = asking.get(address.replace("&amp;", "&"))
    assert answer.headers["content-type"] == "image/png" and "immutable" in answer.headers["cache-control"]
    assert asking.get(f"/exam/mark/scan/0?{query}&v=old").headers["cache-control"] == "no-store"
    with Image.open(io.BytesIO(answer.content)) as image:  # A4, six pixels to the millimetre: the corner marks
        assert image.size == (1260, 1782)
        for x, y in answer_page.CORNERS:
            assert image.getpixel((round(6 * x), round(6 * y))) < 60
            assert image.getpixel((round(6 * x), round(6 * y) - 20)) > 200
    unread = asking.get(f"/exam/mark/scan?build={BUILD}&code={torn}").text
    assert "not all four black squares" in unread and "data-box" not in unread
    assert "the page could not be read" in shown(asking, code=torn)  # each of its answers waits
    assert asking.get(f"/exam/mark/scan/0?build={BUILD}&code={torn}").content[1:4] == b"PNG"
    assert "has been scanned yet" in asking.get(f"/exam/mark/scan?build={BUILD}&code={scan_exam.code(0)}").text
    for wrong in (f"scan/1?{query}", f"scan?build={BUILD}&code=../x", f"scan/0?build={BUILD}&code={scan_exam.code(0)}"):
        assert asking.get(f"/exam/mark/{wrong}").status == 404, wrong
    assert asking.get(f"/exam/mark/scan/..%2f0?{query}").status in (400, 404)
    file = course / "marks" / BUILD / "answers-1.pdf"
    file.rename(tmp_path / "elsewhere.pdf")
    file.symlink_to(tmp_path / "elsewhere.pdf")
    assert asking.get(f"/exam/mark/scan/0?{query}").status == 404


def test_a_scan_is_looked_at_beside_the_answers(visit: Callable[..., Visit], scan_exam: Built, tmp_path: Path) -> None:
    """In a browser: the box of the answer that has the focus; what is decided; wide and narrow; a file that is gone."""
    window = visit((scan_exam.folder.parent / "exam.toml").read_text())
    shutil.copytree(scan_exam.folder, window.folder / "builds" / BUILD)
    code = scan_exam.code(1)
    page = window.open("/exam/mark")
    page.locator("#file").set_input_files(scan_of_two(scan_exam, tmp_path))
    page.get_by_text("scan.pdf is read.").wait_for()
    page.locator(f'.people a[data-code="{code}"]').click()
    page.get_by_role("button", name="Scan", exact=True).click()
    picture = page.get_by_alt_text(f"Scan of page 1 for answers of the sheet {code}")
    expect(picture).to_have_js_property("naturalWidth", 1260)
    page.locator("[data-pick] button").first.focus()
    expect(page.locator(".scan .now.doubt")).to_have_attribute("data-box", f"{code}.2.v_O")
    assert barriers(page) == []
    page.set_viewport_size({"width": 360, "height": 740})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    page.keyboard.press("0")  # there is no answer: the box is no longer one of a doubt
    expect(page.locator(".scan .doubt")).to_have_count(0)
    expect(page.locator(f'.scan .blank[data-box="{code}.2.v_O"]')).to_have_count(1)
    assert window.complaints == []
    page.route("**/mark/scan/0?*", lambda route: route.fulfill(status=404, body="{}"))
    page.keyboard.press("PageDown")
    page.get_by_text("This page cannot be shown").wait_for()


def test_an_answer_on_its_way_stays_in_its_field(visit: Callable[..., Visit], scan_exam: Built) -> None:
    """What the page shows meanwhile is older; it knows nothing of it yet."""
    window = visit((scan_exam.folder.parent / "exam.toml").read_text("utf-8"))
    shutil.copytree(scan_exam.folder, window.folder / "builds" / BUILD)
    page = window.open("/exam/mark")
    first = page.locator("[data-answer] input").first
    held: list[Any] = []
    page.route("**/mark/say*", lambda route: held.append(route))  # noqa: PLW0108  # the browser marks the function
    first.fill("12,5")
    first.press("Enter")
    while not held:
        page.wait_for_timeout(20)
    with page.expect_response("**/mark/shown*"):
        page.evaluate("dispatchEvent(new CustomEvent('exam'))")
    page.wait_for_timeout(100)
    expect(first).to_have_value("12,5")
    held[0].continue_()
    page.get_by_text("Handed in: 1 of 3").wait_for()
    expect(first).to_have_value("12,5")
    # One question across the class, by its symbol.
    page.get_by_role("button", name="By question").click()
    expect(page.locator(".people[data-of=questions] math").first).to_be_visible()


def builds_made(monkeypatch: pytest.MonkeyPatch) -> list[MarkedBuild]:
    """The marks of builds that are begun from now on."""
    marked: list[MarkedBuild] = []
    made = MarkedBuild.__init__

    def noted(own: MarkedBuild, *given: Any) -> None:
        made(own, *given)
        marked.append(own)

    monkeypatch.setattr(MarkedBuild, "__init__", noted)
    return marked


def test_reading_scans_is_stopped(
    asking: Asking, scan_exam: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After a page; the file is in the bin, and comes back by undo."""
    marked = builds_made(monkeypatch)
    answers: list[Answer] = []
    stop = threading.Thread(target=lambda: answers.append(asking.post(f"/exam/mark/stop?build={BUILD}", {})))

    def told(_: object, event: str, **data: object) -> None:
        if event == "scan" and data["done"] == 1 and not answers:
            stop.start()
            assert marked[0].stopping.wait(20)

    monkeypatch.setattr("variantgen.studio.events.Events.tell", told)
    scan_exam.pages[0].save(tmp_path / "scan.pdf", resolution=150, save_all=True, append_images=scan_exam.pages[1:2])
    assert bring(asking, (tmp_path / "scan.pdf").read_bytes(), "scan.pdf").status == 200
    answer = asking.get(f"/exam/mark/list?build={BUILD}")
    assert answer.status == 400 and "stopped" in answer.text
    stop.join(20)
    assert answers[0].json()["files"] == 1
    listed = asking.get(f"/exam/mark/list?build={BUILD}").text
    assert "Removed: 1" in listed and "Handed in: 0 of 3" in listed
    state = asking.get("/exam/state").json()
    assert state["undo"] == "file scan.pdf removed"
    place = asking.post("/exam/undo", {"version": state["version"]}).json()["place"]
    assert place == {"pages": ["mark"], "address": f"/exam/mark?build={BUILD}#"}
    assert "Removed: 1" not in asking.get(f"/exam/mark/list?build={BUILD}").text


def test_stopping_another_reading_keeps_what_was_read(
    asking: Asking, course: Path, scan_exam: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file that was read by other rules stays; what goes is noted before another window may change the files."""
    marked = builds_made(monkeypatch)
    for n in range(2):
        page = filled(scan_exam.pages[n], [written(value) for _, value in scan_exam.key[n]], [])
        page.save(tmp_path / f"{n}.pdf", resolution=150)
    assert bring(asking, (tmp_path / "0.pdf").read_bytes(), "first.pdf").status == 200
    assert "Handed in: 1 of 3" in asking.get(f"/exam/mark/list?build={BUILD}").text
    assert bring(asking, (tmp_path / "1.pdf").read_bytes(), "second.pdf").status == 200
    (course / "marks" / BUILD / "policy.toml").write_text("tolerance = 2\n")  # by an editor
    free: list[bool] = []
    noted = mark_changes._noted

    def noting(request: Request, folder: MarkingFolder, *what: str) -> None:
        with ThreadPoolExecutor() as other:
            free.append(other.submit(folder.lock.acquire, blocking=False).result())
        noted(request, folder, *what)

    monkeypatch.setattr(mark_changes, "_noted", noting)
    answers: list[Answer] = []
    stop = threading.Thread(target=lambda: answers.append(asking.post(f"/exam/mark/stop?build={BUILD}", {})))

    def told(_: object, event: str, **data: object) -> None:
        if event == "scan" and data["file"] == "second.pdf":
            raise AssertionError("is read after the stop")
        if event == "scan" and not stop.ident:
            stop.start()
            assert marked[0].stopping.wait(20)

    monkeypatch.setattr("variantgen.studio.events.Events.tell", told)
    answer = asking.get(f"/exam/mark/list?build={BUILD}")
    stop.join(20)
    assert answer.status == 400 and answers[0].json()["files"] == 1 and free == [False]
    monkeypatch.setattr("variantgen.studio.events.Events.tell", lambda *_, **__: None)
    listed = asking.get(f"/exam/mark/list?build={BUILD}").text
    assert "Removed: 1" in listed and "Handed in: 1 of 3" in listed and "first.pdf" in listed


def test_scans_of_one_build_are_shown_while_those_of_another_are_read(
    asking: Asking, course: Path, scan_exam: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between two pages of a reading."""
    other = BUILD.replace("2026", "2027")
    shutil.copytree(course / "builds" / BUILD, course / "builds" / other)
    scan_exam.pages[1].save(tmp_path / "scan.pdf", resolution=150, save_all=True, append_images=scan_exam.pages[2:3])
    content = (tmp_path / "scan.pdf").read_bytes()
    assert asking.ask("PUT", f"/exam/mark/answers?build={other}&name=a.pdf", (content,)).status == 200
    address = f"/exam/mark/scan/0?build={other}&code={scan_exam.code(1)}"
    assert asking.get(address).status == 200
    seen: list[Answer] = []

    def told(_: object, event: str, **data: object) -> None:
        if event == "scan" and data["build"] == BUILD and data["done"] == 1:
            window = ThreadPoolExecutor()
            try:
                seen.append(window.submit(asking.get, address).result(20))
            finally:
                window.shutdown(wait=False)

    monkeypatch.setattr("variantgen.studio.events.Events.tell", told)
    assert bring(asking, content, "scan.pdf").status == 200
    assert asking.get(f"/exam/mark/list?build={BUILD}").status == 200
    assert [answer.status for answer in seen] == [200]


def test_typed_answers_stand_before_tables_and_are_taken_back(asking: Asking, course: Path, scan_exam: Built) -> None:
    code, (name, value) = scan_exam.code(0), scan_exam.key[0][0]
    problem, quantity = int(name.partition(".")[0]), name.partition(".")[2]
    assert bring(asking, f"student,{name}\n{code},{-value:.5g}\n".encode()).status == 200
    assert 'class="v wrong"' in shown(asking, code=code) and "opposite" in shown(asking, code=code)
    assert "противоположный" in shown(asking, code=code, lang="ru").casefold()
    assert say(asking, code, problem, quantity, f"{value:.5g}").json()["verdict"] == "right"
    assert 'class="v wrong"' not in shown(asking, code=code)
    assert say(asking, code, problem, quantity, "-").json()["of_file"] is True  # a dash leaves room for the table
    say(asking, code, problem, quantity, f"{value:.5g}")
    taken_back = say(asking, code, problem, quantity, "").json()
    assert (taken_back["verdict"], taken_back["text"]) == ("wrong", f"{-value:.5g}")  # the table stands again
    assert taken_back["before"] == f"{value:.5g}"
    assert 'class="v wrong"' in shown(asking, code=code)
    assert asking.post(f"/exam/mark/drop?build={BUILD}", {"file": "answers-1.csv"}).status == 200
    assert "Handed in: 0 of 3" in asking.get(f"/exam/mark/list?build={BUILD}").text
    assert asking.get(f"/exam/mark/find?build={BUILD}&who=young").json() == {"code": scan_exam.code(2)}


def test_what_is_done_to_marks_is_taken_back_in_its_turn(asking: Asking, course: Path, scan_exam: Built) -> None:
    """By the undo of the exam: an answer, a file, the rules; and done again. A window that has seen less takes none."""
    marks, (name, value) = course / "marks" / BUILD, scan_exam.key[0][0]
    problem, quantity = int(name.partition(".")[0]), name.partition(".")[2]

    def moved(how: str) -> str:
        """Undo or redo; what comes next."""
        data = asking.get("/exam/state").json()
        assert asking.post(f"/exam/{how}", {**data, "position": "1.5/"}).status == 409, how
        assert asking.post(f"/exam/{how}", data).status == 200, how
        found: str = asking.get("/exam/state").json()["undo"]
        return found

    def typed() -> list[list[str]]:
        return list(csv.reader((marks / "typed.csv").read_text().splitlines()))[1:]

    assert bring(asking, f"student,{name}\n{scan_exam.code(0)},5\n".encode()).status == 200
    for text in (f"{-value:.5g}", f"{value:.5g}"):
        assert say(asking, scan_exam.code(0), problem, quantity, text).status == 200
    asking.post(f"/exam/mark/drop?build={BUILD}", {"file": "answers-1.csv"})
    asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": {"sign": "40"}, "use": True})
    rules = (marks / "policy.toml").read_text()
    assert asking.get("/exam/state").json()["undo"] == "rules of marking"
    assert moved("undo") == "file answers.csv removed" and not (marks / "policy.toml").exists()
    answer = f"answer {name} of the sheet {scan_exam.code(0)}"
    assert moved("undo") == answer and (marks / "answers-1.csv").exists()
    assert moved("undo") == answer and typed()[0][3] == f"{-value:.5g}"
    assert moved("undo") == "file answers.csv" and typed() == []
    assert moved("undo") == "" and not (marks / "answers-1.csv").exists()
    assert [moved("redo") for _ in range(5)][-1] == "rules of marking"
    assert typed()[0][3] == f"{value:.5g}" and (marks / "policy.toml").read_text() == rules
    assert not (marks / "answers-1.csv").exists()


def test_a_file_changed_since_is_neither_removed_nor_replaced(asking: Asking, course: Path) -> None:
    """Rules that an editor has changed stay in their place."""
    asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": {"sign": "40"}, "use": True})
    asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": {"sign": "60"}, "use": True})
    rules = course / "marks" / BUILD / "policy.toml"
    by_hand = rules.read_text() + "# mine\n"
    rules.write_text(by_hand)
    for left in ("rules of marking", ""):
        version = asking.get("/exam/state").json()["version"]
        answer = asking.post("/exam/undo", {"version": version})
        assert answer.status == 400 and "policy.toml" in answer.text and rules.read_text() == by_hand
        assert asking.get("/exam/state").json()["undo"] == left


def boxes(asking: Asking, code: str) -> dict[str, tuple[str, str]]:
    """What the page shows of a student: the answers and their verdicts, by question."""
    found = re.findall(r'<input id="[^"]*?\.([^"]*)" value="([^"]*)".*?class="v (\w+)"', shown(asking, code=code), re.S)
    return {name: (text, verdict) for name, text, verdict in found}


def test_typed_answers_survive_other_programs(asking: Asking, course: Path, scan_exam: Built) -> None:
    """However another program has written typed.csv, all of it counts, behind what is typed afterwards."""
    code, [(first, right), (second, other)] = scan_exam.code(0), scan_exam.key[0][:2]
    (problem, quantity), typed = first.split("."), f"{right:.5g}"
    marks = course / "marks" / BUILD
    marks.mkdir(parents=True)
    name = read_manifest(scan_exam.folder).sheets[0].student.name
    head, one, two = "student,problem,quantity,answer", first.replace(".", ","), second.replace(".", ",")
    tables = [
        f"{head}\r\n{code},{one},7\r\n{code},{two},{other:.5g}\r\n".replace(",", ";"),
        f"{head}\n{name},{one},7\n{code.casefold()},{two},{other:.5g}\n",
        f"student,{first},{second}\n{code},7,{other:.5g}\n",
        f"{head},who\n{code},{one},7,Иванов\n{code},{two},{other:.5g},Ян\n",
    ]
    for number, table in enumerate(tables, 1):
        content = table.encode("cp1251")
        (marks / "typed.csv").write_bytes(content)
        assert boxes(asking, code)[first] == ("7", "wrong"), table
        answer = say(asking, code, int(problem), quantity, "'" + typed)  # as a spreadsheet marks a text
        assert answer.status == 200 and answer.json()["verdict"] == "right"
        assert boxes(asking, code)[first] == (typed, "right"), table
        assert boxes(asking, code)[second] == (f"{other:.5g}", "right"), table
        assert (marks / f"typed-{number}.csv").read_bytes() == content
    say(asking, code, int(problem), quantity, "8")
    assert len(list(marks.glob("typed-*"))) == len(tables)  # what the studio itself has written stays in place


def test_readings_typed_into_what_was_written_count(asking: Asking, course: Path, scan_exam: Built) -> None:
    """They are among the files of the command, so that the page has them, too."""
    code, (name, value) = scan_exam.code(0), scan_exam.key[0][0]
    result = course / "marks" / BUILD / "result"
    result.mkdir(parents=True)
    table = f"student,problem,quantity,reading\n{code},{name.replace('.', ',')},{value:.5g}\n"
    (result / "review.csv").write_text(table)
    assert boxes(asking, code)[name] == (f"{value:.5g}", "right")
    command = re.search(r'id="command"[^>]*>([^<]*)', asking.get("/exam/mark").text)
    assert command and command[1].count("review.csv") == 1 and "ANSWERS" not in command[1]
    problem, quantity = name.split(".")
    emptied = say(asking, code, int(problem), quantity, "").json()
    assert (emptied["verdict"], emptied["before"], boxes(asking, code)[name]) == (
        "blank",
        f"{value:.5g}",
        ("", "blank"),
    )
    assert bring(asking, b"student,1.v_B\nNo Body,5\n", "quiz.csv").status == 200
    assert "quiz.csv, строка 2: такого студента в работе нет" in shown(asking, view="class", lang="ru")


def test_nothing_is_removed_or_replaced_for_good(asking: Asking, course: Path, scan_exam: Built) -> None:
    """Files and rules come back out of the bin; what is wrong is told in the language of the page."""
    marks = course / "marks" / BUILD
    russian = f"?build={BUILD}&lang=ru"
    refused = asking.post(f"/exam/mark/write{russian}", {})
    assert refused.status == 400 and "ответов ещё нет" in refused.text
    table = f"student,1.v_B\n{scan_exam.code(0)},5\n".encode()
    assert bring(asking, table).status == 200
    kept = asking.post(f"/exam/mark/drop?build={BUILD}", {"file": "answers-1.csv"}).json()["kept"]
    assert not (marks / "answers-1.csv").exists() and (marks / "bin" / kept).read_bytes() == table
    listed = asking.get(f"/exam/mark/list?build={BUILD}").text
    assert "Removed: 1" in listed and f'data-back="{kept}" aria-label="Put back answers.csv"' in listed
    assert bring(asking, b"student,1.v_B\nAnn Lee,6\n").status == 200
    assert asking.post(f"/exam/mark/restore?build={BUILD}", {"kept": kept}).status == 200
    assert (marks / "answers-1.csv").read_bytes() == table and (marks / "answers-2.csv").is_file()
    for wrong in ("", "../typed.csv", kept, "1-x"):
        assert asking.post(f"/exam/mark/restore?build={BUILD}", {"kept": wrong}).status == 400, wrong
    use = {"fields": {"sign": "40"}, "use": True}
    rules, wrong = "# of the chair\nfollow_through = 0.5\n", "# of the chair\nfollow_through = [\n"
    (marks / "policy.toml").write_text(rules)
    kept = asking.post(f"/exam/mark/policy{russian}", use).json()["kept"]
    assert '"sign" = 0.4' in (marks / "policy.toml").read_text() and (marks / "bin" / kept).read_text() == rules
    assert asking.post(f"/exam/mark/restore?build={BUILD}", {"kept": kept}).status == 200
    assert (marks / "policy.toml").read_text() == rules
    large = asking.post(f"/exam/mark/policy{russian}", {"fields": {"total_step": "99"}}).text
    assert "шаг больше баллов всей работы" in large
    (marks / "policy.toml").write_text(wrong)
    for path, data in (("policy", use), ("write", {})):
        refused = asking.post(f"/exam/mark/{path}{russian}", data)
        assert refused.status == 400 and "policy.toml" in refused.text and "is not" not in refused.text, path
    assert (marks / "policy.toml").read_text() == wrong


def test_windows_lose_no_answers(asking: Asking, course: Path, scan_exam: Built) -> None:
    """Answers typed and files brought at once are all there."""
    code, own = scan_exam.code(0), [name.split(".") for name, _ in scan_exam.key[0]]
    tables = [f"student,1.v_B\n{scan_exam.code(place)},5\n".encode() for place in range(3)]
    with ThreadPoolExecutor(8) as pool:
        said = [pool.submit(say, asking, code, int(problem), quantity, "5") for problem, quantity in own]
        brought = [pool.submit(bring, asking, table, f"{n}.csv") for n, table in enumerate(tables)]
        assert {done.result().status for done in (*said, *brought)} == {200}
    marks = course / "marks" / BUILD
    assert len((marks / "typed.csv").read_text().splitlines()) == 1 + len(own)
    assert {path.read_bytes() for path in marks.glob("answers-*.csv")} == set(tables)
    names = json.loads((course / ".studio" / "marks" / f"{BUILD}.json").read_text())
    assert sorted(names.values()) == ["0.csv", "1.csv", "2.csv"]


SCRIPT = "<script>alert(1)</script>"


def test_answers_from_outside_do_no_harm(asking: Asking, course: Path, scan_exam: Built) -> None:
    code, name = scan_exam.code(0), scan_exam.key[0][0][0]
    bomb = io.BytesIO()
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("xl/worksheets/sheet1.xml", b"0" * 60_000_000)
    for content in (bomb.getvalue(), b"PK\x03\x04nothing", b"\x00\x01", b"name,mark\nAnn,5\n", b""):
        answer = bring(asking, content, "../../evil.xlsx")
        assert answer.status == 400 and ".studio" not in answer.text
    assert not (course / "marks").exists() or not list((course / "marks" / BUILD).iterdir())
    table = f"student,{name}\n{code},{SCRIPT}\n{SCRIPT},5\n"
    assert bring(asking, table.encode(), "..%2f..%2f" + SCRIPT.replace("/", "%2f")).status == 200
    assert {path.name for path in (course / "marks" / BUILD).iterdir()} == {"answers-1.csv"}
    everything = [
        shown(asking, code=code),
        shown(asking, view="class"),
        asking.get(f"/exam/mark/list?build={BUILD}").text,
    ]
    assert all("<script>" not in text for text in everything) and any("&lt;script&gt;" in text for text in everything)
    assert asking.ask("PUT", f"/exam/mark/answers?build={BUILD}", content_length="2000000000").status == 413
    for host, origin, status in (("evil.example", None, 421), (None, "http://evil.example", 403)):
        more = {key: value for key, value in (("host", host), ("origin", origin)) if value}
        assert asking.ask("PUT", f"/exam/mark/answers?build={BUILD}", (b"x",), **more).status == status
    for build_key in ("", "..", "nothing", "../exam-2026-01-02"):
        assert asking.get(f"/exam/mark/list?build={build_key}").status == 404
    for path in (
        "shown?code=x",
        "shown?view=questions&problem=1&quantity=no",
        "sheet?code=x",
        "picture?code=x&problem=1",
    ):
        assert asking.get(f"/exam/mark/{path}&build={BUILD}").status == 404, path
    assert say(asking, code, 1, "no", "5").status == say(asking, "x", 1, "v_B", "5").status == 404
    assert say(asking, code, 9, "v_B", "5").status == 404 and say(asking, code, 1, "v_B", "1\u202e2").status == 400
    for fields in ({"sign": "200"}, {"no": "1"}, {"tolerance": "0"}, {"sign": "NaN"}, [], {"sign": []}):
        assert asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": fields, "use": True}).status == 400, fields
    assert asking.post(f"/exam/mark/drop?build={BUILD}", {"file": "../answers-1.csv"}).status == 400
    assert asking.get(f"/exam/mark/result/0?build={BUILD}").status == 400
    (course / "marks" / BUILD / "policy.toml").write_text("sign = [")
    assert "policy.toml" in asking.get(f"/exam/mark/list?build={BUILD}").text
    (course / ".studio" / "marks" / f"{BUILD}.json").write_text("[")
    (course / ".studio" / "marks" / f"{BUILD}-state.json").write_text(json.dumps({"handed_in": "x"}))
    assert asking.get(f"/exam/mark/list?build={BUILD}").status == asking.get("/exam/mark").status == 200


def test_markings_follow_no_links(asking: Asking, course: Path) -> None:
    outside = course.parent / "outside"
    outside.mkdir()
    (course / "marks").symlink_to(outside)
    assert bring(asking, b"student,1.v_B\nAnn Lee,5\n").status == 400
    # Folders that become links while the page is open.
    (course / "marks").unlink()
    assert bring(asking, b"student,1.v_B\nAnn Lee,5\n").status == 200
    (course / "marks" / BUILD / "bin").symlink_to(outside)
    assert asking.post(f"/exam/mark/drop?build={BUILD}", {"file": "answers-1.csv"}).status == 400
    (course / "marks" / BUILD).rename(course / "before")
    (course / "marks" / BUILD).symlink_to(outside)
    assert bring(asking, b"student,1.v_B\nAnn Lee,5\n").status == 400
    assert asking.post(f"/exam/mark/policy?build={BUILD}", {"fields": {"sign": "40"}, "use": True}).status == 400
    assert list(outside.iterdir()) == []


def test_a_build_is_checked_given_another_key_and_its_sheet_found(
    asking: Asking, course: Path, scan_exam: Built
) -> None:
    assert asking.post(f"/builds/{BUILD}/verify", {}).json() == {"right": True, "faults": [], "answers": 15}
    sheet = asking.get(f"/builds/{BUILD}/search?who=young").json()
    assert sheet["name"] == "Cy Young" and sheet["code"] == scan_exam.code(2)
    assert asking.get(f"/builds/{BUILD}/sheet.pdf?who=young").content[:5] == b"%PDF-"
    built = course / "builds" / BUILD
    sheets, manifest = (built / "sheets.pdf").read_bytes(), (built / "manifest.json").read_bytes()
    before = read_manifest(built)
    for wrong in ("", "0", "x", "-1", "200", "1e9", "NaN"):
        assert asking.post(f"/builds/{BUILD}/rekey", {"tolerance": wrong}).status == 400, wrong
    assert (built / "manifest.json").read_bytes() == manifest
    said = asking.post(f"/builds/{BUILD}/rekey", {"tolerance": "5 %"}).json()
    assert said["command"] == f"variantgen rekey {built} --tolerance 0.05"
    after = read_manifest(built)
    assert (built / "sheets.pdf").read_bytes() == sheets
    pairs = zip(before.sheets[0].problems[0].answers, after.sheets[0].problems[0].answers, strict=True)
    assert all(new.tolerance > old.tolerance and new.value == old.value for old, new in pairs)


def test_the_exam_of_next_year_is_compared_with_builds(asking: Asking, course: Path) -> None:
    """The same series for the same class gives the variants that were handed out, another one gives none of them."""
    (course / "roster.csv").write_text(STUDENTS)
    assert asking.get("/exam/overlap?seed=4").json() == {"variants": 6, "same": 6, "builds": 1}
    assert asking.get("/exam/overlap?seed=2027").json() == {"variants": 6, "same": 0, "builds": 1}
    assert asking.get("/exam/overlap?seed=").status == 400
