"""What each operator of a formula does with a stream of samples: on average constant work for each.

Streams are lists of (position, value) in the order of the samples. Operators that look ahead give
the value of a sample only when all samples that it depends on have come.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from ..formula.interval import Interval
from .axis import TOLERANCE

Sample: TypeAlias = tuple[float, float]
Stream: TypeAlias = Sequence[Sample]
Scalar: TypeAlias = Callable[..., float]


class Clock:
    """The positions so far, counted from the first one, and how exact they are."""

    def __init__(self) -> None:
        self.first = 0.0
        self.count = 0
        self.latest = -math.inf
        self.tolerance = 0.0

    def advance(self, position: float) -> float:
        """The next position, counted from the first one."""
        if self.count == 0:
            self.first = position
        self.count += 1
        self.latest = position - self.first
        step = self.latest / (self.count - 1) if self.count > 1 else 0.0
        resolution = 2 * math.ulp(max(abs(position), abs(self.first))) + 4 * math.ulp(self.latest)
        self.tolerance = TOLERANCE * step + resolution
        return self.latest


class StreamNode(Protocol):
    """One operator; it keeps what later samples may still need and no more."""

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The samples that have become known, given the new samples of the inputs."""
        ...

    def finish(self, inputs: Sequence[Stream]) -> Stream:
        """As `step`, and no further samples will come."""
        ...


class StreamPointwise:
    """`function` of the inputs, sample by sample; inputs that look ahead come later than others."""

    def __init__(self, function: Scalar, count: int) -> None:
        self.function = function
        self.waiting: list[deque[Sample]] = [deque() for _ in range(count)]

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The samples that all inputs have."""
        return [
            (samples[0][0], self.function(*[value for _, value in samples]))
            for samples in joined(self.waiting, inputs)
        ]

    finish = step


def joined(waiting: Sequence[deque[Sample]], inputs: Sequence[Stream]) -> list[list[Sample]]:
    """The samples that all inputs have, next to each other; the others wait."""
    if not any(waiting) and len({len(stream) for stream in inputs}) == 1:
        return [list(samples) for samples in zip(*inputs, strict=True)]
    for queue, stream in zip(waiting, inputs, strict=True):
        queue.extend(stream)
    ready = min(map(len, waiting))
    return [[queue.popleft() for queue in waiting] for _ in range(ready)]


@dataclass
class StreamPastWindow:
    """The greatest (`sign` 1) or least (`sign` -1) over `t - interval`: a queue of the samples that
    are greater than all later ones (Lemire, Streaming maximum-minimum filter, 2006)."""

    clock: Clock
    interval: Interval
    sign: int

    def __post_init__(self) -> None:
        self.waiting: deque[Sample] = deque()
        self.queue: deque[Sample] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The extreme at each new sample."""
        found = []
        waiting, queue, sign = self.waiting, self.queue, self.sign
        low, high, slack = self.interval.lo, self.interval.hi, self.clock.tolerance
        for place, value in inputs[0]:
            waiting.append((place, sign * value))
            while waiting and waiting[0][0] <= place - low + slack:
                _enqueue(queue, waiting.popleft(), endless=high == math.inf)
            while queue and queue[0][0] < place - high - slack:
                queue.popleft()
            found.append((place, sign * (queue[0][1] if queue else -math.inf)))
        return found

    finish = step


def _enqueue(queue: deque[Sample], sample: Sample, *, endless: bool) -> None:
    """Add a sample; those before it that are no greater will never be the greatest again.

    In an `endless` window nothing is ever dropped: only the greatest counts.
    """
    value = sample[1]
    while queue and queue[-1][1] <= value:
        queue.pop()
    if not (endless and queue):
        queue.append(sample)


