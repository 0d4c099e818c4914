"""Numbers of printed formulas with as many digits as those of tables."""

from __future__ import annotations

import re

_LONG = re.compile(r"(?<![\w.`])\d+\.\d{6,}(?:e[+-]?\d+)?(?![\w.`])")


def short_numbers(text: str) -> str:
    """The text with six significant digits of longer numbers: `16.6667`. Large ones, such as time
    stamps, keep all of theirs."""
    return _LONG.sub(_short, text)


def _short(number: re.Match[str]) -> str:
    value = float(number[0])
    return f"{value:.6g}" if value < 1e5 else number[0]
