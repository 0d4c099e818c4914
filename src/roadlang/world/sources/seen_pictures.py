"""What extractors found in the pictures that were seen last.

The scenes of a scenario are often sampled again and again. An extractor that says `is_pure` is a
function of its options and the picture, so that the same two give what they gave before.
"""

from __future__ import annotations

import hashlib
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from ...ir.picture import Extraction, Picture

_MOST = 2
_seen: deque[tuple[Any, Picture, str, Extraction]] = deque(maxlen=_MOST)
"""Extractor, picture without its pixels, digest of these, and what was found; the last one first.
Few, because what was found has masks as large as the pictures."""


def seen_before(extractor: Any, picture: Picture, extract: Callable[[], Extraction]) -> Extraction:
    """What `extract` gives; it is called if picture and extractor are none of the last ones."""
    rest, digest = replace(picture, pixels=None), _digest(picture)
    for other, *before, found in list(_seen):
        if type(other) is type(extractor) and other == extractor and before == [rest, digest]:
            return found
    found = extract()
    _seen.appendleft((extractor, rest, digest, found))
    return found


def _digest(picture: Picture) -> str:
    if picture.pixels is None:
        return ""
    pixels = np.ascontiguousarray(picture.pixels)
    return f"{pixels.shape} {hashlib.sha256(pixels.data).hexdigest()}"
