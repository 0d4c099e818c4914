"""Lines against those that are stored, with room for other machines' last digits."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import zip_longest
from pathlib import Path

EXPECTED = Path(__file__).with_name("expected")
SCENES = Path(__file__).with_name("scenes")

_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")
NUMBERS, FIGURE = 1e-9, 0.011
"""Least differences that count: of numbers, and of figures, which have two decimals."""
_RELATIVE = 1e-7
_SIZE, _OF_SIZES = re.compile(r"\bbytes\"?: "), 1e-3
"""Sizes of files: the last digits of numbers, some of them zeros, depend on the processor."""
_SHOWN = 12


def same(line: str, stored: str, absolute: float = NUMBERS) -> bool:
    """Whether two lines say the same: words exactly, numbers to 1e-7 of the largest, sizes of
    files to a thousandth."""
    if line == stored:
        return True
    if _NUMBER.sub("#", line) != _NUMBER.sub("#", stored):
        return False
    pairs = [
        (float(a), float(b))
        for a, b in zip(_NUMBER.findall(line), _NUMBER.findall(stored), strict=True)
    ]
    largest = max(max(abs(a), abs(b)) for a, b in pairs)
    relative = _OF_SIZES if _SIZE.search(line) else _RELATIVE
    return all(abs(a - b) <= max(absolute, relative * largest) for a, b in pairs)


def differences(
    lines: Sequence[str], stored: Sequence[str], absolute: float = NUMBERS
) -> list[str]:
    """The lines that differ, each with what is stored."""
    found = []
    for number, (line, old) in enumerate(zip_longest(lines, stored), 1):
        if line is None or old is None or not same(line, old, absolute):
            found.append(f"line {number}\n  stored: {old}\n  now:    {line}")
    return found


def check(name: str, lines: Iterable[str], absolute: float = NUMBERS) -> None:
    """Fail where `lines` are not those of `expected/NAME.txt`."""
    now = _placeless(lines)
    file = EXPECTED / f"{name}.txt"
    assert file.exists(), f"no {file.name}: run `python -m tests.golden`"
    found = differences(now, file.read_text(encoding="utf-8").splitlines(), absolute)
    assert not found, (
        f"{len(found)} lines differ from {file.name}; if that is meant, `python -m tests.golden` "
        "stores them anew, and `git diff` shows what changed\n" + "\n".join(found[:_SHOWN])
    )


def store(name: str, lines: Iterable[str]) -> None:
    """Write `expected/NAME.txt`."""
    EXPECTED.mkdir(exist_ok=True)
    text = "\n".join(_placeless(lines)) + "\n"
    (EXPECTED / f"{name}.txt").write_text(text, encoding="utf-8")


def _placeless(lines: Iterable[str]) -> list[str]:
    """Single lines, without where this checkout lies."""
    return "\n".join(lines).replace(str(SCENES), "SCENES").splitlines()
