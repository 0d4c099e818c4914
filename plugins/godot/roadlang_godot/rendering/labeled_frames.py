"""Labeled pictures of drives: what all cameras of a scene see, every so many seconds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from roadlang.api import Code, to_json

from ..build.agent_looks import EGO
from ..build.camera_parts import camera_parts
from ..build.drives import decided_in_python
from ..build.layout import layout_of
from ..build.mounted_camera import OUTPUTS, MountedCamera, cameras_of
from ..drive.driving import LockStep
from ..drive.simulate import name_of
from ..engines import engine
from ..engines.restarted_engine import RestartedEngine
from ..faults import fault
from ..net.session import Session
from ..sensors.boxes import seen_things
from ..sensors.camera_frames import CameraFrame
from ..sensors.eyes import Eyes
from ..sensors.frame_documents import labels_of, picture_files
from .pictures import RATE, drive_for, followed

if TYPE_CHECKING:
    from roadlang.api import Scene

    from .pictures import Controllers


@dataclass(frozen=True, slots=True)
class Sampling:
    """When to look: seconds from the start of a drive to the first moment, and from one to the
    next. `size` is that of the pictures of a camera that the scene does not have."""

    start: float = 0.0
    interval: float = 0.5
    size: tuple[int, int] = (640, 360)
    road: str = "mesh"


@dataclass(frozen=True, slots=True)
class LabeledFrame:
    """What one camera saw at one moment, as files: contents by `rgb`, `depth`, ..., `labels`."""

    engine: str
    scene: int
    time: float
    camera: MountedCamera
    contents: Mapping[str, bytes]


Moment = tuple[LabeledFrame, ...]
"""All cameras at one time."""


def labeled_moments(
    scenes: Iterable[tuple[Scene, Controllers]], sampling: Sampling, count: int, most: int
) -> Iterator[Moment]:
    """`count` moments of scenes, at most so many of each; fewer where the drives are too short.

    `scenes` come with their controllers that are written in Python. Raises `EngineError` RL508
    where there is no screen, RL700 where a scene has neither a camera nor an agent.
    """
    engines = RestartedEngine(lambda: engine.start(fixed_fps=RATE, draw=True))
    try:
        for scene, controllers in scenes:
            wanted = min(count, most)
            work = partial(moments_of, scene, controllers, sampling, wanted)
            moments = engines.drive(scene, work)
            yield from moments
            count -= len(moments)
            if count <= 0:
                return
    finally:
        engines.stop()


def default_camera(scene: Scene, size: tuple[int, int]) -> MountedCamera:
    """The front camera of the ego vehicle, else of the first agent. Raises RL700."""
    if not scene.agents:
        raise fault(Code.NO_AGENTS, scene=scene.name)
    names = [agent.name for agent in scene.agents]
    return MountedCamera(EGO if EGO in names else names[0], width=size[0], height=size[1])


def moments_of(
    scene: Scene, controllers: Controllers, sampling: Sampling, count: int, session: Session
) -> list[Moment]:
    """`count` moments of one scene; fewer where its drive ends before. Raises RL700."""
    cameras = cameras_of(scene) or (default_camera(scene, sampling.size),)
    decided = decided_in_python(scene, controllers)
    layout = layout_of(scene, sampling.road, python_driven=decided)
    labeled = [replace(camera, outputs=OUTPUTS, samples=2) for camera in cameras]
    session.begin(layout.settings(RATE), clear=True)
    parts = camera_parts(scene, layout.parts, layout.agents, layout.objects, labeled)
    session.update((*layout.parts, *parts))
    session.prove()
    eyes = Eyes(session, scene, layout, labeled)
    moments: list[Moment] = []
    with LockStep(session) as lock:
        driver = followed(session, scene, layout, decided)
        drive_for(lock, driver, sampling.start)
        while True:
            frames = eyes.look(lock.tick / RATE)
            moments.append(
                tuple(_labeled(scene, frame, eyes, name_of(session)) for frame in frames)
            )
            if len(moments) >= count or driver.finished:
                return moments
            drive_for(lock, driver, sampling.interval)


def _labeled(scene: Scene, frame: CameraFrame, eyes: Eyes, engine: str) -> LabeledFrame:
    labels = to_json(labels_of(scene, frame, seen_things(frame, eyes.instances)))
    contents = {**picture_files(frame), "labels": labels.encode()}
    return LabeledFrame(engine, scene.index, frame.time, frame.camera, contents)
