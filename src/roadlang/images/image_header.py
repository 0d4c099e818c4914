"""The size of a picture from its first bytes, so that pictures that are too large are not
decoded."""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass

from .tiff import TiffError, TiffTags


@dataclass(frozen=True, slots=True)
class ImageHeader:
    """What the first bytes of an image file state; sizes are in pixels."""

    format: str
    width: int
    height: int


def read_header(content: bytes) -> ImageHeader | None:
    """Format and size; None for what is no PNG, JPEG, TIFF, BMP, PNM or WebP file."""
    try:
        if content.startswith(b"\x89PNG\r\n\x1a\n"):
            return ImageHeader("PNG", *struct.unpack(">II", content[16:24]))
        if content.startswith(b"\xff\xd8\xff"):
            return _jpeg(content)
        if content[:4] in (b"II*\x00", b"MM\x00*"):
            tags = TiffTags(content)
            return ImageHeader("TIFF", int(tags.numbers(256)[0]), int(tags.numbers(257)[0]))
        if content.startswith(b"BM"):
            width, height = struct.unpack("<ii", content[18:26])
            return ImageHeader("BMP", abs(width), abs(height))
        if content[:1] == b"P" and content[1:2] in _PNM:
            return _pnm(content)
        if content[:4] == b"RIFF" and content[8:12] == b"WEBP":
            return _webp(content)
    except (struct.error, IndexError, TiffError):
        return None
    return None


def is_complete(format: str, content: bytes) -> bool:
    """Whether the end of the file is there."""
    if format == "PNG":
        return b"IEND" in content[-64:]
    if format == "JPEG":
        return b"\xff\xd9" in content[-65536:]
    if format == "BMP":
        return len(content) >= int(struct.unpack("<I", content[2:6])[0]) * 0.99
    if format == "PNM" and content[1:2] in b"56":
        header = _PNM_HEADER.match(content)
        if header is None:
            return False
        width, height, most = map(int, header.groups())
        values = width * height * (3 if content[1:2] == b"6" else 1)
        return len(content) - header.end() >= values * (2 if most > 255 else 1)
    if format == "WebP":
        return len(content) >= int(struct.unpack("<I", content[4:8])[0])
    return True


def _jpeg(content: bytes) -> ImageHeader | None:
    at = 2
    while at + 9 < len(content):
        if content[at] != 0xFF:
            return None
        marker = content[at + 1]
        if marker == 0xFF:
            at += 1
        elif 0xC0 <= marker <= 0xCF and marker not in (0xC4, 0xC8, 0xCC):
            height, width = struct.unpack(">HH", content[at + 5 : at + 9])
            return ImageHeader("JPEG", width, height)
        else:
            at += 2 + int(struct.unpack(">H", content[at + 2 : at + 4])[0])
    # Cut off before its size is told: a picture all the same.
    return ImageHeader("JPEG", 8, 8)


_PNM = b"2356"
"""gray and color, as text and as bytes"""
_GAP = rb"(?:[ \t\r\n]|#[^\n]*\n)+"
_PNM_HEADER = re.compile(rb"P[2356]" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)\s")


def _pnm(content: bytes) -> ImageHeader | None:
    """PGM and PPM files, which maps of robots are."""
    found = _PNM_HEADER.match(content)
    if found is None:
        return None
    width, height, most = map(int, found.groups())
    return ImageHeader("PNM", width, height) if 0 < most < 65536 else None


def _webp(content: bytes) -> ImageHeader | None:
    chunk = content[12:16]
    if chunk == b"VP8X":
        width = int.from_bytes(content[24:27], "little") + 1
        return ImageHeader("WebP", width, int.from_bytes(content[27:30], "little") + 1)
    if chunk == b"VP8 ":
        width, height = struct.unpack("<HH", content[26:30])
        return ImageHeader("WebP", width & 0x3FFF, height & 0x3FFF)
    if chunk == b"VP8L":
        bits = int.from_bytes(content[21:25], "little")
        return ImageHeader("WebP", (bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1)
    return None
