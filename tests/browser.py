"""Chromium without a window: what a page is when a browser has read it, how it is laid out, and how it is printed."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Sequence
from html import unescape
from pathlib import Path
from typing import Any

from tests.tools import need

_OPTIONS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--hide-scrollbars", "--window-size=1200,900",
]  # fmt: skip
_POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>\n')
# For a page with frames, because a window has a least width; what their scripts find comes as messages.
_LISTENER = """<pre id="found"></pre><script>
const found = {}; addEventListener("message", event => {
  found[event.data[0]] = event.data[1]; document.getElementById("found").textContent = JSON.stringify(found) })
</script>"""


class Browser:
    """A browser with a profile of its own; ``dark`` for those who like dark pages."""

    def __init__(self, program: str, folder: Path, dark: bool = False) -> None:
        self.folder = folder
        self._command = [program, *_OPTIONS, f"--user-data-dir={folder / 'profile'}"]
        self._command += ["--blink-settings=preferredColorScheme=0"] if dark else []

    def dom(self, page: Path) -> str:
        """The document after everything in it has run."""
        return self._run(["--virtual-time-budget=3000", "--dump-dom", page.resolve().as_uri()])

    def measured(self, views: Sequence[tuple[Path, int]], script: str, paper: bool = False) -> list[Any]:
        """What a script returns in pages shown in widths in pixels, after all of each page has been laid out.

        With ``paper`` in the style of paper, as far as it is not about sheets of it.
        """
        frames = []
        for number, (page, width) in enumerate(views):
            shown = unprotected(page.read_text("utf-8")).replace(
                "content-visibility: auto", "content-visibility: visible"
            )
            if paper:
                shown = shown.replace("@media screen", "@media speech").replace("@media print", "@media all")
            shown += f"<script>onload = () => parent.postMessage([{number}, (() => {{ {script} }})()], '*')</script>"
            (self.folder / f"view-{number}.html").write_text(shown, encoding="utf-8")
            frames.append(f'<iframe src="view-{number}.html" style="width:{width}px;height:800px;border:0"></iframe>')
        whole = self.folder / "views.html"
        whole.write_text('<!doctype html><meta charset="utf-8">' + _LISTENER + "".join(frames), encoding="utf-8")
        found = re.search(r'<pre id="found">(.+?)</pre>', self.dom(whole), re.DOTALL)
        assert found, "no script has said anything"
        output = json.loads(unescape(found[1]))
        return [output[str(number)] for number in range(len(views))]

    def printed(self, page: Path) -> Path:
        """The page as PDF."""
        made = self.folder / f"{page.stem}.pdf"
        self._run(["--no-pdf-header-footer", f"--print-to-pdf={made}", page.resolve().as_uri()])
        return made

    def _run(self, arguments: list[str]) -> str:
        command = [*self._command, *arguments]
        run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
        assert run.returncode == 0, run.stderr[-2000:]
        return run.stdout


def unprotected(page: str) -> str:
    """A page without its policy, which would keep scripts from running."""
    bare, count = _POLICY.subn("", page)
    assert count == 1
    return bare


def find_browser() -> str:
    """The path of Chromium; where CI runs, there has to be one."""
    found = shutil.which("chromium") or shutil.which("google-chrome") or shutil.which("chromium-browser")
    need(found is not None, "Chromium", "chromium")
    return str(found)
