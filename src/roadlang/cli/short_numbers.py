"""Numbers of printed formulas with as many digits as those of tables."""

from __future__ import annotations

import re

_LONG = re.compile(r"(?<![\w.`])\d+\.\d{6,}(?:e[+-]?\d+)?(?![\w.`])")


def short_numbers(text: str) -> str:
    """The text with six significant digits of longer numbers: `16.6667`."""
    return _LONG.sub(lambda number: f"{float(number[0]):.6g}", text)
