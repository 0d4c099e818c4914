"""The segments of a JPEG file in front of its pixels."""

from __future__ import annotations

from collections.abc import Iterator

START_OF_SCAN = 0xDA
"""The marker of the segment that the pixels follow."""
_MARKER = 0xFF
"""Begins every marker, and fills the space before some."""


def jpeg_segments(content: bytes) -> Iterator[tuple[int, int]]:
    """The marker of each segment and the place of its first byte, up to `START_OF_SCAN` or where
    the file is cut off. Raises ValueError where no marker is where one has to be."""
    at = 2
    while at + 4 <= len(content):
        if content[at] != _MARKER:
            raise ValueError("a segment of a JPEG does not begin with a marker")
        marker = content[at + 1]
        if marker == _MARKER:
            at += 1
            continue
        yield marker, at
        if marker == START_OF_SCAN:
            return
        at += 2 + int.from_bytes(content[at + 2 : at + 4], "big")
