"""The embedded typesetting engine (Typst): documents from a template and data, without system TeX or network.

Everything variable is passed as JSON or, in solutions, as string literals of source text, so text from outside is
never markup. The engine sees a folder that holds the templates and this data and nothing else, its own fonts only,
and a fixed time stamp.
"""

from __future__ import annotations

import datetime
import importlib.util
import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from msgspec import Struct, field

from variantgen.errors import ToolMissingError, VariantgenError
from variantgen.exam.solution_paper import FOR_TEMPLATES, HEIGHT
from variantgen.figure.drawing import Drawing
from variantgen.outputs.typst.figure_curves import FigureCurves
from variantgen.outputs.typst.fragments import FragmentTable, signs
from variantgen.outputs.typst.markup import Lettered, alternatives
from variantgen.outputs.typst.set_formulas import numbered, set_formulas
from variantgen.outputs.typst.solution_pages import is_too_high, pages_of
from variantgen.outputs.typst.solution_source import SolutionSource
from variantgen.outputs.typst.source import TypstSource
from variantgen.resources import templates_dir

if TYPE_CHECKING:
    import typst

# Templates for solutions, with the height of a page (mm): that of a single problem is as long as it needs to be.
_ROOMS = {"solutions.typ": HEIGHT, "explained.typ": 5000.0}
_EPOCH = datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC)


class TypesettingError(VariantgenError):
    """The engine refused a document: a defect of the templates."""


class Typesetter(Struct, frozen=True, eq=False):
    """A folder with the templates, alone for the engine, what has been measured with them, and what is in its files."""

    root: Path
    measured: dict[str, dict[str, float]] = field(default_factory=dict)
    written: dict[str, str] = field(default_factory=dict)

    def compile(
        self,
        template: str,
        data: Mapping[str, Any] | Sequence[Any],
        form: Literal["pdf", "png", "svg"] = "pdf",
        ppi: float = 200.0,
        tagged: bool = True,
        standards: Sequence[str] = (),
    ) -> list[bytes]:
        """The document; one entry for PDF, one per page for PNG (``ppi`` dots to the inch) and SVG.

        A PDF is ``tagged`` for reading aloud, which takes three quarters of the bytes of a solution; ``standards`` are
        those of PDF that it conforms to. Raises TypesettingError where the engine refuses the template.
        """
        spoken = form == "pdf" and tagged
        letters = form == "pdf" and not tagged
        try:
            if template in _ROOMS:
                inputs = self._solved(cast(Mapping[str, Any], data), form, letters, _ROOMS[template])
            else:
                inputs = self._inputs(form, *self._given(data, form, letters))
            made = _compiler(self.root).compile(
                self.root / template,
                format=form,
                ppi=ppi,
                sys_inputs=self._told(inputs, spoken),
                timestamp=_EPOCH,
                pdf_standards=cast(Any, list(standards)),
                pdf_tags=tagged,
            )
            # The engine forgets what it has not used in its last ten documents. An empty one after each lets it forget
            # twice as soon: it needs two thirds of the memory and no more time.
            _compiler(self.root).compile(b"", format="pdf")
        except RuntimeError as error:
            raise TypesettingError(f"the typesetting engine refused {template}: {error}") from error
        return [made] if isinstance(made, bytes) else list(made or ())

    def _given(self, data: Any, form: str, letters: bool) -> tuple[str, dict[str, Any]]:
        """The data as text, and what else a template is told."""
        if not letters:
            known = {"alternatives": alternatives(data)} if form == "pdf" else {}
            return _json(data, form=form), known
        table = FragmentTable()
        text = _json(data, table, form)
        formulas = numbered(set_formulas(data), table)
        return text, {"set-formulas": formulas, "fragments": table.lines()}

    def _solved(self, data: Mapping[str, Any], form: str, letters: bool, room: float) -> dict[str, str]:
        """The inputs for a solution, with its pages, for which the engine measures what stands on them.

        The names of the inputs are the same while it measures, when there are no pages yet: what they lead to is then
        remembered.
        """
        spoken = form == "pdf" and not letters
        solution = SolutionSource(data, TypstSource(letters, spoken), image=form == "pdf")
        inputs = {"contents": _file("contents"), "pages": _file("pages")}
        for parted in (False, True):
            self._written("contents", solution.text(parted))
            head, problems = solution.blocks(self._asked("solution_heights.typ", inputs, spoken), parted)
            if not is_too_high(problems):
                break
        pages = pages_of(head, problems, room)
        placed = solution.placed(pages.pages, parted, problems)
        self._written("pages", _json({"pages": placed, "high": pages.y}))
        return inputs

    def query(self, template: str, data: Mapping[str, Any], known: Mapping[str, Any]) -> list[float]:
        """The numbers that a template notes under the label ``found``; ``known`` are the formulas that are set."""
        found: list[float] = self._asked(template, self._inputs("pdf", _json(data), {"set-formulas": known}))
        return found

    def _asked(self, template: str, inputs: dict[str, str], spoken: bool = False) -> Any:
        (names,) = self._told(inputs, spoken).values()
        return json.loads(_asking(self.root, template, names).query("<found>", field="value", one=True))

    def _inputs(self, form: str, data: str, known: Mapping[str, Any]) -> dict[str, str]:
        """What templates are told: the names of the files with the data, which are those of this process.

        The same names every time: what the engine remembers holds for documents with the same inputs.
        """
        inputs = {"form": form}
        for name, text in {"data": data, **{name: _json(found) for name, found in known.items()}}.items():
            inputs[name] = self._written(name, text)
        return inputs

    def _written(self, name: str, text: str) -> str:
        """The name of the file of this process that has some text now."""
        file = _file(name)
        if self.written.get(file) != text:  # most inputs are those of the document before
            (self.root / file).write_text(text, "utf-8")
            self.written[file] = text
        return file

    def _told(self, inputs: Mapping[str, str], spoken: bool = False) -> dict[str, str]:
        """All inputs in one file: the engine takes several for others than before, as their order changes.

        Its name says whether the document has tags: what depends on nothing else the engine makes once.
        """
        return {"inputs": self._written("tagged" if spoken else "inputs", _json(inputs))}


