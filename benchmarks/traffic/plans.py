"""Random typed maps: crossings, three arms, offset arms, towns."""

from __future__ import annotations

from random import Random


def crossing(draw: Random) -> str:
    """Four arms."""
    arms = [draw.randint(10, 18) for _ in range(4)]
    width, height = arms[0] + arms[1] + 1, arms[2] + arms[3] + 1
    rows = [["."] * width for _ in range(height)]
    rows[arms[2]] = ["#"] * width
    for row in rows:
        row[arms[0]] = "#"
    return _text(rows)


def three_arms(draw: Random) -> str:
    """A road that ends at another."""
    left, right, down = (draw.randint(10, 18) for _ in range(3))
    rows = [["#"] * (left + right + 1)]
    rows += [["."] * left + ["#"] + ["."] * right for _ in range(down)]
    return _text(rows)


def offset_arms(draw: Random) -> str:
    """Two roads that meet a third from its two sides, some way apart."""
    first, apart, last = draw.randint(8, 14), draw.randint(2, 10), draw.randint(8, 14)
    width = first + apart + last
    up = [["."] * width for _ in range(draw.randint(8, 14))]
    down = [["."] * width for _ in range(draw.randint(8, 14))]
    for row in up:
        row[first] = "#"
    for row in down:
        row[first + apart] = "#"
    return _text([*up, ["#"] * width, *down])


def town(draw: Random) -> str:
    """Streets around blocks."""
    columns = [0]
    rows = [0]
    for lines in (columns, rows):
        for _ in range(draw.randint(2, 3)):
            lines.append(lines[-1] + draw.randint(5, 13))
    text = [
        ["#" if x in columns or y in rows else "." for x in range(columns[-1] + 1)]
        for y in range(rows[-1] + 1)
    ]
    return _text(text)


PLANS = {one.__name__: one for one in (crossing, three_arms, offset_arms, town)}


def _text(rows: list[list[str]]) -> str:
    return "\n".join("".join(row) for row in rows)
