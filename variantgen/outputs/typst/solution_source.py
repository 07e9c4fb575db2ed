"""A document with solutions as source text for the typesetting engine: what stands on its pages, and in which units.

The value of the text is a dictionary with ``bodies``, of which some are ``measured``, and ``figures``; what it calls is
in ``templates/typst/solution.typ``. A solution is a row of parts; parts that belong together are a unit, which is not
parted (:mod:`variantgen.outputs.typst.solution_pages`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from variantgen.exam.solution_paper import COLUMN, EM, WIDTH
from variantgen.outputs.typst.formula_lines import Row
from variantgen.outputs.typst.row_source import placed_lines, row_source
from variantgen.outputs.typst.solution_pages import UNDER_FIGURE, ProblemBlocks, Standing
from variantgen.outputs.typst.solution_parts import Part, ShownFigure, SolvedParts, blocks_of, units_of
from variantgen.outputs.typst.source import TypstSource, array, string

_STATEMENT_UNIT = 0.56  # millimetres of a unit of the figure beside a statement
_LINES_OF_PAGE = 50  # a long program is broken between pages, after so many lines
_BRACKETS = re.compile(r"\([^()]*\)")


class SolutionSource:
    """The source text of one document, and what it consists of."""

    def __init__(self, data: Mapping[str, Any], source: TypstSource, image: bool) -> None:
        self._source = source
        self._image = image
        self._words: Mapping[str, str] = data["words"]
        self._bodies: list[str] = []
        self._figures: list[str] = []
        self._widths: list[tuple[int, float]] = []
        student = data["students"][0] if "students" in data else None
        self._head = self._measured(WIDTH, self._heading_of_all(data, student)) if student else None
        problems = student["problems"] if student else [data["problem"]]
        self._problems = [self._problem(problem, single=not student) for problem in problems]
        self._others = self._said(data, student)

    def text(self, parted: bool) -> str:
        """The source text; ``parted``: parts that belong together are units of their own."""
        measured = array([f"({number},{width!r})" for number, width in self._all_measured(parted)])
        said = {**self._others, "bodies": array(self._bodies), "figures": array(self._figures), "measured": measured}
        return self._source.value(_dictionary(said))

    def blocks(self, measured: Sequence[float], parted: bool) -> tuple[float, list[ProblemBlocks]]:
        """The height of the head and the problems, from the heights (mm) of what is measured."""
        numbers = [number for number, _ in self._all_measured(parted)]
        heights = dict(zip(numbers, measured, strict=True))
        problems = [blocks_of(problem, heights, parted) for problem in self._problems]
        return heights[self._head] if self._head is not None else 0.0, problems

    def placed(self, pages: Sequence[Sequence[Standing]], parted: bool, blocks: Sequence[ProblemBlocks]) -> list[Any]:
        """What ``standing`` of the template gets for each page."""
        units = [list(units_of(problem.parts, parted)) for problem in self._problems]
        return [[item for standing in page for item in self._items(standing, units, blocks)] for page in pages]

    def _items(
        self, standing: Standing, units: Sequence[Sequence[Sequence[Part]]], blocks: Sequence[ProblemBlocks]
    ) -> Iterator[tuple[str, int, float, float, float]]:
        kind, problem, number, x, y, unit = standing
        if kind == "figure":
            figure = self._problems[problem].figures[number]
            yield "figure", figure.drawing, x, y, unit
            yield "text", figure.caption, x, y + figure.drawn * unit + UNDER_FIGURE, COLUMN
        elif kind == "unit":
            block = blocks[problem].units[number]
            for part, start in zip(units[problem][number], block.starts, strict=True):
                if part.high is None:
                    yield "text", part.body, x, y + start, WIDTH if block.wide else COLUMN
                for how, body, right, down in part.placed:
                    yield how, body, round(x + EM * right, 4), round(y + start + EM * down, 4), 0.0
        elif kind == "heading":
            yield "text", self._problems[problem].headings[number], x, y, WIDTH
        elif self._head is not None:
            yield "text", self._head, x, y, WIDTH

    def _all_measured(self, parted: bool) -> list[tuple[int, float]]:
        """The numbers and widths (mm) of the bodies that are measured: parts have the widths of their units."""
        found = [*self._widths]
        for problem in self._problems:
            for unit in units_of(problem.parts, parted):
                width = WIDTH if any(part.wide for part in unit) else COLUMN
                found += [(part.body, width) for part in unit if part.high is None]
        return found

    def _said(self, data: Mapping[str, Any], student: Mapping[str, Any] | None) -> dict[str, str]:
        said = {
            "title": string(data["title"]),
            "lang": string(data["lang"]),
        }
        if student:
            said["variant-word"] = string(self._words["variant"])
            said |= {"code": string(student["code"]), "short": string(student["short"])}
        else:
            said |= {"remark": string(data["remark"]), "notes": array(map(self._source.steady, data["notes"]))}
        return said

    def _heading_of_all(self, data: Mapping[str, Any], student: Mapping[str, Any]) -> str:
        stated = (data["course"], student["group"], self._words["solutions"], data["title"], student["name"])
        notes = array(map(self._source.steady, student["notes"]))
        return _call("head", *map(string, (*stated, self._words["variant"], student["code"])), notes)

    def _body(self, code: str) -> int:
        self._bodies.append(code)
        return len(self._bodies) - 1

    def _measured(self, width: float, code: str) -> int:
        number = self._body(code)
        self._widths.append((number, width))
        return number

    def _problem(self, p: Mapping[str, Any], single: bool) -> SolvedParts:
        made = SolvedParts()
        level = 2 if single else 3
        if not single:
            stated = (string(self._words["problem"]), string(p["number"]), string(p["title"]))
            made.headings = tuple(
                self._measured(WIDTH, _call("problem-heading", *stated, at_top)) for at_top in ("false", "true")
            )
        self._figure(made, {**p["figure"], "unit": _STATEMENT_UNIT, "least": _STATEMENT_UNIT})
        parts = [self._part(self._statement(p), 0.6, 0.8)]
        if p["plan"]:
            parts.append(
                self._part(_call("plan", string(self._words["plan"]), self._source.steady(p["plan"])), 0.8, 0.8)
            )
        for number, section in enumerate(p["sections"], start=1):
            own = [self._part(self._heading(number, section, level), 1.1, 0.65, joined=True)]
            for k, block in enumerate(section["blocks"], start=1):
                # The end of the last step stays with the answer.
                last = number == len(p["sections"]) and k == len(section["blocks"])
                own += self._block(block, block["leads"] or last)
            # No figure stands between formulas of one sentence: those of a step come after the first of its sentences.
            at = next((i for i, part in enumerate(own[:-1]) if not (part.joined or part.open)), len(own) - 1)
            first = len(made.figures)
            for figure in section["figures"]:
                self._figure(made, figure)
            own[at] = replace(own[at], figures=range(first, len(made.figures)))
            parts += own
        parts.append(self._part(self._answer(p["answer"]), 1.1, 0.8))
        if p["check"]:
            own = [self._part(_call("check", string(self._words["check"]), str(level)), 0.9, 0.6, joined=True)]
            for block in p["check"]:
                own += self._block(block, block["leads"])
            wide = any(part.wide for part in own)
            parts += [replace(part, joined=True, wide=wide) for part in own[:-1]]
            parts.append(replace(own[-1], joined=False, wide=wide, below=0.75))
        made.parts = parts
        return made

    def _part(self, code: str, above: float, below: float, **others: Any) -> Part:
        return Part(self._body(code), above, below, **others)

    def _statement(self, p: Mapping[str, Any]) -> str:
        source, words = self._source, self._words
        given = array(map(source.equals, p["given"]))
        asked = array([f"box({source.formula(symbol)})" for symbol in p["asked"]])
        stated = (source.steady(p["text"]), string(words["given"]), given, string(words["find"]), asked)
        return _call("statement", *stated)

    def _heading(self, number: int, section: Mapping[str, Any], level: int) -> str:
        heading = section["heading"]
        by = "bold" if all(isinstance(item, str) for item in heading) else "strong"  # which alone makes formulas bold
        said = self._source.steady(heading, bold=True)
        return _call("step", str(number), said, by, string(section["see"]), str(level))

    def _answer(self, answer: Sequence[Any]) -> str:
        tall = any(not isinstance(item, str) and "frac(" in item[0] for item in answer)
        return _call("answer", string(self._words["answer"]), self._source.steady(answer), "true" if tall else "false")

    def _block(self, block: Mapping[str, Any], joined: bool) -> Iterator[Part]:
        match block["kind"]:
            case "text":
                yield self._part(self._source.steady(block["text"]), 0.7, 0.7, joined=joined)
            case "formulas":
                yield from self._rows(block["rows"], joined)
            case "vectors":
                yield self._part(self._vectors(block), 0.75, 0.8, joined=joined)
            case "program":
                yield from self._program(block["code"], joined)

    def _rows(self, rows: Sequence[Row], joined: bool) -> Iterator[Part]:
        for i, row in enumerate(rows):
            last = i == len(rows) - 1
            above, below = 0.64 if i else 0.7, 0.72 if last else 0.64
            others: dict[str, Any] = {"joined": joined and last, "wide": row.wide, "open": not last}
            high = row.known_height(self._source.letters)
            if high is None:
                yield self._part(row_source(self._source, row), above, below, **others)
            else:
                lines = placed_lines(self._source, row)
                placed = [(how, self._body(code), right, down) for how, code, right, down in lines]
                yield Part(placed[0][1], above, below, high=high, placed=placed, **others)

    def _vectors(self, block: Mapping[str, Any]) -> str:
        source = self._source
        cells: list[str] = []
        for vector, direction, magnitude in block["rows"]:
            cells += [source.formula(vector), source.steady(direction), source.steady(magnitude)]
        return _call("vectors", array(map(string, block["heads"])), *cells)

    def _program(self, code: str, joined: bool) -> Iterator[Part]:
        lines = code.split("\n")
        pieces = [lines[i : i + _LINES_OF_PAGE] for i in range(0, len(lines), _LINES_OF_PAGE)]
        for i, piece in enumerate(pieces, start=1):
            first, last = i == 1, i == len(pieces)
            said = ("true" if first else "false", "true" if last else "false")
            body = _call("program", string("\n".join(piece)), *said)
            others = {"joined": joined and last, "wide": True}
            yield self._part(body, 0.8 if first else 0.0, 0.9 if last else 0.0, **others)

    def _figure(self, made: SolvedParts, f: Mapping[str, Any]) -> None:
        """A figure and its caption, which is measured."""
        drawn = f["figure"]
        caption = [_BRACKETS.sub(_unbroken, item) if isinstance(item, str) else item for item in f["caption"]]
        body = self._measured(COLUMN, _call("caption", self._source.steady(caption)))
        made.figures.append(ShownFigure(len(self._figures), drawn["h"], f["unit"], f["least"], body))
        self._figures.append(self._drawing(drawn))

    def _drawing(self, figure: Mapping[str, Any]) -> str:
        letters = self._source.letters
        labels = figure["labels"].data(letters)
        curves = figure["curves"]
        said = {
            "w": repr(figure["w"]),
            "h": repr(figure["h"]),
            "letter": repr(figure["letter"]),
            "alt": string(figure["alt"].alt if self._source.spoken else ""),
            "curves": string(curves.image) if self._image else _curves(curves.one_by_one()),
            "letters": f"{{{self._source.line(labels['letters'])}}}" if labels["letters"] else "none",
            "labels": f"(markup:{array(f'({x!r},{y!r},{string(markup)})' for x, y, markup in labels['markup'])})",
        }
        return _dictionary(said)


def _curves(curves: Sequence[Any]) -> str:
    return array(
        f"({weight!r},{string(fill)},{array(map(repr, dash))},{string(path)})" for weight, fill, dash, path in curves
    )


def _unbroken(found: re.Match[str]) -> str:
    """What stands in brackets, which is not broken."""
    return found[0].replace(" ", "\N{NO-BREAK SPACE}")


def _dictionary(said: Mapping[str, str]) -> str:
    return f"({','.join([f'{name}:{code}' for name, code in said.items()])})"


def _call(name: str, *arguments: str) -> str:
    return f"{name}({','.join(arguments)})"
