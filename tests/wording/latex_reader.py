"""Arithmetic in LaTeX as text in one line, for the exact reader: what a bar or a root covers is put in parentheses."""

from __future__ import annotations

from tests.wording.exact_reader import FUNCTIONS

_SIGNS = (
    ("\\mathopen{}\\left", ""),
    ("\\right", ""),
    (" \\cdot ", " · "),
    (" \\mathop", "\xa0\\mathop"),  # a letter before a function
    ("\\,", "\xa0"),
    ("^{\\circ}", "°"),
    ("\\omega_{O A}", "ω_OA"),
    ("O A", "OA"),
    ("a_{B}^{n}", "a^n_B"),
    ("-", "−"),
    *((f"{sign}\xa0", f"{sign} ") for sign in "·+−"),
)


def in_line(latex: str) -> str:
    """The formula as plain text. Raises ValueError if a command is not known."""
    for old, new in _SIGNS:
        latex = latex.replace(old, new)
    for name in FUNCTIONS:
        latex = latex.replace(f"\\mathop{{\\text{{{name}}}}}\\nolimits", name)
        latex = latex.replace(f"{name} (", f"{name}(").replace(f"{name} ", f"{name}\xa0")
    while "}" in latex:
        latex = _without_innermost_group(latex)
    if "\\" in latex:
        raise ValueError(latex)
    return latex


def _without_innermost_group(text: str) -> str:
    end = text.index("}")
    start = text.rindex("{", 0, end)
    before, inner, after = text[:start], text[start + 1 : end], text[end + 1 :]
    command = max((c for c in ("^", "\\sqrt", "\\frac", "\\over") if before.endswith(c)), key=len)
    before = before.removesuffix(command)
    match command:
        case "^":
            if before.endswith(tuple(FUNCTIONS)):  # cos^{2} (a): the space after the exponent is that of the function
                after = after.replace(" (", "(", 1) if after.startswith(" (") else after.replace(" ", "\xa0", 1)
            return f"{before}^({inner}){after}" if inner.startswith("−") else f"{before}^{inner}{after}"
        case "\\sqrt":
            times = "\xa0" if before[-1:].isdecimal() else ""
            return f"{before}{times}(√({inner})){after}"
        case "\\frac":  # the denominator follows and becomes an innermost group, too
            return f"{before}(({inner}) / \\over{after}"
        case _:
            return f"{before}({inner})){after}"
