"""What the engine's cameras see, as arrays, and where everything was."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..build.frame import SceneOrigin
from ..build.mounted_camera import MountedCamera, Render

MILLIMETERS = 1000.0
_COUNTS = struct.Struct("<HH")
_MOVER = struct.Struct("<HH12f")
_CAMERA = struct.Struct("<IHHI12f")
_CHANNELS = 3
_TO_WORLD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From the engine's axes (east, up, south) to the world's (east, north, up)."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A place in the world (3,), meters east, north and up, and three axes there: the columns of
    `axes` (3, 3). Of a body they point ahead, left and up; of a camera right, down and forward."""

    place: NDArray[np.float64]
    axes: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class CameraFrame:
    """One picture of a camera. Arrays are (height, width) from the top left.

    `rgb` (height, width, 3) uint8; `depth` float32, meters from the camera's plane, infinite where
    there is nothing; `semantic` uint8, the ids of `SemanticClass`; `instance` uint16, 0 for what is
    no agent or object. None: not among the camera's outputs. `bodies` are all that can move by
    their numbers; None: not present.
    """

    camera: MountedCamera
    time: float
    pose: Pose
    bodies: Mapping[int, Pose | None]
    rgb: NDArray[np.uint8] | None = None
    depth: NDArray[np.float32] | None = None
    semantic: NDArray[np.uint8] | None = None
    instance: NDArray[np.uint16] | None = None

    def readings(self) -> dict[str, NDArray[np.generic]]:
        """The outputs of the camera by name."""
        return {name: getattr(self, name) for name in self.camera.outputs}


def frames_of(
    payload: bytes, cameras: Sequence[MountedCamera], origin: SceneOrigin, time: float
) -> tuple[CameraFrame, ...]:
    """The frames in the joined parts of FRAMES. `cameras`: by their ids, from 1."""
    raw = memoryview(zlib.decompress(payload))
    count, movers = _COUNTS.unpack_from(raw)
    at = _COUNTS.size
    bodies: dict[int, Pose | None] = {}
    for _ in range(movers):
        number, present, *numbers = _MOVER.unpack_from(raw, at)
        left, up, ahead, place = _in_world(numbers, origin)
        bodies[number] = Pose(place, np.stack([ahead, left, up], axis=-1)) if present else None
        at += _MOVER.size
    frames = []
    for _ in range(count):
        id, width, height, renders, *numbers = _CAMERA.unpack_from(raw, at)
        at += _CAMERA.size
        right, up, back, place = _in_world(numbers, origin)
        pose = Pose(place, np.stack([right, -up, -back], axis=-1))
        pictures = {}
        for render in Render:
            if renders & render:
                size = width * height * _CHANNELS
                flat = np.frombuffer(raw, np.uint8, size, at)
                pictures[render] = flat.reshape(height, width, _CHANNELS)
                at += size
        frames.append(CameraFrame(cameras[id - 1], time, pose, bodies, **_arrays(pictures)))
    return tuple(frames)


def _in_world(numbers: Sequence[float], origin: SceneOrigin) -> list[NDArray[np.float64]]:
    """Three axes and a place, 12 numbers of the engine, in the world."""
    rows = np.array(numbers, dtype=np.float64).reshape(4, 3) @ _TO_WORLD.T
    rows[3, :2] += (origin.x, origin.y)
    return list(rows)


def _arrays(pictures: Mapping[Render, NDArray[np.uint8]]) -> dict[str, Any]:
    out: dict[str, Any] = {}
    if Render.RGB in pictures:
        out["rgb"] = pictures[Render.RGB].copy()
    if Render.LABELS in pictures:
        red, green, blue = np.moveaxis(pictures[Render.LABELS], -1, 0)
        out["semantic"] = blue.copy()
        out["instance"] = red.astype(np.uint16) | green.astype(np.uint16) << 8
    if Render.DEPTH in pictures:
        red, green, blue = np.moveaxis(pictures[Render.DEPTH].astype(np.uint32), -1, 0)
        millimeters = red | green << 8 | blue << 16
        meters = (millimeters / MILLIMETERS).astype(np.float32)
        out["depth"] = np.where(millimeters == 0, np.float32(np.inf), meters)
    return out
