"""A studio without a server for requests, and one real server with a real browser for all tests of pages."""

from __future__ import annotations

import shutil
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
import uvicorn

from tests.browser import find_browser
from tests.studio.asking import PORT, Asking
from variantgen.studio.app import make_app
from variantgen.studio.server import listening
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import Workspace

TOKEN = "let-me-in"
EXAM = """\
# The first exam of the year.
schema = 1
title = "Homework"
language = "en"
seed = 2026

[[problem]]
family = "four_bar"   # a comment that stays
form = "crank"
ask = ["v_B", "omega_AB"]
points = 10

[[problem]]
family = "spool"
points = 5
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "exam.toml").write_text(EXAM, "utf-8")
    return tmp_path


@pytest.fixture
def studio(folder: Path) -> Iterator[Studio]:
    found = Studio(Workspace(folder))
    yield found
    found.close()


@pytest.fixture
def client(studio: Studio) -> Asking:
    """A browser that was let in, of the studio of ``folder``."""
    return Asking(make_app(studio, TOKEN, PORT), f"variantgen-{PORT}={TOKEN}")


@dataclass
class Visit:
    """A page in a browser: opened, with what its console and its server have complained of."""

    page: Any
    base: str
    folder: Path
    complaints: list[str] = field(default_factory=list)

    def open(self, path: str, language: str = "en") -> Any:
        mark = "&" if "?" in path else "?"
        self.page.goto(f"{self.base}{path}{mark}lang={language}")
        return self.page


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=15_000)
    program = find_browser()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    """A real server for one folder, with an address that lets in; exams in it belong to single tests."""
    folder = tmp_path_factory.mktemp("studio")
    listener = listening(0)
    port = listener.getsockname()[1]
    app = make_app(Studio(Workspace(folder)), TOKEN, port)
    server = uvicorn.Server(uvicorn.Config(app, log_level="error", ws="none", timeout_graceful_shutdown=1))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    while not server.started:
        assert thread.is_alive()
        time.sleep(0.01)
    yield f"http://127.0.0.1:{port}", folder
    server.should_exit = True
    thread.join(10)
    listener.close()


@pytest.fixture
def visit(chromium: Any, served: tuple[str, Path]) -> Iterator[Callable[..., Visit]]:
    """Opens a window of a width and a theme on the folder of the server, with the exam file ``name``."""
    base, folder = served
    contexts = []
    for old in (*folder.glob("*.toml"), *folder.glob("roster.csv")):
        old.unlink()
    for name in ("builds", "marks", ".studio/roster", ".studio/marks"):
        shutil.rmtree(folder / name, ignore_errors=True)

    def opened(text: str = EXAM, width: int = 1280, theme: str = "light", name: str = "exam") -> Visit:
        if not (folder / f"{name}.toml").exists():
            (folder / f"{name}.toml").write_text(text, "utf-8")
        context = chromium.new_context(viewport={"width": width, "height": 800}, color_scheme=theme, locale="en-US")
        contexts.append(context)
        found = Visit(context.new_page(), base, folder)
        found.page.set_default_timeout(15_000)
        found.page.on("pageerror", lambda error: found.complaints.append(str(error)))
        found.page.on("console", lambda said: said.type == "error" and found.complaints.append(said.text))
        found.page.goto(f"{base}/?t={TOKEN}")
        return found

    yield opened
    for context in contexts:
        context.close()
