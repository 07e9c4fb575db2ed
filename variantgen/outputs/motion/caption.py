"""The caption of the plots, in lines: what the curves mean, what the way is, where it ends, what is constant."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from variantgen.mechanism.turn.sweep import SweepEnd
from variantgen.outputs.motion.plotted_curves import PlottedCurve, origin
from variantgen.outputs.motion.subject import Subject
from variantgen.wording.formula import Equation, Measured, Symbol
from variantgen.wording.mathtext import to_mathtext

SIZE = 8.5  # of the letters, points


def caption_lines(subject: Subject, constants: Sequence[PlottedCurve], clipped: bool, width: float) -> list[str]:
    """The caption in lines of at most ``width`` inches, formulas in mathtext."""
    words, language = subject.language.words("motion"), subject.language
    symbols, sweep = subject.variant.form.symbols, subject.driver_sweep.sweep
    said = [words["curves"]]
    if not subject.driver_sweep.given:
        key = (
            "turned"
            if sweep.leading_driver.angular
            else ("moved" if len(subject.driver_sweep.target) == 1 else "extended")
        )
        points = to_mathtext(language.symbol("".join(subject.driver_sweep.target), symbols))
        said.append(words[key].format(symbol=subject.abscissa_symbol, point=points))
    name, _ = origin(subject.variant, sweep.motion, subject.asked, sweep.instant)
    where = "axes_moving" if name in subject.moving.paths else "axes"
    axes = {letter: to_mathtext(Symbol(letter)) for letter in ("x", "y")}
    said.append(words[where].format(origin=to_mathtext(language.symbol(name, symbols)), **axes))
    said += end_sentences(subject)
    if np.any(~sweep.clear[1:-1]):
        said.append(words["passed"])
    if clipped:
        said.append(words["clipped"])
    if constants:
        values = [Measured(language.rounded(curve.now), language.unit(curve.unit)) for curve in constants]
        equations = [to_mathtext(Equation(c.formula, value)) for c, value in zip(constants, values, strict=True)]
        said.append(f"{words['constant']} {', '.join(equations)}.")
    return _wrapped(" ".join(said), width)


def _wrapped(text: str, width: float) -> list[str]:
    """Lines that are at most so many inches wide; formulas have no spaces, so that none is broken."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    font, meter = FontProperties(size=SIZE), TextToPath()
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if meter.get_text_width_height_descent(longer, font, "$" in longer)[0] <= 72 * width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def end_sentences(subject: Subject) -> list[str]:
    """What bounds the range of the abscissa, where it is not a turn or a choice of the plot."""
    words = subject.language.words("motion")
    ends = subject.driver_sweep.sweep.ends
    left, right = ends if subject.driver_sweep.values[-1] >= subject.driver_sweep.values[0] else ends[::-1]
    worded = (SweepEnd.DEAD_POINT, SweepEnd.JOINT)
    if left is right and left in worded:
        return [words["both"].format(end=words[left.value])]
    sides = (("left", left), ("right", right))
    return [words[side].format(end=words[end.value]) for side, end in sides if end in worded]
