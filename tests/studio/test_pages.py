"""Whole ways through the pages in a real browser: by sight, by keyboard, in both languages, light and dark, narrow."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.studio.conftest import EXAM, Visit

Open = Callable[..., Visit]
PAGES = ("/?all", "/exam/choose")


def saved(visit: Visit, name: str = "exam") -> dict[str, Any]:
    return tomllib.loads((visit.folder / f"{name}.toml").read_text("utf-8"))


def barriers(page: Any) -> list[str]:
    """What axe finds on a page."""
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(page)
    return [f"{item['id']}: {node['html'][:160]}" for item in found.response["violations"] for node in item["nodes"]]


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_nobody_meets_a_barrier(visit: Open, theme: str) -> None:
    """Every page, both languages, wide and narrow: axe finds nothing, nothing scrolls sideways, nothing complains."""
    window = visit(theme=theme)
    for path in PAGES:
        for language in ("en", "ru"):
            page = window.open(path, language)
            page.wait_for_selector("main:not(:has([aria-busy=true]))")
            if path == "/exam/choose":  # axe takes 8 s for all cards, which are alike
                page.get_by_role("searchbox").fill("planet")
            assert barriers(page) == [], (path, language)
            page.set_viewport_size({"width": 360, "height": 740})
            assert page.evaluate("document.documentElement.scrollWidth") <= 360, (path, language)
            page.set_viewport_size({"width": 1280, "height": 800})
            assert page.evaluate("document.documentElement.scrollWidth") <= 1280, (path, language)
    assert window.complaints == []


def test_an_exam_begins_with_pictures(visit: Open) -> None:
    window = visit("", name="empty")  # an empty file is no exam
    page = window.open("/")
    page.get_by_label("Title").fill("Homework 7")
    page.get_by_role("button", name="Choose problems").click()
    page.wait_for_url("**/Homework-7/choose")
    page.get_by_role("searchbox").fill("кулисный swinging")
    card = page.locator(".card:visible")
    assert card.count() == 1 and "swinging" in card.inner_text()
    card.get_by_role("button", name="Add").click()
    page.get_by_text("Problem 1 added", exact=True).wait_for()
    found = saved(window, "Homework-7")
    assert found["problem"] == [{"family": "slotted_rocker", "form": "swinging", "points": 10}]
    # By keyboard alone: out again, and undo.
    card.locator("a").focus()
    page.keyboard.press("Space")
    page.get_by_text("Problem 1 removed", exact=True).wait_for()
    assert "problem" not in saved(window, "Homework-7")
    page.keyboard.press("Control+z")
    page.get_by_text("Taken back: problem 1 removed").wait_for()
    assert saved(window, "Homework-7") == found
    assert card.locator(".badge").inner_text() == "Problem 1"
    assert window.complaints == []


def test_windows_and_editors_see_each_other(visit: Open) -> None:
    first, second = visit(EXAM), visit(EXAM)
    one, two = first.open("/exam/choose"), second.open("/exam/choose")
    for page in (one, two):
        page.wait_for_selector("#cards[aria-busy=false]")
    one.locator('[data-card="ladder/oblique"] [data-do=add]').click()
    two.locator('[data-card="ladder/oblique"] .badge').wait_for()
    assert two.locator('[data-under="choose"]').inner_text() == "3\N{NO-BREAK SPACE}problems"
    path: Path = first.folder / "exam.toml"
    path.write_text(path.read_text().replace('"oblique"', '"driven_at_wall"'))
    one.locator('[data-card="ladder/driven_at_wall"] .badge').wait_for()
    two.locator('[data-card="ladder/driven_at_wall"] .badge').wait_for()
    assert first.complaints == second.complaints == []
