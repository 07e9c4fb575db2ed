"""What a computation does with arrays, recorded operation by operation.

A :class:`Recorded` number stands for an array of the batch whose values are not known. Formulas take it as they take an
array: operators and functions of numpy come here, and instead of working something out they note what is to be done.
So no formula of a construction or a joint is written twice. Numbers that are no arrays are worked out at once and
remain in the record as constants. What would need a value (``if``, ``float``, a loop until something is small) raises
TypeError: such a computation has no straight line.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

import numpy as np
from msgspec import Struct
from numpy.typing import DTypeLike

Operand: TypeAlias = Any  # an ArrayOperation, or a constant: bool, int, float, complex, a number of numpy

# Recorded numbers look like the arrays of a batch of one, so that shapes agree with those of constants.
SHAPE = (1,)
INPUT, CHOICE, JOINED, REAL, IMAGINARY, CONVERTED = "input", "where", "joined", "real", "imag", "astype"
_POWERS = {2: "square", 1: "positive", 0.5: "sqrt", -1: "reciprocal"}  # what numpy takes for them
# The operand with which the others change nothing; one times a complex number makes a positive zero of a negative one.
_NEUTRAL = {"multiply": 1.0, "logical_and": True, "bitwise_and": True}


class ArrayOperation(Struct, frozen=True, eq=False):
    """An operation of numpy by its name, or one of those above; ``place`` is its number in the recording."""

    place: int
    name: str
    operands: tuple[Operand, ...]
    dtype: np.dtype[Any]

    @property
    def sources(self) -> list[ArrayOperation]:
        """The operands that are no constants."""
        return [x for x in self.operands if isinstance(x, ArrayOperation)]


class Recording:
    """Operations in their order; one that is there already is not noted again."""

    def __init__(self) -> None:
        self._operations: list[ArrayOperation] = []
        self._known: dict[tuple[Any, ...], ArrayOperation] = {}

    def input(self, place: int, dtype: DTypeLike) -> Recorded:
        """A number that is given in this place."""
        return self.note(INPUT, (place,), np.dtype(dtype))

    def note(self, name: str, operands: Sequence[Any], dtype: np.dtype[Any]) -> Recorded:
        """The result of an operation on recorded numbers and constants."""
        known = tuple(x.operation if isinstance(x, Recorded) else x for x in operands)
        key = name, dtype, *(x.place if isinstance(x, ArrayOperation) else repr(x) for x in known)
        if key not in self._known:
            self._known[key] = ArrayOperation(len(self._operations), name, known, dtype)
            self._operations.append(self._known[key])
        return Recorded(self, self._known[key])

    def needed(self, results: Iterable[ArrayOperation]) -> list[ArrayOperation]:
        """What some results need, in the order of the recording, themselves included."""
        found = {operation.place for operation in results}
        for operation in reversed(self._operations):
            if operation.place in found:
                found.update(x.place for x in operation.sources)
        return [operation for operation in self._operations if operation.place in found]


class Recorded(np.lib.mixins.NDArrayOperatorsMixin):
    """The result of an operation of a recording."""

    shape = SHAPE
    __hash__ = None  # type: ignore[assignment]  # comparing is an operation

    def __init__(self, recording: Recording, operation: ArrayOperation) -> None:
        self.recording, self.operation = recording, operation

    def __bool__(self) -> bool:
        raise TypeError(f"the value of {self.operation.name} is not known while it is recorded")

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise TypeError(f"the values of {self.operation.name} are not known while it is recorded")

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *operands: Any, **options: Any) -> Any:
        if method != "__call__" or options or ufunc.nout != 1 or getattr(np, ufunc.__name__, None) is not ufunc:
            return NotImplemented  # so numpy raises TypeError
        return _applied(self.recording, ufunc, [_plain(x) for x in operands])

    def __array_function__(self, function: Any, _: Any, operands: tuple[Any, ...], options: dict[str, Any]) -> Any:
        if function not in _FUNCTIONS or options:
            return NotImplemented
        return _FUNCTIONS[function](*map(_plain, operands))

    @property
    def dtype(self) -> np.dtype[Any]:
        """The type of the numbers."""
        return self.operation.dtype

    @property
    def real(self) -> Recorded:
        """The real part."""
        return self._part(REAL, 0) if self.dtype.kind == "c" else self

    @property
    def imag(self) -> Any:
        """The imaginary part."""
        return self._part(IMAGINARY, 1) if self.dtype.kind == "c" else 0.0

    def _part(self, name: str, number: int) -> Recorded:
        if self.operation.name == JOINED:
            return Recorded(self.recording, self.operation.operands[number])
        return self.recording.note(name, (self,), np.dtype(float))

    def joined(self, imaginary: Recorded) -> Recorded:
        """The complex number of two real ones."""
        return self.recording.note(JOINED, (self, imaginary), np.dtype(complex))

    def astype(self, dtype: DTypeLike) -> Recorded:
        """The number in another type."""
        wanted = np.dtype(dtype)
        return self if wanted == self.dtype else self.recording.note(CONVERTED, (self,), wanted)


def _plain(x: Any) -> Any:
    """A number of Python in place of an array of one number or of a double of numpy; of small integers one of numpy."""
    if isinstance(x, np.ndarray):
        if x.size != 1:
            raise TypeError("an array among the constants of a recording")
        x = x.reshape(-1)[0]
    return x.item() if isinstance(x, np.float64 | np.complex128 | np.bool_) else x


def _type(x: Any) -> Any:
    """The type of an operand as numpy asks for it: numbers of Python take that of the others."""
    return x.dtype if isinstance(x, Recorded | np.generic) else np.dtype(bool) if isinstance(x, bool) else type(x)


def _applied(recording: Recording, ufunc: np.ufunc, operands: list[Any]) -> Any:
    """The result of a function of numpy, or the operand where the function changes nothing."""
    name, dtype = ufunc.__name__, ufunc.resolve_dtypes((*map(_type, operands), None))[-1]
    if name == "power" and not isinstance(operands[1], Recorded) and operands[1] in _POWERS:
        name, operands = _POWERS[operands[1]], operands[:1]
    if name == "positive" or (name == "conjugate" and dtype.kind != "c"):
        return operands[0]
    if name in ("minimum", "maximum") and _same(*operands):
        return operands[0]
    for one, other in (operands, operands[::-1]) if name in _NEUTRAL else ():
        if not isinstance(one, Recorded) and one == _NEUTRAL[name] and other.dtype == dtype and dtype.kind != "c":
            return other
    return recording.note(name, operands, dtype)


def _same(x: Any, y: Any) -> bool:
    return isinstance(x, Recorded) and isinstance(y, Recorded) and x.operation is y.operation


def _chosen(condition: Any, x: Any, y: Any) -> Any:
    if not isinstance(condition, Recorded):
        return x if condition else y
    types = [item.dtype if isinstance(item, Recorded) else item for item in (x, y)]
    return condition.recording.note(CHOICE, (condition, x, y), np.result_type(*types))


_FUNCTIONS: dict[Callable[..., Any], Callable[..., Any]] = {
    np.where: _chosen,
    np.real: lambda x: x.real,
    np.imag: lambda x: x.imag,
    np.clip: lambda x, low, high: np.minimum(np.maximum(x, low), high),
    np.shape: lambda _: SHAPE,
    np.result_type: lambda *items: np.result_type(*(x.dtype if isinstance(x, Recorded) else x for x in items)),
}
