"""A recorded motion written for one variant, in Python's own numbers: each operation takes a fifth of one on arrays.

Python's arithmetic and numpy's have the same bits, but for what :func:`_by_numpy` tells; that is left to numpy.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from variantgen.mechanism.motion import Motion
from variantgen.mechanism.program.recording import (
    CHOICE,
    CONVERTED,
    IMAGINARY,
    INPUT,
    JOINED,
    REAL,
    ArrayOperation,
    Operand,
    Recording,
)
from variantgen.mechanism.program.source import Source, motion_text, results

_SIGNS = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/"}
_COMPARED = {"greater": ">", "less": "<", "greater_equal": ">=", "less_equal": "<=", "equal": "==", "not_equal": "!="}
_TEXTS = {
    **{name: f"{{}} {sign} {{}}" for name, sign in {**_SIGNS, **_COMPARED}.items()},
    **dict.fromkeys(("logical_and", "bitwise_and"), "{} and {}"),
    **dict.fromkeys(("logical_or", "bitwise_or"), "{} or {}"),
    **dict.fromkeys(("logical_not", "invert"), "not {}"),
    # Of what is not a number none is the smallest.
    "minimum": "{0} if {0} < {1} else {1} if {1} <= {0} else nan",
    "maximum": "{0} if {0} > {1} else {1} if {1} >= {0} else nan",
    "absolute": "abs({})",
    "negative": "-{}",
    "square": "{0} * {0}",
    "sqrt": "sqrt({})",
    "isfinite": "isfinite({})",
    "conjugate": "{}.conjugate()",
    REAL: "{}.real",
    IMAGINARY: "{}.imag",
    JOINED: "complex({}, {})",
    CHOICE: "{1} if {0} else {2}",
    CONVERTED: "int({})",
}


def for_one_variant(recording: Recording, motion: Motion) -> Callable[..., Motion]:
    """The function ``motion(scene, inputs)`` with inputs of shape (1,).

    It raises ArithmeticError or ValueError where numpy would go on with infinite numbers or what is none.
    """
    source = Source("scene, inputs", sqrt=math.sqrt, isfinite=math.isfinite, nan=math.nan, array=np.array)
    for operation in recording.needed(results(motion)):
        source.add(f"x{operation.place} = {_text(source, operation)}")
    # One array of each type, of which every result is a piece.
    pieces: dict[ArrayOperation, str] = {}
    for kind, dtype in (("f", "float"), ("c", "complex"), ("i", "'int8'")):
        own = [x for x in results(motion) if x.dtype.kind == kind]
        pieces |= {x: f"{kind}[{i}:{i + 1}]" for i, x in enumerate(own)}
        source.add(f"{kind} = array([{', '.join(f'x{x.place}' for x in own)}], {dtype})")

    def written(x: Operand) -> str:
        return pieces[x] if isinstance(x, ArrayOperation) else source.constant(x)

    source.add(f"return {motion_text(motion, written)}")
    return source.function()


def _text(source: Source, operation: ArrayOperation) -> str:
    if operation.name == INPUT:
        return f"inputs[{operation.operands[0]}].item()"
    operands = [f"x{x.place}" if isinstance(x, ArrayOperation) else source.constant(x) for x in operation.operands]
    if operation.name == CHOICE and operation.dtype.kind == "c":
        operands[1:] = [f"complex({x})" for x in operands[1:]]
    if operation.name not in _TEXTS or _by_numpy(operation):
        return f"{source.call(getattr(np, operation.name))}({', '.join(operands)}).item()"
    return _TEXTS[operation.name].format(*operands)


def _by_numpy(operation: ArrayOperation) -> bool:
    """Whether Python may end in another bit.

    For products of complex numbers numpy rounds once what Python rounds twice, if the processor can; where a part is
    zero that makes no difference. Magnitudes, quotients and squares of complex numbers are worked out in other ways.
    """
    constants = [x for x in operation.operands if isinstance(x, complex)]
    count = len(constants) + sum(x.dtype.kind == "c" for x in operation.sources)
    if operation.name == "multiply":
        return count > 1 and not any(0 in (x.real, x.imag) for x in constants)
    return count > 0 and operation.name in ("absolute", "divide", "square")
