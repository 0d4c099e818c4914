"""Faults of actuators: what becomes of the controls that controllers have decided on."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Booleans, Integers
from ...ir.actuation import ActuationBatch
from ...ir.batch import BatchRandom, mix, numbered
from ..calling.decision import Decision
from ..state.world import World
from .controller_groups import Group


@dataclass
class Actuators:
    """The faults of the agents of a world, in the order of the scene file. `step`: seconds between
    decisions."""

    faults: Sequence[Group]
    step: float
    _keys: dict[int, tuple[Integers, NDArray[np.uint64]]] = field(default_factory=dict)
    """by number of a fault: the agents that it had, and what keys their random numbers"""

    def alter(self, world: World, active: Booleans, decision: Decision) -> None:
        """Change what is decided. `active` (places, N): whose conditions hold. Raises RL470,
        RL474."""
        if not self.faults:
            return
        steps = (world.tick - world.began) // max(1, round(self.step / world.dt))
        for number, group in enumerate(self.faults):
            rows = group.rows
            keys = numbered(self._keys_of(number, world), steps[rows])
            wanted = ActuationBatch(
                decision.steering[rows], decision.acceleration[rows],
                active[group.place, rows], self.step, BatchRandom(mix(keys)),
            )  # fmt: skip
            found = group.controller.alter(group.of_all, wanted, group.state)
            decision.steering[rows], decision.acceleration[rows] = found

    def _keys_of(self, number: int, world: World) -> NDArray[np.uint64]:
        group = self.faults[number]
        known = self._keys.get(number)
        if known is None or known[0] is not group.rows:
            keys = [_key(world, int(row), group.place) for row in group.rows]
            known = self._keys[number] = group.rows, np.array(keys, dtype=np.uint64)
        return known[1]


def _key(world: World, row: int, place: int) -> int:
    actor, made = world.actors[row], world.scenes[row // world.slots].provenance
    assert actor is not None
    words = (made.seed, made.scene, made.attempt, actor.name, "fault", place)
    digest = hashlib.blake2b(repr(words).encode(), digest_size=8).digest()
    return int.from_bytes(digest, "little")
