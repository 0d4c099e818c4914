"""How far lines can be displaced before they fold, and distances between them, in lines."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from roadlang import geometry as g
from roadlang.geometry.batches.clearances import clearance
from roadlang.geometry.batches.displacement import undisplaced
from roadlang.geometry.batches.distances import lp_norm, pointwise, quadrature
from roadlang.geometry.batches.folding import fold_of_points, turns_too_much
from tests.golden.road_views import bends
from tests.golden.summaries import array


def fold_lines(first: int, count: int) -> Iterator[str]:
    """Random lines, swayed more and more until each test of a fold holds."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        curve = bends(rng)
        if number % 3 == 0:
            at = np.arange(7) * math.tau / 7
            wave = 20.0 + rng.uniform(-4.0, 4.0, 7)
            curve = g.Curve.through(np.stack([wave * np.cos(at), wave * np.sin(at)], 1), True)
        s = curve.stations(1.0)
        frame = g.CurveFrame.of(curve, s)
        sway = np.sin(s[None] / rng.uniform(1.5, 12.0, (5, 1)) + rng.uniform(0.0, 6.0, (5, 1)))
        yield f"{number}: {curve.length:.10g} {curve.closed}"
        for test in (_folds, _is_not_surely_smooth, _has_short_steps, _turns_too_much):
            yield f"  {test.__name__} from {_numbers(_least(test, frame, sway))}"
        one, two = g.displace(frame, s, 0.5 * sway), g.displace(frame, s, -0.3 * sway[::-1])
        yield f"  apart {_numbers(pointwise(one, two))} {_numbers(quadrature(one))}"
        yield f"  norms {_numbers(lp_norm(pointwise(one, two), quadrature(one), 3.0))}"
        yield f"  margin {_numbers(g.margin(one, (-30.0, -20.0), (45.0, 60.0)))}"
        beside = g.sample(bends(rng), np.linspace(0.0, 15.0, 12))
        yield f"  clear {_numbers(clearance(one, [beside]))}"


def _numbers(value: Any) -> str:
    return array(np.asarray(value, dtype=float).ravel().tolist())


def _folds(frame: g.CurveFrame, moves: Any) -> Any:
    return frame.steps.folded(moves)


def _is_not_surely_smooth(frame: g.CurveFrame, moves: Any) -> Any:
    return ~frame.steps.surely_smooth(moves)


def _has_short_steps(frame: g.CurveFrame, moves: Any) -> Any:
    points, line = g.displace(frame, frame.stations, moves).points, undisplaced(frame)
    return fold_of_points(points, frame.steps.gaps, frame.closed, (line.points, line.steps))


def _turns_too_much(frame: g.CurveFrame, moves: Any) -> Any:
    batch = g.displace(frame, frame.stations, moves)
    return turns_too_much(batch.curvature, batch.steps, batch.closed)


def _least(test: Callable[[g.CurveFrame, Any], Any], frame: g.CurveFrame, shapes: Any) -> Any:
    """By what factor a test begins to hold, for each row of `shapes`, between 0 and 40."""
    low, high = np.zeros(len(shapes)), np.full(len(shapes), 40.0)
    for _ in range(40):
        middle = 0.5 * (low + high)
        holds = np.asarray(test(frame, middle[:, None] * shapes))
        low, high = np.where(holds, low, middle), np.where(holds, middle, high)
    return high