def _file(name: str) -> str:
    """The file of this process with what is called so: data, or source text."""
    return f"{name}-{os.getpid()}.{'txt' if name == 'contents' else 'json'}"


@lru_cache(maxsize=1)
def _compiler(root: Path) -> typst.Compiler:
    """The engine for a folder; it reads its fonts when it is made."""
    import typst

    return typst.Compiler(root=root, font_paths=[], ignore_system_fonts=True)


@lru_cache(maxsize=2)
def _asking(root: Path, template: str, names: str) -> typst.Compiler:
    """An engine that answers questions about one template: only a new one is given a template for that."""
    import typst

    inputs = {"inputs": names}
    return typst.Compiler(root / template, root=root, font_paths=[], ignore_system_fonts=True, sys_inputs=inputs)


def _json(data: Any, table: FragmentTable | None = None, form: str = "pdf") -> str:
    """The data as text: with letters by the ``table`` of the document's fragments, if it has one, else with equations.

    Drawings stand for their words, which only documents that are read out, with tags, hold.
    """

    def shown(item: Drawing | FigureCurves | Lettered) -> Any:
        if isinstance(item, Lettered):
            return item.data(letters=table is not None, table=table)
        if isinstance(item, FigureCurves):
            return item.image if form == "pdf" else item.one_by_one()
        return item.alt if table is None and form == "pdf" else ""

    return json.dumps(data, ensure_ascii=False, separators=(",", ":"), default=shown)


@contextmanager
def typesetter() -> Iterator[Typesetter]:
    """A typesetter whose folder lasts as long as the block. Raises ToolMissingError without the engine."""
    # One thread: measured on 100 sheets, the engine's own threads cost a third more CPU and save no time here;
    # --jobs is the way to use more cores.
    os.environ.setdefault("RAYON_NUM_THREADS", "1")
    # Only looked for, so that the message comes before any work: a process that has not used it can be forked.
    if importlib.util.find_spec("typst") is None:
        raise ToolMissingError("PDF output needs the package typst: install it with  pip install typst")
    with tempfile.TemporaryDirectory(prefix="variantgen-") as folder:
        for path in sorted((templates_dir() / "typst").glob("*.typ")):
            shutil.copyfile(path, Path(folder) / path.name)
        for name, data in (("signs", signs()), ("measures", FOR_TEMPLATES)):
            (Path(folder) / f"{name}.json").write_text(_json(data), "utf-8")
        yield Typesetter(Path(folder))
