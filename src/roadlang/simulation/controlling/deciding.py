"""What the controllers of a group decide, now or for a time."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ...geometry.arrays import Booleans, Integers
from ...ir.control import ControlBatch
from ..calling.option_columns import options_of
from ..observing.observing import View
from ..observing.single_agents import OthersSeen, observations
from .controller_groups import Group


def decided(
    group: Group,
    chosen: Integers,
    view: View,
    lasting: Booleans | None = None,
    moves: Booleans | None = None,
) -> ControlBatch:
    """What the controllers of some agents of a group decide. `lasting`: whose state goes on,
    by default that of all. `moves`: whose state also goes on if the controllers move lines."""
    if group.singles:
        return _decided_singly(group, chosen, view)
    interval = group.controller.kind.interval
    if interval > view.step:
        return _held(group, chosen, view)
    return _decided_now(group, chosen, view, lasting, moves)


@dataclass(frozen=True)
class Lasting:
    """For how long decisions of some agents of a group hold: seconds."""

    since: float
    """when who has not decided for longest did"""
    interval: float

    @classmethod
    def of(cls, group: Group, chosen: Integers, dt: float) -> Lasting:
        """From what these agents decided last. `dt`: of a step of the vehicles."""
        return cls(float(group.since[chosen].min()), _interval(group, dt))

    def is_over(self, time: float) -> bool:
        """Whether any of them decides anew."""
        return time - self.since > self.interval


def _interval(group: Group, dt: float) -> float:
    """Seconds after which agents of a group decide anew."""
    return group.controller.kind.interval - 0.5 * dt


def _held(group: Group, chosen: Integers, view: View) -> ControlBatch:
    """What some agents decided when they did last, or do now."""
    time = view.world.time
    again = (time - group.since[chosen] > _interval(group, view.world.dt)).nonzero()[0]
    if not len(again):
        return group.last_decided(chosen)
    now = _decided_now(group, chosen[again], view)
    group.hold(chosen[again], now, time)
    if len(again) == len(chosen) and _is_plain(now):
        return now
    failures = {int(again[place]): reason for place, reason in (now.failures or {}).items()}
    return replace(group.last_decided(chosen), failures=failures)


def _is_plain(decided: ControlBatch) -> bool:
    """Whether it has no columns other than steering and acceleration."""
    others = (
        decided.heading, decided.line_offset, decided.line_time, decided.acceleration_limit,
        decided.pose, decided.failures,
    )  # fmt: skip
    return all(one is None for one in others)


def _decided_now(
    group: Group,
    chosen: Integers,
    view: View,
    lasting: Booleans | None = None,
    moves: Booleans | None = None,
) -> ControlBatch:
    rows = group.rows[chosen]
    guarded = group.controller
    everyone = len(chosen) == len(group.rows)
    built = group.of_all if everyone else guarded.built(options_of(group.columns, chosen))
    state = None if group.state is None else group.state[chosen]
    found = guarded.decide(built, view.of(rows), state)
    if state is not None:
        if lasting is not None and moves is not None and found.line_offset is not None:
            lasting = lasting | moves
        last = slice(None) if lasting is None else np.flatnonzero(lasting)
        group.state[chosen[last]] = state[last]
    return found


def _decided_singly(group: Group, chosen: Integers, view: View) -> ControlBatch:
    """Loop over agents whose controllers decide for one alone."""
    slots = view.world.slots
    rows = group.rows[chosen]
    scenes = rows // slots
    found = []
    for scene in dict.fromkeys(scenes.tolist()):  # the rows are in the order of the scenes
        of_scene = scenes == scene
        others = OthersSeen(view, view.world.scenes[scene], scene * slots)
        seen = observations(view, rows[of_scene], others)
        found += [group.singles[index].control(observation)
                  for index, observation in zip(chosen[of_scene], seen, strict=True)]  # fmt: skip
    return ControlBatch.of(found)
