"""The cameras of a scene and the labels of what they see, as parts to send."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..net.scene_part import ScenePart
from .label_parts import instances_of, label_parts
from .mounted_camera import MountedCamera

if TYPE_CHECKING:
    from roadlang.api import Scene


def camera_parts(
    scene: Scene,
    parts: Sequence[ScenePart],
    agents: Mapping[str, int],
    objects: Mapping[int, Sequence[str]],
    cameras: Sequence[MountedCamera],
) -> list[ScenePart]:
    """Cameras and the labels of the `parts` that are sent; nothing where there is no camera.

    `agents`: the engine's numbers by name; `objects`: names by the ids of their things.
    """
    if not cameras:
        return []
    labels = label_parts(parts, agents, objects, instances_of(scene, objects))
    numbered = enumerate(cameras, start=1)
    return labels + [camera.part(id, agents[camera.agent]) for id, camera in numbered]
