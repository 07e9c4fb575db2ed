"""A class list brought as it comes: columns by sight, questions, stable ids, what changed, nothing but a list."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from playwright.sync_api import expect

from tests.studio.asking import Answer, Asking
from tests.studio.conftest import Visit
from tests.studio.test_attacks import SCRIPT
from tests.studio.test_pages import barriers
from variantgen.exam.roster import Student, read_class
from variantgen.studio.documents.document import ChangedSinceError
from variantgen.studio.roster import lists, students
from variantgen.studio.roster.table import ClassTable, Tab
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import Workspace

OFFICE = """School of Engineering\t\t\t
No\tStudent\tMatr. no.\tClass
1\tAlder, Zoe\tS4100\tME-21
2\tHeron, Ben\tS4107\tME-21
3\tHeron, Benjamin\tS4107\tME-22
"""


def bring(client: Asking, content: str | bytes, name: str = "list.csv") -> Answer:
    body = content.encode() if isinstance(content, str) else content
    return client.ask("PUT", f"/exam/roster/table?name={name}", (body,))


def workbook(tabs: dict[str, Iterable[Sequence[str]]]) -> bytes:
    book = openpyxl.Workbook()
    del book["Sheet"]
    for title, rows in tabs.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def seen(client: Asking) -> dict[str, str]:
    """The version of the table that a window sees, and by what it is kept."""
    return dict(re.findall(r'data-(version|key)="([^"]*)"', client.get("/exam/roster/shown").text))


def said(client: Asking, what: str, data: dict[str, object]) -> Answer:
    """What a window that sees the present table asks."""
    return client.post(f"/exam/roster/{what}", {"version": seen(client)["version"], **data})


def ready(client: Asking) -> dict[str, str]:
    """What the page has to say of the table, from its attributes."""
    return dict(re.findall(r'data-(ready|taken|asked|count)="([^"]*)"', client.get("/exam/roster/shown?tab=0").text))


def test_a_pasted_table_becomes_the_class(visit: Callable[..., Visit]) -> None:
    """Titles skipped, columns found by what stands in them, one question, and the list is used; then taken back."""
    window = visit()
    page = window.open("/exam/roster")
    page.get_by_role("button", name="Paste a table").click()
    page.get_by_role("textbox").fill(OFFICE)
    page.get_by_role("button", name="Read").click()
    page.get_by_text("Answer 1\N{NO-BREAK SPACE}question, then use").wait_for()
    assert page.get_by_label("Column B is").input_value() == "name"
    assert page.get_by_label("Column C is").input_value() == "id"
    page.get_by_label("Column D is").select_option("group")
    expect(page.locator(".report")).to_contain_text("ME-21")
    assert barriers(page) == []
    page.get_by_role("button", name="Two people").click()
    page.get_by_role("button", name="Use: 3").click()
    page.get_by_text("The class list is written.").wait_for()
    written = (window.folder / "roster.csv").read_text()
    assert written.splitlines() == [
        "id,name,group", 'S4100,"Alder, Zoe",ME-21', 'S4107,"Heron, Ben",ME-21', 'S4107 [2],"Heron, Benjamin",ME-22'
    ]  # fmt: skip
    expect(page.locator("[data-under=roster]")).to_have_text("3\N{NO-BREAK SPACE}students")
    expect(page.locator("#command")).to_contain_text("--roster")
    page.locator("#toast").get_by_role("button", name="Undo").click()
    expect(page.locator("[data-under=roster]")).to_have_text("no roster")
    assert not (window.folder / "roster.csv").exists()
    window.page.set_viewport_size({"width": 360, "height": 740})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    assert window.complaints == []


def test_what_is_set_back_can_be_changed_again(visit: Callable[..., Visit]) -> None:
    """The table is then as it was two answers before: what was made of its old version is not asked for again."""
    page = visit().open("/exam/roster")
    paste(page, OFFICE)
    column, sign = page.get_by_label("Column D is"), page.locator(".report")
    for kind in ("group", "", "group", ""):
        with page.expect_response("**/roster/shown*"):
            column.select_option(kind)
        expect(sign).to_contain_text("ME-21") if kind else expect(sign).not_to_contain_text("ME-21")
    with page.expect_response("**/roster/say*"):
        page.get_by_role("button", name="One person").click()
    page.get_by_role("button", name="Use: 2").wait_for()


def paste(page: Any, table: str) -> None:
    page.get_by_role("button", name="Paste a table").click()
    page.get_by_role("textbox").fill(table)
    page.get_by_role("button", name="Read").click()


def test_two_windows_paste_and_undo_leads_to_the_list(visit: Callable[..., Visit]) -> None:
    """Pasted tables of one name are told apart by who stands in them; what one window uses the other shows at once."""
    first, second = visit(), visit()
    mine, theirs = first.open("/exam/roster"), second.open("/exam/roster")
    paste(mine, "name,id\nAnn Lee,1\nBo Ray,2")
    mine.get_by_role("button", name="Use: 2").wait_for()
    paste(theirs, "name,id\nCy Fox,7\nDi Orr,8\nEd Poe,9")
    theirs.get_by_role("button", name="Use: 3").wait_for()
    mine.get_by_role("button", name="Use: 2").click()
    expect(mine.locator("#overtaken")).to_contain_text("(3\N{NO-BREAK SPACE}students: Cy Fox, Di Orr…)")
    expect(mine.locator("#overtaken")).to_contain_text("(2\N{NO-BREAK SPACE}students: Ann Lee, Bo Ray…)")
    mine.locator("#overtaken").get_by_role("button").nth(1).click()  # theirs
    mine.get_by_role("button", name="Use: 3").click()
    expect(theirs.locator("[data-under=roster]")).to_have_text("3\N{NO-BREAK SPACE}students")
    other = second.open("/exam/choose")
    other.locator("#undo").click()
    other.wait_for_url("**/exam/roster")
    other.get_by_text("Taken back: class list of 3").wait_for()
    expect(mine.locator("[data-under=roster]")).to_have_text("no roster")


def test_tabs_are_groups_and_columns_are_said_once(client: Asking, folder: Path) -> None:
    tabs = {
        group: [["Person", "Sign"], [f"{name} One", sign], [f"{name} Two", sign + "x"]]
        for group, name, sign in (("A-1", "Ann", "q"), ("A-2", "Bob", "w"))
    }
    assert bring(client, workbook({**tabs, "Staff": [["Phone"], ["12"]]}), "..%2f..%2fevil.xlsx").status == 200
    assert said(client, "say", {"tab": 0, "column": 1, "kind": "id"}).status == 200
    assert ready(client) == {"ready": "yes", "taken": "no", "asked": "0\N{NO-BREAK SPACE}questions", "count": "4"}
    assert said(client, "use", {}).json()["students"] == 4
    assert (folder / "roster.csv").read_text().splitlines()[1:] == [
        "q,Ann One,A-1",
        "qx,Ann Two,A-1",
        "w,Bob One,A-2",
        "wx,Bob Two,A-2",
    ]
    assert ready(client)["taken"] == "yes" and not (folder.parent / "evil.xlsx").exists()
    # The next list with these heads is read the same way, and a tab can be left out.
    bring(client, workbook({"B-1": [["Title of the year"], ["Person", "Sign"], ["Cem Three", "zz"]], **tabs}))
    assert said(client, "say", {"tab": 2, "used": False}).status == 200
    assert said(client, "use", {}).status == 200
    assert (folder / "roster.csv").read_text().splitlines()[1:] == [
        "zz,Cem Three,B-1",
        "q,Ann One,A-1",
        "qx,Ann Two,A-1",
    ]


def test_ids_stay_those_of_the_last_build() -> None:
    before = [Student("S1", "Rowan Pia", "A"), Student("S2", "Wodruff Zoe", "A"), Student("S3", "Osier Kit", "A")]
    rows = ((1, ["Pia Rowan", "S9", "A"]), (2, ["Woodruff Zoe", "S8", "A"]), (3, ["Swift Owen", "S7", "A"]))
    table = ClassTable("", (Tab("", rows, 0, ("name", "id", "group"), True),))
    asked = students.read_students(table, before).questions
    assert [(q.key, q.before.id if q.before else "") for q in asked] == [("id:S9", "S1"), ("id:S8", "S2")]
    answered = ClassTable("", table.tabs, {"id:S9": "same", "id:S8": "new"})
    found = students.read_students(answered, before)
    assert found.is_ready and [student.id for student in found.students] == ["S1", "S8", "S7"]


def test_rows_that_need_an_answer_are_not_used_before(client: Asking, folder: Path) -> None:
    bring(client, "name,id\nAnn\N{ZERO WIDTH SPACE} Lee,1a\nBob Ray,\n,3c\nAnn Lee,1a\n")
    assert ready(client)["asked"].startswith("4") and said(client, "use", {}).status == 400
    assert not (folder / "roster.csv").exists()
    shown = client.get("/exam/roster/shown").text
    answers = {"unseen": "clean", "no_id": "named", "no_name": "skip", "twice": "one"}
    for key in re.findall(r'data-question="([^"]*)"', shown):
        assert said(client, "say", {"question": key, "answer": answers[key.rpartition(":")[2]]}).status == 200
    assert said(client, "use", {}).json()["students"] == 2
    assert (folder / "roster.csv").read_text() == "id,name,group\n1a,Ann Lee,\nBob Ray,Bob Ray,\n"


@pytest.mark.parametrize("language", ["en", "ru"])
def test_names_are_never_markup_nor_paths(client: Asking, folder: Path, language: str) -> None:
    client.get("/exam/roster")  # its command needs the folder of builds
    before = {path for path in folder.parent.rglob("*") if ".studio" not in path.parts}
    row = f'"{SCRIPT.replace(chr(34), chr(34) * 2)}"'
    assert bring(client, f"name,id,group\n{row},{row},{row}\n", "%3Cscript%3Ealert(1)%3C%2Fscript%3E").status == 200
    shown = client.get(f"/exam/roster/shown?lang={language}").text
    assert "<script>alert" not in shown and "onerror=alert(1)>" not in shown and "&lt;script&gt;alert" in shown
    bring(client, "name\nAnn Lee\n", "../../../etc/passwd%00")
    assert {path for path in folder.parent.rglob("*") if ".studio" not in path.parts} == before
    assert {path.name for path in (folder / ".studio" / "roster").iterdir()} == {"table", "said.json", "uploads"}


def test_tables_that_cannot_be_read_are_refused(client: Asking, folder: Path) -> None:
    bomb = io.BytesIO()
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("xl/worksheets/sheet1.xml", b"0" * 60_000_000)
    bring(client, "name\nAnn Lee\n")
    for content in (bomb.getvalue(), b"PK\x03\x04nothing", b"\x00\x01\x02", b"\n\n", b""):
        answer = bring(client, content, "class.xlsx")
        assert answer.status == 400 and ".studio" not in answer.text
    assert client.ask("PUT", "/exam/roster/table?name=x", content_length="60000000").status == 413
    assert "это не книга XLSX" in bring(client, b"PK\x03\x04nothing", "x.xlsx&lang=ru").text
    assert ready(client)["count"] == "1"  # the table before is still there
    for data in (
        {"tab": 5, "kind": "id"}, {"column": 7, "kind": "id"}, {"column": 0, "kind": "no"}, {"begin": -1},
        {"question": "x", "answer": "no"}, {"column": [], "kind": "id"},
    ):  # fmt: skip
        assert said(client, "say", data).status == 400, data
    for text in ("[", "[]", '{"name": 5, "tabs": [{"kinds": [1], "begin": 1e9, "used": 2}], "answers": []}'):
        (folder / ".studio" / "roster" / "said.json").write_text(text)
        assert client.get("/exam/roster/shown").status == 200
    assert client.ask("PUT", "/exam/roster/table?name=x", (b"name\nAnn Lee\n",), host="evil.example").status == 421
    assert (
        client.ask("PUT", "/exam/roster/table?name=x", (b"name\nAnn Lee\n",), origin="http://evil.example").status
        == 403
    )


def test_links_are_not_written_through(client: Asking, folder: Path) -> None:
    outside = folder.parent / "outside.csv"
    outside.write_text("name\nAnn Lee\n")
    (folder / "roster.csv").symlink_to(outside)
    bring(client, "name\nBob Ray\n")
    assert client.post("/exam/roster/use", {"version": ""}).status == 400
    assert outside.read_text() == "name\nAnn Lee\n"


def test_no_list_is_lost_when_lists_are_taken_back(client: Asking, folder: Path) -> None:
    """In the order of all steps of the exam; what somebody has changed by hand since stays."""
    path, own = folder / "roster.csv", "id,name\n7,By Hand\n"

    def used(name: str) -> None:
        bring(client, f"id,name\nx1,{name}\n")
        assert said(client, "use", {}).status == 200

    def state() -> dict[str, str]:
        found: dict[str, str] = client.get("/exam/state").json()
        return found

    def moved(how: str) -> int:
        return client.post(f"/exam/{how}", {"version": state()["version"]}).status

    path.write_text(own)
    used("Ann Lee")
    edit = {"operations": [{"op": "set", "path": "seed", "value": 7}], "version": state()["version"]}
    assert client.post("/exam/edit", edit).status == 200
    used("Bob Ray")
    assert state()["undo"] == "class list of 1" and moved("undo") == 200 and "Ann Lee" in path.read_text()
    assert state()["undo"] == "seed" and moved("undo") == 200 and "seed = 2026" in (folder / "exam.toml").read_text()
    assert moved("undo") == 200 and path.read_text() == own and state()["undo"] == ""
    assert [moved("redo") for _ in range(3)] == [200] * 3 and "Bob Ray" in path.read_text()
    assert "seed = 7" in (folder / "exam.toml").read_text()
    path.write_text(path.read_text() + "x2,Cem Hand,\n")
    assert moved("undo") == 400 and "Cem Hand" in path.read_text()  # changed by hand since
    assert "Cem Hand" in client.get("/exam/roster/shown").text and state()["undo"] == "seed"
    path.unlink()
    used("Eve Roe")
    assert moved("undo") == 200 and not path.exists()
    kept = [each.read_text() for each in (folder / ".studio" / "roster" / "lists").iterdir()]
    assert own in kept and any("Eve Roe" in each for each in kept)


@pytest.mark.parametrize("steps", [1, 2])
def test_what_an_editor_saves_while_a_list_is_taken_back_stays(
    studio: Studio, monkeypatch: pytest.MonkeyPatch, steps: int
) -> None:
    """With one list the file would be removed, with two the first would come back."""
    space, edited = studio.workspace, "id,name\n7,Edited\n"
    written = [lists.write_list(space, f"id,name\n1,{name}\n") for name in ("Ann", "Bob")[:steps]]
    now, looks = lists._now, []

    def saved_after_the_first_look(own: Workspace) -> bytes | None:
        found = now(own)
        if not looks:
            (own.folder / "roster.csv").write_text(edited)
        looks.append(found)
        return found

    monkeypatch.setattr(lists, "_now", saved_after_the_first_look)
    with pytest.raises(ChangedSinceError):
        lists.exchange(space, written[-1][1], written[-1][0])
    assert (space.folder / "roster.csv").read_text() == edited


def test_what_a_window_asks_is_of_the_table_that_it_sees(client: Asking, folder: Path) -> None:
    """Two windows: the list of the other is not used, and neither table with its answers is lost."""
    bring(client, "id,name\na1,Ann Lee\na1,Ann Roe\n", "A.csv")
    assert said(client, "say", {"question": "row:0:3:twice", "answer": "two"}).status == 200
    mine = seen(client)
    assert bring(client, "id,name\nb1,Bob Ray\n", "B.csv").json() == {"before": mine["key"]}
    answer = client.post("/exam/roster/use", {"version": mine["version"]})
    assert (answer.status, answer.json()["theirs"]) == (409, "B.csv") and not (folder / "roster.csv").exists()
    data = {"version": mine["version"], "question": "row:0:2:twice", "answer": "one"}
    assert client.post("/exam/roster/say", data).status == 409
    assert said(client, "take", {"table": mine["key"]}).status == 200
    assert said(client, "use", {}).json()["students"] == 2 and "a1 [2],Ann Roe" in (folder / "roster.csv").read_text()
    before = seen(client)
    (folder / "roster.csv").write_text("id,name\n7,By Hand\n")
    assert client.post("/exam/roster/use", {"version": before["version"]}).status == 409
    assert said(client, "take", {"table": mine["key"]}).status == 200 and ready(client)["count"] == "2"
    for key in ("../table", "0" * 16):
        assert said(client, "take", {"table": key}).status == 400
    assert said(client, "take", {"table": ""}).status == 200 and ready(client)["count"] == "1"
    assert "By Hand" in client.get("/exam/roster/shown").text


def test_ids_are_those_that_the_command_line_reads(client: Asking, folder: Path, tmp_path: Path) -> None:
    """A column headed id is one, also where it counts; what nobody has said is not remembered for the next list."""
    lists = {
        "id,name,group\n1,Ann Bee,G\n2,Bob Cee,G\n": ["1", "2"],
        "id,name,group\nab1,Ann Bee,G\nxy7,Bob Cee,G\n": ["ab1", "xy7"],
        "No,name\n1,Ann Bee\n2,Bob Cee\n": ["Ann Bee", "Bob Cee"],
        "No,name\n71,Ann Bee\n85,Bob Cee\n": ["71", "85"],
        "No,name\n1,Ann Bee\n2,Bob Cee\nTotal 2,\n": ["Ann Bee", "Bob Cee"],
    }
    for text, ids in lists.items():
        (tmp_path / "class.csv").write_text(text)
        assert [student.id for student in read_class(tmp_path / "class.csv").students] == ids
        assert bring(client, text).status == said(client, "use", {}).status == 200
        assert [student.id for student in read_class(folder / "roster.csv").students] == ids
    (folder / "roster.csv").write_text("id,name\n1,Ann Bee\n2,Bob Cee\n")  # made by hand
    shown = client.get("/exam/roster/shown").text
    assert re.findall(r'value="(\w*)" selected', shown) == ["id", "name"] and ready(client)["taken"] == "yes"
    assert "The ids only count the rows" in shown


def test_rows_that_are_not_shown_are_counted_in_every_tab(client: Asking) -> None:
    long = [["name", "id"], *([f"Ann {chr(97 + i % 26) * (1 + i // 26)}", f"s{i}"] for i in range(306))]
    bring(client, workbook({"A": [["name", "id"], ["Bob Ray", "b"]], "B": long}))
    assert "more rows" not in client.get("/exam/roster/shown?tab=0").text
    assert "7 more rows" in client.get("/exam/roster/shown?tab=1").text
