"""Opens picture files of any quality: what cannot be used is reported before it is decoded."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..files.matching import files_matching
from ..files.picture_ends import LAST, has_end
from ..files.picture_formats import READABLE, WHOLE_AGAIN, other_content
from ..files.reading import LARGEST_INPUT, UnreadableFile, read_file
from .codec_output import codec_output
from .image_header import ImageHeader, read_header
from .image_scale import FoundScale, scale_in_file, unusable_world_file
from .mosaic import Tile, TilesDoNotFit, mosaic
from .no_data import on_its_ground, within_margins
from .placed_pixels import MOST_PIXELS, Pixels, PlacedPixels, placed
from .tiff_bands import TiffBands

LEAST_SIDE = 2
_SILENT = 0
_HALF, _WHITE, _NEARLY_ALL = 0.5, 200.0, 0.99


@dataclass(frozen=True)
class OpenedImage:
    """`shown`: (height, width, 3) BGR, with scale and place where the files, or those next to them,
    have them; `inputs`: these files, their paths as written and sha256; `damage`: RL446 of each
    that is decoded in part only."""

    shown: PlacedPixels
    inputs: tuple[tuple[str, str], ...]
    damage: tuple[Diagnostic, ...] = ()

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the pictures, and why their place is not known."""
        return (*self.damage, *filter(None, (self.shown.warning,)))

    @property
    def pixels(self) -> Pixels:
        """Square on the ground, where the place is known."""
        return self.shown.pixels

    @property
    def scale(self) -> float | None:
        """Meters per pixel, where known."""
        return self.shown.scale


def open_image(path: Path, written: str, span: Span | None) -> OpenedImage:
    """Read a picture, or the tiles of one: `*` and `?` stand for parts of their names.

    Raises DiagnosticError RL400 to RL405, RL442.
    """
    folder = os.path.dirname(written)
    found = [
        (file, written if file == path else os.path.join(folder, file.name))
        for file in files_matching(path)
    ]
    if not found:
        reason = "no file matches this name"
        raise _refusal(Code.UNREADABLE_INPUT, span, written, reason=reason)
    return open_tiles(found, written, span)


def open_tiles(files: Sequence[tuple[Path, str]], written: str, span: Span | None) -> OpenedImage:
    """Read a picture from one or several files, with their paths as written.

    Raises DiagnosticError RL400 to RL405, RL442.
    """
    read = [_read(path, name, span) for path, name in files]
    inputs = tuple(item for each in read for item in each.inputs)
    damage = tuple(each.damage for each in read if each.damage is not None)
    if len(read) == 1:
        path, name = files[0]
        fault = unusable_world_file(path)
        shown = placed(read[0].without_margin(), read[0].found, name, span, fault)
        return OpenedImage(shown, inputs, damage)
    tiles = [
        Tile(name, each.pixels, each.found or FoundScale(None), each.shown)
        for (_, name), each in zip(files, read, strict=True)
    ]
    try:
        pixels, scale = mosaic(tiles, MOST_PIXELS)
    except TilesDoNotFit as fault:
        raise _refusal(Code.TILES_DO_NOT_FIT, span, written, reason=str(fault)) from None
    return OpenedImage(placed(pixels, scale, written, span), inputs, damage)


@dataclass(frozen=True)
class _ReadImage:
    pixels: Pixels
    shown: NDArray[np.bool_] | None
    """(height, width) where it shows something; None: everywhere."""
    found: FoundScale | None
    inputs: tuple[tuple[str, str], ...]
    damage: Diagnostic | None
    beside_margin: NDArray[np.bool_] | None
    """(height, width) where it is no margin that the file says has no data; None: everywhere."""

    def without_margin(self) -> Pixels:
        """Its pixels, of a drawing with the ground in place of a margin."""
        return on_its_ground(self.pixels, self.beside_margin)


def _read(path: Path, written: str, span: Span | None) -> _ReadImage:
    content = read_input(path, written, span)
    header = read_header(content)
    if header is None:
        raise _refusal(Code.NOT_AN_IMAGE, span, written, help=(other_content(content), READABLE))
    _check_size(header, written, span)
    if not has_end(content, content[-LAST:], len(content), lambda: content):
        raise _refusal(Code.TRUNCATED_IMAGE, span, written, help=(WHOLE_AGAIN,))
    bands = TiffBands.of(content) if header.format == "TIFF" else TiffBands()
    pixels, damage = (None, None) if bands.is_misread else _decoded(content, header)
    if pixels is None or pixels.size == 0:
        raise _refusal(
            Code.DAMAGED_IMAGE, span, written, format=header.format, help=(bands.unsupported,)
        )
    pixels = bands.colors(pixels)
    found = scale_in_file(path, content, header.format)
    folder = os.path.dirname(written)
    beside = () if found is None else found.files
    inputs = (
        (written, hashlib.sha256(content).hexdigest()),
        *((os.path.join(folder, name), digest) for name, digest in beside),
    )
    warning = None
    if damage is not None:
        place = None if span is not None else written
        warning = diagnose(Code.PARTLY_DAMAGED_IMAGE, span, path=place, file=written, reason=damage)
    shown = bands.shown(pixels)
    beside_margin = None if bands.no_data is None else within_margins(shown)
    colors = as_colors(pixels, beside_margin)
    return _ReadImage(colors, shown, found, inputs, warning, beside_margin)


