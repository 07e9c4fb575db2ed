"""Families of the folder: begun, kept with conflicts, shown with their mistakes; nothing outside is touched."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Route, expect

from tests.studio.asking import Asking
from tests.studio.conftest import Visit
from variantgen.resources import catalog_dir
from variantgen.skeletons import new_family


@pytest.fixture
def own(client: Asking, folder: Path) -> Path:
    """A family that was begun in the studio."""
    assert client.post("/author/new", {"name": "own", "start": ""}).json() == {"address": "?family=own"}
    return folder / "own"


def kept(client: Asking, file: str, text: str, version: str) -> tuple[int, dict[str, object]]:
    found = client.post("/author/own/save", {"file": file, "text": text, "version": version})
    return found.status, found.json()


def test_a_copy_has_the_files_of_its_source(client: Asking, folder: Path) -> None:
    assert client.post("/author/new", {"name": "mine", "start": "spool"}).status == 200
    names = sorted(path.name for path in (folder / "mine").iterdir())
    source = catalog_dir() / "spool"
    assert names == sorted(path.name for path in source.iterdir())
    assert all((folder / "mine" / name).read_bytes() == (source / name).read_bytes() for name in names)


@pytest.mark.parametrize(
    "data", [{"name": "../out"}, {"name": "four_bar"}, {"name": "A"}, {"name": "own", "start": "../exam"}, {"name": 1}]
)
def test_what_cannot_be_begun_is_refused(client: Asking, folder: Path, data: dict[str, object]) -> None:
    before = sorted(folder.iterdir())
    assert client.post("/author/new", data).status == 400
    assert sorted(path for path in folder.iterdir() if path.name != ".studio") == before


def test_a_text_is_kept_unless_another_was_faster(client: Asking, own: Path) -> None:
    state = client.get("/author/own/state").json()
    before, version = state["texts"]["family.toml"], state["versions"]["family.toml"]
    status, data = kept(client, "family.toml", before + "# mine\n", version)
    assert status == 200 and (own / "family.toml").read_text("utf-8") == before + "# mine\n"
    (own / "family.toml").write_text(before + "# theirs\n", "utf-8")
    status, answer = kept(client, "family.toml", before + "# mine again\n", str(data["version"]))
    assert status == 409 and answer["theirs"] == before + "# theirs\n"
    assert (own / "family.toml").read_text("utf-8") == before + "# theirs\n"


def test_a_text_in_conflict_is_a_draft_until_a_choice_settles_it(client: Asking, own: Path) -> None:
    """What was typed is there for the next window; another window that saves does not end it."""
    file, state = "statement.en.j2", client.get("/author/own/state").json()
    version = state["versions"][file]
    (own / file).write_text("THEIRS\r\n", "utf-8", newline="")
    assert kept(client, file, "MINE\n", version)[0] == 409
    state = client.get("/author/own/state").json()
    assert state["drafts"] == {file: "MINE\n"}
    assert kept(client, file, "THEIRS 2\n", state["versions"][file])[0] == 200
    state = client.get("/author/own/state").json()
    assert state["drafts"] == {file: "MINE\n"}
    data = {"file": file, "text": "THEIRS 2\n", "version": state["versions"][file], "settles": True}
    assert client.post("/author/own/save", data).status == 200
    assert client.get("/author/own/state").json()["drafts"] == {}
    assert (own / file).read_bytes() == b"THEIRS 2\r\n"


def test_the_choice_between_two_texts_stays(visit: Callable[..., Visit]) -> None:
    """Through focus and other variants; slow saves do not meet themselves; a closed window loses nothing."""
    window, file = visit(), "statement.en.j2"
    new_family("own", window.folder)
    path, page = window.folder / "own" / file, window.open("/author?family=own")
    area, mine = page.locator(f'textarea[data-file="{file}"]'), page.get_by_role("button", name="Keep mine")
    expect(page.locator("#author")).to_have_attribute("aria-busy", "false")

    def slow(route: Route) -> None:
        answer = route.fetch()
        page.wait_for_timeout(1000)
        route.fulfill(response=answer)

    page.route("**/save?*", slow, times=1)
    area.press_sequentially("AAA")
    page.wait_for_timeout(700)
    area.press_sequentially("BBB")
    expect(page.locator("#kept")).to_contain_text("· kept", timeout=10_000)
    expect(mine).to_be_hidden()
    path.write_text("THEIRS\n", "utf-8")
    area.press_sequentially("MINE")
    expect(page.locator("#both")).to_contain_text("THEIRS")
    page.evaluate("dispatchEvent(new Event('focus'))")
    with page.expect_response("**/look?*seed=12*"):
        page.locator("#after").click()
    expect(mine).to_be_visible()
    page.goto("about:blank")
    window.open("/author?family=own")
    expect(page.locator("#both")).to_contain_text("THEIRS")
    expect(area).to_have_value(re.compile("AAABBBMINE"))
    area.blur()
    assert path.read_text("utf-8") == "THEIRS\n"
    with page.expect_response("**/save?*"):
        mine.click()
    expect(page.locator("#both")).to_be_hidden()
    assert "AAABBBMINE" in path.read_text("utf-8")
    shutil.rmtree(window.folder / "own")


def test_ends_of_lines_stay(client: Asking, own: Path) -> None:
    (own / "statement.en.j2").write_bytes(b"One.\r\nTwo.\r\n")
    version = client.get("/author/own/state").json()["versions"]["statement.en.j2"]
    assert kept(client, "statement.en.j2", "One.\nThree.\n", version)[0] == 200
    assert (own / "statement.en.j2").read_bytes() == b"One.\r\nThree.\r\n"


def test_links_and_other_files_are_left_alone(
    client: Asking, own: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    outside = tmp_path_factory.mktemp("outside") / "secret.toml"
    outside.write_text("secret")
    for file in ("../exam.toml", "notes.txt", "/etc/passwd"):
        assert kept(client, file, "x", "")[0] == 400
    (own / "cases.toml").unlink()
    (own / "cases.toml").symlink_to(outside)
    assert client.get("/author/own/state").status == 400
    assert kept(client, "cases.toml", "x", "")[0] == 400 and outside.read_text() == "secret"
    (own.parent / "linked").symlink_to(outside.parent)
    assert client.get("/author/linked/state").status == 404
    assert client.get("/author/spool/state").status == 404  # the catalogue is not the folder


def test_mistakes_have_file_and_line(client: Asking, own: Path) -> None:
    text = (own / "family.toml").read_text("utf-8")
    line = text.split("\n").index('A = { polar = { origin = "O", distance = "OA", angle = "phi" } }') + 1
    (own / "family.toml").write_text(text.replace('distance = "OA"', 'distance = "OX"'), "utf-8")
    (mistake,) = client.get("/author/own/look?seed=1").json()["mistakes"]
    assert (mistake["file"], mistake["line"]) == ("family.toml", line)
    (own / "family.toml").write_text(text, "utf-8")
    (own / "statement.ru.j2").write_text("Кривошип\n{{ phii }}\n", "utf-8")
    found = client.get("/author/own/look?seed=1").json()
    assert set(found["statements"]) == {"en"} and found["figure"].startswith("<svg")
    assert [(m["file"], m["line"], m["nearest"]) for m in found["mistakes"]] == [("statement.ru.j2", 2, "phi")]


def test_markup_in_a_family_is_text(client: Asking, own: Path) -> None:
    text = (own / "statement.en.j2").read_text("utf-8")
    (own / "statement.en.j2").write_text("<script>x</script> " + text, "utf-8")
    told = client.get("/author/own/look?seed=1").json()["statements"]["en"]
    assert "<script>" not in told and "&lt;script&gt;" in told


def test_a_solution_is_set(client: Asking, own: Path) -> None:
    found = client.get("/author/own/solution/-/3.svg?lang=ru")
    assert found.status == 200 and found.content.startswith(b"<svg")


def test_mistakes_are_told_in_the_language_of_the_page(client: Asking, own: Path) -> None:
    """Refusals, mistakes of a family and of its statements: none of their words is left in English."""
    for data, word in (
        ({"name": "my-fam"}, "строчная"), ({"name": "four_bar"}, "каталоге"), ({"name": "own"}, "уже есть"),
        ({"name": "x" * 61}, "слишком длинно"),
    ):  # fmt: skip
        (problem,) = client.post("/author/new?lang=ru", {"start": "", **data}).json()["problems"]
        assert word in problem["message"] and not re.search("[a-z]{3}", problem["message"]), problem
    text = (own / "family.toml").read_text("utf-8")
    for wrong, words in (
        ("titel = 1\n" + text, ["неизвестный ключ", "имелось в виду title?"]),
        (text + "\n[bodys]\n", ["неизвестный ключ"]),
    ):
        (own / "family.toml").write_text(wrong, "utf-8")
        mistakes = client.get("/author/own/look?seed=1&lang=ru").json()["mistakes"]
        assert all(any(word in m["message"] + m["remedy"] for m in mistakes) for word in words), mistakes
    (own / "family.toml").write_text(text, "utf-8")
    for template, word in (("{{ phii }}", "неизвестное имя"), ("{% for x in [1] %}{% endfor %}", "не разрешено")):
        (own / "statement.ru.j2").write_text(template, "utf-8")
        (mistake,) = client.get("/author/own/look?seed=1&lang=ru").json()["mistakes"]
        assert word in mistake["message"], mistake
    (own / "statement.ru.j2").unlink()
    (own / "statement.ru.j2").mkdir()
    answer = client.get("/author/own/state?lang=ru")
    assert answer.status == 400 and answer.json()["problems"][0]["message"] == "это не файл"
