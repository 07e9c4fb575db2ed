"""The embedded typesetting engine (Typst): documents from a template and data, without system TeX or network.

Everything variable is passed as JSON, so text from outside is never markup. The engine sees a folder that holds the
templates and this JSON and nothing else, its own fonts only, and a fixed time stamp.
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
from variantgen.outputs.typst.fragments import FragmentTable, signs
from variantgen.outputs.typst.markup import Lettered, alternatives
from variantgen.outputs.typst.set_formulas import numbered, set_formulas
from variantgen.outputs.typst.solution_pages import contents_of, is_too_high, pages_of
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
        known: dict[str, Any] = {}
        table = FragmentTable() if form == "pdf" and not tagged else None
        text = _json(data, table, spoken=form == "pdf" and tagged)
        if table:
            known["set-formulas"] = numbered(set_formulas(data, longer=template in _ROOMS), table)
            known["fragments"] = table.lines()
        elif form == "pdf":
            known["alternatives"] = alternatives(data)
        inputs = self._inputs(form, text, known)
        try:
            if template in _ROOMS:
                inputs = self._with_pages(inputs, _ROOMS[template])
            made = _compiler(self.root).compile(
                self.root / template,
                format=form,
                ppi=ppi,
                sys_inputs=self._told(inputs),
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

    def _with_pages(self, inputs: dict[str, str], room: float) -> dict[str, str]:
        """The inputs with the pages of a solution, for which the engine measures what stands on them.

        The names of the inputs are the same while it measures, when there are no pages yet: what they lead to is then
        remembered.
        """
        for parted in ("no", "yes"):
            inputs = {**inputs, "pages": _file("pages"), "parted": parted}
            head, problems = contents_of(self._asked("solution_heights.typ", inputs))
            if not is_too_high(problems):
                break
        self._written("pages", _json(pages_of(head, problems, room)))
        return inputs

    def query(self, template: str, data: Mapping[str, Any], known: Mapping[str, Any]) -> list[float]:
        """The numbers that a template notes under the label ``found``; ``known`` are the formulas that are set."""
        found: list[float] = self._asked(template, self._inputs("pdf", _json(data), {"set-formulas": known}))
        return found

    def _asked(self, template: str, inputs: dict[str, str]) -> Any:
        (names,) = self._told(inputs).values()
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

    def _told(self, inputs: Mapping[str, str]) -> dict[str, str]:
        """All inputs in one file: the engine takes several for others than before, as their order changes."""
        return {"inputs": self._written("inputs", _json(inputs))}


def _file(name: str) -> str:
    """The file of this process with what is called so."""
    return f"{name}-{os.getpid()}.json"


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


def _json(data: Any, table: FragmentTable | None = None, spoken: bool = False) -> str:
    """The data as text: with letters by the ``table`` of the document's fragments, if it has one, else with equations.

    Drawings stand for their words, which only documents that are read out, with tags, hold.
    """

    def shown(item: Drawing | Lettered) -> Any:
        if isinstance(item, Lettered):
            return item.data(letters=table is not None, table=table)
        return item.alt if spoken else ""

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
