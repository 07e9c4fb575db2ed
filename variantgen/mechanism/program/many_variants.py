"""A recorded motion written for a batch, in arrays that are used again as soon as nobody needs what is in them.

The operations are numpy's, in the order of the recording: every number has the same bits as without the program.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from variantgen.mechanism.motion import Motion
from variantgen.mechanism.program.recording import CHOICE, IMAGINARY, INPUT, REAL, ArrayOperation, Operand, Recording
from variantgen.mechanism.program.source import Source, motion_text, results


def for_many_variants(recording: Recording, motion: Motion) -> Callable[..., Motion]:
    """The function ``motion(scene, inputs, size)`` with inputs of shape (size,)."""
    return _Writer(recording, motion).source.function()


class _Writer:
    """Writes operation by operation; knows which arrays are free."""

    def __init__(self, recording: Recording, motion: Motion) -> None:
        self.source = Source("scene, inputs, size", empty=np.empty, copyto=np.copyto, broadcast_to=np.broadcast_to)
        operations = recording.needed(results(motion))
        self._kept = {_whole(x) for x in results(motion)}
        self._last = {_whole(x): operation for operation in operations for x in operation.sources}
        self._names: dict[ArrayOperation, str] = {}
        self._free: dict[np.dtype[Any], list[str]] = {}
        for operation in operations:
            self._write(operation)
        self.source.add(f"return {motion_text(motion, self._result)}")

    def _write(self, operation: ArrayOperation) -> None:
        """One operation. Its result may take the place of an operand, but not of one of which it reads a part."""
        operands, name = [self._name(x) for x in operation.operands], f"x{operation.place}"
        done = [x for x in dict.fromkeys(map(_whole, operation.sources)) if self._is_done(x, operation)]
        whole = [x for x in done if all(_whole(y) is not x or y is x for y in operation.sources)]
        if operation.name != CHOICE:
            self._release(whole)
        self._names[operation] = name
        match operation.name:
            case "input":
                self.source.add(f"{name} = inputs[{operation.operands[0]}]")
            case "real" | "imag":
                self.source.add(f"{name} = {operands[0]}.{operation.name}")
            case "astype":
                self.source.add(f"{name} = {operands[0]}.astype({self.source.constant(operation.dtype)})")
            case "where":
                self._choose(operation, whole)
                self._release(x for x in whole if self._names[x] != self._names[operation])
            case "joined":
                name = self._array(operation)
                self.source.add(f"{name}.real, {name}.imag = {', '.join(operands)}")
            case _:
                function = self.source.call(getattr(np, operation.name))
                self.source.add(f"{function}({', '.join(operands)}, out={self._array(operation)})")
        self._release(x for x in done if x not in whole)

    def _choose(self, operation: ArrayOperation, done: list[ArrayOperation]) -> None:
        """One of two numbers, ``done`` being needed no more: the other is written over it where it is chosen.

        Choices keep sound numbers from unsound ones, so hardly any differs from the rest of a batch. That takes a third
        of the time that ``where`` needs.
        """
        condition, x, y = operation.operands
        mask = self._name(condition)
        if isinstance(x, ArrayOperation) and (not isinstance(y, ArrayOperation) or (x in done and y not in done)):
            x, y, mask = y, x, f"~{mask}"
        if y in done and y is not condition and y.dtype == operation.dtype:
            self._names[operation] = self._names[y]
        else:
            self.source.add(f"copyto({self._array(operation)}, {self._name(y)})")
        self.source.add(f"copyto({self._names[operation]}, {self._name(x)}, where={mask})")

    def _is_done(self, whole: ArrayOperation, operation: ArrayOperation) -> bool:
        """Whether an array of the program is needed by this operation for the last time."""
        return self._last[whole] is operation and whole not in self._kept and whole.name != INPUT

    def _array(self, operation: ArrayOperation) -> str:
        """An array for a result: a free one, or a new one."""
        free = self._free.get(operation.dtype)
        if free and operation not in self._kept:
            self._names[operation] = free.pop()
        else:
            self.source.add(f"{self._names[operation]} = empty(size, {self.source.constant(operation.dtype)})")
        return self._names[operation]

    def _release(self, done: Iterable[ArrayOperation]) -> None:
        for operation in done:
            self._free.setdefault(operation.dtype, []).append(self._names[operation])

    def _name(self, operand: Operand) -> str:
        # A constant as an array takes numpy half the time of a number of Python.
        return self._names[operand] if isinstance(operand, ArrayOperation) else self.source.constant(np.array(operand))

    def _result(self, operand: Operand) -> str:
        if isinstance(operand, ArrayOperation):
            return self._names[operand]
        return f"broadcast_to({self.source.constant(operand)}, size)"


def _whole(operation: ArrayOperation) -> ArrayOperation:
    """The operation in whose array a real or imaginary part lies."""
    whole: ArrayOperation = operation.operands[0] if operation.name in (REAL, IMAGINARY) else operation
    return whole
