"""How lanes are numbered, run and are marked. Imports no numpy: files are checked without it."""

from __future__ import annotations

from typing import Literal, TypeAlias, get_args

Direction: TypeAlias = Literal["forward", "backward", "both", "none"]
Marking: TypeAlias = Literal["solid", "broken", "double", "none", "curb"]

DIRECTIONS: tuple[Direction, ...] = get_args(Direction)
MARKINGS: tuple[Marking, ...] = get_args(Marking)

DEFAULT_LANES = 2


def lane_ids(lanes: int) -> tuple[int, ...]:
    """From the left edge to the right, as in OpenDRIVE: -1 is the first right of the middle, 1 the
    first left of it. Of an odd number the extra lane is on the right."""
    left = lanes // 2
    return (*range(left, 0, -1), *range(-1, left - lanes - 1, -1))
