"""Text in lines of a given width, measured by the average width of a letter."""

from __future__ import annotations

LETTER = 0.53
"""Width of an average letter of the figure's font, as a share of its size."""
BOLD_LETTER = 0.72
"""The same of a bold letter in DejaVu Sans, the widest of the usual fonts."""


def letters(width: float, size: float) -> int:
    """How many letters fit into `width` pixels at a font size."""
    return max(int(width / (LETTER * size)), 1)


def wrapped(content: str, most: int) -> list[str]:
    """Lines of at most `most` letters, broken at spaces; no-break spaces hold words together."""
    lines: list[str] = []
    for word in content.split(" "):
        while len(word) > most:
            lines.append(word[:most])
            word = word[most:]
        if lines and len(lines[-1]) + 1 + len(word) <= most:
            lines[-1] += f" {word}"
        elif word:
            lines.append(word)
    return [line.replace("\N{NO-BREAK SPACE}", " ") for line in lines] or [""]
