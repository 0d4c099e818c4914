"""Counts and durations on a stream of samples."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from ..formula.interval import UNBOUNDED
from .graph_operations import Measuring
from .stream_nodes import Clock, Sample, Stream
from .weights import enough_weight


@dataclass
class StreamMeasure:
    """The greatest level of a window that is held often or long enough. Work a sample grows with
    the length of the window."""

    clock: Clock
    operation: Measuring

    def __post_init__(self) -> None:
        self.interval = self.operation.interval or UNBOUNDED
        self.upcoming: deque[float] = deque()
        self.samples: deque[Sample] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The level at each sample whose window is over."""
        found = []
        samples, upcoming = self.samples, self.upcoming
        latest = self.interval.hi + self.clock.tolerance
        upcoming.append(self.clock.latest)
        for place, value in inputs[0]:
            while samples and samples[0][0] + latest < place:
                found.append(self._decide(place))
            samples.append((place, value))
            upcoming.popleft()
        while samples and upcoming and samples[0][0] + latest < upcoming[0]:
            found.append(self._decide(upcoming[0]))
        return found

    def finish(self, inputs: Sequence[Stream]) -> Stream:
        """The rest, in windows that end with the last sample."""
        found = list(self.step(inputs))
        while self.samples:
            found.append(self._decide(self.samples[-1][0]))
        return found

    def _decide(self, following: float) -> Sample:
        """`following`: where the sample after the last one is, or the end of the stream."""
        start = self.samples[0][0]
        low = start + self.interval.lo - self.clock.tolerance
        ends = [*[place for place, _ in self.samples][1:], following]
        levels = sorted(
            ((value, self._weight(place, end, start))
             for (place, value), end in zip(self.samples, ends, strict=True) if place >= low),
            key=lambda level: -level[0],
        )  # fmt: skip
        self.samples.popleft()
        enough = enough_weight(self.operation, self.clock.tolerance, self.clock.latest)
        total = 0.0
        for value, weight in levels:
            total += weight
            if total > enough:
                return start, value
        return start, -math.inf

    def _weight(self, place: float, following: float, start: float) -> float:
        if self.operation.counts:
            return 1.0
        return max(min(following, start + self.interval.hi) - place, 0.0)
