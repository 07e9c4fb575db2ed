"""Attacks: other sites, other names of this machine, paths, large and slow bodies, scripts in texts."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import shutil
import socket
import stat
import threading
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
import uvicorn

from tests.studio.asking import BROKEN, HOST, PORT, Asking
from tests.studio.conftest import EXAM, TOKEN
from variantgen.errors import InputError
from variantgen.resources import catalog_dir
from variantgen.studio import pages, security, server
from variantgen.studio.app import make_app
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import Workspace, write_whole

PAGES = ("/?all", "/exam/choose", "/exam/state", "/exam/chosen", "/static/studio.js")
COOKIE = f"variantgen-{PORT}={TOKEN}"
EDIT = {"operations": [{"op": "set", "path": "title", "value": "Taken"}], "version": "", "window": ""}


@pytest.mark.parametrize("path", PAGES)
def test_only_this_address_is_answered(client: Asking, path: str) -> None:
    assert client.get(path).status == 200
    for host in (
        "evil.example",
        f"evil.example:{PORT}",
        "127.0.0.1",
        "127.0.0.1:1",
        f"127.0.0.1:{PORT}.evil.example",
        "",
    ):
        for method in ("GET", "HEAD", "POST", "PUT"):
            assert client.ask(method, path, host=host, origin=f"http://{host}").status == 421, (host, method)
    two = [(b"host", HOST.encode()), (b"host", b"evil.example"), (b"cookie", COOKIE.encode())]
    assert client.raw("GET", path, two).status == 421
    assert client.raw("GET", path, [(b"cookie", COOKIE.encode())]).status == 421


@pytest.mark.parametrize("path", PAGES)
def test_without_the_cookie_nothing_is_seen(client: Asking, path: str) -> None:
    for cookie in (
        None,
        "",
        "x=y",
        f"variantgen-{PORT}=",
        f"variantgen-{PORT}=let-me-out",
        f"variantgen={TOKEN}",
        "\xff",
    ):
        answer = client.get(path, cookie=cookie)
        assert answer.status == 403 and "Homework" not in answer.text


def test_a_browser_is_opened_by_a_file_and_not_by_the_token(
    chromium: Any, served: tuple[str, Path], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No argument of a program has the token; the file that only its owner can read leads to the first page."""
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    workspace = Workspace(folder)
    server._open(workspace, f"{served[0]}/?t={TOKEN}", True, lambda _: None)
    [address] = opened
    door = folder / ".studio" / "open.html"
    assert address == door.resolve().as_uri() and TOKEN not in address
    assert stat.S_IMODE(door.stat().st_mode) == 0o600
    context = chromium.new_context()
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector("header.top")
    assert page.url.startswith(served[0]) and TOKEN not in page.url
    context.close()


def test_the_first_address_becomes_a_strict_cookie(client: Asking) -> None:
    stranger = Asking(client.app)
    answer = stranger.get(f"/?t={TOKEN}")
    assert answer.status == 303 and answer.headers["location"] == "/"
    assert {"HttpOnly", "SameSite=strict"} <= {part.strip() for part in answer.headers["set-cookie"].split(";")}
    for path in ("/?t=wrong", "/?t=", f"/?t={TOKEN}&t={TOKEN}", f"/exam/choose?t={TOKEN}", f"/?T={TOKEN}"):
        answer = stranger.get(path)
        assert answer.status == 403 and "set-cookie" not in answer.headers, path
    assert stranger.ask("POST", f"/?t={TOKEN}").status == 403


@pytest.mark.parametrize("site", ["cross-site", "same-site", "nonsense", "same-origin, cross-site"])
def test_another_site_gets_nothing(client: Asking, folder: Path, site: str) -> None:
    assert client.get("/exam/choose", sec_fetch_site=site).status == 403
    assert client.post("/exam/edit", EDIT, sec_fetch_site=site).status == 403
    assert (folder / "exam.toml").read_text() == EXAM


