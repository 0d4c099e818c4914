"""Controllers of agents, guarded: one that fails is named with its plugin, wherever it drives."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from ..ir.control import Control, ControlBatch, Observation, ObservationBatch
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Controller, implements
from ..plugins.registry import KindEntry
from ..plugins.results import real_numbers

UNDRIVEN_BRAKING = 4.0
"""m/s^2: what nobody drives brakes."""


class GuardedController(Controller):
    """A controller with its options. It keeps its state from one `control` to the next."""

    def __init__(
        self, kind: type[Controller], options: Mapping[str, Any], entry: KindEntry
    ) -> None:
        self.kind = kind
        self.options = dict(options)
        self.entry = entry
        self._single: Controller | None = None
        self._state: Any = None

    @property
    def in_batches(self) -> bool:
        """Whether it decides for many agents at once."""
        return implements(self.kind, "controls")

    def built(self, options: Mapping[str, Any]) -> Controller:
        """The controller with other options, which may be columns. Raises RL470."""
        with plugin_guard(self.entry, None):
            return self.kind(**options)

    def control(self, observation: Observation) -> Control:
        """What the controller decides. Raises DiagnosticError RL470, RL474."""
        if self._single is None:
            self._single = self.built(self.options)
            self._state = self.first_state(self._single, 1)
        if implements(self.kind, "control"):
            return self._checked(observation)
        batch = ObservationBatch.of_one(observation)
        decided = self.decide(self._single, batch, self._state)
        heading = math.nan if decided.heading is None else float(decided.heading[0])
        return Control(float(decided.steering[0]), float(decided.acceleration[0]), heading)

    def first_state(self, controller: Controller, count: int) -> Any:
        """The state of `count` agents at the start. Raises RL470, RL474."""
        with plugin_guard(self.entry, None):
            state = controller.start(count)
        if state is not None and (not isinstance(state, np.ndarray) or len(state) != count):
            raise wrong_result(self.entry, None, f"gave a state that is no array of {count} rows")
        return state

    def decide(self, controller: Controller, seen: ObservationBatch, state: Any) -> ControlBatch:
        """What the controller decides for a batch. Raises RL470, RL474."""
        with plugin_guard(self.entry, None):
            decided: Any = controller.controls(seen, state)
        if not isinstance(decided, ControlBatch):
            fault = f"gave a {type(decided).__name__}, not a ControlBatch"
            raise wrong_result(self.entry, None, fault)
        steering = self._column(decided.steering, "steering", len(seen.x))
        acceleration = self._column(decided.acceleration, "acceleration", len(seen.x))
        if not np.isfinite(acceleration).all() or np.isinf(steering).any():
            raise wrong_result(self.entry, None, "gave controls that are not finite")
        heading = None
        if decided.heading is not None:
            heading = self._column(decided.heading, "heading", len(seen.x))
        return ControlBatch(steering, acceleration, heading)

    def _column(self, values: Any, what: str, count: int) -> Floats:
        numbers = real_numbers(values, what, self.entry, None)
        if numbers.shape != (count,):
            fault = f"gave {what} of shape {numbers.shape}, not {(count,)}"
            raise wrong_result(self.entry, None, fault)
        return numbers

    def _checked(self, observation: Observation) -> Control:
        assert self._single is not None
        with plugin_guard(self.entry, None):
            decision: Any = self._single.control(observation)
        if not isinstance(decision, Control):
            fault = f"gave a {type(decision).__name__}, not a Control"
            raise wrong_result(self.entry, None, fault)
        with plugin_guard(self.entry, None):
            steering, acceleration = float(decision.steering), float(decision.acceleration)
            control = Control(steering, acceleration, float(decision.heading))
        if not (math.isfinite(control.steering) and math.isfinite(control.acceleration)):
            raise wrong_result(self.entry, None, f"gave {decision}, which is not finite")
        return control


class Driver(Controller):
    """What drives one agent: its controllers by their place in `SceneActor.drive`, None for those
    that are not written in Python; the last without a condition is at the place `steady`.
    `signals`: the kinds of drive signals that their conditions name."""

    def __init__(
        self,
        each: Mapping[int, GuardedController | None],
        steady: int | None,
        signals: Mapping[str, KindEntry] | None = None,
    ) -> None:
        self.each = each
        self.signals = dict(signals or {})
        self._steady = each[steady] if steady is not None else None

    def control(self, observation: Observation) -> Control:
        """What the last controller without a condition decides. Raises RL470, RL474."""
        if self._steady is None:
            return Control(0.0, -UNDRIVEN_BRAKING)
        return self._steady.control(observation)
