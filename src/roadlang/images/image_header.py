"""The size of a picture from its first bytes, so that pictures that are too large are not
decoded."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass

from ..files.jpeg_segments import jpeg_segments
from ..files.picture_ends import PNM_HEADER
from ..files.picture_formats import picture_format
from .tiff import TiffTags

_FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""the markers of segments of JPEG that tell its size"""
_CODESTREAM = b"\xff\x4f\xff\x51"
"""the first bytes of JPEG 2000's data"""
_Size = tuple[int, int]
"""width and height in pixels"""


@dataclass(frozen=True, slots=True)
class ImageHeader:
    """What the first bytes of an image file state; sizes are in pixels."""

    format: str
    width: int
    height: int


def read_header(content: bytes) -> ImageHeader | None:
    """Format and size; None for what is no picture that can be read."""
    name = picture_format(content)
    if name is None:
        return None
    try:
        size = _SIZES[name](content)
    except (struct.error, IndexError, ValueError):
        return None
    return None if size is None else ImageHeader(name, *size)


def _png(content: bytes) -> _Size:
    width, height = struct.unpack(">II", content[16:24])
    return width, height


def _tiff(content: bytes) -> _Size:
    tags = TiffTags(content)
    return int(tags.numbers(256)[0]), int(tags.numbers(257)[0])


def _bmp(content: bytes) -> _Size:
    width, height = struct.unpack("<ii", content[18:26])
    return abs(width), abs(height)


def _jpeg(content: bytes) -> _Size | None:
    try:
        for marker, at in jpeg_segments(content):
            if marker in _FRAMES and at + 9 <= len(content):
                height, width = struct.unpack(">HH", content[at + 5 : at + 9])
                return width, height
    except ValueError:
        return None
    # Cut off before its size is stated: a picture all the same.
    return 8, 8


def _pnm(content: bytes) -> _Size | None:
    """PGM and PPM files, which maps of robots are."""
    found = PNM_HEADER.match(content)
    if found is None:
        return None
    width, height, most = map(int, found.groups())
    return (width, height) if 0 < most < 65536 else None


def _webp(content: bytes) -> _Size | None:
    chunk = content[12:16]
    if chunk == b"VP8X":
        width = int.from_bytes(content[24:27], "little") + 1
        return width, int.from_bytes(content[27:30], "little") + 1
    if chunk == b"VP8 ":
        width, height = struct.unpack("<HH", content[26:30])
        return width & 0x3FFF, height & 0x3FFF
    if chunk == b"VP8L":
        bits = int.from_bytes(content[21:25], "little")
        return (bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1
    return None


def _jpeg_2000(content: bytes) -> _Size:
    """Of the codestream (ITU-T T.800, A.5.1), bare or in the boxes of a JP2 file."""
    at = content.index(_CODESTREAM)
    right, bottom, left, top = struct.unpack(">IIII", content[at + 8 : at + 24])
    return right - left, bottom - top


_SIZES: dict[str, Callable[[bytes], _Size | None]] = {
    "PNG": _png,
    "JPEG": _jpeg,
    "TIFF": _tiff,
    "BMP": _bmp,
    "PNM": _pnm,
    "WebP": _webp,
    "JPEG 2000": _jpeg_2000,
}
