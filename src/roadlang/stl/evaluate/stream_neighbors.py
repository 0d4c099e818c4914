"""`next` and `prev` on a stream of samples."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence

from .stream_nodes import Stream


class StreamPrevious:
    """The input at the previous sample, -inf at the first."""

    def __init__(self) -> None:
        self.latest = -math.inf

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The value at each new sample."""
        found = []
        for place, value in inputs[0]:
            found.append((place, self.latest))
            self.latest = value
        return found

    finish = step


class StreamNext:
    """The input at the next sample, -inf at the last."""

    def __init__(self) -> None:
        self.places: deque[float] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The value at each sample that is followed by another."""
        found = []
        for place, value in inputs[0]:
            if self.places:
                found.append((self.places.popleft(), value))
            self.places.append(place)
        return found

    def finish(self, inputs: Sequence[Stream]) -> Stream:
        """As `step`, and the last sample."""
        found = [*self.step(inputs), *((place, -math.inf) for place in self.places)]
        self.places.clear()
        return found
