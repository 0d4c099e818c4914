"""Scenes as files that open without roadlang: scenes of Godot, and glTF with Godot's looks."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING

from ..build.drives import decided_in_python
from ..build.mounted_camera import cameras_of
from ..drive.driving import LockStep
from ..engines import engine
from ..net.protocol import Message
from .overview_camera import built_places, free_pose
from .pictures import RATE, build, drive_for, followed

_UNIQUE_ID = re.compile(rb" unique_id=\d+(?=[ \]])")
_RESOURCE = re.compile(rb'(\[sub_resource type="(\w+)" id="|SubResource\(")(\w+)"')
_ASPECT = 16 / 9
"""Of the window of a new project."""

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene

    from ..build.layout import Layout
    from ..net.session import Session


def export_scene(
    scene: Scene,
    format: str,
    road: str = "mesh",
    moment: float = 0.0,
    controllers: Mapping[str, Controller] | None = None,
) -> bytes:
    """The bytes of a file of a scene as it is after `moment` seconds of driving.

    `format`: `tscn` or `glb`; `road`: `mesh` or `tiles`. Raises `EngineError`.
    """
    decided = decided_in_python(scene, controllers or {})
    draw = bool(cameras_of(scene))
    started = engine.start(fixed_fps=RATE, draw=draw)
    with started as running, running.connect(scene.name) as session:
        layout = build(session, scene, road, decided)
        if moment > 0 and layout.agents:
            with LockStep(session) as lock:
                drive_for(lock, followed(session, scene, layout, decided), moment)
                return exported(session, layout, format)
        return exported(session, layout, format)


def exported(session: Session, layout: Layout, format: str) -> bytes:
    """The bytes of a file of what is built now, with a camera that sees all of it. Raises
    `EngineError` RL507."""
    pose = free_pose(built_places(layout.parts), _ASPECT)
    content = session.fetch(Message.EXPORT, {"format": format, **asdict(pose)}, Message.EXPORTED)
    return _with_numbered_ids(content) if format == "tscn" else content


def _with_numbered_ids(content: bytes) -> bytes:
    """A text scene of Godot with ids by their order: Godot draws them at random for each file."""
    numbers: dict[bytes, bytes] = {}

    def renamed(match: re.Match[bytes]) -> bytes:
        before, kind, old = match.groups()
        if kind is not None:
            numbers[old] = b"%s_%d" % (kind, len(numbers) + 1)
        return b'%s%s"' % (before, numbers.get(old, old))

    return _RESOURCE.sub(renamed, _UNIQUE_ID.sub(b"", content))
