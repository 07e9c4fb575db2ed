"""Operations on keys of a TOML text, which change the lines of these keys and nothing else.

An operation is a table as the browser sends it: ``{"op": "set", "path": "problem[3].range.phi", "value": [45, 135]}``;
``unset`` takes a key away, ``insert`` puts a table ``value`` into a list ``path`` before the place ``at`` (from 1),
``remove`` and ``move`` (``to``) take a table of a list away or to another place. What has come out is compared with
what was meant before it is used.
"""

from __future__ import annotations

import copy
import json
import re
import tomllib
from collections.abc import Mapping, Sequence
from decimal import Decimal
from itertools import pairwise
from typing import Any

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.toml_lines import Entry, Path, Places, detached, parse_path, places, written_path

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_OPERATIONS = ("set", "unset", "insert", "remove", "move")
_MOST = 100  # operations of one edit
_LARGEST = Decimal("1e300")  # beyond which JSON has no number
_PLACES = 10_000  # of a list


class Operation(Struct, frozen=True):
    """What is to be done with a key; ``at`` counts from 0."""

    op: str
    path: Path
    value: Any = None
    at: int = 0

    @property
    def touched(self) -> Path:
        """The path that another edit must not have changed in the meantime: of a list that is reordered the whole."""
        return self.path[:-1] if self.op in ("remove", "move") else self.path


def read_operations(given: Any) -> tuple[Operation, ...]:
    """The operations of a request. Raises InputError for what is none."""
    if not isinstance(given, list) or not 1 <= len(given) <= _MOST:
        raise InputError(Problem("expected a list of operations", key="operations"))
    return tuple(_operation(item) for item in given)


def _operation(item: Any) -> Operation:
    if not isinstance(item, Mapping) or item.get("op") not in _OPERATIONS or not isinstance(item.get("path"), str):
        raise InputError(Problem("expected an operation with a path", key="operations", value=str(item)[:80]))
    op, path = item["op"], parse_path(item["path"])
    place = item.get("at" if op == "insert" else "to", 1)
    if not path or not isinstance(place, int) or not 0 <= place <= _PLACES:
        raise InputError(Problem("expected a key and a place", key="operations", value=str(item)[:80]))
    if op in ("remove", "move") and not isinstance(path[-1], int):
        raise InputError(Problem("expected a table of a list", key=item["path"]))
    return Operation(op, path, _with_decimals(item.get("value")), max(0, place - 1))


def _with_decimals(value: Any) -> Any:
    """A value of JSON with the decimals that are written; what TOML has no word for is refused."""
    if isinstance(value, float):
        return Decimal(repr(value))
    if isinstance(value, list):
        return [_with_decimals(item) for item in value]
    if isinstance(value, Mapping):
        return {str(name): _with_decimals(item) for name, item in value.items()}
    return value


def apply(text: str, operations: Sequence[Operation]) -> str:
    """The text after operations. Raises InputError where they do not fit, or the text is written in an unusual way."""
    for operation in operations:
        meant = _meant(_data(text), operation)
        changed = _applied(text, operation)
        try:
            right = tomllib.loads(changed, parse_float=Decimal) == meant
        except tomllib.TOMLDecodeError:
            right = False
        if not right:
            remedy = "change the text of the file itself"
            raise InputError(
                Problem("is written in a way that cannot be changed here", key=_name(operation), remedy=remedy)
            )
        text = changed
    return text