@dataclass
class StreamFutureWindow:
    """The greatest (`sign` 1) or least (`sign` -1) over `t + interval`, which has an end.

    `upcoming` are the positions of samples whose value the input does not know yet.
    """

    clock: Clock
    interval: Interval
    sign: int

    def __post_init__(self) -> None:
        self.upcoming: deque[float] = deque()
        self.undecided: deque[float] = deque()
        self.queue: deque[Sample] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The extreme at each sample whose window is over."""
        found: list[Sample] = []
        undecided, queue, sign = self.undecided, self.queue, self.sign
        high, slack, upcoming = self.interval.hi, self.clock.tolerance, self.upcoming
        upcoming.append(self.clock.latest)
        for place, value in inputs[0]:
            while undecided and undecided[0] + high + slack < place:
                found.append(self._decide(undecided.popleft()))
            _enqueue(queue, (place, sign * value), endless=False)
            undecided.append(place)
            upcoming.popleft()
        while undecided and upcoming and undecided[0] + high + slack < upcoming[0]:
            found.append(self._decide(undecided.popleft()))
        return found

    def finish(self, inputs: Sequence[Stream]) -> Stream:
        """The rest, in windows that end with the last sample."""
        found = [*self.step(inputs), *map(self._decide, self.undecided)]
        self.undecided.clear()
        return found

    def _decide(self, place: float) -> Sample:
        queue = self.queue
        while queue and queue[0][0] < place + self.interval.lo - self.clock.tolerance:
            queue.popleft()
        return place, self.sign * (queue[0][1] if queue else -math.inf)


@dataclass
class StreamSince:
    """`left since[a, b] right`: of each witness the least of `right` there and `left` since then.

    A new value of `left` caps those of all witnesses, of which the queue holds the ones that are
    greater than all later ones: the capped ones are at its front and become one.
    """

    clock: Clock
    interval: Interval

    def __post_init__(self) -> None:
        self.inputs: tuple[deque[Sample], deque[Sample]] = (deque(), deque())
        self.waiting: deque[Sample] = deque()
        self.lefts: deque[Sample] = deque()
        self.queue: deque[Sample] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The value at each new sample."""
        low, high, slack = self.interval.lo, self.interval.hi, self.clock.tolerance
        queue, waiting, lefts = self.queue, self.waiting, self.lefts
        found = []
        for (place, left), (_, right) in joined(self.inputs, inputs):
            self._cap(left)
            _enqueue(lefts, (place, -left), endless=False)
            waiting.append((place, right))
            while waiting and waiting[0][0] <= place - low + slack:
                witness, value = waiting.popleft()
                while lefts and lefts[0][0] <= witness:
                    lefts.popleft()
                value = min(value, -lefts[0][1]) if lefts else value
                _enqueue(queue, (witness, value), endless=high == math.inf)
            while queue and queue[0][0] < place - high - slack:
                queue.popleft()
            found.append((place, queue[0][1] if queue else -math.inf))
        return found

    finish = step

    def _cap(self, left: float) -> None:
        queue, latest = self.queue, None
        while queue and queue[0][1] >= left:
            latest = queue.popleft()
        if latest is not None:
            queue.appendleft((latest[0], left))


@dataclass
class StreamUntil:
    """`left until[a, b] right`, b finite. Work a sample can grow to the length of the window."""

    clock: Clock
    interval: Interval

    def __post_init__(self) -> None:
        self.inputs: tuple[deque[Sample], deque[Sample]] = (deque(), deque())
        self.upcoming: deque[float] = deque()
        self.samples: deque[tuple[float, float, float]] = deque()

    def step(self, inputs: Sequence[Stream]) -> Stream:
        """The value at each sample whose window is over."""
        found = []
        samples, upcoming = self.samples, self.upcoming
        latest = self.interval.hi + self.clock.tolerance
        upcoming.append(self.clock.latest)
        for (place, left), (_, right) in joined(self.inputs, inputs):
            while samples and samples[0][0] + latest < place:
                found.append(self._decide())
            samples.append((place, left, right))
            upcoming.popleft()
        while samples and upcoming and samples[0][0] + latest < upcoming[0]:
            found.append(self._decide())
        return found

    def finish(self, inputs: Sequence[Stream]) -> Stream:
        """The rest, in windows that end with the last sample."""
        found = list(self.step(inputs))
        while self.samples:
            found.append(self._decide())
        return found

    def _decide(self) -> Sample:
        start = self.samples[0][0]
        low = start + self.interval.lo - self.clock.tolerance
        best, held = -math.inf, math.inf
        for place, left, right in self.samples:
            if place >= low:
                best = max(best, min(right, held))
            held = min(held, left)
            if held <= best:
                break
        self.samples.popleft()
        return start, best