@pytest.mark.parametrize(
    "origin", [None, "null", "http://evil.example", f"https://{HOST}", "http://127.0.0.1", f"http://localhost:{PORT}"]
)
def test_forms_and_fetches_of_others_change_nothing(client: Asking, folder: Path, origin: str | None) -> None:
    for path in ("/exam/edit", "/exam/text", "/exam/undo", "/exams", "/stars"):
        assert client.post(path, EDIT, origin=origin).status == 403
    assert (folder / "exam.toml").read_text() == EXAM
    assert [path.name for path in folder.glob("*.toml")] == ["exam.toml"]


CHANGING = sorted(
    (method, route.path)
    for page in pages.PAGES
    for route in page.ROUTES
    for method in route.methods or ()
    if method in ("POST", "PUT")
)


def test_no_address_changes_anything_for_others(client: Asking, folder: Path) -> None:
    """Every address that changes something: another site, another name, nobody who was let in, a plain form."""
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert len(CHANGING) > 20
    for method, pattern in CHANGING:
        path = pattern.replace("{exam}", "exam").replace("{family}", "spool").replace("{build}", "exam-2026-01-02")
        data, kind = (b'{"version": "", "title": "x", "language": "en"}',), "application/json"
        asked: list[tuple[int, dict[str, str | None]]] = [
            (403, {"origin": "http://evil.example"}),
            (403, {"origin": None}),
            (403, {"origin": "null", "sec_fetch_site": "cross-site"}),
            (403, {"sec_fetch_site": "same-site"}),
            (403, {"cookie": None}),
            (421, {"host": f"evil.example:{PORT}"}),
        ]
        for status, headers in asked:
            assert client.ask(method, path, data, **{"content-type": kind, **headers}).status == status, (path, headers)
        if method == "POST":
            form = client.ask(method, path, (b"version=&title=x",), content_type="application/x-www-form-urlencoded")
            assert form.status in (400, 404), path
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize("path", ["/exam/edit", "/exam/text", "/exam/roster/table?name=x"])
def test_what_breaks_off_changes_nothing(client: Asking, folder: Path, path: str) -> None:
    """A connection that ends within a body: nothing of it is read, nothing is left, the next one is answered."""
    raw = [(b"host", HOST.encode()), (b"origin", f"http://{HOST}".encode()), (b"cookie", COOKIE.encode())]
    raw += [(b"content-type", b"application/json"), (b"content-length", b"5000")]
    method = "PUT" if "table" in path else "POST"
    with contextlib.suppress(Exception):  # nobody is there to be answered
        client.raw(method, path, raw, [b'{"version": "', BROKEN])
    assert (folder / "exam.toml").read_text() == EXAM and not (folder / "roster.csv").exists()
    assert not [each for each in folder.rglob("*") if "incoming" in each.name or each.suffix == ".part"]
    assert client.get("/exam/roster/shown").status == client.get("/exam/state").status == 200
    assert 'id="drop"' in client.get("/exam/roster/shown").text  # no table is there


def test_a_journal_that_others_have_written_does_no_harm(client: Asking, folder: Path) -> None:
    version = client.get("/exam/state").json()["version"]
    assert client.post("/exam/edit", {**EDIT, "version": version}).status == 200
    kept, outside = folder / ".studio" / "journals" / "exam" / "journal.json", folder.parent / "secret.csv"
    outside.write_text("id,name\n1,Secret\n")
    steps = json.loads(kept.read_text())["steps"]
    for deed in (
        {"kind": "list", "before": "../../../../secret", "after": ""},
        {"kind": "list"}, {"kind": "no"}, {"x": "y"},
        {"kind": "file", "build": "../x", "file": "../exam.toml", "kept": ""},
        {"kind": "file", "build": "exam-2026-01-02", "file": "../../exam.toml", "kept": "../../../secret.csv"},
        {"kind": "answer", "build": "exam", "code": "x", "problem": "no", "quantity": "", "before": "", "after": ""},
    ):  # fmt: skip
        kept.write_text(json.dumps({"done": 1, "steps": [{**steps[0], "deed": deed}]}))
        studio = Studio(Workspace(folder))
        own = Asking(make_app(studio, TOKEN, PORT), COOKIE)
        now = own.get("/exam/state").json()
        assert own.post("/exam/undo", {"version": now["version"]}).status in (400, 404), deed
        assert own.get("/exam/state").json()["undo"] == "", deed  # it is struck out
        studio.close()
    assert not (folder / "roster.csv").exists() and "Taken" in (folder / "exam.toml").read_text()


