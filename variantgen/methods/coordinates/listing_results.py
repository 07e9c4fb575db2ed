"""The lines of a program that print what is asked, from the derivatives of the coordinates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from variantgen.algebra.expression import Value
from variantgen.algebra.python_source import number
from variantgen.families.quantities import Quantity, line_ends
from variantgen.families.quantities.kinds import ACROSS, ALONG, NATURAL
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.rope_speed import rope_piece
from variantgen.methods.coordinates.model import Model

_TABLES = {1: "V", 2: "A"}


def lines(model: Model, names: Mapping[Value, str]) -> list[str]:
    """One ``print`` per asked quantity of the instant: its name and its number in the printed unit."""
    writer = _Outputs(model, names)
    return [f'print("{q.name} =", {writer.of(q)})' for q in model.task.asked if q.is_of_instant]


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
        match quantity.group:
            case "rotation":
                return self._part(self._rate(quantity.target, quantity.order), quantity.component)
            case "vector" if quantity.component in NATURAL:
                return self._natural(quantity.target, quantity.component)
            case "difference":
                pair = zip(*(self._components(point, quantity.order) for point in quantity.pair), strict=True)
                x, y = (self._difference(*ends) for ends in pair)
                return self._vector((x, y), quantity.component)
            case "vector":
                return self._vector(self._components(quantity.target, quantity.order), quantity.component)
            case "path":
                return f"{self._speed(quantity.target)}**2/({self._natural(quantity.target, 'n')})"
            case "centre":
                return self._coordinate(quantity) if quantity.is_coordinate else self._distance(quantity)
            case "centre angle":
                rates = [self._rate(quantity.target, order) for order in (2, 1)]
                return f"np.degrees(np.arctan2(abs({rates[0]}), ({rates[1]})**2))"
            case "rope":
                return self._rope(quantity)
            case "ratio":
                return f"({self._rate(quantity.target, 1)})/({self._rate(quantity.component, 1)})"
            case "position":
                return self._position(quantity)
        return self._relative(quantity)

    def _speed(self, point: str) -> str:
        return "np.hypot({}, {})".format(*self._components(point, 1))

    def _natural(self, point: str, component: str) -> str:
        """The tangential or normal acceleration: ``a.v / v``, ``|v x a| / v``."""
        (vx, vy), (ax, ay) = self._components(point, 1), self._components(point, 2)
        product = f"({vx}*{ax} + {vy}*{ay})" if component == "t" else f"abs({vx}*{ay} - {vy}*{ax})"
        return f"{product}/{self._speed(point)}"

    def _coordinate(self, quantity: Quantity) -> str:
        """A coordinate of the point of a body where ``v`` or ``a`` is zero, from its first point."""
        pole, number = self.model.task.scene.bodies[quantity.target][0], 0 if quantity.component == "x" else 1
        place, omega = self._place(pole, number), self._rate(quantity.target, 1)
        x, y = self._components(pole, quantity.order)
        if quantity.kind == "P":
            return f"{place} - {y}/({omega})" if number == 0 else f"{place} + {x}/({omega})"
        epsilon = self._rate(quantity.target, 2)
        above = f"{x}*({omega})**2 - {y}*({epsilon})" if number == 0 else f"{x}*({epsilon}) + {y}*({omega})**2"
        return f"{place} + ({above})/(({omega})**4 + ({epsilon})**2)"

    def _rope(self, quantity: Quantity) -> str:
        """The speed of the rim of a drum, or of the end of a rope along it, and what movable pulleys add."""
        task = self.model.task
        piece, resting = rope_piece(task.scene, quantity.target, quantity.component), task.linkage.resting
        way = piece.way(resting) if piece else None
        assert way is not None, "the answer has been found so"
        rays = [complex(ray) for ray in way.rays(task.in_metres)]
        terms = []
        if (drum := way.bends[0].body) is not None:
            terms.append(f"({self._rate(drum, 1)})*({number(way.rim(task.in_metres) / task.length_unit)})")
        steps = [rays[0], *(after - before for before, after in pairwise(rays))]
        for bend, step in zip(way.bends, steps, strict=True):
            if bend.point not in resting:
                x, y = self._components(bend.point, 1)
                parts = [f"({rate})*({number(part)})" for rate, part in ((x, step.real), (y, step.imag)) if rate != "0"]
                terms += parts
        return f"abs({' + '.join(terms) or 0})"

    def _position(self, quantity: Quantity) -> str:
        """A coordinate, a distance, the direction of a line, or a corner between two."""
        if quantity.is_coordinate:
            return self._place(quantity.target, 0 if quantity.kind == "x" else 1)
        points = quantity.points(self.model.task.now.z)
        if quantity.kind == "distance":
            return "np.hypot({}, {})".format(*self._way(*points))
        if not quantity.component:
            return "np.degrees(np.arctan2({1}, {0}))".format(*self._way(*points))
        first, corner, last = points
        (ax, ay), (bx, by) = self._way(corner, first), self._way(corner, last)
        return f"np.degrees(abs(np.arctan2({ax}*{by} - {ay}*{bx}, {ax}*{bx} + {ay}*{by})))"

    def _way(self, start: str, end: str) -> tuple[str, str]:
        x, y = (self._difference(self._place(end, axis), self._place(start, axis)) for axis in (0, 1))
        return x, y

    def _part(self, rate: str, component: str) -> str:
        return {"abs": f"abs({rate})", "sense": f"np.sign({rate})"}.get(component, rate)

    def _derivative(self, place: Value | None, order: int) -> str:
        return "0" if place is None else f'{_TABLES[order]}["{self.names[place]}"]'

    def _components(self, point: str, order: int) -> tuple[str, str]:
        x, y = (self._derivative(self.model.unknown(point, axis), order) for axis in (0, 1))
        return x, y

    def _vector(self, components: tuple[str, str], component: str) -> str:
        x, y = components
        if component.startswith((ALONG, ACROSS)):
            way = self._unit(component.partition("_")[2]) * (1 if component.startswith(ALONG) else 1j)
            return f"({x})*({number(way.real)}) + ({y})*({number(way.imag)})"
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

    def _unit(self, line: str) -> complex:
        """The unit vector of a line from its first point to its second."""
        z = self.model.task.now.z
        ends = line_ends(line, z)
        assert ends is not None, "the name of the quantity has been read"
        return (z[ends[1]] - z[ends[0]]) / abs(z[ends[1]] - z[ends[0]])

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
