"""Whether the end of a picture file is there, as far as its first and last bytes tell.

What is damaged between them is found when the picture is decoded.
"""

from __future__ import annotations

import re
import struct

from .picture_formats import picture_format

LAST = 65536
"""Bytes of the end of a file that are looked at: pictures may be followed by other data."""
_LAST_CHUNK = 8
"""bytes of the last chunk of a PNG file from its name on"""
_GAP = rb"(?:[ \t\r\n]|#[^\n]*\n)+"
PNM_HEADER = re.compile(rb"P[2356]" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)" + _GAP + rb"(\d+)\s")
"""of PGM and PPM files: width, height and the greatest value"""


def has_end(start: bytes, end: bytes, size: int) -> bool:
    """Whether a file is a whole picture: its first bytes, its `LAST` ones, and how many it has.

    A file is given the benefit of the doubt where its format does not tell.
    """
    format = picture_format(start)
    try:
        if format == "PNG":
            return 0 <= end.rfind(b"IEND", -64) <= len(end) - _LAST_CHUNK
        if format in ("JPEG", "JPEG 2000"):
            return b"\xff\xd9" in end[-LAST:]
        if format == "BMP":
            return size >= int(struct.unpack("<I", start[2:6])[0]) * 0.99
        if format == "WebP":
            return size >= int(struct.unpack("<I", start[4:8])[0]) + 8
    except struct.error:
        return False
    return format != "PNM" or _has_all_values(start, size)


def _has_all_values(start: bytes, size: int) -> bool:
    header = PNM_HEADER.match(start)
    if start[1:2] not in b"56" or header is None:
        return True
    width, height, most = map(int, header.groups())
    values = width * height * (3 if start[1:2] == b"6" else 1)
    return size - header.end() >= values * (2 if most > 255 else 1)
