"""The cameras of a scene in an engine: what has to be sent, and looking through them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .camera_frames import CameraFrame, frames_of
from .label_parts import instances_of, label_parts
from .layout import Layout
from .mounted_camera import MountedCamera
from .protocol import Message
from .scene_part import ScenePart
from .session import Session

if TYPE_CHECKING:
    from roadlang.api import Scene


class Eyes:
    """The cameras of a scene. `parts` are to be sent with those of the layout."""

    def __init__(self, scene: Scene, layout: Layout, cameras: Sequence[MountedCamera]) -> None:
        self.cameras = tuple(cameras)
        self.instances = instances_of(scene, layout)
        self._origin = layout.frame
        self.parts: list[ScenePart] = label_parts(layout, self.instances)
        self.parts += [
            camera.part(id, layout.agents[camera.agent])
            for id, camera in enumerate(self.cameras, start=1)
        ]

    def look(
        self, session: Session, time: float, cameras: Sequence[MountedCamera] | None = None
    ) -> tuple[CameraFrame, ...]:
        """What the cameras see now, by default all of them. Raises `EngineError` RL508 where the
        engine has no screen."""
        wanted = self.cameras if cameras is None else cameras
        if not wanted:
            return ()
        wish = {"cameras": [self.cameras.index(camera) + 1 for camera in wanted]}
        answer = session.fetch(Message.LOOK, wish, Message.FRAMES)
        return frames_of(answer, self.cameras, self._origin, time)
