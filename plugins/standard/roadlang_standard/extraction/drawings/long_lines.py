"""The long lines of a plan: without its frame, and without what is written or dashed in it."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..masks.mask_parts import parts_and_boxes, where_parts

_LONG = 0.2
"""A connected part is long if its extent is more than this share of the picture's shorter side;
letters, dashes and arrows are smaller."""
_AROUND, _RIM, _MOSTLY = 0.85, 0.06, 0.6
"""A frame, with what is joined to it, extends over at least `_AROUND` of both sides of the picture,
and more than `_MOSTLY` of its pixels are within `_RIM` shorter sides of the border."""


def long_lines(ink: Booleans) -> Booleans | None:
    """The long lines of the ink (h, w); None where these are all of it, or where there are none."""
    _, parts, stats = parts_and_boxes(ink)
    sizes = stats[:, [cv2.CC_STAT_HEIGHT, cv2.CC_STAT_WIDTH]]
    kept = sizes.max(axis=1) > _LONG * min(ink.shape)
    kept[0] = False
    for key in np.flatnonzero(kept & (sizes > _AROUND * np.array(ink.shape)).all(axis=1)):
        kept[key] = not _is_frame(parts == key)
    if not kept.any() or kept[1:].all():
        return None
    return where_parts(kept, parts)


def _is_frame(part: Booleans) -> bool:
    """Whether most of a part (h, w) lies along the border of the picture."""
    margin = int(np.ceil(_RIM * min(part.shape)))
    inner = part[margin:-margin, margin:-margin]
    return bool(np.count_nonzero(inner) < (1 - _MOSTLY) * np.count_nonzero(part))
