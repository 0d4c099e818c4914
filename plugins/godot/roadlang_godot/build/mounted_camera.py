"""Cameras of agents, as they are sent to the engine."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from enum import IntFlag
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from roadlang_standard.sense_camera import Camera

from ..net.protocol import Message
from ..net.scene_part import ScenePart

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene

OUTPUTS = ("rgb", "depth", "semantic", "instance")
"""What a reading can hold."""


class Render(IntFlag):
    """What the engine draws for a camera (`sensors/camera.gd`)."""

    RGB = 1
    LABELS = 2
    DEPTH = 4


_ENGINE_NAMES = {Render.RGB: "rgb", Render.LABELS: "labels", Render.DEPTH: "depth"}
_RENDERS = {
    "rgb": Render.RGB,
    "semantic": Render.LABELS,
    "instance": Render.LABELS,
    "depth": Render.DEPTH,
}


@dataclass(frozen=True, slots=True)
class MountedCamera:
    """A camera of an agent. SI units and radians.

    `at` is ahead of the center of the agent, left of it, and above the ground; `fov` is the
    horizontal field of view; `yaw` to the left, `pitch` upward; `every` seconds from one picture to
    the next, 0 for all steps; `samples` of the color of each pixel, 1 or 2.
    """

    agent: str
    name: str = "front"
    width: int = 320
    height: int = 180
    fov: float = math.pi / 2
    at: tuple[float, float, float] = (1.5, 0.0, 1.2)
    yaw: float = 0.0
    pitch: float = 0.0
    every: float = 0.0
    outputs: tuple[str, ...] = ("rgb",)
    samples: int = 1

    @classmethod
    def of(cls, agent: str, name: str, options: Mapping[str, Any]) -> MountedCamera:
        """That of a scene's `sense with camera`."""
        x, y, z = options["at"]
        return cls(
            agent,
            name,
            round(options["width"]),
            round(options["height"]),
            float(options["fov"]),
            (float(x), float(y), float(z)),
            float(options["yaw"]),
            float(options["pitch"]),
            float(options.get("every") or 0.0),
            tuple(options["outputs"]),
        )

    @property
    def title(self) -> str:
        """The agent and the name, as in names of files."""
        return f"{self.agent}.{self.name}"

    @property
    def renders(self) -> Render:
        """What the engine has to draw for the outputs."""
        renders = Render(0)
        for output in self.outputs:
            renders |= _RENDERS[output]
        return renders

    @property
    def focal_length(self) -> float:
        """In pixels, the same along both axes; the optical axis meets the middle of the picture."""
        return 0.5 * self.width / math.tan(0.5 * self.fov)

    def matrix(self) -> NDArray[np.float64]:
        """(3, 3) from camera coordinates (right, down, forward) to pixels, as in OpenCV.

        Pixel (i, j) covers columns i to i + 1 and rows j to j + 1.
        """
        f = self.focal_length
        return np.array([[f, 0, 0.5 * self.width], [0, f, 0.5 * self.height], [0, 0, 1]])

    def part(self, id: int, agent: int) -> ScenePart:
        """The thing that the engine builds; `agent` is its number there."""
        x, y, z = self.at
        spec = {
            "agent": agent, "width": self.width, "height": self.height, "fov": self.fov,
            "x": x, "y": y, "z": z, "yaw": self.yaw, "pitch": self.pitch, "samples": self.samples,
            "outputs": [name for drawn, name in _ENGINE_NAMES.items() if drawn in self.renders],
        }  # fmt: skip
        body = json.dumps(spec, allow_nan=False, separators=(",", ":"), sort_keys=True).encode()
        return ScenePart(Message.CAMERA, id, body, body, f"camera {self.title}")


def cameras_of(scene: Scene) -> tuple[MountedCamera, ...]:
    """All cameras of a scene."""
    return tuple(
        MountedCamera.of(agent.name, sensor.name, sensor.options)
        for agent in scene.agents
        for sensor in agent.sensors
        if sensor.kind == Camera.name
    )
