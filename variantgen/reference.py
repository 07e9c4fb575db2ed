"""Reference tables of the scene language, printed from the code itself.

``catalog/README.md`` holds them between markers; ``python -m variantgen.reference`` renews them in a checkout, and a
test notices when that was forgotten.
"""

from __future__ import annotations

import inspect
import re

from variantgen.families.machine import LIMITS, SIZES
from variantgen.families.parameters.dimensions import CONSTANTS
from variantgen.families.parameters.expressions import FUNCTIONS
from variantgen.families.parameters.units import UNITS
from variantgen.mechanism.component import FieldSpec, discover, field_specs
from variantgen.resources import catalog_dir

_MARKED = re.compile(r"(<!-- table: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def refreshed(text: str) -> str:
    """A text with every marked table printed anew."""
    return _MARKED.sub(lambda match: f"{match[1]}{table(match[2])}\n{match[3]}", text)


def table(name: str) -> str:
    """A table in Markdown: constructions, conditions, joints, drivers, units, sizes or expressions."""
    if name == "units":
        return _units()
    if name == "sizes":
        return _sizes()
    if name == "expressions":
        return _expressions()
    rows = ["| kind | fields (optional ones in brackets) | meaning |", "|---|---|---|"]
    for kind, component in discover(f"variantgen.mechanism.{name}").items():
        fields = "<br>".join(_field(spec) for spec in field_specs(component))
        rows.append(f"| `{kind}` | {fields} | {_cell(_meaning(component))} |")
    parts = [part for component in discover(f"variantgen.mechanism.{name}").values() for part in _parts(component)]
    for part in parts:
        fields = "<br>".join(_field(spec) for spec in field_specs(part))
        rows.append(f"| a {part.__name__.lower()} | {fields} | {_cell(_first_paragraph(part))} |")
    return "\n".join(rows)


def _parts(component: type) -> list[type]:
    return [spec.part for spec in field_specs(component) if spec.part]


def _field(spec: FieldSpec) -> str:
    name = f"`{spec.name}`" if spec.required else f"[`{spec.name}`]"
    return f"{name}: {_cell(spec.expects)}"


def _meaning(component: type) -> str:
    """The summary of the module and the first paragraph of the class."""
    module = inspect.getmodule(component)
    summary = ((module.__doc__ if module else None) or "").strip().splitlines()
    return f"{summary[0]} {_first_paragraph(component)}"


def _first_paragraph(component: type) -> str:
    return " ".join(inspect.cleandoc(component.__doc__ or "").split("\n\n")[0].split())


def _cell(text: str) -> str:
    return text.replace("``", "`").replace("|", "\\|").removesuffix("::")


def _units() -> str:
    kinds: dict[str, list[str]] = {}
    for unit in UNITS.values():
        kinds.setdefault(unit.measures, []).append(f"`{unit.name}`")
    rows = [f"| {measures} | {', '.join(names)} |" for measures, names in kinds.items()]
    return "\n".join(["| measures | units |", "|---|---|", *rows])


def _sizes() -> str:
    heads = ["`size`", *(f"`{name}` ({unit_name})" for name, unit_name in LIMITS.items())]
    rows = [[f"`{size}`", *(f"{getattr(machine, name):g}" for name in LIMITS)] for size, machine in SIZES.items()]
    head, *lines = (f"| {' | '.join(row)} |" for row in (heads, *rows))
    return "\n".join([head, "|---" * len(heads) + "|", *lines])


def _expressions() -> str:
    rows = [
        ("operators", "`+ - * /`, `^` or `**` with a whole power, brackets"),
        ("functions", ", ".join(f"`{name}`" for name in FUNCTIONS)),
        ("constants", ", ".join(f"`{name}`" for name in CONSTANTS).replace("`inch`", "`in` or `inch`")),
    ]
    return "\n".join(["| | |", "|---|---|", *(f"| {name} | {text} |" for name, text in rows)])


if __name__ == "__main__":
    path = catalog_dir() / "README.md"
    path.write_text(refreshed(path.read_text("utf-8")), "utf-8")
