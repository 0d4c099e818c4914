"""Searches side by side, and the candidates that are drawn at random among theirs."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..geometry.arrays import Floats, read_only
from ..plugins.attribution import called_by_plugins
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Axis, Search
from ..plugins.results import real_numbers
from .evaluator import Proposal
from .outcome import Outcome
from .plan import Plan


class Islands:
    """The searches of a plan. Each gives a batch of points in every round. `screen` judges points
    by the requirements."""

    def __init__(
        self, plan: Plan, axes: Sequence[Axis], screen: Callable[[Floats], Floats]
    ) -> None:
        self._plan = plan
        self._axes = tuple(axes)
        self._screen = screen
        self._searches: list[Search] = []
        for island in range(plan.islands):
            with plugin_guard(plan.entry, plan.span):
                search = plan.searcher.start(self._axes, _seed(plan.seed, island))
                search.screen_with(called_by_plugins(self._screened))
            self._searches.append(search)
        self._pending: deque[list[tuple[Search, list[int], Floats]]] = deque()

    def ask(self, first: int, most: int) -> list[Proposal]:
        """The candidates of the next round, at most `most`, numbered from `first`; none where all
        searches have come to their ends. Raises RL474 where not one begins."""
        pending: list[tuple[Search, list[int], Floats]] = []
        proposals: list[Proposal] = []
        for search in self._searches:
            count = min(self._batch_size(search), most - len(proposals))
            start = first + len(proposals)
            searched = [i for i in range(start, start + count) if not self._plan.is_random(i)]
            points = self._points(search, len(searched))
            has_ended = len(points) < len(searched)
            searched = searched[: len(points)]
            # A search that has come to its end takes no more random candidates with it.
            end = (searched[-1] + 1 if searched else start) if has_ended else start + count
            chosen = dict(zip(searched, points.tolist(), strict=True))
            pending.append((search, [index - first for index in searched], points))
            proposals += (self._proposal(index, chosen.get(index)) for index in range(start, end))
        if not proposals and first == 0:
            fault = "gave no points to begin with"
            raise wrong_result(self._plan.entry, self._plan.span, fault)
        self._pending.append(pending)
        return proposals

    def tell(self, outcomes: Sequence[Outcome], values: Floats) -> None:
        """What came of the candidates of the first round that was asked for and not told yet."""
        length = max((len(outcome.descriptor) for outcome in outcomes), default=0)
        for search, rows, points in self._pending.popleft():
            if not rows:
                continue
            descriptors = np.full((len(rows), length), np.nan)
            for row, number in enumerate(rows):
                found = outcomes[number].descriptor
                descriptors[row, : len(found)] = found
            with plugin_guard(self._plan.entry, self._plan.span):
                search.tell(read_only(points), read_only(values[rows]), read_only(descriptors))

    def _batch_size(self, search: Search) -> int:
        """How many candidates a search has in the next round. Raises RL474."""
        most = self._plan.batch
        with plugin_guard(self._plan.entry, self._plan.span):
            count = search.batch_size(most)
        if not isinstance(count, int) or not 1 <= count <= most:
            fault = f"gave the batch size {count!r}, which is no whole number from 1 to {most}"
            raise wrong_result(self._plan.entry, self._plan.span, fault)
        return count

    def _points(self, search: Search, count: int) -> Floats:
        if count <= 0:
            return np.empty((0, len(self._axes)))
        with plugin_guard(self._plan.entry, self._plan.span):
            result = search.ask(count)
        return self._checked(result, count)

    def _screened(self, points: Floats) -> Floats:
        return self._screen(self._checked(points))

    def _checked(self, found: Any, count: int | None = None) -> Floats:
        """Points (n, axes) that a search gave, at most `count`. Raises RL474."""
        points = real_numbers(found, "points", self._plan.entry, self._plan.span)
        if count is None:
            count = len(points) if points.ndim else 1
        fits = points.ndim == 2 and points.shape[1] == len(self._axes) and len(points) <= count
        if not fits:
            fault = f"gave points of shape {points.shape}, not {(count, len(self._axes))}"
            raise wrong_result(self._plan.entry, self._plan.span, fault)
        beyond = points[~((points >= 0.0) & (points < 1.0))]
        if len(beyond):
            fault = f"gave the coordinate {beyond[0]:g}, which is not within [0, 1)"
            raise wrong_result(self._plan.entry, self._plan.span, fault)
        return points

    def _proposal(self, index: int, point: Sequence[float] | None) -> Proposal:
        if point is None:
            return Proposal(index, self._random_point(index), True)
        return Proposal(index, tuple(point), self._plan.searcher.is_random)

    def _random_point(self, index: int) -> tuple[float, ...]:
        key = _seed(self._plan.seed, -1)
        random = np.random.Generator(np.random.Philox(key=key, counter=index << 64))
        return tuple(random.random(len(self._axes)).tolist())


def _seed(seed: int, island: int) -> int:
    """A seed of 63 bits for each island; -1 stands for the random share."""
    state = np.random.SeedSequence([seed, island + 1]).generate_state(1, np.uint64)[0]
    return int(state >> np.uint64(1))
