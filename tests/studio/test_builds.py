"""What is built by the studio is what the command builds, byte for byte; it goes on when the page is closed."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import expect

from tests.studio.asking import Asking
from tests.studio.conftest import EXAM, Visit
from variantgen.cli import main

SMALL = EXAM.replace("[[problem]]", '[solutions]\ndepth = "none"\n\n[[problem]]', 1)


def hashes(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir() if path.is_file()}


def test_an_exam_is_built_downloaded_and_checked(visit: Callable[..., Visit], tmp_path: Path) -> None:
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
    assert words[:5] == ["variantgen", "build", "exam.toml", "--variants", "2"] and words[-2] == "--out"
    built = window.folder / words[-1]
    assert main(["build", str(window.folder / "exam.toml"), "--variants", "2", "--out", str(tmp_path / "by-hand")]) == 0
    assert hashes(built) == hashes(tmp_path / "by-hand")
    with page.expect_download() as download:
        page.get_by_role("link", name=re.compile("sheets.pdf")).click()
    assert download.value.path().read_bytes() == (built / "sheets.pdf").read_bytes()
    assert window.complaints == []


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


def test_next_year_is_a_file_of_its_own(client: Asking, folder: Path) -> None:
    answer = client.post("/exam/next", {"seed": "2027"}).json()
    assert answer == {"address": "/exam-2027/compose", "file": "exam-2027.toml"}
    assert (folder / "exam-2027.toml").read_text() == EXAM.replace("seed = 2026", "seed = 2027")
    assert (folder / "exam.toml").read_text() == EXAM
    assert client.post("/exam/next", {"seed": "../2028"}).json()["file"] == "exam-2028.toml"
