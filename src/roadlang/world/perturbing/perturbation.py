"""Runs `perturb` passes on batches of roads, on an interval where they say so, and checks them."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.kind_instance import KindInstance, row_of_kind
from ...geometry import DisplacedBatch, displace, over
from ...geometry.arrays import Floats, read_only
from ...ir.batch import BatchRandom, RoadBatch
from ...ir.values import PassCall
from ...plugins.guard import wrong_result
from ...plugins.kinds import implements
from ...plugins.results import real_numbers
from .beside_arms import kept_beside
from .displacement_bound import displacement_bound
from .interval_faults import interval_off_road
from .root_roads import is_undisplaced
from .verified import verified

FARTHEST = 1e6
_ROUNDING = 1e-9


def perturbed(
    before: RoadBatch,
    call: PassCall,
    candidates: CandidateBatch,
    element: int = 0,
    window: Floats | None = None,
    room: Floats | None = None,
) -> RoadBatch:
    """A road after one pass. `window` (S,) fades the displacement at junctions; `room` (S,), where
    it is beside another road, is the most that it is moved, meters.

    In a window, or on an interval, a displacement in the plane keeps its part along the normal.
    Raises RL470 and RL474 for what the kind does wrong, RL414 for an interval off the road.
    """
    built = build(call, candidates, element)
    interval = _interval(call, candidates, element)
    road = before if interval is None else replace(before, interval=interval)
    random = candidates.random(call.place, element)
    displacement = displacement_by(built, road, random, candidates)
    if displacement.ndim == 3 and (interval is not None or window is not None):
        displacement = _along_normal(displacement, before)
    if interval is not None:
        displacement = displacement * _over(call, interval, before, candidates, element)
    if window is not None:
        displacement = window * displacement
    if room is not None:
        displacement = kept_beside(displacement, room)
    return verified(call, before.name, displaced(before, displacement), candidates)


def displaced(before: RoadBatch, displacement: Floats) -> RoadBatch:
    """A road moved by `displacement`: (V, S) along its normal, or (V, S, 2) east and north."""
    base = before.curves
    if is_undisplaced(before) and isinstance(base, DisplacedBatch):
        curves = displace(base.frame, before.stations, displacement)
    else:
        curves = displace(base, before.stations, displacement)
    if displacement.ndim == 3:
        displacement = _along_normal(displacement, before)
    moved = before.displacement
    if moved[:1].any() or moved.any():  # mostly the first row tells
        displacement = moved + displacement
    elif isinstance(curves, DisplacedBatch):
        displacement = curves.displacement  # one array: rows of it are then copied once
    return replace(before, curves=curves, displacement=displacement)


def _along_normal(displacement: Floats, road: RoadBatch) -> Floats:
    """(V, S) of (V, S, 2): the part to the left of the road."""
    return np.asarray((displacement * road.normal).sum(axis=-1))


def displacement_by(
    built: KindInstance, road: RoadBatch, random: BatchRandom, candidates: CandidateBatch
) -> Floats:
    """(V, S) or (V, S, 2) meters that a kind displaces a road by; V: candidates, or 1.

    Raises RL470 where the kind fails, RL474 for what is no displacement.
    """
    kind, count = built.kind, candidates.count
    if implements(type(kind), "displacements"):
        with built.guarded:
            result = kind.displacements(road, random)
        found = _in_shape(built, result, len(road.stations), count)
    else:
        rows = [_row(built, road, random, row) for row in range(count)]
        if len({row.shape for row in rows}) > 1:
            raise wrong_result(built.entry, built.call.span, "gave displacements of two shapes")
        found = np.concatenate(rows)
    _check_size(found, built, road, count)
    return found


def _check_size(displacement: Floats, built: KindInstance, road: RoadBatch, count: int) -> None:
    """Raises RL474 for what is not finite, or beyond what the kind states, RL472 for what is
    beyond all measure."""
    sizes = displacement if displacement.ndim == 2 else np.hypot(*np.moveaxis(displacement, -1, 0))
    greatest = np.maximum(sizes.max(axis=1, initial=0.0), -sizes.min(axis=1, initial=0.0))
    if not np.isfinite(greatest).all():
        fault = "gave displacements that are not finite numbers"
        raise wrong_result(built.entry, built.call.span, fault)
    if greatest.max(initial=0.0) > FARTHEST:
        raise _too_far(built, road)
    bound = displacement_bound(built, count)
    beyond = greatest > bound + _ROUNDING * np.maximum(1.0, bound)
    if beyond.any():
        row = int(np.argmax(beyond))
        moved, stated = (float(np.broadcast_to(v, beyond.shape)[row]) for v in (greatest, bound))
        fault = f"moved `{road.name}` by {moved:g} m, beyond its bound of {stated:g} m"
        raise wrong_result(built.entry, built.call.span, fault)


def _too_far(built: KindInstance, road: RoadBatch) -> DiagnosticError:
    """RL472: the options decide how far a road is moved."""
    what, span = f"{built.call.verb} with {built.entry.name}", built.call.span
    reason = f"it moves `{road.name}` by more than {FARTHEST / 1000.0:,.0f} km"
    return DiagnosticError(diagnose(Code.IMPOSSIBLE_GEOMETRY, span, what=what, reason=reason))


def _row(built: KindInstance, road: RoadBatch, random: BatchRandom, row: int) -> Floats:
    """(1, S) or (1, S, 2) meters of one candidate."""
    single = road.take(np.array([row]))
    kind = row_of_kind(built.kind, row)
    with built.guarded:
        found = kind.displacement(single, random.generator(row))
    return _in_shape(built, found, len(road.stations), 1)


def _in_shape(built: KindInstance, result: Any, stations: int, count: int) -> Floats:
    """(1 or `count`, S) or (1 or `count`, S, 2): rows may be left out where one is for all."""
    found = real_numbers(result, "displacements", built.entry, built.call.span)
    of_a_row = ((stations,), (stations, 2))
    if found.shape in of_a_row:
        found = found[None]
    if found.shape[:1] not in ((1,), (count,)) or found.shape[1:] not in of_a_row:
        wanted = f"({count}, {stations})" if count > 1 else f"({stations},)"
        fault = f"gave displacements of shape {found.shape}, not {wanted}"
        raise wrong_result(built.entry, built.call.span, fault)
    return found


def _interval(call: PassCall, candidates: CandidateBatch, element: int) -> tuple[Any, Any] | None:
    over_option = call.common.get("over")
    if over_option is None:
        return None
    low, high = evaluate(over_option, candidates, element)
    return low, high


def _over(
    call: PassCall,
    interval: tuple[Any, Any],
    road: RoadBatch,
    candidates: CandidateBatch,
    element: int,
) -> Floats:
    """(S,) or (V, S): one on the interval, fading out over `taper` meters inside its ends."""
    option = call.common.get("taper")
    taper = 0.0 if option is None else evaluate(option, candidates, element)
    columns = np.broadcast_arrays(*(np.asarray(item, float) for item in (*interval, taper)))
    rows = [
        _window(call, road, *map(float, row)) for row in zip(*map(np.ravel, columns), strict=True)
    ]
    return rows[0] if len(rows) == 1 else np.stack(rows)


def _window(call: PassCall, road: RoadBatch, low: float, high: float, taper: float) -> Floats:
    end = float(road.period if road.period is not None else road.stations[-1])
    reversed_ = low > high and road.period is None
    if low == high or reversed_ or low >= end or high <= 0:
        span = call.option_spans.get("over", call.span)
        raise DiagnosticError(interval_off_road(span, road.name, low, high, end))
    return _kept_window(road.stations.tobytes(), low, high, taper, road.period)


@lru_cache(maxsize=64)
def _kept_window(
    stations: bytes, low: float, high: float, taper: float, period: float | None
) -> Floats:
    """Kept, as pass after pass and batch after batch is often perturbed on the same interval."""
    return read_only(over(np.frombuffer(stations), low, high, taper, period))
