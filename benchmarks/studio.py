"""The studio: the first page after the command, the gallery of all forms, from a slider to its figure.

    python -m benchmarks.studio [--moves N] [--building]

A studio is started in a new folder with an exam of one problem; ``first page`` is from the command to the last byte of
the page, ``gallery`` the cards and all their figures, at the first start and later, asked for six at a time, as
browsers do. Then Chromium moves a slider ``N`` times: from the event to the frame after the new figure
stands in the page. ``--building`` lets a build of 400 sheets run meanwhile. Prints a Markdown table.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from urllib.parse import urlsplit

EXAM = """\
schema = 1
title = "Measured"
language = "en"

[[problem]]
family = "sleeve_on_crank"
points = 10
"""
_STARTS = 5
_AT_ONCE = 6
# Moves a slider by one step, and waits for another figure and for two frames after it.
_MOVE = """
async step => {
  const live = document.getElementById("live"), slider = document.querySelector("[data-name=phi] .track input");
  const changed = new Promise(done => {
    new MutationObserver((_, seen) => { seen.disconnect(); done(); }).observe(live, { childList: true });
  });
  slider.value = Number(slider.value) + step;
  const start = performance.now();
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  await changed;
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  return performance.now() - start;
}
"""


class Client:
    """One connection to a studio, with its cookie."""

    def __init__(self, address: str) -> None:
        parts = urlsplit(address)
        self._connection = HTTPConnection(str(parts.hostname), parts.port)
        self._headers: dict[str, str] = {}
        self._connection.request("GET", f"/?{parts.query}")
        answer = self._connection.getresponse()
        answer.read()
        self._headers["cookie"] = str(answer.getheader("set-cookie")).partition(";")[0]

    def get(self, path: str) -> bytes:
        """What an address answers."""
        self._connection.request("GET", path, headers=self._headers)
        answer = self._connection.getresponse()
        content = answer.read()
        assert answer.status == 200, (path, answer.status)
        return content


@contextmanager
def studio(folder: Path) -> Iterator[str]:
    """A studio that runs; its first address."""
    command = [sys.executable, "-m", "variantgen", "studio", str(folder), "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


def first_page(folder: Path) -> float:
    """Seconds from the command to the last byte of the page Choose."""
    start = time.perf_counter()
    with studio(folder) as address:
        Client(address).get("/exam/choose")
        return time.perf_counter() - start


def gallery(address: str) -> float:
    """Seconds for the cards and their figures."""
    start = time.perf_counter()
    html = json.loads(Client(address).get("/exam/cards?lang=en"))["html"]
    paths = [path.replace("&amp;", "&") for path in re.findall(r'<img src="([^"]+)"', html)]
    assert len(paths) > 70, len(paths)

    def fetch(part: Sequence[str]) -> None:
        client = Client(address)
        for path in part:
            client.get(path)

    with ThreadPoolExecutor(_AT_ONCE) as pool:
        list(pool.map(fetch, [paths[i::_AT_ONCE] for i in range(_AT_ONCE)]))
    return time.perf_counter() - start


def moves(address: str, count: int) -> list[float]:
    """Milliseconds from a move of a slider to its figure, in Chromium."""
    from playwright.sync_api import sync_playwright

    program = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page()
        page.goto(address)
        page.goto(f"{address.partition('/?')[0]}/exam/compose")
        page.wait_for_selector("#live svg")
        page.wait_for_selector("#room[aria-busy=false]")
        page.wait_for_selector("#pages img")
        found = [page.evaluate(_MOVE, 1 if i // 10 % 2 == 0 else -1) for i in range(count)]
        browser.close()
    return [float(each) for each in found]


def percentile(values: Sequence[float], share: float) -> float:
    """The value below which a share of the values lies."""
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def main(argv: Sequence[str] | None = None) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="The studio: times of pages and figures.")
    parser.add_argument("--moves", type=int, default=60)
    parser.add_argument("--building", action="store_true")
    arguments = parser.parse_args(argv)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "exam.toml").write_text(EXAM)
        rows = [("first page, s", f"{percentile([first_page(folder) for _ in range(_STARTS)], 0.5):.2f}")]
        with studio(folder) as address:
            rows.append(("gallery, first start, s", f"{gallery(address):.2f}"))
            rows.append(("gallery, later, s", f"{percentile([gallery(address) for _ in range(3)], 0.5):.2f}"))
            command = [sys.executable, "-m", "variantgen", "build", str(folder / "exam.toml"), "--variants", "400"]
            beside = subprocess.Popen([*command, "--out", str(folder / "out")]) if arguments.building else None
            found = moves(address, arguments.moves)
            if beside:
                beside.terminate()
                beside.wait()
        rows.append(("slider to figure, median, ms", f"{percentile(found, 0.5):.0f}"))
        rows.append(("slider to figure, 95th percentile, ms", f"{percentile(found, 0.95):.0f}"))
    load = f"load {os.getloadavg()[0]:.0f} on {os.cpu_count()} cores"
    sys.stdout.write(f"| measured ({load}) | |\n|---|---|\n" + "".join(f"| {a} | {b} |\n" for a, b in rows))


if __name__ == "__main__":
    main()