@pytest.mark.parametrize("kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""])
def test_only_json_changes_anything(client: Asking, folder: Path, kind: str) -> None:
    body = (json.dumps({**EDIT, "version": client.get("/exam/state").json()["version"]}).encode(),)
    assert client.ask("POST", "/exam/edit", body, content_type=kind).status == 400
    assert (folder / "exam.toml").read_text() == EXAM
    assert client.ask("POST", "/exam/edit", body, content_type="application/json").status == 200
    assert "Taken" in (folder / "exam.toml").read_text()


@pytest.mark.parametrize("method", ["DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "PROPFIND", "get"])
def test_other_methods_are_unknown(client: Asking, method: str) -> None:
    assert client.ask(method, "/exam/choose").status == 405


@pytest.mark.parametrize(
    "path",
    [
        "/static/../server.py", "/static/%2e%2e/server.py", "/static/..%2fserver.py", "/static//etc/passwd",
        "/../exam/choose",
        "/exam.toml/choose", "/../../etc/passwd/choose", "/..%2fexam/choose", "/secret/choose", "/.studio/choose",
        "/figure/../etc/11.svg", "/figure/four_bar/..%2f..%2fx/11.svg", "/figure/four_bar/crank/1e9.svg",
        "/figure/four_bar/crank/-1.svg", "/figure/four_bar/crank/999999999999999999999.svg",
        "/figure/x\x00y/crank/1.svg",
        "/figure/four_bar/no/1.svg", "/example/..%5c..%5cx/y", "/\\..\\exam/choose",
    ],
)  # fmt: skip
def test_no_path_leads_out(client: Asking, folder: Path, path: str) -> None:
    (folder.parent / "secret.toml").write_text(EXAM)
    answer = client.get(path)
    assert answer.status in (400, 404), answer.text
    assert "root:" not in answer.text and "Homework" not in answer.text


def test_links_out_of_the_folder_are_left_alone(folder: Path, client: Asking) -> None:
    outside = folder.parent / "outside.toml"
    outside.write_text(EXAM)
    (folder / "linked.toml").symlink_to(outside)
    families = folder.parent / "families"
    (families / "stolen").mkdir(parents=True)
    (families / "stolen" / "family.toml").write_text("title = { en = 'Stolen' }")
    (folder / "stolen").symlink_to(families / "stolen")
    assert client.get("/linked/choose").status == 404
    assert "linked" not in client.get("/?all").text
    assert "Stolen" not in client.get("/exam/cards").text and "stolen" not in client.get("/exam/cards").text
    # The exam becomes a link while it is open: neither read nor written.
    version = client.get("/exam/state").json()["version"]
    (folder / "exam.toml").unlink()
    (folder / "exam.toml").symlink_to(outside)
    assert client.post("/exam/edit", {**EDIT, "version": version}).status == 404
    assert outside.read_text() == EXAM


def test_links_inside_the_folder_of_the_studio_are_refused(folder: Path, client: Asking) -> None:
    outside = folder.parent / "outside"
    outside.mkdir()
    (folder / ".studio").mkdir(exist_ok=True)
    for name in ("journals", "drafts", "cache"):
        (folder / ".studio" / name).symlink_to(outside)
    assert client.get("/exam/state").status == client.get("/exam/cards").status == 400
    assert list(outside.iterdir()) == []


def test_a_linked_family_is_not_read_beside_an_own_one(folder: Path, client: Asking) -> None:
    shutil.copytree(catalog_dir() / "spool", folder.parent / "stolen")
    shutil.copytree(catalog_dir() / "spool", folder / "mine")
    (folder / "stolen").symlink_to(folder.parent / "stolen")
    for name, status in (("mine", 200), ("stolen", 400)):
        (folder / "exam.toml").write_text(EXAM.replace('"spool"', f'"{name}"'))
        assert client.get("/exam/problem/2").status == status


def test_the_cache_is_checked(folder: Path, client: Asking) -> None:
    assert client.get("/exam/cards").status == 200
    kept = next((folder / ".studio" / "cache").glob("cards-*.json"))
    right = json.loads(kept.read_text())
    symbols = {**right[0], "ask": {"en": ["<form action=/x>POISON"], "ru": []}}
    for wrong in ([symbols, *right[1:]], [{}], {}, {"a": 1}, [5], [{**right[0], "titles": 5}]):
        kept.write_text(json.dumps(wrong))
        answer = client.get("/exam/cards")
        assert answer.status == 200 and "POISON" not in answer.text and "four_bar" in answer.text


def test_only_an_own_studio_is_opened_again(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    workspace = Workspace(folder)
    monkeypatch.setattr(server, "_answers", lambda *_: True)
    good = f"http://127.0.0.1:{PORT}/?t=abc-_9"
    lock = workspace.state("running.json")
    lock.write_text(json.dumps({"process": os.getpid(), "address": good}))
    assert server._running(workspace) == good
    for address in (
        f"http://127.0.0.1:{PORT}/?t=a&b=c", f"http://127.0.0.1:{PORT}/logout", "http://127.0.0.1:99999/?t=a",
        "http://127.0.0.1:²/?t=a", f"http://evil.example:{PORT}/?t=a", f"http://127.0.0.1:{PORT}@evil/?t=a", 5,
    ):  # fmt: skip
        lock.write_text(json.dumps({"process": os.getpid(), "address": address}))
        assert server._running(workspace) == "", address
    for process in (-1, 0, 2**22 + 1, 10**30, "1", None):
        lock.write_text(json.dumps({"process": process, "address": good}))
        assert server._running(workspace) == "", process


def test_texts_are_measured_in_bytes_and_unreadable_files_listed(folder: Path, client: Asking) -> None:
    version = client.get("/exam/state").json()["version"]
    large = EXAM + "# " + "ж" * 120_000 + "\n"
    refused = client.post("/exam/text", {"text": large, "version": version})
    assert refused.status == 400 and "200 kB" in refused.json()["problems"][0]["message"]
    assert client.get("/exam/state").status == 200
    (folder / "old.toml").write_bytes(EXAM.replace("Homework", "Работа").encode("cp1251"))
    page = client.get("/").text
    assert "old.toml" in page and "UTF-8" in page


def test_a_link_as_the_folder_of_the_studio_is_refused(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "work").mkdir()
    (tmp_path / "work" / ".studio").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InputError, match="link"):
        Workspace(tmp_path / "work")


@pytest.mark.parametrize(
    "title", ["../../evil", "/etc/passwd", "..", "C:\\evil", "a\x00b", "CON", ".hidden", "x" * 200, "?*|<>"]
)
def test_titles_never_become_paths(client: Asking, folder: Path, title: str) -> None:
    before = set(folder.parent.rglob("*.toml"))
    answer = client.post("/exams", {"title": title, "language": "en"})
    new = set(folder.parent.rglob("*.toml")) - before
    assert answer.status in (200, 400)
    assert all(path.parent == folder and not path.name.startswith(".") for path in new)
    assert len(new) == (answer.status == 200)
    assert client.get("/?all").status == 200


def test_large_bodies_are_refused(client: Asking, folder: Path) -> None:
    assert client.ask("POST", "/exam/edit", content_length="1000000000", content_type="application/json").status == 413
    for length in ("-1", "1e3", "0x10", "٣"):
        raw = [(b"host", HOST.encode()), (b"origin", f"http://{HOST}".encode()), (b"cookie", COOKIE.encode())]
        raw += [(b"content-length", length.encode("utf-8"))]
        assert client.raw("POST", "/exam/edit", raw).status == 400
    untold = [b"x" * 400_000] * 3
    assert client.ask("POST", "/exam/edit", untold, content_type="application/json").status == 413
    deep = b"[" * 100_000
    assert client.ask("POST", "/exam/edit", (deep,), content_type="application/json").status == 400
    assert (folder / "exam.toml").read_text() == EXAM


def test_slow_bodies_are_given_up(client: Asking, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(security, "BODY_SECONDS", 0.01)
    raw = [(b"host", HOST.encode()), (b"origin", f"http://{HOST}".encode()), (b"cookie", COOKIE.encode())]
    raw += [(b"content-type", b"application/json")]
    assert client.raw("POST", "/exam/edit", raw, [b"{", None, b"}"]).status == 413


def test_bodies_that_only_trickle_are_given_up(client: Asking, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every piece comes in time, the whole does not."""
    monkeypatch.setattr(security, "WHOLE_SECONDS", 0.0)
    monkeypatch.setattr(security, "_SLOWEST", 1e12)
    assert client.ask("POST", "/exam/edit", [b"{", b'"a"', b": 1}"], content_type="application/json").status == 413


def test_headers_must_come_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """A connection that says nothing, and one whose headers do not end, are closed; a whole request is answered."""

    async def app(_: object, __: object, send: Callable[[dict[str, Any]], Awaitable[None]]) -> None:
        await asyncio.sleep(0.3)  # longer than headers may take
        await send({"type": "http.response.start", "status": 200, "headers": [(b"content-length", b"2")]})
        await send({"type": "http.response.body", "body": b"ok"})

    monkeypatch.setattr(server, "HEADER_SECONDS", 0.1)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        running = uvicorn.Server(uvicorn.Config(app, log_level="error", http=server.PatientProtocol, lifespan="off"))
        thread = threading.Thread(target=running.run, kwargs={"sockets": [listener]}, daemon=True)
        thread.start()
        for said, heard in (
            (b"", b""),
            (b"GET / HTTP/1.1\r\nHost: x\r\nX-", b""),
            (b"GET / HTTP/1.1\r\nHost: x\r\n\r\n", b"HTTP/1.1 200"),
        ):
            with socket.create_connection(listener.getsockname(), timeout=10) as connection:
                connection.sendall(said)
                assert connection.recv(12) == heard, said
        running.should_exit = True
        thread.join(10)


def test_odd_values_have_a_message(client: Asking, folder: Path) -> None:
    version = client.get("/exam/state").json()["version"]
    for operation in (
        {"op": "set", "path": "title", "value": "\ud800"},
        {"op": "set", "path": "x" + ".y" * 3000, "value": 1},
        {"op": "set", "path": f"problem[{'9' * 5000}].points", "value": 1},
        {"op": "move", "path": "problem[1]", "to": 10**30},
        {"op": "set", "path": "seed", "value": float("nan")},
    ):
        assert client.post("/exam/edit", {"operations": [operation], "version": version}).status == 400, operation
    assert client.post("/exam/try", {"problem": 1, "form": [], "at": {}}).status == 400
    assert client.ask("POST", "/exam/edit", content_length="9" * 5000).status == 413
    assert (folder / "exam.toml").read_text() == EXAM
    assert client.post("/exam/next", {"seed": "\N{SUPERSCRIPT TWO}"}).status == 200
    for text in (
        EXAM + "x =", EXAM.replace('"crank"', "5"), EXAM.replace('family = "four_bar"', "x = 1"),
        EXAM.replace("points = 10", "set.phi = nan"), EXAM.replace("points = 10", "range.phi = [nan, 5]"),
        EXAM.replace("seed = 2026", "seed = 2026\ntolerance = 1e999999"),
    ):  # fmt: skip
        (folder / "exam.toml").write_text(text)
        for path in ("/exam/compose", "/exam/outline", "/exam/problem/1", "/exam/room/1", "/exam/state"):
            assert client.get(path).status in (200, 400), (path, text)
        assert client.post("/exam/next", {"seed": "5"}).status in (200, 400), text
    (folder / "exam.toml").write_text(EXAM.replace("seed = 2026", "seed = 2026\ndate = 2026-01-02"))
    edit = [{"op": "set", "path": "date", "value": "x"}]
    assert client.post("/exam/edit", {"operations": edit, "version": version}).json()["theirs"] == "2026-01-02"


def test_a_fault_of_the_program_is_answered(client: Asking, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("variantgen.studio.pages.exams.summary", lambda *_: 1 / 0)
    answer = client.get("/exam/state")
    assert answer.status == 500 and "ZeroDivisionError" in answer.json()["problems"][0]["message"]
    assert client.get("/exam/state", host="evil.example").json()["problems"][0]["message"]


SCRIPT = "<script>alert(1)</script><img src=x onerror=alert(1)>\"'`{{7*1234567}}</title>"


def test_texts_are_never_markup(client: Asking, folder: Path) -> None:
    """Script in every text of an exam and of a class list, known families and unknown ones, on all pages and pieces."""
    operations = [{"op": "set", "path": name, "value": SCRIPT} for name in ("title", "course")]
    version = client.get("/exam/state").json()["version"]
    assert client.post("/exam/edit", {"operations": operations, "version": version}).status == 200
    (folder / f"{'x' * 5}<b>.toml").write_text(EXAM)
    for path in ("/?all", "/exam/choose"):
        page = client.get(path).text
        assert "<script>alert" not in page and "onerror=alert(1)>" not in page and "<b>.toml" not in page
        assert "&lt;script&gt;alert" in page and str(7 * 1234567) not in page  # no such number by chance
    keys = ("title", "course", "date", "duration", "instructions", "language", "seed")
    top = "schema = 1\n" + "".join(f"{key} = {json.dumps(SCRIPT)}\n" for key in keys)
    inner = "".join(f"{key} = {json.dumps(SCRIPT)}\n" for key in ("family", "form", "ask", "nice", "points", "units"))
    lists = f'family = "four_bar"\nform = {json.dumps([SCRIPT])}\nask = {json.dumps([SCRIPT])}\n'
    keyed = f"set = {{ {json.dumps(SCRIPT)} = {json.dumps(SCRIPT)} }}\nrange = {{ {json.dumps(SCRIPT)} = [1, 2] }}\n"
    pool = f"families = [{json.dumps(SCRIPT)}, {json.dumps(SCRIPT)}]\n"
    problems = "".join(f"[[problem]]\n{own}" for own in (inner, lists + keyed, pool))
    (folder / "exam.toml").write_text(f"{top}{json.dumps(SCRIPT)} = 1\n{problems}")
    quoted = '"' + SCRIPT.replace('"', '""') + '"'
    (folder / "roster.csv").write_text(f"id,name,group\n{quoted},{quoted},{quoted}\n1,Ann,{quoted}\n")
    for language in ("en", "ru"):
        for path in (
            "/?all", *(f"/exam/{name}" for name in ("choose", "compose", "roster", "build", "mark", "play", "author")),
            "/exam/outline", "/exam/problem/1", "/exam/problem/2", "/exam/problem/3", "/exam/roster/shown",
            "/exam/cards", "/exam/archive", "/exam/play/mechanisms", "/exam/motion/1/1", "/exam/sheet/1",
        ):  # fmt: skip
            mark = "&" if "?" in path else "?"
            answer = client.get(f"{path}{mark}lang={language}", accept="text/html")
            assert answer.status in (200, 303, 400, 404), (path, answer.text[:300])
            page = answer.text
            if answer.headers.get("content-type", "").startswith("application/json"):
                page = str(answer.json().get("html", ""))
            assert "<script>alert" not in page and "onerror=alert(1)>" not in page, (path, language)


def test_every_answer_has_the_policy(client: Asking) -> None:
    for path in (*PAGES, "/nothing", "/exam/nothing", "/figure/four_bar/crank/11.svg?v=1", "/exam/cards"):
        answer = client.get(path)
        policy = answer.headers["content-security-policy"]
        assert "default-src 'none'" in policy and "unsafe-eval" not in policy
        assert "unsafe-inline" not in policy or (
            answer.headers["content-type"] == "image/svg+xml" and "script-src" not in policy
        )
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["cross-origin-resource-policy"] == "same-origin"


def test_pages_have_no_script_or_style_inside(client: Asking) -> None:
    for path in ("/?all", "/exam/choose", "/nothing"):
        page = client.get(path, accept="text/html").text
        assert "<style" not in page and " style=" not in page and " onclick=" not in page and "javascript:" not in page
        assert page.count("<script") == page.count('<script type="module" src="/static/')


def test_a_file_is_whole_or_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "exam.toml"
    path.write_text("old")
    path.chmod(0o600)

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(OSError, match="space"):
        write_whole(path, "new")
    assert path.read_text() == "old" and [p.name for p in tmp_path.iterdir()] == ["exam.toml"]
    monkeypatch.undo()
    write_whole(path, "new")
    assert path.read_text() == "new" and stat.S_IMODE(path.stat().st_mode) == 0o600
