"""Text that is safe to show: control and formatting characters as `U+001B`.

Source lines, names, file names and the words of plugins may hold anything. Written to a terminal
as they are, escape sequences would move the cursor or set the title, and bidirectional controls
would show a line in another order than it has (CVE-2021-42574).
"""

from __future__ import annotations

import unicodedata

_UNSAFE = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})
"""Unicode categories: control, format (bidirectional and zero-width), surrogates, separators."""


def printable(text: str, *, keep: str = "") -> str:
    """`text` with every unsafe character written as its code point; those in `keep` stay."""
    if text.isascii() and text.isprintable():
        return text
    return "".join(char if char in keep else shown(char) for char in text)


def shown(char: str) -> str:
    """One character as it may be shown."""
    if char == " " or char.isprintable():
        return char
    if unicodedata.category(char) in _UNSAFE:
        return f"U+{ord(char):04X}"
    return char


def one_line(text: str) -> str:
    """`text` on one line: line breaks and tabs become spaces, the rest is made printable."""
    return printable(" ".join(text.split("\n")).replace("\t", " ").replace("\r", " "))


def columns(text: str) -> int:
    """How many columns of a terminal `text` takes: wide characters two, combining marks none."""
    if text.isascii():
        return len(text)
    return sum(_width(char) for char in text)


def _width(char: str) -> int:
    if unicodedata.category(char) in ("Mn", "Me"):
        return 0
    return 2 if unicodedata.east_asian_width(char) in "WF" else 1
