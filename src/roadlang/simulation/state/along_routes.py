"""Where agents are along their routes, and how fast they may be there; compiled where numba is
loaded, to the same bits as `RouteTable`."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lines.route_table import RouteTable
from ..vehicles import compiled


def stations(table: RouteTable, rows: Integers, along: Floats) -> Floats:
    """(n,) `RouteTable.station` of some agents at arc lengths of their lines."""
    if not compiled.is_loaded():
        return table.station(rows, along)
    out = np.empty(len(rows))
    legs = table.begin, table.per_meter, table.last, table.first
    _stations()(table.line, rows, along, legs, table.stations, out)
    return out


def limits_ahead(
    table: RouteTable, rows: Integers, along: Floats, braking: Floats | float, on: Floats | float
) -> Floats:
    """(n,) `RouteTable.speed_limit_ahead` of some agents at arc lengths of their lines."""
    there = along + on
    if not compiled.is_loaded():
        return table.speed_limit_ahead(rows, there, braking)
    out = np.empty((2, len(rows)))
    out[0] = braking
    _limits()(table.line, rows, there, table.limits, out)
    return np.asarray(out[1])


def loop_over_stations(
    line: Any, rows: Any, along: Any, legs: Any, stations: Any, out: Any
) -> None:  # fmt: skip
    """Fill `out`, (n,). numba compiles it; Python never runs it."""
    begin, per_meter, last, first = legs
    for k in range(rows.shape[0]):
        own, s, leg = line[rows[k]], along[k], 0
        for other in range(1, begin.shape[1]):
            if s >= begin[own, other]:
                leg += 1
        ahead = s - begin[own, leg] if np.isfinite(begin[own, leg]) else s
        ahead, most = ahead * per_meter[own, leg], float(last[own, leg])
        ahead = ahead if ahead > 0.0 else 0.0
        ahead = ahead if ahead < most else most
        cell = min(int(ahead), last[own, leg] - 1)
        node = first[own, leg] + cell
        low = stations[node]
        out[k] = low + (stations[node + 1] - low) * (ahead - cell)


def loop_over_limits(line: Any, rows: Any, there: Any, limits: Any, out: Any) -> None:
    """Fill the second row of `out`, (2, n), where the first are decelerations. numba compiles it;
    Python never runs it."""
    square, begin, end = limits
    for k in range(rows.shape[0]):
        own, rate, least = line[rows[k]], 2.0 * out[0, k], np.inf
        for leg in range(square.shape[1]):
            away = begin[own, leg] - there[k]
            found = square[own, leg] + rate * (away if away > 0.0 else 0.0)
            if end[own, leg] > there[k] and found < least:
                least = found
        out[1, k] = np.sqrt(least)


@cache
def _stations() -> Any:
    compiled.register((), (loop_over_stations,))
    return compiled.compile_loop(loop_over_stations, sys.modules[__name__])


@cache
def _limits() -> Any:
    compiled.register((), (loop_over_limits,))
    return compiled.compile_loop(loop_over_limits, sys.modules[__name__])
