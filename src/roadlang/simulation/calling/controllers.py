"""Controllers of agents, guarded: one that fails is named with its plugin, wherever it drives."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from operator import attrgetter
from typing import Any

import numpy as np

from ...diagnostics import Span
from ...geometry.arrays import Floats
from ...ir.actuation import ActuationBatch
from ...ir.control import Control, ControlBatch
from ...ir.observation import Observation, ObservationBatch
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.kinds import Controller, implements
from ...plugins.registry import KindEntry
from ...plugins.results import real_numbers
from .plugin_states import first_state
from .sensors import GuardedSensor

UNDRIVEN_BRAKING = 4.0
"""m/s^2: what nobody drives brakes."""


_NUMBERS = ("steering", "acceleration", "heading", "line_offset", "line_time")
_numbers_of = attrgetter(*_NUMBERS)
_PLAIN = frozenset((float,))
_OTHERS = ("heading", "line_offset", "line_time", "acceleration_limit")
_others_of = attrgetter(*_OTHERS)


class GuardedController(Controller):
    """A controller with its options. It keeps its state from one `control` to the next. `span`:
    where it is written, if that is known."""

    def __init__(
        self,
        kind: type[Controller],
        options: Mapping[str, Any],
        entry: KindEntry,
        span: Span | None = None,
    ) -> None:
        self.kind = kind
        self.options = dict(options)
        self.entry = entry
        self.span = span
        self._single: Controller | None = None
        self._state: Any = None

    def anew(self) -> GuardedController:
        """The same controller, which remembers nothing."""
        return GuardedController(self.kind, self.options, self.entry, self.span)

    def for_several(self, spans: Collection[Span | None]) -> GuardedController:
        """One that is called for all that are written at some places: which of them is at fault
        is not known."""
        span = self.span if len(set(spans)) == 1 else None
        return GuardedController(self.kind, self.options, self.entry, span)

    def carry_on(self, before: GuardedController) -> None:
        """Remember what another controller of this kind, with perhaps other options, does. Raises
        RL470."""
        if before._single is None:
            return
        self._state, self._single = before._state, before._single
        if self.options != before.options:
            self._single = self.built(self.options)
            for name, value in getattr(before._single, "__dict__", {}).items():
                if name not in self.options:  # kinds are frozen, what they remember is not
                    object.__setattr__(self._single, name, value)

    @property
    def in_batches(self) -> bool:
        """Whether it decides for many agents at once."""
        return implements(self.kind, "controls")

    @property
    def alters(self) -> bool:
        """Whether it changes what others decide."""
        return implements(self.kind, "altered")

    def alter(
        self, controller: Controller, wanted: ActuationBatch, state: Any
    ) -> tuple[Floats, Floats]:
        """Steering and acceleration in place of those that are wanted. Raises RL470, RL474."""
        with plugin_guard(self.entry, self.span):
            steering, acceleration = controller.altered(wanted, state)
        count = len(wanted.steering)
        found = (
            self._column(steering, "steering", count),
            self._column(acceleration, "acceleration", count),
        )
        if not all(np.isfinite(column).all() for column in found):
            raise wrong_result(self.entry, self.span, "gave controls that are not finite")
        return found

    def built(self, options: Mapping[str, Any]) -> Controller:
        """The controller with other options, which may be columns. Raises RL470."""
        with plugin_guard(self.entry, self.span):
            return self.kind(**options)

    def control(self, observation: Observation) -> Control:
        """What the controller decides. Raises DiagnosticError RL470, RL474."""
        if self._single is None:
            self._single = self.built(self.options)
            self._state = self.first_state(self._single, 1)
        if implements(self.kind, "control"):
            return self._checked(observation)
        batch = ObservationBatch.of_single(observation)
        return _only(self.decide(self._single, batch, self._state))

    def first_state(self, controller: Controller, count: int) -> Any:
        """The state of `count` agents at the start. Raises RL470, RL474."""
        return first_state(self.entry, self.span, controller, count)

    def decide(self, controller: Controller, seen: ObservationBatch, state: Any) -> ControlBatch:
        """What the controller decides for a batch. Raises RL470, RL474."""
        with plugin_guard(self.entry, self.span):
            decided: Any = controller.controls(seen, state)
        if not isinstance(decided, ControlBatch):
            fault = f"gave a {type(decided).__name__}, not a ControlBatch"
            raise wrong_result(self.entry, self.span, fault)
        count = len(seen.x)
        steering = self._column(decided.steering, "steering", count)
        acceleration = self._column(decided.acceleration, "acceleration", count)
        if _have_infinite(steering, acceleration):
            raise wrong_result(self.entry, self.span, "gave controls that are not finite")
        others = {
            name: self._column(value, name, count)
            for name, value in zip(_OTHERS, _others_of(decided), strict=True)
            if value is not None
        }
        pose = None if decided.pose is None else self._poses(decided.pose, count)
        failures = self._failures(decided.failures, count)
        return ControlBatch(steering, acceleration, pose=pose, failures=failures, **others)

    def _failures(self, reasons: Any, count: int) -> Mapping[int, str] | None:
        if not reasons:
            return None
        if not isinstance(reasons, Mapping) or not all(
            place in range(count) and isinstance(reason, str) for place, reason in reasons.items()
        ):
            fault = f"gave failures that are not texts by index in a batch of {count}: {reasons!r}"
            raise wrong_result(self.entry, self.span, fault)
        return {int(place): reason for place, reason in reasons.items()}

    def _poses(self, values: Any, count: int) -> Floats:
        numbers = real_numbers(values, "poses", self.entry, self.span)
        if numbers.shape != (count, 4):
            fault = f"gave poses of shape {numbers.shape}, not {(count, 4)}"
            raise wrong_result(self.entry, self.span, fault)
        return numbers

    def _column(self, values: Any, what: str, count: int) -> Floats:
        numbers = real_numbers(values, what, self.entry, self.span)
        if numbers.shape != (count,):
            fault = f"gave {what} of shape {numbers.shape}, not {(count,)}"
            raise wrong_result(self.entry, self.span, fault)
        return numbers

    def _checked(self, observation: Observation) -> Control:
        assert self._single is not None
        with plugin_guard(self.entry, self.span):
            decision: Any = self._single.control(observation)
        if not isinstance(decision, Control):
            fault = f"gave a {type(decision).__name__}, not a Control"
            raise wrong_result(self.entry, self.span, fault)
        numbers = _numbers_of(decision)
        control = decision
        if not _PLAIN.issuperset(map(type, numbers)):
            with plugin_guard(self.entry, self.span):
                plain: dict[str, Any] = dict(zip(_NUMBERS, map(float, numbers), strict=True))
                control = replace(decision, **plain)
        if not (math.isfinite(control.steering) and math.isfinite(control.acceleration)):
            raise wrong_result(self.entry, self.span, f"gave {decision}, which is not finite")
        return control


def _have_infinite(one: Floats, other: Floats) -> bool:
    with np.errstate(invalid="ignore", over="ignore"):
        product = one.dot(other)
    if math.isfinite(product):  # so is every number of both: one look at most columns
        return False
    return bool(np.isinf(one).any() or np.isinf(other).any())


def _only(batch: ControlBatch) -> Control:
    """The decision of a batch of one agent."""

    def number(column: Floats | None, default: float) -> float:
        return default if column is None else float(column[0])

    pose = None
    if batch.pose is not None and math.isfinite(batch.pose[0, 0]):
        x, y, heading, speed = batch.pose[0].tolist()
        pose = (x, y, heading, speed)
    return Control(
        float(batch.steering[0]), float(batch.acceleration[0]), number(batch.heading, math.nan),
        number(batch.line_offset, math.nan), number(batch.line_time, 0.0), pose,
        (batch.failures or {}).get(0, ""),
    )  # fmt: skip


class Driver(Controller):
    """What drives one agent: its controllers by their place in `SceneActor.drive`, None for those
    that are not written in Python; `steady` are the places of those without a condition;
    `signals`: the kinds of drive signals that their conditions name; `sensors`: those of the
    agent; `spans`: where they are written, by place."""

    def __init__(
        self,
        each: Mapping[int, GuardedController | None],
        steady: Sequence[int],
        signals: Mapping[str, KindEntry] | None = None,
        sensors: Sequence[GuardedSensor] = (),
        spans: Mapping[int, Span | None] | None = None,
    ) -> None:
        self.spans = dict(spans or {})
        self.sensors = tuple(sensors)
        self.each = each
        self.signals = dict(signals or {})
        self._steady = [each[place] for place in reversed(steady)]

    def control(self, observation: Observation) -> Control:
        """What the last controller without a condition decides, and where it leaves steering or
        acceleration open, those without a condition before it. Raises RL470, RL474."""
        found = Control(0.0, -UNDRIVEN_BRAKING)
        for place, controller in enumerate(self._steady):
            if controller is None:
                continue
            earlier = controller.control(observation)
            found = earlier if place == 0 else found.filled(earlier)
            if not found.is_open:
                break
        return found.filled(Control(0.0, 0.0)) if found.is_open else found
