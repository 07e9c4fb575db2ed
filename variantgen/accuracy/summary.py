"""The summary of the measurement in docs/accuracy.md, between markers.

    python -m variantgen.accuracy.summary [DIR]

renews it in a checkout, with the diagrams: from a folder that ``variantgen accuracy --out DIR`` has made, or from a
measurement of its own. A test notices only when the structure is broken; numbers depend on the machine.
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from pathlib import Path

from variantgen.accuracy.report.report_files import SUMMARY, write
from variantgen.accuracy.run import FULL, run
from variantgen.resources import catalog_dir

PICTURES = ("work_precision.png", "motion.png")
_MARKED = re.compile(r"(<!-- accuracy -->\n).*?(<!-- end of accuracy -->)", re.DOTALL)


def refreshed(text: str, summary: str) -> str:
    """A text with the marked part replaced."""
    return _MARKED.sub(lambda match: f"{match[1]}{summary.strip()}\n{match[2]}", text)


def renew(folder: Path, checkout: Path) -> None:
    """Put the summary of a report and its diagrams into a checkout."""
    page = checkout / "docs" / "accuracy.md"
    page.write_text(refreshed(page.read_text("utf-8"), (folder / SUMMARY).read_text("utf-8")), "utf-8")
    for name in PICTURES:
        shutil.copyfile(folder / name, checkout / "docs" / "pictures" / name)


def main() -> None:
    """See the module."""
    checkout = catalog_dir().parent
    if len(sys.argv) > 1:
        renew(Path(sys.argv[1]), checkout)
        return
    with tempfile.TemporaryDirectory() as name:
        write(run(FULL, lambda what: print(what, file=sys.stderr, flush=True)), Path(name))
        renew(Path(name), checkout)


if __name__ == "__main__":
    main()
