"""Features of crops, each used several times: to make them takes as long as to learn from them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator

import numpy as np
import torch
from torch import Tensor

_KEPT = 960
"""Crops whose features are kept, in half precision: about 900 MB of the pretrained encoder's."""

Batch = tuple[list[Tensor], Tensor, Tensor]
"""Features, target and weight; the first axis of each counts the crops."""


def reused(
    feed: Iterator[list[Tensor]], see: Callable[[Tensor], list[Tensor]], uses: int, seed: int
) -> Iterator[Batch]:
    """What `see` says of each picture of the feed; each crop is in `uses` batches, on average.

    With one use the batches are those of the feed; with more, they are mixed from all that is kept.
    """
    rng = np.random.default_rng(seed)
    kept: deque[list[Tensor]] = deque(maxlen=_KEPT)
    for image, target, weight in feed:
        with torch.no_grad():
            features = see(image)
        if uses == 1:
            yield features, target, weight
            continue
        kept.extend(
            [part[i].half() for part in (*features, target, weight)] for i in range(len(image))
        )
        for _ in range(uses):
            picked = [kept[i] for i in rng.integers(len(kept), size=len(image))]
            *mixed, target, weight = (
                torch.stack(parts).float() for parts in zip(*picked, strict=True)
            )
            yield [it.contiguous(memory_format=torch.channels_last) for it in mixed], target, weight
