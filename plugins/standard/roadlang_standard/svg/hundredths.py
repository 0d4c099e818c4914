"""Whole numbers of hundredths as text, many at once: 1250 is `12.5`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.typing import NDArray

LOWEST, HIGHEST = -99_999, 999_999
"""What is written in at most seven characters."""
_BLOCK = 1 << 16


def joined(numbers: NDArray[np.int64], separators: str) -> str:
    """The text of (n, m) hundredths, each number followed by its column's separator.

    None is less than `LOWEST` or greater than `HIGHEST`; `separators` is m ASCII characters.
    """
    import numpy as np

    first, table = _table_from(int(numbers.min(initial=0)), int(numbers.max(initial=0)))
    letters = table[numbers - first]
    letters |= np.array([ord(letter) << 56 for letter in separators], np.uint64)
    return letters.tobytes().translate(None, b"\0").decode("ascii")


_known: list[tuple[int, Any]] = []
"""The number that the table begins with, and the table."""


def _table_from(low: int, high: int) -> tuple[int, NDArray[np.uint64]]:
    if _known:
        first, table = _known[0]
        if first <= low and high < first + len(table):
            return first, table
        low, high = min(low, first), max(high, first + len(table) - 1)
    first = max(low // _BLOCK * _BLOCK, LOWEST)
    above = _sizes(min(high // _BLOCK * _BLOCK + _BLOCK, HIGHEST + 1))
    below = _sizes(1 - first)[:0:-1] | _packed(["-"])
    import numpy as np

    _known[:] = [(first, np.concatenate([below, above]))]
    return _known[0]


def _sizes(count: int) -> NDArray[np.uint64]:
    """The texts of 0 to `count` - 1."""
    wholes = _packed(f"{number:4}" for number in range((count + 99) // 100))
    fractions = _packed(["", *(f"    .{part:02}".rstrip("0") for part in range(1, 100))])
    found: NDArray[np.uint64] = (wholes[:, None] | fractions).ravel()[:count]
    return found


def _packed(texts: Iterable[str]) -> NDArray[np.uint64]:
    """Up to eight characters for each number, the first in the lowest byte; spaces become 0."""
    import numpy as np

    letters = "".join(text.ljust(8) for text in texts).replace(" ", "\0")
    return np.frombuffer(letters.encode("ascii"), "<u8")
