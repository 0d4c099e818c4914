"""The tags of the first page of a TIFF file (TIFF 6.0, section 2)."""

from __future__ import annotations

import struct

_FORMATS = {1: "B", 3: "H", 4: "I", 11: "f", 12: "d"}
_MOST_VALUES = 10_000


class TiffError(ValueError):
    """Not a TIFF file that can be read."""


class TiffTags:
    """Looked up by number. Raises `TiffError` where the file is broken."""

    def __init__(self, content: bytes) -> None:
        self._content = content
        self._order = "<" if content[:2] == b"II" else ">"
        self._entries: dict[int, tuple[int, int, int]] = {}
        (start,) = self._unpack("I", 4)
        (count,) = self._unpack("H", start)
        for index in range(count):
            at = start + 2 + 12 * index
            tag, kind, values = self._unpack("HHI", at)
            self._entries[tag] = (kind, values, at + 8)

    def numbers(self, tag: int) -> tuple[float, ...]:
        """The values of a tag; empty where it is not there or holds no numbers."""
        if tag not in self._entries:
            return ()
        kind, count, at = self._entries[tag]
        if kind not in _FORMATS or count > _MOST_VALUES:
            return ()
        layout = f"{count}{_FORMATS[kind]}"
        if struct.calcsize(layout) > 4:
            (at,) = self._unpack("I", at)
        return self._unpack(layout, at)

    def _unpack(self, layout: str, at: int) -> tuple[int, ...]:
        try:
            return struct.unpack_from(self._order + layout, self._content, at)
        except struct.error as error:
            raise TiffError(str(error)) from None
