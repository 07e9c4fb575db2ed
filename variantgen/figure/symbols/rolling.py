"""Ground line under a rolling wheel, or the rack or plank on which it rolls."""

from __future__ import annotations

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, THIN, Layer
from variantgen.figure.placement.label_requests import along_line
from variantgen.figure.symbols.gears import pitch_circle, tooth
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.wording.formula import Symbol

_THICKNESS = 2.2


def draw(board: Board, joint: Rolling) -> None:
    """Add the line through the contact, hatched on the far side, longer than the wheel; or the moving strip."""
    sketch = board.sketch
    contact, centre = sketch.at[joint.contact], sketch.at[joint.centre]
    down = (contact - centre) / abs(contact - centre)
    if board.is_rack(joint.on):
        _draw_rack(board, joint, down)
    elif joint.on is not None:
        members = [sketch.at[name] for name in board.form.bodies[joint.on][:2]]
        if len(members) == 1:  # a rack or belt of one point reaches past the wheel and past this point
            way, half = 1j * down, 1.25 * abs(contact - centre)
            place = ((members[0] - contact) * way.conjugate()).real
            low, high = min(-half, place - _THICKNESS), max(half, place + _THICKNESS)
            members = [contact + low * way, contact + high * way]
        first, second = members
        strip = (first, second, second + _THICKNESS * down, first + _THICKNESS * down)
        sketch.path(strip, Layer.SLIDER, MEDIUM, closed=True, fill="shade")
        if number := board.form.symbols.get(joint.on):
            sketch.label(along_line(Symbol(number), strip[2], 0.7 * strip[2] + 0.3 * strip[3]))
    else:
        half = 1.25 * abs(contact - centre)
        start, end = contact - half * 1j * down, contact + half * 1j * down
        sketch.path((start, end), Layer.GROUND)
        sketch.hatch(start, end, down)
    sketch.occupy(joint.centre, down)
    for taken in (down, 1j * down, -1j * down):
        sketch.occupy(joint.contact, taken)


def _draw_rack(board: Board, joint: Rolling, down: complex) -> None:
    """A rack along its pitch line, behind the slider to which it is fixed, and the pitch circle of its gear."""
    sketch = board.sketch
    assert joint.on is not None
    first, second = (sketch.at[name] for name in board.form.bodies[joint.on][:2])
    radius = abs(sketch.at[joint.contact] - sketch.at[joint.centre])
    near, far = (depth * down for depth in (tooth(radius), tooth(radius) + _THICKNESS))
    strip = (first + near, second + near, second + far, first + far)
    sketch.path(strip, Layer.GROUND, MEDIUM, closed=True, fill="shade")
    sketch.path((first, second), Layer.GROUND, THIN, dash="dashdot")
    pitch_circle(board, sketch.at[joint.centre], radius)
