"""The tags of the first page of a TIFF file (TIFF 6.0, section 2), or of a BigTIFF file, whose
places and counts have 64 bits."""

from __future__ import annotations

import struct
from collections.abc import Sequence

_FORMATS = {1: "B", 3: "H", 4: "I", 11: "f", 12: "d", 16: "Q"}
_TEXT = 2
_MOST_VALUES = 10_000
_BIG = 43
_NARROW, _WIDE = ("I", "H", 12, 4), ("Q", "Q", 20, 8)
"""How places and the number of tags are written, the bytes of a tag, and those of its values that
stand in it."""


class TiffError(ValueError):
    """Not a TIFF file that can be read."""


class TiffTags:
    """Looked up by number. Raises `TiffError` where the file is broken."""

    def __init__(self, content: bytes) -> None:
        self._content = content
        self._order = "<" if content[:2] == b"II" else ">"
        self._entries: dict[int, tuple[int, int, int]] = {}
        is_big = self._unpack("H", 2) == (_BIG,)
        self._place, counted, length, self._room = _WIDE if is_big else _NARROW
        (start,) = self._unpack(self._place, 8 if is_big else 4)
        (count,) = self._unpack(counted, start)
        first = start + struct.calcsize("=" + counted)
        for index in range(min(count, _MOST_VALUES)):
            at = first + length * index
            tag, kind, values = self._unpack(f"HH{self._place}", at)
            self._entries[tag] = (kind, values, at + length - self._room)

    def numbers(self, tag: int) -> tuple[float, ...]:
        """The values of a tag; empty where it is not there or holds no numbers."""
        if tag not in self._entries:
            return ()
        kind, count, at = self._entries[tag]
        if kind not in _FORMATS or count > _MOST_VALUES:
            return ()
        layout = f"{count}{_FORMATS[kind]}"
        if struct.calcsize("=" + layout) > self._room:
            (at,) = self._unpack(self._place, at)
        return self._unpack(layout, at)

    def rewritten(self, tag: int, numbers: Sequence[int]) -> bytes:
        """The file with other values of a tag that is there, as many as stand in it: with none it
        is a tag that readers skip."""
        kind, _, at = self._entries[tag]
        layout = f"{self._order}{self._place}{len(numbers)}{_FORMATS[kind]}"
        values = struct.pack(layout, len(numbers), *numbers)
        start = at - struct.calcsize("=" + self._place)
        return self._content[:start] + values + self._content[start + len(values) :]

    def text(self, tag: int) -> str:
        """The text of a tag; empty where it is not there or holds no text."""
        kind, count, at = self._entries.get(tag, (0, 0, 0))
        if kind != _TEXT or count > _MOST_VALUES:
            return ""
        if count > self._room:
            (at,) = self._unpack(self._place, at)
        return self._content[at : at + count].split(b"\0")[0].decode("ascii", "replace")

    def _unpack(self, layout: str, at: int) -> tuple[int, ...]:
        try:
            return struct.unpack_from(self._order + layout, self._content, at)
        except (struct.error, OverflowError) as error:
            raise TiffError(str(error)) from None
