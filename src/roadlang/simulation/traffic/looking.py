"""One look at all agents on the way to junctions; compiled where numba is loaded, to the same
bits."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from ..junctions import crossings
from ..state.world import World
from ..vehicles import compiled
from . import approach_loops, approaches, asking, grants, remembering
from .approaches import Approaches
from .asking import Asking
from .crowd import Crowd
from .entrants import Ways
from .remembering import remember

LOOKS = 5_000
"""Looks at one agent by this process from which on the loop is used: about a minute of 20 agents.
It takes seconds to compile, once after an installation."""
_looked = [0]


def begun(world: World, ways: Ways) -> Approaches:
    """The crossings of some agents, which `looked` may still fill."""
    _looked[0] += len(ways.number)
    if not _is_compiled(world, ways):
        return Approaches.of(world, ways)
    shape = ways.number.shape
    (to_line, to_leave), truths = np.empty((2, *shape)), np.empty((3, *shape), dtype=bool)
    may_go, must_stop, is_over = truths
    return Approaches(to_line, to_leave, ways.number, may_go, must_stop, is_over, is_over)


def looked(world: World, crowd: Crowd) -> Asking:
    """Who asks to go, of a crowd whose crossings are `begun`; what is remembered of it is brought
    up to date."""
    ways = crowd.entrants.ways
    if not _is_compiled(world, ways):
        remember(crowd)
        return Asking.of(crowd)
    near, granted, entrants, count = crowd.near, crowd.grants, crowd.entrants, len(crowd.speed)
    truths, room = np.empty((3, count), dtype=bool), np.empty(count)
    slot, crossed = np.empty(count, dtype=np.int64), ways.crossings
    _loop()(
        (crossed.stop, crossed.exit, crossed.junction, (entrants.in_turn, entrants.is_short),
         ways.lights.members),
        (ways.half[:, 0], entrants.length, world.motion.along, crowd.speed, world.age,
         crowd.objects, crowd.gaps),
        (crowd.present, crowd.is_moving, crowd.obeys),
        (granted.order, granted.arrival, granted.has_stopped, granted.waiting),
        crowd.time,
        (near.to_line, near.to_leave, near.may_go, near.must_stop, near.is_over),
        (*truths, slot, room),
    )  # fmt: skip
    asks, comes, is_first = truths
    return Asking(asks, comes, slot, entrants.each, is_first, room)


def _is_compiled(world: World, ways: Ways) -> bool:
    """The loop is written for all agents of a world whose lines are open."""
    everyone = isinstance(ways.rows, slice)
    pays = _looked[0] > LOOKS and compiled.is_loaded()
    return everyone and not world.track.has_closed and pays


@cache
def _loop() -> Any:
    parts = (
        approaches.horizon, approach_loops.least_braking, approach_loops.approach,
        approach_loops.remember,
        approach_loops.take_back, approach_loops.ask_to_go, approach_loops.ahead,
        approach_loops.room_of,
    )  # fmt: skip
    # A call would copy all that is known of the arrays that it takes.
    compiled.register(parts, (approach_loops.looked,))
    said = approach_loops, approaches, asking, grants, remembering, crossings
    return compiled.compile_loop(approach_loops.looked, *said)
