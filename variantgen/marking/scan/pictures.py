"""Pages of scans and photos as arrays of grey levels."""

from __future__ import annotations

import importlib
import io
import warnings
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, missing_package
from variantgen.limits import SCAN_BYTES, SCAN_PAGES, SCAN_PIXELS

if TYPE_CHECKING:
    from PIL.Image import Image

Grey = NDArray[np.uint8]

SUFFIXES = (".pdf", ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".webp", ".bmp")
_FORMATS = ("PNG", "JPEG", "TIFF", "WEBP", "BMP")
_LONG_SIDE = 2339  # pixels of A4 at 200 dpi: more cost time and read no better
_LEAST_SIDE = 800
_HALVED = 3000  # pixels of a page along its long side from which half of them are enough, as of 300 dpi
_COVERED = 0.9  # of a page that a scan takes


class ScanImage(Struct, frozen=True):
    """A page of a file: where it is from, and its grey levels, an array of rows; None where ``why`` it has none."""

    where: str
    grey: Grey | None
    why: str = ""


def is_picture(path: Path) -> bool:
    """Whether a file is a scan or a photo, by the ending of its name."""
    return path.suffix.lower() in SUFFIXES


def check_packages() -> None:
    """Raise ToolMissingError where a package is missing that scans are read with."""
    for module, package in (("pypdfium2", "pypdfium2"), ("zxingcpp", "zxing-cpp"), ("PIL", "pillow")):
        try:
            importlib.import_module(module)
        except ImportError:
            raise missing_package("scans are read with", package, "scan") from None


def pictures(path: Path, only: int = 0) -> Generator[ScanImage]:
    """The pages of a file one by one, or ``only`` that of a number, from 1 (none where the file has fewer pages).

    Raises InputError for a file that cannot be opened or is too large.
    """
    try:
        with path.open("rb") as file:
            head = file.read(5)
        if path.stat().st_size > SCAN_BYTES:
            raise _refused(path, f"the file is larger than {SCAN_BYTES // 1_000_000} MB", "part it into several files")
    except OSError as error:
        raise InputError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    yield from _pdf_pages(path, only) if head == b"%PDF-" else _image_pages(path, only)


def page_count(path: Path) -> int:
    """How many pages a file has; 0 for one that cannot be opened."""
    try:
        with path.open("rb") as file:
            head = file.read(5)
        if head == b"%PDF-":
            import pypdfium2

            with pypdfium2.PdfDocument(path) as document:
                return len(document)
        from PIL import Image

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # sizes are looked at where pages are read
            with Image.open(path, formats=_FORMATS) as image:
                return int(getattr(image, "n_frames", 1))
    except Exception:  # noqa: BLE001  # of whatever library; what is wrong is told where the file is read
        return 0


def _refused(path: Path, message: str, remedy: str) -> InputError:
    return InputError(Problem(message, file=str(path), remedy=remedy))


def _too_large(path: Path) -> InputError:
    return _refused(path, f"has more than {SCAN_PIXELS // 1_000_000} million pixels", "scan it with 200 to 300 dpi")


def _pdf_pages(path: Path, only: int) -> Iterator[ScanImage]:
    import pypdfium2

    try:
        document = pypdfium2.PdfDocument(path)
    except pypdfium2.PdfiumError:
        raise _refused(
            path, "is not a readable PDF", "open it in a viewer and save it again, without password"
        ) from None
    try:
        count = len(document)
        if count > SCAN_PAGES:
            raise _refused(path, f"has more than {SCAN_PAGES} pages", "part it into several files")
        for number in range(only - 1, min(only, count)) if only else range(count):
            where = f"{path.name}, page {number + 1}"
            try:
                page = document[number]
                yield ScanImage(where, *_rendered(page))
                page.close()
            except (pypdfium2.PdfiumError, MemoryError, OSError, SyntaxError, ValueError):
                yield ScanImage(where, None, "the page is damaged")
    finally:
        document.close()


