"""Where agents and objects are once they are placed, for many candidates or for one."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...geometry.arrays import Floats, Integers
from ...ir.placed_batch import PlacedBatch
from ...ir.scenario import ScenarioActor
from ..placement_faults import DEFAULT_APART
from ..roads.named_roads import name_of_road
from ..roads.roads import road_batch
from .copies import counts, is_group, most_copies
from .placement_order import can_be_placed_again, placement_order
from .placement_without_overlap import Arrangement
from .positions import starts_of
from .relative_lanes import may_be_missing
from .room_between import COPY
from .routes import routes_of
from .spots import NoPlace, shortfall

FAR = 1e9
"""Meters to the end of a road that nothing can be beyond"""


def placed(actor: ScenarioActor, candidates: CandidateBatch) -> PlacedBatch:
    """Where every copy of an agent or object is."""
    return _arrangement(candidates).batch(actor)


def placed_routes(actor: ScenarioActor, candidates: CandidateBatch) -> NDArray[Any]:
    """(V, N) the routes of an agent: see `routes_of`."""
    return routes_of(actor, candidates, _arrangement(candidates).batch)


def _arrangement(candidates: CandidateBatch) -> Arrangement:
    make = candidates.once
    return make("arrangement", lambda: Arrangement(candidates), inherited=False)


def placed_copy(actor: ScenarioActor, candidates: CandidateBatch, copy: int = 1) -> PlacedBatch:
    """(V, 1) where a copy (counted from 1) of an agent or object is. Of a copy that no candidate
    has only `start` is known: where it would be."""
    number = copy if is_group(actor) else 1
    if number <= most_copies(actor, candidates):
        return placed(actor, candidates).copy(number)
    numbers = np.full(candidates.count, number)
    copies = CopyBatch(candidates, np.arange(candidates.count), numbers)
    others = _arrangement(candidates).batch
    on_road = actor.on in candidates.scenario.roads
    start = starts_of(actor, copies, others) if on_road else np.full(candidates.count, np.nan)
    nothing, no = np.full((candidates.count, 1), np.nan), np.zeros((candidates.count, 1), bool)
    lane = no.astype(np.int64)
    x = y = heading = length = width = offset = nothing
    return PlacedBatch(no, x, y, heading, length, width, start[:, None], offset, lane, no, lane - 1)


def room_on_road(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    """(V,) meters from where each copy begins to the nearer end of its road; the least of all. In a
    network it is below zero where a point is far from every lane, or no way leads on.

    What can be placed again does so until it is on the road: see `room_among_others`.
    """
    assert actor.on is not None
    most = most_copies(actor, candidates)
    if most == 0 or can_be_placed_again(actor, candidates):
        return np.full(candidates.count, FAR)
    if actor.on in candidates.scenario.networks:
        return _room_of_lanes(actor, candidates)
    # Arc lengths alone take much less work than whole places.
    room = np.full(candidates.count, FAR)
    if may_be_missing(actor, candidates.scenario):
        room = _room_of_lanes(actor, candidates)
    if road_batch(actor.on, candidates).closed:
        return room
    return np.asarray(np.minimum(_inside_road(actor, candidates).min(axis=1), room))


def _inside_road(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    """(V, N) meters from each copy to the nearer end of its road, negative beyond it; `FAR` of
    copies that are not there."""
    assert actor.on is not None
    road, most = road_batch(actor.on, candidates), most_copies(actor, candidates)
    copies = CopyBatch.every(candidates, most)
    start = starts_of(actor, copies, _arrangement(candidates).batch)
    start = start.reshape(candidates.count, most)
    inside = np.minimum(start, road.length - start)
    # The last station is the end: rounding must not put 100% beyond it.
    inside = np.where(inside > -1e-9 * road.length, np.maximum(inside, 0.0), inside)
    present = np.arange(1, most + 1) <= counts(actor, candidates)[:, None]
    return np.where(present, inside, FAR)


def lacking_road(actor: ScenarioActor, candidates: CandidateBatch) -> tuple[int, float] | None:
    """The copy of a group that is farthest beyond the end of its road in the first candidate, and
    by how many meters; None where all are on their roads, or one has no place at all."""
    if actor.on in candidates.scenario.networks:
        if (_no_place(actor, candidates)[0] != NoPlace.HAS_ONE).any():
            return None
        beyond = _lacking_of_lanes(actor, candidates)[0]
    else:
        beyond = -_inside_road(actor, candidates)[0]
    copy = int(beyond.argmax())
    return (copy, float(beyond[copy])) if beyond[copy] > 0.0 else None


def why_no_place(actor: ScenarioActor, candidates: CandidateBatch) -> NoPlace:
    """Why a copy has no place at all in the first candidate; the first of those that have none."""
    found = _no_place(actor, candidates)[0]
    without = found[found != NoPlace.HAS_ONE]
    return NoPlace(int(without[0])) if len(without) else NoPlace.HAS_ONE


def missing_lane(actor: ScenarioActor, candidates: CandidateBatch) -> tuple[str, int] | None:
    """The road of a copy in the first candidate that does not have the lane that another decides
    for it, and the number of that lane; None where there is none."""
    found = _arrangement(candidates).placed(actor)
    lanes = np.where(found["present"].astype(bool), found["missing_lane"], 0)[0]
    lacking = np.flatnonzero(lanes)
    if not len(lacking):
        return None
    copy = int(lacking[0])
    return str(name_of_road(actor, int(found["road"][0, copy]))), int(lanes[copy])


def _room_of_lanes(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    lacking = _lacking_of_lanes(actor, candidates).max(axis=1)
    return np.where(lacking > 0.0, -lacking, FAR)


def _lacking_of_lanes(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    """(V, N) meters that each copy is beyond the lanes, or what counts where it has no place."""
    found = _arrangement(candidates).placed(actor)
    lacking = np.where(found["present"].astype(bool), found["lacking"], 0.0)
    return shortfall(lacking, _no_place(actor, candidates))


def _no_place(actor: ScenarioActor, candidates: CandidateBatch) -> Integers:
    """(V, N) see `NoPlace`."""
    found = _arrangement(candidates).placed(actor)
    present = found["present"].astype(bool)
    return np.where(present, found["no_place"], NoPlace.HAS_ONE).astype(np.int64)


def room_among_others(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    """(V,) 0 where every copy found a place clear of what was placed before; else below zero, the
    meters that it lacks."""
    if candidates.record is None and _is_in_nobodys_way(actor, candidates):
        return np.full(candidates.count, -0.0)  # wherever it is: that need not be found
    found = _arrangement(candidates).placed(actor)
    missing = np.where(found["present"].astype(bool), found["missing"], 0.0)
    return np.asarray(-missing.max(axis=1, initial=0.0))


def _is_in_nobodys_way(actor: ScenarioActor, candidates: CandidateBatch) -> bool:
    """Whether it is one alone, placed first and once and for all."""
    is_first = placement_order(candidates.scenario)[0].name == actor.name
    return is_first and not is_group(actor) and not can_be_placed_again(actor, candidates)


def placed_tries(actor: ScenarioActor, candidates: CandidateBatch) -> Integers:
    """(V, N) at which try each copy was placed: `known_tries` of candidates placed alike."""
    return np.asarray(_arrangement(candidates).placed(actor)["tries"])


def blocker_of(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """The name of what a copy is too near to in the first candidate where it does not fit; None
    where that is no agent or object. A copy may be too near to another of its own."""
    arrangement = _arrangement(candidates)
    found = arrangement.placed(actor)
    blockers = found["blocker"][found["missing"] > 0.0]
    number = int(blockers[0]) if len(blockers) else -1
    if number == COPY:
        return actor.name
    return arrangement.order[number].name if number >= 0 else None


def least_spacing(actor: ScenarioActor, candidates: CandidateBatch) -> float:
    """Meters from center to center at which copies in a row keep clear of each other, whichever
    they are."""
    found = _arrangement(candidates).placed(actor)
    apart = np.where(np.isfinite(found["apart"]), found["apart"], DEFAULT_APART)
    return float(np.nanmax(found["length"] + apart))
