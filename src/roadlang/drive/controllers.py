"""The controllers of a scene that are written in Python, ready to be asked."""

from __future__ import annotations

from ..ir.scene import Scene, SceneActor
from ..plugins.kinds import Controller
from ..plugins.registry import Registry


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
    kind = registry.find("drive", steady[-1].kind).load()
    if not issubclass(kind, Controller) or kind.control is Controller.control:
        return None
    names = kind.__dataclass_fields__
    return kind(**{key: value for key, value in steady[-1].options.items() if key in names})
