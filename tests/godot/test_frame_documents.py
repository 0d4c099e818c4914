"""The camera in the labels of a frame: its numbers turn places of the world into pixels."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from roadlang_godot.build.mounted_camera import MountedCamera
from roadlang_godot.sensors.camera_frames import CameraFrame, Pose
from roadlang_godot.sensors.frame_documents import labels_of
from tests.backends.handmade_scenes import bend


@pytest.mark.parametrize(("width", "height", "fov"), [(320, 180, 90), (640, 480, 40), (9, 30, 120)])
@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (1.0, -0.4, 0.2), (-3.0, 0.1, 2.9)])
def test_rays_of_the_edges_of_a_picture_end_at_its_edges(
    width: int, height: int, fov: float, turn: tuple[float, float, float]
) -> None:
    camera = MountedCamera("ego", width=width, height=height, fov=math.radians(fov))
    axes = Rotation.from_euler("xyz", turn).as_matrix()
    place = np.array([4.0, -2.0, 1.5])
    frame = CameraFrame(camera, 1.5, Pose(place, axes), {})
    found = labels_of(bend(), frame, ())
    assert (found.scene, found.index, found.time) == (bend().name, bend().index, 1.5)
    seen = found.camera
    assert (seen.agent, seen.name, seen.width, seen.height) == ("ego", "front", width, height)
    w, x, y, z = seen.rotation
    assert w >= 0.0
    turned = Rotation.from_quat([x, y, z, w]).as_matrix()
    side = math.tan(math.radians(fov) / 2.0)
    for right, down in ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.5, -0.5)):
        ray = np.array([right * side, down * side * height / width, 1.0])
        point = place + 7.0 * axes @ ray
        across, below, ahead = turned.T @ (point - np.array(seen.position))
        pixel = seen.fx * across / ahead + seen.cx, seen.fy * below / ahead + seen.cy
        expected = (1.0 + right) * width / 2.0, (1.0 + down) * height / 2.0
        assert pixel == pytest.approx(expected, abs=0.01)
