"""Solved problems as bytes, for other processes and for a build that goes on later.

The exam and its families are not packed: they are named, and found again in the exam that the reader has. Reading
makes only objects of the few classes that problems consist of, so that a file put in their place can do nothing.
"""

from __future__ import annotations

import io
import pickle
from collections.abc import Sequence
from decimal import Decimal
from typing import Any

from variantgen.errors import VariantgenError
from variantgen.exam.blueprint import Exam, Task
from variantgen.exam.sheets import Answer, Item
from variantgen.families.family import Family, Form
from variantgen.families.quantities import Quantity
from variantgen.families.units import Unit
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Surd

_CLASSES = {(c.__module__, c.__qualname__): c for c in (Answer, Decimal, Item, Quantity, Surd, Unit, Variant)}


class PackingError(VariantgenError):
    """Bytes that no problems were packed to, or those of another exam."""


def pack(exam: Exam, items: Sequence[Item]) -> bytes:
    """Problems of an exam, with their answers, as bytes."""
    file = io.BytesIO()
    _Packer(file, exam).dump(tuple(items))
    return file.getvalue()


def unpack(exam: Exam, content: bytes) -> tuple[Item, ...]:
    """What was packed. Raises PackingError."""
    try:
        found = _Reader(io.BytesIO(content), exam).load()
    except PackingError:
        raise
    # What damaged bytes lead to is not restricted to errors of the module.
    except Exception as error:
        raise PackingError(f"packed problems cannot be read: {type(error).__name__}") from error
    if not (isinstance(found, tuple) and all(isinstance(one, Item) for one in found)):
        raise PackingError("packed problems cannot be read: they are something else")
    return found


class _Packer(pickle.Pickler):
    """Names tasks, families and forms by their places in the exam.

    They are told from other objects by their class: a method that is asked about every object takes longer than all
    the rest.
    """

    def __init__(self, file: io.BytesIO, exam: Exam) -> None:
        super().__init__(file, protocol=5)
        names: dict[int, tuple[object, ...]] = {}
        for i, task in enumerate(exam.tasks):
            names.setdefault(id(task), (i,))
            for k, family in enumerate(task.families):
                names.setdefault(id(family), (i, k))
                for name, form in family.forms.items():
                    names.setdefault(id(form), (i, k, name))

        def named(item: object) -> tuple[Any, ...]:
            return _named, names[id(item)]

        self.dispatch_table = {Task: named, Family: named, Form: named}


def _named(*place: Any) -> Task | Family | Form:
    """The object of an exam that has a name; a reader puts its own exam behind it."""
    raise PackingError(f"{place} names something only in an exam")


class _Reader(pickle.Unpickler):
    def __init__(self, file: io.BytesIO, exam: Exam) -> None:
        super().__init__(file)
        self._exam = exam

    def find_class(self, module_name: str, global_name: str) -> Any:
        """One of the classes of problems, or what finds the objects of the exam."""
        if (module_name, global_name) == (_named.__module__, _named.__qualname__):
            return self._found
        if (module_name, global_name) not in _CLASSES:
            raise PackingError(f"packed problems cannot be read: they hold a {module_name}.{global_name}")
        return _CLASSES[module_name, global_name]

    def _found(self, number: int, family: int | None = None, form: str | None = None) -> Task | Family | Form:
        """The object of the exam that has this name."""
        task: Task = self._exam.tasks[number]
        if family is None:
            return task
        return task.families[family] if form is None else task.families[family].forms[form]
