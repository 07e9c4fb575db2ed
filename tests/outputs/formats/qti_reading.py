"""An own reading of QTI 2.1 and 3.0, as far as the packages use it: what stands where, and how answers are scored.

The official schemas are in no package that can be installed, so the tables below say what was read in the
specification: children in their order, attributes (those that must be there end with an exclamation mark).
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

MATHML = "http://www.w3.org/1998/Math/MathML"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*")  # the names of XML without a colon that are used here

_EXPRESSIONS = "and or gte lte variable baseValue sum testVariables"
# Element: its attributes; its children: "a? b* c+" in this order, or "{a b c}" in any, with "#" for text.
MODEL = {
    "assessmentItem": (
        "identifier! title! label adaptive timeDependent! toolName toolVersion",
        "responseDeclaration* outcomeDeclaration* itemBody? responseProcessing? modalFeedback*",
    ),
    "responseDeclaration": ("identifier! cardinality! baseType", "correctResponse?"),
    "correctResponse": ("interpretation", "value+"),
    "outcomeDeclaration": ("identifier! cardinality! baseType normalMaximum normalMinimum", "defaultValue?"),
    "defaultValue": ("interpretation", "value+"),
    "value": ("baseType", "#"),
    "itemBody": ("class id label", "{BLOCK}"),
    "textEntryInteraction": ("responseIdentifier! expectedLength patternMask placeholderText class id label", ""),
    "responseProcessing": ("template", "{responseCondition setOutcomeValue}"),
    "responseCondition": ("", "responseIf"),
    "responseIf": ("", "(EXPRESSION) {setOutcomeValue responseCondition}"),
    "setOutcomeValue": ("identifier!", "(EXPRESSION)"),
    "and": ("", "{EXPRESSION}"),
    "or": ("", "{EXPRESSION}"),
    "sum": ("", "{EXPRESSION}"),
    "gte": ("", "(EXPRESSION) (EXPRESSION)"),
    "lte": ("", "(EXPRESSION) (EXPRESSION)"),
    "variable": ("identifier! weightIdentifier", ""),
    "baseValue": ("baseType!", "#"),
    "testVariables": ("variableIdentifier! weightIdentifier baseType sectionIdentifier includeCategory", ""),
    "modalFeedback": ("outcomeIdentifier! showHide! identifier! title", "{FLOW #}"),
    "contentBody": ("class id label", "{FLOW #}"),
    "assessmentTest": ("identifier! title!", "outcomeDeclaration* testPart+ outcomeProcessing?"),
    "testPart": ("identifier! navigationMode! submissionMode!", "itemSessionControl? assessmentSection+"),
    "itemSessionControl": ("maxAttempts showFeedback allowReview showSolution allowComment", ""),
    "assessmentSection": (
        "identifier! required fixed title! visible! keepTogether",
        "selection? ordering? {assessmentSection assessmentItemRef}",
    ),
    "selection": ("select! withReplacement", ""),
    "assessmentItemRef": ("identifier! required fixed href! category", ""),
    "outcomeProcessing": ("", "{setOutcomeValue}"),
}
_HTML = {
    "p": "{INLINE #}", "h4": "{INLINE #}", "pre": "{INLINE #}", "span": "{INLINE #}", "strong": "{INLINE #}",
    "small": "{INLINE #}", "i": "{INLINE #}", "sub": "{INLINE #}", "sup": "{INLINE #}", "code": "{INLINE #}",
    "div": "{FLOW #}", "img": "", "table": "thead? tbody+", "thead": "tr+", "tbody": "tr+", "tr": "{td th}",
    "td": "{FLOW #}", "th": "{FLOW #}",
}  # fmt: skip
_MORE = {"img": "src! alt! width height longdesc", "th": "scope", "td": "headers"}
# HTML 5, which QTI 3.0 has.
_NEWER = {"figure": "{FLOW figcaption #}", "figcaption": "{FLOW #}"}
_BLOCKS = "p h4 pre div table figure"
_INLINE = "span strong small i sub sup code img math textEntryInteraction"
_GROUPS = {
    "EXPRESSION": _EXPRESSIONS,
    "BLOCK": _BLOCKS,
    "INLINE": _INLINE,
    "FLOW": f"{_BLOCKS} {_INLINE}",
}
# Presentation elements and attributes that MathML 2 and MathML 3 share.
_MATH = {
    "math": "", "mrow": "", "mi": "", "mn": "", "mtext": "", "mspace": "width", "mfrac": "", "msqrt": "",
    "mstyle": "displaystyle", "msub": "", "msup": "", "msubsup": "", "munderover": "", "mover": "accent",
    "mo": "form separator lspace rspace stretchy mathsize", "mpadded": "height voffset depth width lspace",
}  # fmt: skip


def check(tree: Element, modern: bool) -> None:
    """Whether a tree, with the names of QTI 2.1, is as the specification says; ``modern``: with the HTML of 3.0."""
    if tree.tag == "math":
        _check_math(tree)
        return
    html = {**_HTML, **(_NEWER if modern else {})}
    if tree.tag in html:
        attributes, children = f"class id label lang {_MORE.get(tree.tag, '')}", html[tree.tag]
    else:
        assert tree.tag in MODEL, tree.tag
        attributes, children = MODEL[tree.tag]
        if tree.tag == "modalFeedback" and modern:
            children = "contentBody"
    _check_attributes(tree, attributes.split())
    _check_children(tree, children)
    for child in tree:
        check(child, modern)


def _check_attributes(tree: Element, known: list[str]) -> None:
    names = {name.rstrip("!") for name in known}
    assert set(tree.attrib) <= names, (tree.tag, tree.attrib)
    assert {name[:-1] for name in known if name.endswith("!")} <= set(tree.attrib), (tree.tag, tree.attrib)
    for name in ("identifier", "responseIdentifier", "outcomeIdentifier", "variableIdentifier"):
        assert _NAME.fullmatch(tree.get(name, "x")), tree.get(name)


def _check_children(tree: Element, pattern: str) -> None:
    if "#" not in pattern:
        texts = (tree.text, *(child.tail for child in tree))
        assert not any((text or "").strip() for text in texts), (tree.tag, texts)
    for group, members in _GROUPS.items():
        pattern = pattern.replace(group, members)
    pattern = re.sub(r"[{(]([^})]*)[})]", lambda found: _any(found[1], found[0][0] == "{"), pattern)
    wanted = "".join(_one(part) for part in re.split(r" (?![^(]*\))", pattern) if part and part != "#")
    found = "".join(f"{child.tag} " for child in tree)
    assert re.fullmatch(wanted, found), (tree.tag, found[:200], wanted[:200])


def _any(names: str, repeated: bool) -> str:
    return f"({'|'.join(name for name in names.split() if name != '#')}){'*' if repeated else ''}"


def _one(part: str) -> str:
    """A part of a pattern as a regular expression over names that end with a space."""
    name, sign = (part[:-1], part[-1]) if part[-1] in "?*+" else (part, "")
    return f"(?:{name} ){sign}"


def _check_math(tree: Element) -> None:
    assert tree.tag in _MATH, tree.tag
    assert set(tree.attrib) <= set(_MATH[tree.tag].split()), (tree.tag, tree.attrib)
    for child in tree:
        _check_math(child)


class Attempt:
    """An attempt at an item with the names of QTI 2.1: its outcomes after response processing."""

    def __init__(self, item: Element, responses: dict[str, float | None]) -> None:
        declared = item.findall("responseDeclaration")
        assert {one.get("identifier") for one in declared} >= responses.keys()
        assert all(one.get("cardinality") == "single" and one.get("baseType") == "float" for one in declared)
        self.values: dict[str, float | str | None] = dict(responses)
        for outcome in item.findall("outcomeDeclaration"):
            default = outcome.find("defaultValue/value")
            number = outcome.get("baseType") == "float"
            self.values[outcome.get("identifier", "")] = (
                float(default.text or "") if number and default is not None else None
            )
        self._run(item.find("responseProcessing"))

    def _run(self, rules: Element | None) -> None:
        for rule in [] if rules is None else rules:
            if rule.tag == "setOutcomeValue":
                self.values[rule.get("identifier", "")] = self._value(rule[0])
            else:
                (branch,) = rule  # a condition without an else
                if self._value(branch[0]) is True:
                    self._run(branch[1:])

    def _value(self, expression: Element) -> float | str | bool | None:
        """The value of an expression; None is NULL, which comes through sums and comparisons."""
        found = [self._value(child) for child in expression]
        match expression.tag:
            case "variable":
                return self.values[expression.get("identifier", "")]
            case "baseValue":
                text = expression.text or ""
                return float(text) if expression.get("baseType") == "float" else text
            case "sum":
                return None if None in found else sum(found)  # type: ignore[arg-type]
            case "gte" | "lte":
                first, second = found
                if first is None or second is None:
                    return None
                return first >= second if expression.tag == "gte" else first <= second  # type: ignore[operator]
            case "and":
                return all(one is True for one in found)
            case "or":
                return any(one is True for one in found)
        raise AssertionError(expression.tag)
