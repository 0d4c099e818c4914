"""The controllers of a scene that are written in Python, ready to be asked."""

from __future__ import annotations

import math
from typing import Any

from ..ir.control import Control, Observation
from ..ir.scene import Scene, SceneActor
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Controller, implements
from ..plugins.options import schema_of
from ..plugins.registry import KindEntry, Registry


class Guarded(Controller):
    """A controller that is named with its plugin where it fails, wherever it drives."""

    def __init__(self, controller: Controller, entry: KindEntry) -> None:
        self._controller = controller
        self._entry = entry

    def control(self, observation: Observation) -> Control:
        """What the controller decides. Raises DiagnosticError RL470, RL474."""
        with plugin_guard(self._entry, None):
            decision: Any = self._controller.control(observation)
        if not isinstance(decision, Control):
            fault = f"gave a {type(decision).__name__}, not a Control"
            raise wrong_result(self._entry, None, fault)
        with plugin_guard(self._entry, None):
            control = Control(float(decision.steering), float(decision.acceleration))
        if not (math.isfinite(control.steering) and math.isfinite(control.acceleration)):
            raise wrong_result(self._entry, None, f"gave {control}, which is not finite")
        return control


def python_controllers(scene: Scene, registry: Registry) -> dict[str, Controller]:
    """Agent to its controller, where the last unconditional one implements `control`."""
    found = {}
    for actor in scene.agents:
        controller = _controller(actor, registry)
        if controller is not None:
            found[actor.name] = controller
    return found


def _controller(actor: SceneActor, registry: Registry) -> Controller | None:
    steady = [call for call in actor.drive if call.when is None]
    if not steady or not registry.has("drive", steady[-1].kind):
        return None
    entry = find_entry(registry, "drive", steady[-1].kind)
    with plugin_guard(entry, None):
        kind = entry.load()
        if not issubclass(kind, Controller) or not implements(kind, "control"):
            return None
        names = {option.name for option in schema_of(kind)}
        options = {key: value for key, value in steady[-1].options.items() if key in names}
        return Guarded(kind(**options), entry)
