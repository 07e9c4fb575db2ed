"""The embedded typesetting engine (Typst): documents from a template and data, without system TeX or network.

Everything variable is passed as JSON, so text from outside is never markup. The engine sees a folder that holds the
templates and nothing else, its own fonts only, and a fixed time stamp.
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
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from variantgen.errors import ToolMissingError, VariantgenError
from variantgen.figure.curves import DASHES, Curve, curves
from variantgen.figure.drawing import LETTER, Drawing
from variantgen.outputs.typst.markup import alternatives, markup
from variantgen.outputs.typst.set_formulas import set_formulas
from variantgen.resources import templates_dir
from variantgen.wording.formula import Equation, Measured, Surd

if TYPE_CHECKING:
    import typst

_STEPS = {"M": "M%d %d", "L": "L%d %d", "C": "C%d %d %d %d %d %d", "Z": "Z"}
_EPOCH = datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC)


class TypesettingError(VariantgenError):
    """The engine refused a document: a defect of the templates."""


@dataclass(frozen=True)
class Typesetter:
    """A folder with the templates, alone for the engine."""

    root: Path

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
        those of PDF that it conforms to.
        """
        with_alt = tagged and form == "pdf"
        inputs = {"data": _json(data, with_alt), "form": form}
        if form == "pdf":
            known = {"alternatives": alternatives(data)} if tagged else {"set-formulas": set_formulas(data)}
            inputs.update((name, _json(found)) for name, found in known.items())
        try:
            made = _compiler(self.root).compile(
                self.root / template,
                format=form,
                ppi=ppi,
                sys_inputs=inputs,
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


def figure_data(drawing: Drawing) -> dict[str, Any]:
    """A drawing as data for ``figure.typ``: places x, y in whole hundredths of u, y down.

    A curve is weight, fill, dashes and the path, as SVG writes it. The drawing itself stands for its words, which are
    made when they are needed.
    """
    drawn = curves(drawing.lines)
    points = [point for curve in drawn for _, ends in curve.steps for point in ends]
    places = iter(_hundredths([*points, *(label.at for label in drawing.labels)], drawing.height))
    return {
        "w": round(drawing.width, 2),
        "h": round(drawing.height, 2),
        "letter": LETTER,
        "alt": drawing,
        "curves": [[c.weight, c.fill, DASHES[c.dash], _path(c, places)] for c in drawn],
        "labels": [[next(places), next(places), markup(label.formula), label.paper] for label in drawing.labels],
    }


def _path(curve: Curve, places: Iterator[int]) -> str:
    """The steps of a curve with the next places."""
    form = "".join([_STEPS[kind] for kind, _ in curve.steps])
    return form % tuple(islice(places, form.count("%")))


def _hundredths(points: Sequence[complex], height: float) -> list[int]:
    """Coordinates in turn, y down from a height."""
    at = np.array(points, dtype=complex)
    found: list[int] = np.rint(100 * np.stack((at.real, height - at.imag), axis=-1)).astype(int).ravel().tolist()
    return found


def equals_data(equation: Equation, exact: Surd | None = None) -> dict[str, str]:
    """``symbol = value unit`` as data for ``equals`` of ``common.typ``; a unit without a space is put to the value.

    ``exact`` is the value in closed form, which stands before the rounded one.
    """
    right = equation.right
    if not isinstance(right, Measured):
        raise TypeError("expected an equation with a measured value")
    tight = "".join(word for word, _ in right.unit.parts) if right.unit.tight else ""
    return {
        "symbol": markup(equation.left),
        "exact": markup(exact) if exact else "",
        "value": right.number.text + tight,
        "unit": "" if tight else markup(right.unit),
    }
