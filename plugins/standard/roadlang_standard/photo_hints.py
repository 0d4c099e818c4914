"""What a user says of the roads in a photo, in pixels: it has to lie in the picture."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Annotated

from roadlang.api import ListOf, OptionError, PixelPoint, list_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from roadlang.api import Picture

Box = Annotated[ListOf[PixelPoint], list_of(PixelPoint, at_least=2)]
"""Two opposite corners."""
_Point = tuple[float, float]


def check_only_through(only_through: bool, through: Sequence[_Point]) -> None:
    """Raises OptionError where only marked roads are wanted and none is marked."""
    if only_through and not len(through):
        raise OptionError("only_through", "needs `through`: pixels of the roads to keep")


def check_hints(
    through: Sequence[_Point], leave_out: Sequence[Sequence[_Point]], picture: Picture
) -> None:
    """Raises OptionError for a pixel of a road that the picture does not have, or a box beside it.

    One pixel beyond the border is a matter of rounding.
    """
    if picture.pixels is None:
        return
    width, height = picture.file_size
    size = f"the picture has {width} x {height} px"
    for x, y in through:
        if not (-1.0 <= x <= width and -1.0 <= y <= height):
            raise OptionError("through", f"names the pixel ({x:g}px, {y:g}px), but {size}")
    for box in leave_out:
        (left, top), (right, bottom) = (
            tuple(pick(corner[axis] for corner in box) for axis in (0, 1)) for pick in (min, max)
        )
        if right < 0.0 or bottom < 0.0 or left > width or top > height:
            place = f"({left:g}px, {top:g}px) to ({right:g}px, {bottom:g}px)"
            raise OptionError("leave_out", f"has a box from {place}, but {size}")


def roads_in_picture(through: Sequence[_Point], picture: Picture) -> tuple[_Point, ...]:
    """Pixels of the file in the picture, which may have been resampled to square pixels."""
    if picture.file is None:
        return tuple(through)
    return tuple(_moved(point, picture) for point in through)


def boxes_in_picture(
    boxes: Sequence[Sequence[_Point]], picture: Picture
) -> tuple[tuple[_Point, ...], ...]:
    """The same of boxes: the four corners of each, around which a new box lies."""
    if picture.file is None:
        return tuple(map(tuple, boxes))
    sides = ([(min(axis), max(axis)) for axis in zip(*box, strict=True)] for box in boxes)
    return tuple(tuple(_moved(corner, picture) for corner in product(*both)) for both in sides)


def _moved(point: _Point, picture: Picture) -> _Point:
    import numpy as np

    x, y = picture.from_file(np.array(point, dtype=float)).tolist()
    return x, y
