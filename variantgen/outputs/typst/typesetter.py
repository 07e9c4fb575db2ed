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
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from variantgen.errors import ToolMissingError, VariantgenError
from variantgen.figure.drawing import Drawing
from variantgen.outputs.typst.markup import alternatives
from variantgen.outputs.typst.set_formulas import set_formulas
from variantgen.resources import templates_dir

if TYPE_CHECKING:
    import typst

_EPOCH = datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC)


class TypesettingError(VariantgenError):
    """The engine refused a document: a defect of the templates."""


@dataclass(frozen=True)
class Typesetter:
    """A folder with the templates, alone for the engine, and what has been measured with them."""

    root: Path
    measured: dict[str, dict[str, float]] = field(default_factory=dict, compare=False, repr=False)

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
        with_alt = tagged and form == "pdf"
        known: dict[str, Any] = {}
        if form == "pdf":
            known = (
                {"alternatives": alternatives(data)}
                if tagged
                else {"set-formulas": set_formulas(data, template == "solutions.typ")}
            )
        try:
            made = _compiler(self.root).compile(
                self.root / template,
                format=form,
                ppi=ppi,
                sys_inputs=self._inputs(form, _json(data, with_alt), known),
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

    def query(self, template: str, data: Mapping[str, Any], known: Mapping[str, Any]) -> list[float]:
        """The numbers that a template notes under the label ``found``; ``known`` are the formulas that are set."""
        import typst

        inputs = self._inputs("pdf", _json(data, False), {"set-formulas": known})
        # An engine of its own, because only a new one is given a template for a query: 3 ms, once for many sheets.
        engine = typst.Compiler(
            self.root / template, root=self.root, font_paths=[], ignore_system_fonts=True, sys_inputs=inputs
        )
        found: list[float] = json.loads(engine.query("<found>", field="value", one=True))
        return found

    def _inputs(self, form: str, data: str, known: Mapping[str, Any]) -> dict[str, str]:
        """What templates are told: the names of the files with the data, which are those of this process.

        The same names every time: what the engine remembers holds for documents that are told the same.
        """
        inputs = {}
        for name, text in {"data": data, **{name: _json(found) for name, found in known.items()}}.items():
            inputs[name] = f"{name}-{os.getpid()}.json"
            (self.root / inputs[name]).write_text(text, "utf-8")
        return {**inputs, "form": form}


@lru_cache(maxsize=1)
def _compiler(root: Path) -> typst.Compiler:
    """The engine for a folder; it reads its fonts when it is made."""
    import typst

    return typst.Compiler(root=root, font_paths=[], ignore_system_fonts=True)


def _json(data: Any, with_alt: bool = True) -> str:
    """The data as text; drawings in it stand for their words, which only documents with tags hold."""

    def words(drawing: Drawing) -> str:
        return drawing.alt if with_alt else ""

    return json.dumps(data, ensure_ascii=False, separators=(",", ":"), default=words)


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
        yield Typesetter(Path(folder))
