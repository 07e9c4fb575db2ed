"""Plots of the motion of a variant over the way of its driver (``show --motion``): PDF, SVG, PNG; GIF is a film.

Needs matplotlib (the extra ``plots``). Same input, same bytes: no dates, no random names.
"""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.quantities import Quantity
from variantgen.outputs.figures import write_whole
from variantgen.outputs.figures.mpl import need_matplotlib
from variantgen.outputs.motion.film import film
from variantgen.outputs.motion.page import page
from variantgen.outputs.motion.subject import Subject
from variantgen.variants.driver_sweep import driver_sweep
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language, load_language

FORMATS = ("pdf", "svg", "png", "gif")
STYLE = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9.5,
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "path.simplify": False,
    "pdf.fonttype": 42,
    "svg.fonttype": "path",
    "svg.hashsalt": "variantgen",
}


def write_motion(variant: Variant, asked: Sequence[Quantity], language_name: str, path: Path, remark: str = "") -> None:
    """Write the plots of a variant; the format follows the ending of the path.

    Raises InputError for another ending, a variant that does not move and a path that cannot be written, and
    ToolMissingError without matplotlib.
    """
    form = path.suffix.lstrip(".").lower()
    if form not in FORMATS:
        raise InputError(Problem("unknown format", key="--motion", value=path.name, remedy=nearest(form, FORMATS)))
    made = motion_bytes(variant, asked, load_language(language_name), form, remark)
    write_whole(path, made, "--motion")


def motion_bytes(variant: Variant, asked: Sequence[Quantity], language: Language, form: str, remark: str = "") -> bytes:
    """The plots of a variant as a document of one of the ``FORMATS``. Raises as :func:`write_motion` does."""
    need_matplotlib()
    import matplotlib as mpl

    subject = Subject(variant, driver_sweep(variant, asked), asked, language)
    with mpl.rc_context():
        # Settings of the machine must not change the page.
        mpl.rcdefaults()
        mpl.rcParams.update(STYLE)
        if form == "gif":
            return film(subject)
        figure = page(subject, remark)
        stream = BytesIO()
        dates = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {}}[form]
        figure.savefig(stream, format=form, metadata=dates, dpi=200)
        return stream.getvalue()
