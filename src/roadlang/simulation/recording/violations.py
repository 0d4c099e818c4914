"""Which drives have violated all that is expected of them, whatever happens next."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...diagnostics import DiagnosticError
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene
from ...plugins.registry import KindEntry
from ..signals.pending_samples import PendingSamples
from ..signals.recorded_samples import RecordedSample
from ..signals.triggers import PlacedCondition, Trigger, conditions_by_form
from ..state.world import World

_ROUNDING = 1e-9
"""Seconds by which sums of time steps may differ."""


class ViolationWatch:
    """Looks at every sample, at as many together as it can. An expectation is violated for certain
    once it is `always p` and `p` is false; a scene with an expectation of another form is never
    done."""

    def __init__(self, world: World, signals: Mapping[str, KindEntry], patience: float) -> None:
        """`signals`: drive signals by the names that scenes have for them; `patience`: seconds that
        a drive goes on after its last expectation was violated; infinite: always to its end."""
        self._patience = patience
        self._slots = world.slots
        self._watched: list[_Watched] = []
        self._open = np.zeros(len(world.scenes), dtype=np.int64)
        """expectations that are not violated yet; -1 where there are none"""
        self._violated_at = np.full(len(world.scenes), -math.inf)
        """when the last of those that are violated was"""
        self._pending = PendingSamples(world)
        if math.isfinite(patience):
            self._watch(world, signals)
        self.is_idle = not self._watched
        """whether no sample is looked at"""

    def done(self, time: float, sample: RecordedSample) -> Booleans | None:
        """(S,) scenes that have violated everything for long enough; None where there are none.

        To be called at every sample, in order.
        """
        if self.is_idle:
            return None
        self._pending.add(time, sample)
        if self._is_over(time - self._pending.times[0]):
            self._look()
        violated = self._open == 0
        if not np.count_nonzero(violated):
            return None
        return np.asarray(violated & self._is_over(time - self._violated_at))

    def take(self, scenes: Integers, place: Integers, agents: Integers) -> None:
        """From now on the world has these of its scenes alone. `place`: (N,) where its agents are
        now, -1 for no more; `agents`: those that stay."""
        self._open, self._violated_at = self._open[scenes], self._violated_at[scenes]
        self._pending.take(agents)
        for watched in self._watched:
            watched.take(place, agents)

    def _is_over(self, seconds: Any) -> Any:
        return seconds > self._patience - _ROUNDING

    def _look(self) -> None:
        """At all samples that nobody has looked at yet."""
        for watched in list(self._watched):
            new = watched.newly_violated(self._pending)
            if new is None:
                self._watched.remove(watched)
                continue
            scenes = new[0] // self._slots
            self._open[scenes] -= 1
            self._violated_at[scenes] = np.maximum(self._violated_at[scenes], new[1])
        self._pending.clear()

    def _watch(self, world: World, signals: Mapping[str, KindEntry]) -> None:
        found: list[PlacedCondition] = []
        for number, scene in enumerate(world.scenes):
            expected = list(_expected(scene))
            self._open[number] = len(expected) or -1
            first = number * world.slots
            found += [(at, first, part) for at, part in enumerate(expected) if part is not None]
        for form in conditions_by_form(found):
            trigger = _trigger(form, world, signals)
            if trigger and not any(signal.looks_back for signal in trigger.signals.values()):
                self._watched.append(_Watched(trigger, np.zeros(len(trigger.rows), bool)))


def _trigger(
    form: list[PlacedCondition], world: World, signals: Mapping[str, KindEntry]
) -> Trigger | None:
    """Of those conditions that are known step by step; scenes with others go on to their ends."""
    try:
        return Trigger.of(form, world, signals, latched=False)
    except DiagnosticError:
        if len(form) == 1:
            return None
    known = [one for one in form if _trigger([one], world, signals)]
    return Trigger.of(known, world, signals, latched=False) if known else None


@dataclass
class _Watched:
    """What has to be true at every sample, of one form, in some scenes."""

    trigger: Trigger
    violated: Booleans

    def newly_violated(self, samples: PendingSamples) -> tuple[Integers, Floats] | None:
        """The first agents of scenes in which it is violated for the first time, and when; None
        where it cannot be evaluated step by step."""
        try:
            holds, failed = self.trigger.held(samples)
        except DiagnosticError:  # of the formula, the same in every scene
            return None
        # A scene whose signal fails goes on to its end; the fault is reported when it is judged.
        violated = ~holds & ~failed
        new = violated.any(axis=0) & ~self.violated
        self.violated |= new
        first = np.argmax(violated[:, new], axis=0)
        return self.trigger.rows[new], np.array(samples.times)[first]

    def take(self, place: Integers, agents: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        self.violated = self.violated[place[self.trigger.rows] >= 0]
        self.trigger.take(place, agents)


def _expected(scene: Scene) -> Iterator[Mapping[str, Any] | None]:
    """Of each expectation of the drive what has to be true at every sample; None of other forms."""
    for verdict in scene.expectations:
        if verdict.domain != "drive":
            continue
        form = verdict.formula or {}
        formula = form.get("formula")
        if isinstance(formula, Mapping) and list(formula) == ["always"]:
            yield {**form, "formula": formula["always"]}
        else:
            yield None
