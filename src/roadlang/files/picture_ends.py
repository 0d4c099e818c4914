"""Whether the end of a picture file is there, told without decoding it.

What is damaged before its end is found when the picture is decoded.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable

from .jpeg_segments import START_OF_SCAN, jpeg_segments
from .picture_formats import picture_format

LAST = 65536
"""Bytes of the end of a file that are looked at first."""
_SIGNATURE, _CHUNK, _LAST_CHUNK = 8, 12, 8
"""Bytes of PNG's signature, of a chunk beside its data, and of the last one from its name on."""
_END_OF_JPEG = b"\xff\xd9"
_GAP = rb"(?:[ \t\r\n]|#[^\n]*\n)+"
PNM_HEADER = re.compile(rb"P[2356]" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)\s")
"""of PGM and PPM files: width, height and the greatest value"""


def has_end(start: bytes, end: bytes, size: int, content: Callable[[], bytes]) -> bool:
    """Whether a file is a whole picture: its first bytes, its `LAST` ones, how many it has, and all
    of them, which are asked for only where the others do not tell. The end of the picture may not
    be that of the file: phones add a video, and editors leave what was there before.

    A file is given the benefit of the doubt where its format does not tell.
    """
    format = picture_format(start)
    try:
        if format == "PNG":
            return 0 <= end.rfind(b"IEND", -64) <= len(end) - _LAST_CHUNK or _png_ends(content())
        if format == "JPEG":
            return _jpeg_ends(content())
        if format == "JPEG 2000":
            return _END_OF_JPEG in end[-LAST:]
        if format == "BMP":
            return size >= int(struct.unpack("<I", start[2:6])[0]) * 0.99
        if format == "WebP":
            return size >= int(struct.unpack("<I", start[4:8])[0]) + 8
    except (struct.error, ValueError):
        return False
    return format != "PNM" or _has_all_values(start, size)


def _has_all_values(start: bytes, size: int) -> bool:
    header = PNM_HEADER.match(start)
    if start[1:2] not in b"56" or header is None:
        return True
    width, height, most = map(int, header.groups())
    values = width * height * (3 if start[1:2] == b"6" else 1)
    return size - header.end() >= values * (2 if most > 255 else 1)


def _png_ends(content: bytes) -> bool:
    at = _SIGNATURE
    while at + _CHUNK <= len(content):
        if content[at + 4 : at + 8] == b"IEND":
            return True
        at += _CHUNK + int.from_bytes(content[at : at + 4], "big")
    return False


def _jpeg_ends(content: bytes) -> bool:
    """By the marker after the first scan: a preview in front of it has one, too."""
    found = dict(jpeg_segments(content))
    return START_OF_SCAN in found and content.find(_END_OF_JPEG, found[START_OF_SCAN]) >= 0
