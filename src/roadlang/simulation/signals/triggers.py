"""`when:` and `while:` of controllers: which of them are active, over all agents of a world."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from ...diagnostics import DiagnosticError, Span
from ...geometry.arrays import Booleans, Integers
from ...ir.scene import Call
from ...plugins.registry import KindEntry
from ..state.world import World
from ..vehicles.poses import Poses
from .conditions import ControllerCondition
from .pending_samples import PendingSamples
from .samples import Samples
from .signals import SignalCall

NO_SPANS: Mapping[tuple[int, int], Span] = MappingProxyType({})
PlacedCall = tuple[int, int, Call]
"""The place in the list of an agent, the column of the agent, and the call"""
PlacedCondition = tuple[int, int, Mapping[str, Any] | None]
"""A place, the column of an agent, and its condition there `{formula, signals, numbers}`"""


@dataclass
class Trigger:
    """Conditions of one form, at one place of the lists of R agents."""

    place: int
    rows: Integers
    condition: ControllerCondition
    signals: dict[str, SignalCall]
    latched: Booleans | None
    """of `when:`, which stays true once it is; None of `while:`"""
    span: Span | None = None
    """where their controller is written, if it is the same"""

    @classmethod
    def of(
        cls,
        form: Sequence[PlacedCondition],
        world: World,
        kinds: Mapping[str, KindEntry],
        *,
        latched: bool,
    ) -> Trigger:
        """Of conditions of one form. Raises RL513 for what is not known step by step."""
        conditions = [condition for _, _, condition in form if condition is not None]
        rows = np.array([row for _, row, _ in form], dtype=np.int64)
        scenes = (rows // world.slots).tolist()
        first = conditions[0]
        signals = {
            name: SignalCall(
                [member["signals"][name] for member in conditions], scenes, world, kinds
            )
            for name in first.get("signals", {})
        }
        numbers = {
            name: np.array([float(member["numbers"][name]) for member in conditions])
            for name in first.get("numbers", {})
        }
        condition = ControllerCondition(first["formula"], numbers, len(rows))
        past = np.zeros(len(rows), dtype=bool) if latched else None
        return cls(form[0][0], rows, condition, signals, past)

    def holds(self, samples: Samples, time: float) -> Booleans:
        """(R,) whose condition holds."""
        now = self.condition.now(time, lambda name: self.signals[name].values(samples))
        if self.latched is None:
            return now
        self.latched |= now
        return self.latched

    def held(self, samples: PendingSamples) -> tuple[Booleans, Booleans]:
        """(K, R) whether the condition, which is not latched, held at each of the samples, and
        whether a signal had failed until then. To be evaluated of every sample once, in order."""
        count = len(samples.times)
        if self.condition.is_pointwise:
            try:
                holds = self.condition.at_once(
                    count, lambda name: self.signals[name].at_once(samples, count)
                )
            except DiagnosticError:
                pass  # in one of the scenes: see which
            else:
                return holds, np.broadcast_to(self._failed, holds.shape)
        found = [self._known(samples.first(number + 1)) for number in range(count)]
        return np.stack([holds for holds, _ in found]), np.stack([failed for _, failed in found])

    def _known(self, samples: PendingSamples) -> tuple[Booleans, Booleans]:
        """(R,) the same of the last sample."""
        time = samples.times[-1]
        now = self.condition.now(time, lambda name: self.signals[name].known_values(samples))
        return now, self._failed

    @property
    def _failed(self) -> Booleans:
        failed = [signal.failed for signal in self.signals.values()]
        return np.asarray(np.logical_or.reduce([np.zeros(len(self.rows), dtype=bool), *failed]))

    def carry_on(self, agent: int, before: Trigger, at: int) -> None:
        """One of the agents goes on with what one of another trigger has seen."""
        if self.latched is not None and before.latched is not None:
            self.latched[agent] = before.latched[at]
        self.condition.carry_on(agent, before.condition, at)

    def take(self, place: Integers, agents: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        remaining = np.flatnonzero(place[self.rows] >= 0)
        for signal in self.signals.values():
            signal.take(remaining, agents, len(place))
        self.condition.take(remaining)
        self.rows = place[self.rows[remaining]]
        self.latched = None if self.latched is None else self.latched[remaining]


class Triggers:
    """Which controller of each agent is in charge: the last whose conditions all hold. `faults`:
    places and agents of what decides nothing, but has conditions too; `spans`: where
    controllers are written, by place and agent."""

    def __init__(
        self,
        world: World,
        calls: Sequence[PlacedCall],
        signals: Mapping[str, KindEntry],
        faults: Sequence[tuple[int, Integers]] = (),
        spans: Mapping[tuple[int, int], Span] = NO_SPANS,
    ) -> None:
        places = 1 + max((place for place, _, _ in calls), default=0)
        self._exists = np.zeros((places, len(world.present)), dtype=bool)
        for place, row, _ in calls:
            self._exists[place, row] = True
        self._decides = np.ones_like(self._exists)
        for place, rows in faults:
            self._decides[place, rows] = False
        starts = ((place, row, call.when) for place, row, call in calls)
        limits = ((place, row, call.during) for place, row, call in calls)
        self._triggers = [
            *_triggers(world, starts, signals, latched=True),
            *_triggers(world, limits, signals, latched=False),
        ]
        for trigger in self._triggers:
            written = {spans.get((trigger.place, row)) for row in trigger.rows.tolist()}
            trigger.span = written.pop() if len(written) == 1 else None
        self._number = np.arange(places)[:, None]
        self._always: Integers | None = None
        """what `in_charge` gives, where no condition changes it"""
        self.active = self._exists
        """(places, N) whose conditions all held at the last `in_charge`"""
        depths = [s.looks_back for t in self._triggers for s in t.signals.values()]
        self._samples = Samples(max(depths, default=0))

    @property
    def is_empty(self) -> bool:
        """Whether no controller has a condition."""
        return not self._triggers

    def in_charge(self, world: World, poses: Poses) -> Integers:
        """(N,) the place of the controller in charge, -1 for none."""
        if not self._triggers:
            if self._always is None:
                self._always = self._last(self._exists)
            return self._always
        active = self._exists.copy()
        self._samples.add(world, poses)
        for trigger in self._triggers:
            try:
                holds = trigger.holds(self._samples, world.time)
            except DiagnosticError as error:
                raise error.at(trigger.span) from error.__cause__
            active[trigger.place, trigger.rows] &= holds
        self.active = active
        return self._last(active)

    def _last(self, active: Booleans) -> Integers:
        """(N,) the last place that is active, -1 for none."""
        deciding = active & self._decides
        return np.asarray(np.where(deciding, self._number, -1).max(axis=0))

    def carry_on(
        self,
        before: Triggers,
        places: Mapping[tuple[int, int], tuple[int, int]],
        is_everyone: bool,
    ) -> None:
        """Conditions that an edit left as they were remember what has been. `places`: agent and
        place in its list now, and before; `is_everyone`: whether all agents are in their columns.
        """
        known = {
            (row, trigger.place, trigger.latched is None): (trigger, at)
            for trigger in before._triggers
            for at, row in enumerate(trigger.rows.tolist())
        }
        for trigger in self._triggers:
            for agent, row in enumerate(trigger.rows.tolist()):
                earlier = places.get((row, trigger.place))
                found = earlier and known.get((*earlier, trigger.latched is None))
                if found and found[0].condition.formula == trigger.condition.formula:
                    trigger.carry_on(agent, *found)
        if is_everyone:
            self._samples.carry_on(before._samples)

    def take(self, place: Integers, agents: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        for trigger in self._triggers:
            trigger.take(place, agents)
        self._samples.take(agents)
        self._exists, self._always = self._exists[:, agents], None
        self._decides = self._decides[:, agents]
        self.active = self.active[:, agents]


def _triggers(
    world: World,
    conditions: Iterable[PlacedCondition],
    signals: Mapping[str, KindEntry],
    *,
    latched: bool,
) -> list[Trigger]:
    forms = conditions_by_form(conditions)
    return [Trigger.of(form, world, signals, latched=latched) for form in forms]


def conditions_by_form(conditions: Iterable[PlacedCondition]) -> list[list[PlacedCondition]]:
    """Conditions of one form together: scenes of one file differ in their numbers alone."""
    members: dict[Any, list[PlacedCondition]] = {}
    texts: dict[Any, str] = {}
    for place, row, condition in conditions:
        if condition is not None:
            formula, numbers = condition["formula"], tuple(sorted(condition.get("numbers", {})))
            signals = condition.get("signals", {}).items()
            kinds = tuple((name, signal["kind"]) for name, signal in signals)
            shared = id(formula), kinds, numbers  # scenes of one search have the same formula
            if shared not in texts:
                texts[shared] = json.dumps([formula, dict(kinds), numbers], sort_keys=True)
            members.setdefault((place, texts[shared]), []).append((place, row, condition))
    return list(members.values())