def _rendered(page: Any) -> tuple[Grey | None, str]:
    """A page of a PDF as grey levels, or None and why not."""
    from pypdfium2 import raw

    images = list(page.get_objects(filter=[raw.FPDF_PAGEOBJ_IMAGE], max_depth=2))
    for found in images:
        width, height = found.get_px_size()
        if width * height > SCAN_PIXELS:
            return None, f"the page has an image of more than {SCAN_PIXELS // 1_000_000} million pixels"
    if len(images) == 1 and _is_whole_page(page, images[0]):
        with _image_of(images[0]) as image:
            if image.mode in ("L", "RGB") and image.width * image.height <= SCAN_PIXELS:
                return _levels(image)
    long_side = max(page.get_size())
    if not 1 < long_side < 1e5:
        return None, "the page has no usable size"
    bitmap = page.render(scale=_LONG_SIDE / long_side, grayscale=True, may_draw_forms=False)
    grey: Grey = bitmap.to_numpy().copy()
    return (grey[..., 0] if grey.ndim == 3 else grey), ""


def _is_whole_page(page: Any, image: Any) -> bool:
    """Whether a page is nothing but this image, as scanners write it: taking it takes half the time of drawing it."""
    from pypdfium2 import raw

    if "JPXDecode" in image.get_filters() or raw.FPDFPageObj_HasTransparency(image):
        return False  # the first is drawn sooner in a smaller size
    if sum(1 for _ in page.get_objects(max_depth=2)) > 1:
        return False
    a, b, c, d, _, _ = image.get_matrix().get()
    turned = a * d - b * c
    return bool(turned > 0 and turned >= _COVERED * page.get_width() * page.get_height())  # not mirrored, not a part


def _image_of(image: Any) -> Image:
    """The image of a page as it is in the file."""
    from PIL import Image as Images

    if image.get_filters() == ["DCTDecode"]:  # a part of its samples is enough
        return Images.open(io.BytesIO(bytes(image.get_data(decode_simple=False))), formats=["JPEG"])
    found: Image = image.get_bitmap().to_pil()
    return found.reduce(2) if max(found.size) >= _HALVED and found.mode in ("L", "RGB") else found


def _image_pages(path: Path, only: int) -> Iterator[ScanImage]:
    from PIL import Image, ImageSequence, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # sizes are looked at here
            image = Image.open(path, formats=_FORMATS)
    except Image.DecompressionBombError:
        raise _too_large(path) from None
    except (UnidentifiedImageError, OSError, ValueError):
        raise _refused(path, "is not a readable image", f"expected {', '.join(SUFFIXES)}") from None
    with image:
        if image.width * image.height > SCAN_PIXELS:
            raise _too_large(path)
        several = getattr(image, "n_frames", 1) > 1
        for number, frame in enumerate(ImageSequence.Iterator(image) if several else [image], start=1):
            if only and number != only:
                continue
            where = f"{path.name}, page {number}" if several else path.name
            if number > SCAN_PAGES:
                raise _refused(path, f"has more than {SCAN_PAGES} pages", "part it into several files")
            if frame.width * frame.height > SCAN_PIXELS:
                yield ScanImage(where, None, f"the page has more than {SCAN_PIXELS // 1_000_000} million pixels")
                continue
            try:
                yield ScanImage(where, *_levels(frame))
            except (OSError, ValueError, SyntaxError, MemoryError):
                if not several:
                    raise _refused(path, "the image is damaged", "scan or photograph the page again") from None
                yield ScanImage(where, None, "the page is damaged")


def _levels(image: Image) -> tuple[Grey | None, str]:
    """The grey levels of an image, in a size that is quick to read."""
    if max(image.size) < _LEAST_SIDE:
        return None, f"the page has fewer than {_LEAST_SIDE} pixels along its long side"
    image.draft("L", (1240, 1754))  # JPEG files are decoded at once in a smaller size
    if image.mode in ("LA", "PA", "RGBA") or "transparency" in image.info:  # paper is white where nothing was drawn
        from PIL import Image as Images

        shown = image.convert("RGBA")
        image = Images.alpha_composite(Images.new("RGBA", shown.size, "white"), shown)
    grey = image.convert("L")
    step = max(grey.size) / _LONG_SIDE
    if step > 1.25:
        grey = grey.resize((round(grey.width / step), round(grey.height / step)), reducing_gap=2.0)
    return np.asarray(grey), ""
