"""Pictures and clips of scenes: chase view, top view, free camera."""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roadlang.api import Code
from roadlang.commands import write_file
from roadlang_standard.camera_pictures import clip_of

from ..build.drives import decided_in_python
from ..build.layout import Layout, layout_of
from ..drive.driving import LockStep
from ..drive.followed_scene import FollowedScene
from ..engines import engine
from ..faults import fault
from ..net.protocol import Message
from ..net.session import Session
from ..sensors.eyes import Eyes
from .clips import decoded
from .overview_camera import FreePose, TopFrame, built_places, free_pose, top_frame

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene

    Controllers = Mapping[str, Controller]

RATE = 60
EVERY = 3
"""Physics ticks for which a decision of Python holds."""


@dataclass(frozen=True, slots=True)
class Shot:
    """What to draw. `scale` is meters a pixel of the top view; `pose` is x, y, z, yaw, pitch."""

    view: str = "chase"
    width: int = 1280
    height: int = 720
    scale: float | None = None
    agent: str | None = None
    pose: tuple[float, ...] | None = None
    format: str = "png"
    road: str = "mesh"


def render_picture(
    scene: Scene, shot: Shot, moment: float = 0.0, controllers: Controllers | None = None
) -> bytes:
    """The bytes of one picture, after `moment` seconds of driving. `controllers` are those that are
    written in Python: needed where the engine does not have all."""
    with engine.start(fixed_fps=RATE, draw=True) as running, running.connect(scene.name) as session:
        decided = decided_in_python(scene, controllers or {})
        layout = build(session, scene, shot.road, decided)
        if moment > 0 and layout.agents:
            with LockStep(session) as lock:
                drive_for(lock, followed(session, scene, layout, decided), moment)
                return take(session, layout, shot)
        return take(session, layout, shot)


def render_clip(
    scene: Scene,
    shot: Shot,
    path: Path,
    duration: float,
    fps: int,
    start: float = 0.0,
    controllers: Controllers | None = None,
) -> int:
    """Write a clip (`.avi`, `.mp4`) of a drive, or nothing where that fails; returns the number
    of frames. Raises `EngineError`."""
    if not os.access(path.parent, os.W_OK):
        raise fault(Code.CLIP_NOT_WRITTEN, path=path)
    every = max(1, round(RATE / fps))
    count = max(1, round(duration * RATE / every))
    pictures = _pictures(scene, shot, start, every, count, controllers or {})
    write_file(path, clip_of(map(decoded, pictures), RATE / every, str(path)))
    return count


def _pictures(
    scene: Scene, shot: Shot, start: float, every: int, count: int, controllers: Controllers
) -> Iterator[bytes]:
    """Pictures of a drive, one in `every` ticks."""
    with engine.start(fixed_fps=RATE, draw=True) as running, running.connect(scene.name) as session:
        decided = decided_in_python(scene, controllers)
        layout = build(session, scene, shot.road, decided)
        with LockStep(session) as lock:
            driver = followed(session, scene, layout, decided)
            drive_for(lock, driver, start)
            for _ in range(count):
                yield take(session, layout, shot)
                drive_for(lock, driver, every / RATE)


def followed(session: Session, scene: Scene, layout: Layout, decided: Controllers) -> FollowedScene:
    """What decides for the agents of a scene in steps of `EVERY` ticks."""
    eyes = Eyes(session, scene, layout)
    return FollowedScene(scene, layout, EVERY / RATE, RATE, decided, eyes)


def drive_for(lock: LockStep, driver: FollowedScene, seconds: float) -> None:
    """Go on for some time; decisions hold for `EVERY` ticks."""
    last = lock.tick + round(seconds * RATE)
    while lock.tick < last:
        if lock.tick % EVERY == 0:
            driver.look(lock.state)
        controls = driver.controls() if lock.tick % EVERY == 0 else {}
        lock.step(controls, min(EVERY - lock.tick % EVERY, last - lock.tick))


def build(
    session: Session, scene: Scene, road: str = "mesh", decided: Collection[str] = ()
) -> Layout:
    """Build a scene in an engine and prove it built. `decided`: agents that Python drives."""
    layout = layout_of(scene, road, python_driven=decided)
    session.begin(layout.settings(RATE), clear=True)
    session.update(layout.parts)
    session.prove()
    return layout


def take(session: Session, layout: Layout, shot: Shot) -> bytes:
    """One picture of what stands in the engine now."""
    session.send_json(Message.VIEW, view_of(layout, shot), "the view")
    session.flush()
    wish = {"width": shot.width, "height": shot.height, "format": shot.format}
    return session.fetch(Message.SHOT, wish, Message.PICTURE)


def _top_frame(layout: Layout, shot: Shot) -> TopFrame:
    """With a scale of its own, around the origin."""
    if shot.scale is not None:
        return TopFrame(0.0, 0.0, shot.scale * shot.height)
    return top_frame(built_places(layout.parts), shot.width / shot.height)


def view_of(layout: Layout, shot: Shot) -> dict[str, Any]:
    """What is sent to the engine about the camera: meters from the origin, radians."""
    view: dict[str, Any] = {"camera": shot.view}
    if shot.agent is not None and shot.agent in layout.agents:
        view["agent"] = layout.agents[shot.agent]
    elif layout.agents:
        view["agent"] = min(layout.agents.values())
    if shot.view == "top":
        view |= asdict(_top_frame(layout, shot))
    elif shot.view == "free":
        view |= asdict(_free_pose(layout, shot))
    return view


def _free_pose(layout: Layout, shot: Shot) -> FreePose:
    if shot.pose is None:
        return free_pose(built_places(layout.parts), shot.width / shot.height)
    x, y, z, yaw, pitch = shot.pose
    turn = math.radians(yaw), math.radians(pitch)
    return FreePose(x - layout.frame.x, y - layout.frame.y, z, *turn)
