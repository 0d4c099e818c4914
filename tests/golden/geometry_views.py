"""Curves, junctions and rectangles from random numbers, in lines."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from roadlang import geometry as g
from roadlang.geometry.junctions.plan import PlanOptions
from tests.geometry.junctions.crossings_of_roads import plan_of, star
from tests.golden.summaries import array, of_json


def plain_value(value: Any) -> Any:
    """Dataclasses and arrays as JSON has them."""
    if is_dataclass(value) and not isinstance(value, type):
        return {
            one.name: plain_value(getattr(value, one.name))
            for one in fields(value)
            if not one.name.startswith("_")
        }
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {str(key): plain_value(item) for key, item in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        items = sorted(value) if isinstance(value, set | frozenset) else value
        return [plain_value(item) for item in items]
    return value if isinstance(value, str | int | float | None) else str(value)


def junction_lines(first: int, count: int) -> Iterator[str]:
    """Plans of junctions of three to five roads, and of two junctions close together."""
    rng = np.random.default_rng(first)
    for number in range(first, first + count):
        angles = np.sort(rng.choice(24, int(rng.integers(3, 6)), replace=False)) * 15.0
        network = star(*angles.tolist(), length=float(rng.choice([40.0, 90.0])))
        roads = len(network.edges)
        lanes = [int(n) for n in rng.integers(1, 5, roads)]
        one_way = [edge.id for edge in network.edges if rng.random() < 0.25]
        yield f"{number}: {angles.tolist()} lanes {lanes} one-way {one_way}"
        plan = plan_of(network, lanes, one_way, PlanOptions())
        yield from of_json(plain_value(plan), "  ")
        for junction in plan.junctions:
            yield from of_json(plain_value(g.signal_phases(junction)), "  phases")
            yield from of_json(plain_value(g.minor_roads(junction)), "  minor")


def _line(rng: np.random.Generator) -> Any:
    steps = rng.uniform(15.0, 40.0, 7)
    heading = np.cumsum(rng.uniform(-0.9, 0.9, 7))
    return np.cumsum(np.stack([steps * np.cos(heading), steps * np.sin(heading)], axis=1), axis=0)


def curve_lines(first: int, count: int) -> Iterator[str]:
    """Random curves: bends, offsets, clearances, distances, crossings."""
    rng = np.random.default_rng(first)
    for number in range(first, first + count):
        points, closed = _line(rng), number % 3 == 0
        curve = g.Curve.through(points, closed and math.dist(points[0], points[-1]) > 20.0)
        s = curve.stations(1.5)
        frame = g.CurveFrame.of(curve, s)
        sway = rng.uniform(1.0, 9.0) * np.sin(s[None, :] / rng.uniform(4.0, 20.0, (3, 1)))
        yield f"{number}: {curve.length:.10g} closed {curve.closed}"
        moved = g.displace(frame, s, sway)
        for name in ("points", "heading", "curvature", "length", "speed", "folded", "gaps"):
            yield f"  {name}: {_numbers(getattr(moved, name))}"
        again = g.displace(moved, s, 0.3 * sway[:, ::-1])
        for name in ("points", "heading", "curvature", "speed", "folded"):
            yield f"  again {name}: {_numbers(getattr(again, name))}"
        other = g.Curve.through(_line(rng))
        beside = g.sample(other, other.stations(2.0))
        rounded = g.filleted(points, float(rng.uniform(3.0, 25.0)), False)
        for label, one in (("other", other), ("filleted", rounded)):
            at = np.linspace(0.0, one.length, 30)
            yield f"  {label}: {_numbers(one.at(at))} {_numbers(one.curvature(at))}"
            yield f"  bending {_numbers(one.bending(at)[0])} {_numbers(one.bending(at)[1])}"
            yield f"  projected {_numbers(one.project(points + 3.0)[0])}"
            yield f"  part {_numbers(one.between(5.0, 40.0).at([0.0, 9.0, 30.0]))}"
            yield f"  back {_numbers(one.reversed().at(at))}"
        yield f"  clearance {_numbers(g.clearance(moved))}"
        yield f"  crossings {_numbers(g.crossings(moved, beside))}"
        yield f"  itself {_numbers(g.self_crossings(moved))}"
        yield f"  frechet {_numbers(g.frechet(moved, beside))}"


def _numbers(value: Any) -> str:
    return array(np.asarray(value, dtype=float).ravel().tolist())


def rectangle_lines(first: int, count: int) -> Iterator[str]:
    """Rectangles: how far apart, when they touch."""
    rng = np.random.default_rng(first)
    for number in range(first, first + count):
        x, y = rng.uniform(-9.0, 9.0, (2, 2, 40))
        heading = rng.uniform(-4.0, 4.0, (2, 40))
        length, width = rng.uniform(0.5, 6.0, (2, 2, 40))
        one, two = (g.Footprints(x[i], y[i], heading[i], length[i], width[i]) for i in range(2))
        yield f"{number}: {array(g.separation(one, two).tolist())}"
        yield f"  {array(g.distance_between(one, two).tolist())}"
        pairs = g.close_pairs(one, two, 1.5)
        yield f"  {[array(np.asarray(part).tolist()) for part in pairs]}"
