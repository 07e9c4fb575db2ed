"""What the check of a family found."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from msgspec import Struct, field
from msgspec.structs import asdict

_SHOWN = 3  # places of copies of a mistake that are named


class Spread(Struct, frozen=True):
    """How the values of one asked quantity are spread, in its printed unit.

    ``low``, ``middle``, ``high``: the values below which a tenth, a half, nine tenths of the variants lie.
    ``commonest``
    is the share of the most frequent value (three digits); ``positive`` the share of positive values.
    """

    quantity: str
    unit: str
    low: float
    middle: float
    high: float
    commonest: float
    positive: float

    def as_text(self) -> str:
        """``v_B 12 .. 45 .. 90 cm/s``."""
        return f"{self.quantity} {self.low:.3g} .. {self.middle:.3g} .. {self.high:.3g} {self.unit}".removesuffix(" 1")


class FormReport(Struct):
    """What the draws of one form showed.

    ``nice`` is an estimate of the number of hand-friendly variants (0: none were found), each of which took
    ``nice_attempts`` draws in the mean. ``own_acceptance`` leaves out the screens of answers (rounding, mistakes).
    ``beyond`` draws were larger or faster than the ``size`` class of the form ('': none) allows.
    """

    name: str
    parameters: int
    blocks: list[int]
    variants: int = 0
    distinct: int = 0
    acceptance: float = 0.0
    own_acceptance: float = 0.0
    grid: int = 0
    valid: int = 0
    valid_exact: bool = False
    seconds_per_1000: float = 0.0
    deviation: float = 0.0
    invariant: float = 0.0
    rejected: dict[str, int] = field(default_factory=dict)
    spread: list[Spread] = field(default_factory=list)
    nice: int = 0
    nice_attempts: float = 0.0
    size: str = ""
    beyond: int = 0

    def as_text(self) -> list[str]:
        """The lines of the report."""
        count = f"{self.valid}" if self.valid_exact else f"about {self.valid:.2g}"
        nice = f"about {self.nice:.2g}, {self.nice_attempts:.0f} draws each" if self.nice else "none"
        worst = ", ".join(f"{name} {number}" for name, number in list(self.rejected.items())[:3] if number)
        return [
            f"    {self.name or 'variants'}: {self.variants} drawn, {self.distinct} distinct, acceptance"
            f" {100 * self.acceptance:.1f} % ({100 * self.own_acceptance:.1f} % by its own screens),"
            f" {count} distinct ones of {self.grid:.3g},"
            f" {self.seconds_per_1000:.2f} s per 1000",
            f"        {self.parameters} parameters, blocks {'+'.join(map(str, self.blocks)) or 'none'};"
            f" independent computation within {self.deviation:.0e}, invariants within {self.invariant:.0e}",
            f"        rejected most: {worst or 'nothing'}",
            f"        hand-friendly: {nice}",
            f"        size {self.size}: {self.beyond} draws beyond its limits"
            if self.size
            else "        no limits of size",
            "        tenth .. half .. nine tenths: " + "; ".join(item.as_text() for item in self.spread),
        ]


class Finding(Struct, frozen=True):
    """A mistake: what it is and where it was seen. Findings of one ``kind`` are copies of one mistake."""

    kind: str
    where: str
    message: str


class Report(Struct):
    """What the check of one family found; ``failures`` is empty when all is well, ``remarks`` are no failures."""

    family: str
    findings: list[Finding] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)
    forms: list[FormReport] = field(default_factory=list)
    seconds: float = 0.0

    def fail(self, message: str, where: str = "", kind: str = "") -> None:
        """Note a mistake; copies are distinguished by ``where``, and known by ``kind`` (without one by the message)."""
        self.findings.append(Finding(kind or message, where, message))

    def remark(self, text: str) -> None:
        """Note once what is no failure, but should be looked at."""
        if text not in self.remarks:
            self.remarks.append(text)

    @property
    def failures(self) -> Sequence[str]:
        """The mistakes, each once: the first copy of it, and where the others were seen."""
        groups: dict[str, list[Finding]] = {}
        for finding in self.findings:
            groups.setdefault(finding.kind, []).append(finding)
        return [_grouped(copies) for copies in groups.values()]

    def as_json(self) -> dict[str, Any]:
        """The report as plain data."""
        content = asdict(self)
        del content["findings"]
        content["forms"] = [asdict(form) | {"spread": [asdict(item) for item in form.spread]} for form in self.forms]
        return {"ok": not self.findings, "failures": self.failures, **content}

    def as_text(self) -> str:
        """The report in a few lines."""
        lines = [f"{self.family}: {'FAILED' if self.findings else 'ok'}  ({self.seconds:.2f} s)"]
        if self.cases:
            lines.append(f"    worked cases: {', '.join(self.cases)}")
        for form in self.forms:
            lines += form.as_text()
        lines += [f"    ! {failure}" for failure in self.failures]
        lines += [f"    ({remark})" for remark in self.remarks]
        return "\n".join(lines)


def _grouped(copies: Sequence[Finding]) -> str:
    """One mistake with the place of its first copy, the number of others, and some of their places."""
    first = copies[0]
    text = f"{first.where}: {first.message}" if first.where else first.message
    others = [place for place in dict.fromkeys(finding.where for finding in copies[1:]) if place != first.where]
    if not others:
        return text
    shown = "; ".join(others[:_SHOWN]) + ("; ..." if len(others) > _SHOWN else "")
    what = "form/variant" if len(others) == 1 else "forms/variants"
    return f"{text}\n      and {len(others)} more {what}: {shown}"
