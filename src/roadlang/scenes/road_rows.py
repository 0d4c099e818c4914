"""A road in many scenes: its arrays as the numbers that scenes have."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry import GeometryError
from ..geometry.arrays import Booleans, Floats, read_only
from ..ir.batch import RoadBatch
from ..ir.read_only import Floats as FloatNumbers
from ..ir.scene_lane import SceneLane
from ..ir.scene_road import SceneRoad, with_rows
from ..world.lanes.cross_sections import LaneBatch
from ..world.station_numbers import station_numbers

Numbers = tuple[float, ...]


def road_rows(
    batch: RoadBatch,
    lanes: LaneBatch,
    speed_limits: Sequence[float | None],
    scenario: IndexedScenario,
    **members: Any,
) -> list[SceneRoad]:
    """A road of each variant of a batch, or of its lanes and limits; one where all are equal.

    `speed_limits` has one for each, or one for all; `members` are those that all have. Raises
    RL475 where a variant is no road any more.
    """
    count = max(batch.variants, lanes.variants, len(speed_limits))
    arc = _arc_lengths(batch, members["name"])
    widths = np.broadcast_to(batch.width, (len(batch.width), len(batch.stations)))
    section = lanes.pattern
    offset = section.center_offset
    center = () if offset is None else _fewest(offset.at(batch.stations).tolist())
    listed = _lane_lists(lanes, widths, batch.stations)
    same, differing = _rows_of(
        stations=arc, x=batch.points[..., 0], y=batch.points[..., 1],
        heading=batch.heading, curvature=batch.curvature, width=widths,
    )  # fmt: skip
    every: dict[str, Any] = {
        **members,
        **same,
        **dict.fromkeys(differing, ()),
        "reference_stations": station_numbers(batch.stations, scenario),
        "lanes": section.lane_count,
        "closed": batch.closed,
        "center_marking": section.center_marking,
        "center_offset": center,
    }
    each: dict[str, Sequence[Any]] = {
        "lane_list": listed,
        "length": batch.length[:, 0].tolist(),
        "speed_limit": speed_limits,
    }
    first = SceneRoad(**every, **{name: column[0] for name, column in each.items()})
    return [first] if count == 1 else _each_of(first, differing, each, count)


def _each_of(
    first: SceneRoad, rows: dict[str, Floats], each: dict[str, Sequence[Any]], count: int
) -> list[SceneRoad]:
    """One road for each row; `each`: members with a value for each, or one for all."""
    columns = (column if len(column) == count else [*column] * count for column in each.values())
    return [
        with_rows(
            first,
            {name: numbers[row] for name, numbers in rows.items()},
            **dict(zip(each, values, strict=True)),
        )
        for row, values in enumerate(zip(*columns, strict=True))
    ]


_BARELY = 1e-6
"""Meters: the width of a lane that no station shows."""


def _arc_lengths(batch: RoadBatch, name: str) -> Floats:
    """(V, S) of the points, along each road."""
    apart = np.diff(batch.points, axis=1)
    steps = np.hypot(apart[..., 0], apart[..., 1])
    arc = np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], axis=1)
    numbers = (arc, batch.points, batch.heading, batch.curvature, batch.width)
    if not all(np.isfinite(array).all() for array in numbers) or not (steps > 0).all():
        raise DiagnosticError(diagnose(Code.DEGENERATE_ROAD, None, name=name))
    return arc


def _lane_lists(lanes: LaneBatch, width: Floats, stations: Floats) -> list[tuple[SceneLane, ...]]:
    """The lanes of each row of `width`, or of the lanes; one list where all are equal."""
    count = max(len(width), lanes.variants)
    widths = lanes.lane_widths(width, stations)  # (L, V, S)
    if not (widths >= 0.0).all():
        raise GeometryError("a width must be positive")
    # A lane that is shorter than the distance between two stations has no width at any.
    widths = np.where(widths.any(axis=2, keepdims=True), widths, _BARELY)
    even: Booleans = (widths == widths[..., :1]).all(axis=2)
    columns = []
    for lane, across, is_even in zip(lanes.pattern.lanes, widths, even, strict=True):
        limit = lanes.speed_limits.get(lane.id, lane.speed_limit)
        limits = [None] if limit is None else np.asarray(limit, float).reshape(-1).tolist()
        shown = _fewest_of_rows(across, is_even)
        columns.append(
            [
                SceneLane(lane.id, lane.kind, lane.direction, shown[row % len(shown)],
                    lane.drivable, limits[row % len(limits)], lane.marking, lane.users, lane.raised)
                for row in range(max(len(shown), len(limits)))
            ]
        )  # fmt: skip
    count = max(map(len, columns))
    return list(zip(*(column * (count // len(column)) for column in columns), strict=True))


def _fewest_of_rows(widths: Floats, even: Booleans) -> list[Numbers]:
    """One number for each row in which all are the same; one row where that is so of all rows."""
    if even.all() and (widths[:, 0] == widths[0, 0]).all():
        return [(float(widths[0, 0]),)]
    rows = zip(widths, even.tolist(), strict=True)
    return [(float(row[0]),) if is_even else FloatNumbers(row.tolist()) for row, is_even in rows]


def _fewest(numbers: list[float]) -> Numbers:
    """One number where all are the same."""
    return tuple(numbers[:1]) if len(set(numbers)) == 1 else tuple(numbers)


def _rows_of(**columns: Floats) -> tuple[dict[str, Numbers], dict[str, Floats]]:
    """Of each (V, S) by name: the numbers of a row where all are equal, to the sign of a 0; the
    read-only rows of the others."""
    same: dict[str, Numbers] = {}
    differing: dict[str, Floats] = {}
    for name, rows in columns.items():
        if len(rows) > 1 and not _are_equal(rows):
            differing[name] = read_only(np.ascontiguousarray(rows))
        else:
            row = read_only(np.ascontiguousarray(rows[0]))
            same[name] = FloatNumbers.of_row(row.tolist(), row)
    return same, differing


def _are_equal(rows: Floats) -> bool:
    first = rows[0]
    return bool((rows == first).all() and (np.signbit(rows) == np.signbit(first)).all())
