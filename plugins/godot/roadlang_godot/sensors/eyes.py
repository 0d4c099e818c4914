"""Looking through the cameras of a scene that is built in an engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..build.label_parts import instances_of
from ..build.mounted_camera import MountedCamera, cameras_of
from ..net.protocol import Message
from .camera_frames import CameraFrame, frames_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import DueReading, Scene

    from ..build.layout import Layout
    from ..net.session import Session


class Eyes:
    """The cameras of a scene that is built in the engine of a session, by default its own."""

    def __init__(
        self,
        session: Session,
        scene: Scene,
        layout: Layout,
        cameras: Sequence[MountedCamera] | None = None,
    ) -> None:
        self.cameras = cameras_of(scene) if cameras is None else tuple(cameras)
        self.instances = instances_of(scene, layout.objects) if self.cameras else ()
        self._session = session
        self._origin = layout.frame

    def look(
        self, time: float, cameras: Sequence[MountedCamera] | None = None
    ) -> tuple[CameraFrame, ...]:
        """What the cameras see now, by default all of them. Raises `EngineError` RL508 where the
        engine has no screen."""
        wanted = self.cameras if cameras is None else cameras
        if not wanted:
            return ()
        wish = {"cameras": [self.cameras.index(camera) + 1 for camera in wanted]}
        answer = self._session.fetch(Message.LOOK, wish, Message.FRAMES)
        return frames_of(answer, self.cameras, self._origin, time)

    def readings(
        self, due: Sequence[DueReading], time: float
    ) -> list[tuple[DueReading, Mapping[str, NDArray[np.generic]]]]:
        """The readings that are due, all of one look."""
        by_name = {(camera.agent, camera.name): camera for camera in self.cameras}
        cameras = [by_name[reading.agent, reading.sensor.name] for reading in due]
        frames = {frame.camera: frame for frame in self.look(time, cameras)} if due else {}
        return [
            (reading, frames[camera].readings())
            for reading, camera in zip(due, cameras, strict=True)
        ]