def value_at(data: Any, path: Path) -> Any:
    """The value of a path in the content of a file; None where there is none."""
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def written(value: Any) -> str:
    """A value as TOML. Raises InputError for one that TOML has no word for."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Decimal):
        text = f"{value:f}"
        return text if "." in text else text + ".0" if value != value.to_integral_value() else text
    if isinstance(value, int):
        return str(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return f"[{', '.join(map(written, value))}]"
    if isinstance(value, Mapping):
        inner = ", ".join(f"{_written_key(name)} = {written(item)}" for name, item in value.items())
        return f"{{ {inner} }}" if inner else "{}"
    raise InputError(Problem("has no value that a file can hold", value=str(value)[:60]))


def plain(value: object) -> object:
    """A value of a file as JSON can hold it."""
    if isinstance(value, list):
        return [plain(item) for item in value]
    if isinstance(value, dict):
        return {name: plain(item) for name, item in value.items()}
    if isinstance(value, Decimal):
        return float(value) if value.is_finite() and abs(value) < _LARGEST else str(value)
    return value if isinstance(value, str | int | bool) or value is None else str(value)


def _written_key(name: str) -> str:
    return name if _BARE.fullmatch(name) else written(name)


def _name(operation: Operation) -> str:
    return written_path(operation.path)


def _data(text: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except (ValueError, RecursionError) as error:
        raise InputError(Problem(f"is not valid TOML: {error}", remedy="correct the text first")) from None


def _meant(data: dict[str, Any], operation: Operation) -> dict[str, Any]:
    """The content after an operation, worked out without the text. Raises InputError where it does not fit."""
    data = copy.deepcopy(data)
    *above, last = operation.path
    inside: Any = data
    try:
        if operation.op == "insert":
            above, last = [*above, last], operation.at
            for part in above:
                inside = inside.setdefault(part, []) if isinstance(inside, dict) else inside[part]
            inside.insert(last, copy.deepcopy(operation.value))
            return data
        for part in above:
            inside = inside.setdefault(part, {}) if isinstance(inside, dict) else inside[part]
        if operation.op == "set":
            inside[last] = copy.deepcopy(operation.value)
        elif operation.op == "unset":
            inside.pop(last, None)
            for length in range(len(above), 0, -1):  # nothing stands for an empty table
                if isinstance(above[length - 1], str) and value_at(data, tuple(above[:length])) == {}:
                    value_at(data, tuple(above[: length - 1])).pop(above[length - 1])
        else:
            taken = inside.pop(last)
            if operation.op == "move":
                inside.insert(operation.at, taken)
            elif not inside and isinstance(above[-1], str):
                value_at(data, tuple(above[:-1])).pop(above[-1])
    except (KeyError, IndexError, TypeError, AttributeError):
        raise InputError(Problem("is no longer there", key=_name(operation), remedy="load the page again")) from None
    return data


def _applied(text: str, operation: Operation) -> str:
    if text and not text.endswith("\n"):
        text += "\n"
    found = places(text)
    if operation.op == "insert":
        return _inserted(found, operation)
    if operation.op in ("remove", "move"):
        return _moved(found, operation)
    return _set(found, operation) if operation.op == "set" else _unset(found, operation.path)


def _set(found: Places, operation: Operation) -> str:
    text, path = found.text, operation.path
    for entry in found.entries:
        size = len(entry.path)
        if entry.path == path:
            return text[: entry.value] + written(operation.value) + text[entry.value_end :]
        if entry.path == path[:size]:  # inside a table in braces
            changed = _meant({"it": _value(found, entry)}, Operation("set", ("it", *path[size:]), operation.value))
            return text[: entry.value] + written(changed["it"]) + text[entry.value_end :]
    bare = _unset(found, path)
    if bare != text:
        found = places(bare)
    return _with_new_key(found, path, written(operation.value))


def _with_new_key(found: Places, path: Path, value: str) -> str:
    """The text with a key that is not there, beside its next of kin."""
    table = max((h.path for h in found.headers if h.path == path[: len(h.path)]), key=len, default=())
    if len(table) == len(path):
        raise InputError(Problem("is a table", key=written_path(path)))
    numbers = [place for place, part in enumerate(path) if isinstance(part, int)]
    if numbers and numbers[-1] >= len(table):
        raise InputError(Problem("is no longer there", key=written_path(path), remedy="load the page again"))
    own = [e for e in found.entries if _table_of(found, e) == table]
    kin = [e for e in own if e.path[: len(path) - 1] == path[:-1] and len(path) - 1 > len(table)] or own
    line = ".".join(_written_key(str(part)) for part in path[len(table) :]) + f" = {value}\n"
    if kin:
        place = kin[-1].end
    else:
        heads = [header.end for header in found.headers if header.path == table]
        place = heads[0] if heads else 0
    return found.text[:place] + line + found.text[place:]


def _table_of(found: Places, entry: Entry) -> Path:
    """The path of the table under whose head an entry stands."""
    above = [header for header in found.headers if header.start < entry.start]
    return above[-1].path if above else ()


def _unset(found: Places, path: Path) -> str:
    text = found.text
    for entry in found.entries:
        size = len(entry.path)
        if entry.path == path[:size] and size < len(path):
            changed = _meant({"it": _value(found, entry)}, Operation("unset", ("it", *path[size:])))
            if changed.get("it"):
                return text[: entry.value] + written(changed["it"]) + text[entry.value_end :]
            return text[: entry.start] + text[entry.end :]
    gone = [(e.start, e.end) for e in found.entries if e.path[: len(path)] == path]
    heads = [(h.start, h.end) for h in found.headers if h.path[: len(path)] == path]
    for start, end in sorted((*gone, *heads), reverse=True):
        text = text[:start] + text[end:]
    return text


def _value(found: Places, entry: Entry) -> Any:
    """The value of an entry by itself."""
    return _data(f"it = {found.text[entry.value : entry.value_end]}")["it"]


def _blocks(found: Places, path: Path) -> tuple[int, list[str], int]:
    """The tables of a list as pieces of text, with where the first begins and where the last ends."""
    heads = [header for header in found.headers if header.path[:-1] == path and isinstance(header.path[-1], int)]
    if not heads:
        raise InputError(Problem("is no list of tables", key=written_path(path)))
    later = [
        header.block for header in found.headers if header.path[: len(path)] != path and header.start > heads[-1].start
    ]
    end = later[0] if later else len(found.text)
    starts = [*(head.block for head in heads), end]
    return starts[0], [found.text[a:b] for a, b in pairwise(starts)], end


def _joined(before: str, blocks: Sequence[str], after: str) -> str:
    """Blocks with one empty line before each and what stands before and after them."""
    pieces = [piece.strip("\n") for piece in (before, *blocks, after)]
    return "\n\n".join(piece for piece in pieces if piece) + "\n"


def _moved(found: Places, operation: Operation) -> str:
    path, number = operation.path[:-1], operation.path[-1]
    start, blocks, end = _blocks(found, path)
    taken = blocks.pop(int(number))
    if operation.op == "move":
        blocks.insert(operation.at, taken)
    else:
        blocks.insert(int(number), detached(taken))
    return _joined(found.text[:start], blocks, found.text[end:])


def _inserted(found: Places, operation: Operation) -> str:
    if not isinstance(operation.value, Mapping):
        raise InputError(Problem("expected a table", key=_name(operation)))
    head = ".".join(_written_key(str(part)) for part in operation.path)
    lines = [f"[[{head}]]", *(f"{_written_key(name)} = {written(value)}" for name, value in operation.value.items())]
    new = "\n".join(lines)
    if any(header.path[:-1] == operation.path for header in found.headers):
        start, blocks, end = _blocks(found, operation.path)
    else:
        start, blocks, end = len(found.text), [], len(found.text)
    blocks.insert(operation.at, new)
    return _joined(found.text[:start], blocks, found.text[end:])
