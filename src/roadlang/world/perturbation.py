"""Runs `perturb` passes on batches of roads, on a stretch where they say so, and checks them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import build, evaluate
from ..evaluate.kind_instance import KindInstance, row_of_kind
from ..geometry import Window, displace, over
from ..ir.batch import BatchRandom, RoadBatch
from ..ir.values import PassCall
from ..plugins.guard import wrong_result
from ..plugins.kinds import implements
from .stations import is_still

Floats = NDArray[np.float64]
FARTHEST = 1e6
_ROUNDING = 1e-9


def perturbed(
    before: RoadBatch,
    call: PassCall,
    candidates: CandidateBatch,
    element: int = 0,
    window: Window | None = None,
) -> RoadBatch:
    """A road after one pass. `window` fades the displacement at junctions.

    Raises RL470, RL474 (plugin_guard the kind) and RL414 for a stretch that is none.
    """
    built = build(call, candidates, element)
    stretch = _stretch(call, candidates, element)
    seen = before if stretch is None else replace(before, stretch=stretch)
    moves = _displacements(built, seen, candidates.random(call.place, element), candidates)
    if stretch is not None:
        moves = moves * _over(call, stretch, before, candidates, element)
    if window is not None:
        moves = window.value * moves
    return displaced(before, moves)


def displaced(before: RoadBatch, moves: Floats) -> RoadBatch:
    """A road moved along its normal by `moves` (V, S)."""
    if is_still(before):
        curves = displace(before.curves.frame, before.stations, moves)  # type: ignore[attr-defined]
        return replace(before, curves=curves, displacement=moves)
    curves = displace(before.curves, before.stations, moves)
    return replace(before, curves=curves, displacement=before.displacement + moves)


def _displacements(
    built: KindInstance, road: RoadBatch, random: BatchRandom, candidates: CandidateBatch
) -> Floats:
    kind = built.kind
    stations = len(road.stations)
    if implements(type(kind), "displacements"):
        with built.guarded:
            moves = np.asarray(kind.displacements(road, random), dtype=np.float64)
        if moves.shape == (stations,):  # no option is random: alike in all candidates
            moves = moves[None, :]
        if moves.shape not in ((1, stations), (candidates.count, stations)):
            fault = (
                f"gave displacements of shape {moves.shape}, not ({candidates.count}, {stations})"
            )
            raise wrong_result(built.entry, built.call.span, fault)
    else:
        moves = np.stack([_displacement(built, road, random, i) for i in range(candidates.count)])
    if not np.isfinite(moves).all():
        raise wrong_result(
            built.entry, built.call.span, "gave displacements that are not finite numbers"
        )
    _check_size(moves, built, road)
    return moves


def _check_size(moves: Floats, built: KindInstance, road: RoadBatch) -> None:
    """Raises RL474 for a displacement beyond what the kind states, or beyond all measure."""
    farthest = np.abs(moves).max(axis=1, keepdims=True, initial=0.0)
    if farthest.max(initial=0.0) > FARTHEST:
        raise wrong_result(
            built.entry, built.call.span, f"moved `{road.name}` by more than {FARTHEST:g} m"
        )
    with built.guarded:
        bound = np.asarray(built.kind.displacement_bound(), dtype=np.float64).reshape(-1, 1)
    beyond = farthest > bound + _ROUNDING * np.maximum(1.0, bound)
    if beyond.any():
        row = int(np.flatnonzero(beyond.any(axis=1))[0])
        stated = float(np.broadcast_to(bound, farthest.shape)[row, 0])
        fault = f"moved `{road.name}` by {farthest[row, 0]:g} m, beyond its bound of {stated:g} m"
        raise wrong_result(built.entry, built.call.span, fault)


def _displacement(built: KindInstance, road: RoadBatch, random: BatchRandom, row: int) -> Floats:
    """(S,) meters of one variant."""
    one = road.take(np.array([row if road.variants > 1 else 0]))
    kind = row_of_kind(built.kind, row)
    with built.guarded:
        moves = np.asarray(kind.displacement(one, random.generator(row)), dtype=np.float64)
    stations = len(road.stations)
    # What is computed of `road.length` or `road.curvature` has the one row of the road.
    if moves.shape not in ((stations,), (1, stations)):
        raise wrong_result(
            built.entry,
            built.call.span,
            f"gave displacements of shape {moves.shape}, not ({stations},)",
        )
    return moves.reshape(stations)


def _stretch(call: PassCall, candidates: CandidateBatch, element: int) -> tuple[Any, Any] | None:
    given = dict(call.common).get("over")
    if given is None:
        return None
    low, high = evaluate(given, candidates, element)
    return low, high


def _over(
    call: PassCall,
    stretch: tuple[Any, Any],
    road: RoadBatch,
    candidates: CandidateBatch,
    element: int,
) -> Floats:
    """(S,) or (V, S): one on the stretch, fading out over `taper` meters inside its ends."""
    given = dict(call.common).get("taper")
    taper = 0.0 if given is None else evaluate(given, candidates, element)
    columns = np.broadcast_arrays(*(np.asarray(item, float) for item in (*stretch, taper)))
    rows = [
        _window(call, road, *map(float, row)) for row in zip(*map(np.ravel, columns), strict=True)
    ]
    return rows[0] if len(rows) == 1 else np.stack(rows)


def _window(call: PassCall, road: RoadBatch, low: float, high: float, taper: float) -> Floats:
    end = float(road.period if road.period is not None else road.stations[-1])
    if (low > high and road.period is None) or low >= end or high <= 0:
        raise DiagnosticError(
            diagnose(
                Code.INTERVAL_OFF_ROAD,
                call.span,
                stretch=f"[{low:g}m, {high:g}m]",
                road=road.name,
                length=f"{end:.1f}m",
            )
        )
    return over(road.stations, low, high, taper, road.period).value