def read_input(path: Path, written: str, span: Span | None, limit: int = LARGEST_INPUT) -> bytes:
    """The bytes of an input file. Raises DiagnosticError RL400, RL401."""
    try:
        content = read_file(path, limit)
    except UnreadableFile as error:
        if error.size is not None:
            size = f"{error.size / 1e6:.0f} MB"
            raise _refusal(Code.FILE_TOO_LARGE, span, written, size=size) from None
        raise _refusal(Code.UNREADABLE_INPUT, span, written, reason=error.reason) from None
    if not content:
        raise _refusal(Code.UNREADABLE_INPUT, span, written, reason="it is empty")
    return content


def _check_size(header: ImageHeader, written: str, span: Span | None) -> None:
    size = f"{header.width} x {header.height} px"
    if header.width * header.height > MOST_PIXELS:
        most = f"{MOST_PIXELS // 1_000_000} million pixels can be read"
        raise _refusal(
            Code.FILE_TOO_LARGE,
            span,
            written,
            size=size,
            help=(f"{most}: crop it to the road, or scale it down",),
        )
    if min(header.width, header.height) < LEAST_SIDE:
        raise _refusal(Code.IMAGE_TOO_SMALL, span, written, size=size)


def _refusal(
    code: str,
    span: Span | None,
    written: str,
    *,
    help: tuple[str, ...] = (),
    reason: str = "",
    size: str = "",
    format: str = "",
) -> DiagnosticError:
    path = None if span is not None else written
    return DiagnosticError(
        diagnose(
            code, span, help=help, path=path, file=written, reason=reason, size=size, format=format
        )
    )


def _decoded(content: bytes, header: ImageHeader) -> tuple[NDArray[np.generic] | None, str | None]:
    """The pixels, and what of the file is damaged, in words."""
    import cv2

    # Only color mode honors the orientation that cameras note in JPEG files.
    mode = cv2.IMREAD_COLOR if header.format == "JPEG" else cv2.IMREAD_UNCHANGED
    level = _set_log_level(_SILENT)
    try:
        if header.format == "TIFF":
            content = TiffBands.in_color(content)
        with codec_output() as printed:
            pixels: NDArray[np.generic] | None
            pixels = cv2.imdecode(np.frombuffer(content, np.uint8), mode)
        return pixels, printed.damage
    except cv2.error:
        return None, None
    finally:
        _set_log_level(level)


def _set_log_level(level: int) -> int:
    """Of OpenCV, which moved the function between 4 and 5; returns the level before."""
    import cv2

    old = getattr(cv2, "setLogLevel", None)
    return int((old or cv2.utils.logging.setLogLevel)(level))


def as_colors(pixels: NDArray[np.generic], counted: NDArray[np.bool_] | None = None) -> Pixels:
    """Any depth and number of channels to 8-bit BGR; transparent pixels become white, or black
    where little but white lines is drawn. Where more than eight bits are scaled, only the range of
    `counted` pixels (height, width) counts, and all others become dark; None: all count."""
    eight = _as_bytes(pixels, counted)
    if eight.ndim == 2:
        eight = eight[..., None]
    channels = eight.shape[2]
    if channels in (2, 4):
        cover = eight[..., -1:].astype(np.float32) / 255.0
        colors = eight[..., :-1].astype(np.float32)
        ground = 0.0 if _is_drawn_white(colors, cover[..., 0] > 0.5) else 255.0
        eight = np.rint(colors * cover + ground * (1.0 - cover)).astype(np.uint8)
    if eight.shape[2] == 1:
        eight = np.repeat(eight, 3, axis=2)
    return np.ascontiguousarray(eight[..., :3])


def _is_drawn_white(colors: NDArray[np.float32], drawn: NDArray[np.bool_]) -> bool:
    """Whether what covers less than half of the picture is white: on white it would vanish."""
    shown = colors[drawn]
    if not 0 < len(shown) < _HALF * drawn.size:
        return False
    return bool(np.mean(shown.min(axis=-1) > _WHITE) > _NEARLY_ALL)


def _as_bytes(pixels: NDArray[np.generic], counted: NDArray[np.bool_] | None) -> Pixels:
    if pixels.dtype == np.uint8:
        return np.asarray(pixels, np.uint8)
    numbers = np.nan_to_num(pixels.astype(np.float32), nan=0.0, posinf=0.0, neginf=0.0)
    if counted is not None and counted.any():
        numbers[~counted] = numbers[counted].min()  # -9999 would leave no contrast
    low, high = float(numbers.min()), float(numbers.max())
    if pixels.dtype == np.uint16 and high > 4095:
        low, high = 0.0, 65535.0  # all sixteen bits are used
    span = high - low
    if span <= 0:
        return np.full(numbers.shape, 128, np.uint8)
    return np.asarray(np.rint((numbers - low) * (255.0 / span)), np.uint8)
