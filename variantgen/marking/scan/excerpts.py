"""Pictures of scans (PNG) for whoever looks at them: an answer or a page, upright and to scale, or all as it came."""

from __future__ import annotations

import io

import numpy as np

from variantgen.exam import answer_page
from variantgen.marking.scan.pictures import Grey
from variantgen.marking.scan.registration import Placed

_ANSWER = 7.0  # pixels to the millimetre of the picture of an answer
_PAGE = 6.0  # and of a page
_THUMBNAIL = 900  # pixels of the long side


def answer_png(grey: Grey, placed: Placed, block: int) -> bytes:
    """The picture of an answer, by the place of its block on the page."""
    left, top = answer_page.block_corner(block)
    columns, rows = round(_ANSWER * answer_page.BLOCK_WIDTH), round(_ANSWER * answer_page.BLOCK_HEIGHT)
    x, y = np.meshgrid(left + (np.arange(columns) + 0.5) / _ANSWER, top + (np.arange(rows) + 0.5) / _ANSWER)
    u, v = placed.pixels(x, y)
    u = np.clip(np.rint(u).astype(int), 0, grey.shape[1] - 1)
    v = np.clip(np.rint(v).astype(int), 0, grey.shape[0] - 1)
    return _png(grey[v, u])


def page_png(grey: Grey, placed: Placed | None) -> bytes:
    """The picture of a page: A4 where it is known how it lies there, otherwise as it came."""
    if placed is None:
        return thumbnail_png(grey, round(_PAGE * answer_page.HEIGHT))
    from PIL import Image

    matrix = placed.matrix / placed.matrix[2, 2]
    matrix = matrix @ np.diag([1 / _PAGE, 1 / _PAGE, 1.0])  # from pixels of the picture
    size = round(_PAGE * answer_page.WIDTH), round(_PAGE * answer_page.HEIGHT)
    bilinear, perspective = Image.Resampling.BILINEAR, Image.Transform.PERSPECTIVE
    upright = Image.fromarray(grey).transform(size, perspective, matrix.ravel()[:8].tolist(), bilinear, fillcolor=255)
    return _png(np.asarray(upright))


def thumbnail_png(grey: Grey, long_side: int = _THUMBNAIL) -> bytes:
    """A page as it came, not larger than this in pixels."""
    step = max(1, -(-max(grey.shape) // long_side))
    return _png(np.ascontiguousarray(grey[::step, ::step]))


def _png(grey: Grey) -> bytes:
    from PIL import Image

    file = io.BytesIO()
    Image.fromarray(grey // 17 * 17).save(file, "PNG", optimize=False)  # 16 levels are enough to look at
    return file.getvalue()
