"""The lines of a program that print what is asked, from the derivatives of the coordinates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from variantgen.algebra.expression import Value
from variantgen.algebra.python_source import number
from variantgen.families.quantities import Quantity
from variantgen.mechanism.relative import sliding_points
from variantgen.methods.coordinates.model import Model

_TABLES = {1: "V", 2: "A"}


def lines(model: Model, names: Mapping[Value, str]) -> list[str]:
    """One ``print`` per asked quantity: its name and its number in the printed unit."""
    writer = _Outputs(model, names)
    return [f'print("{q.name} =", {writer.of(q)})' for q in model.task.asked]


def constants(model: Model) -> Iterator[tuple[str, float]]:
    """Radii of circular slots, which only the relative motion may use."""
    for path in model.task.linkage.slides:
        if path.centre:
            yield path.centre + path.point, abs(model.now(path.centre, path.point))


class _Outputs:
    """Expressions of asked quantities in Python."""

    def __init__(self, model: Model, names: Mapping[Value, str]) -> None:
        self.model, self.names = model, names

    def of(self, quantity: Quantity) -> str:
        """The expression of a quantity."""
        match quantity.kind:
            case "omega" | "epsilon":
                return self._part(self._rate(quantity.target, quantity.order), quantity.component)
            case "v" | "a":
                return self._vector(self._components(quantity.target, quantity.order), quantity.component)
            case "P" | "Q":
                return self._distance(quantity)
            case "mu":
                rates = [self._rate(quantity.target, order) for order in (2, 1)]
                return f"np.degrees(np.arctan2(abs({rates[0]}), ({rates[1]})**2))"
        return self._relative(quantity)

    def _part(self, rate: str, component: str) -> str:
        return {"abs": f"abs({rate})", "sense": f"np.sign({rate})"}.get(component, rate)

    def _derivative(self, place: Value | None, order: int) -> str:
        return "0" if place is None else f'{_TABLES[order]}["{self.names[place]}"]'

    def _components(self, point: str, order: int) -> tuple[str, str]:
        x, y = (self._derivative(self.model.unknown(point, axis), order) for axis in (0, 1))
        return x, y

    def _vector(self, components: tuple[str, str], component: str) -> str:
        x, y = components
        match component:
            case "x":
                return x
            case "y":
                return y
            case "angle":
                return f"np.degrees(np.arctan2({y}, {x}))"
        if "0" in components:
            return f"abs({x if y == '0' else y})"
        return f"np.hypot({x}, {y})"

    def _place(self, point: str, axis: int) -> str:
        place = self.model.unknown(point, axis)
        if place is not None:
            return f'Q["{self.names[place]}"]'
        z = self.model.task.now.z[point]
        return number((z.real, z.imag)[axis])

    def _rate(self, body: str, order: int) -> str:
        """The derivative of the angle of a body, or by two of its points."""
        model = self.model
        if not model.is_turning(body):
            return "0"
        if model.has_angle(body):
            return self._derivative(model.angle(body), order)
        first, second = model.reference(body) or ("", "")
        shifts = [self._difference(self._place(second, axis), self._place(first, axis)) for axis in (0, 1)]
        ends = [self._components(point, order) for point in (second, first)]
        rates = [self._difference(a, b) for a, b in zip(*ends, strict=True)]
        value = model.geometry.length(first, second)
        length = self.names.get(value) or number(value.exact)
        return f"({shifts[0]}*{rates[1]} - {shifts[1]}*{rates[0]})/{length}**2"

    @staticmethod
    def _difference(end: str, start: str) -> str:
        if start == "0":
            return end
        return f"({end} - {start})"

    def _distance(self, quantity: Quantity) -> str:
        """Distance of a point from the centre: ``v / |omega|``, ``a / sqrt(epsilon^2 + omega^4)``."""
        order = quantity.order
        size = self._vector(self._components(quantity.component, order), "")
        omega = self._rate(quantity.target, 1)
        if order == 1:
            return f"{size}/abs({omega})"
        return f"{size}/np.hypot({self._rate(quantity.target, 2)}, ({omega})**2)"

    def _relative(self, quantity: Quantity) -> str:
        """Along a line the derivatives of the way; on a circle those of the angle times the radius."""
        model, point = self.model, quantity.target
        carrier = sliding_points(model.task.scene)[point]
        place = model.slides[point, carrier]
        path = model.task.linkage.slide(point, carrier)
        radius = f"{path.centre}{point}*" if path.centre else ""
        speed = f"{radius}{self._derivative(place, 1)}"
        tangent = complex(path.tangent(model.task.now.z))
        if quantity.kind == "v_rel":
            return self._along([(speed, tangent)], quantity.component)
        if quantity.kind == "a_cor":
            return self._along([(f"2*{self._rate(carrier, 1)}*{speed}", 1j * tangent)], quantity.component)
        parts = [(f"{radius}{self._derivative(place, 2)}", tangent)]
        if path.centre:
            parts.append((f"{radius}{self._derivative(place, 1)}**2", 1j * tangent))
        return self._along(parts, quantity.component)

    def _along(self, parts: list[tuple[str, complex]], component: str) -> str:
        """A vector given by parts along unit vectors at right angles."""
        if component == "":
            return f"abs({parts[0][0]})" if len(parts) == 1 else f"np.hypot({parts[0][0]}, {parts[1][0]})"
        sums = [" + ".join(f"{text}*({number((way.real, way.imag)[axis])})" for text, way in parts) for axis in (0, 1)]
        return self._vector((sums[0], sums[1]), component)
