"""Frames of cameras as files: pictures, and the document of their labels."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import CameraGeometry, FrameLabels, LabeledThing
from roadlang_standard.camera_pictures import png_of

from .boxes import Floats, SeenThing
from .camera_frames import CameraFrame

if TYPE_CHECKING:
    from roadlang.api import Scene

_DIGITS = 6
_PIXEL_DIGITS = 3


def labels_of(scene: Scene, frame: CameraFrame, things: Iterable[SeenThing]) -> FrameLabels:
    """What is known of a frame."""
    return FrameLabels(
        scene.name,
        scene.index,
        round(frame.time, _DIGITS),
        _camera(frame),
        tuple(_labeled(thing, frame) for thing in things),
    )


def picture_files(frame: CameraFrame) -> dict[str, bytes]:
    """PNG files of the outputs that a frame has, by the names of the outputs."""
    outputs = {"rgb": frame.rgb, "depth": frame.depth, "semantic": frame.semantic,
               "instance": frame.instance}  # fmt: skip
    return {name: png_of(name, array) for name, array in outputs.items() if array is not None}


def _camera(frame: CameraFrame) -> CameraGeometry:
    camera = frame.camera
    return CameraGeometry(
        agent=camera.agent,
        name=camera.name,
        width=camera.width,
        height=camera.height,
        fx=round(camera.focal_length, _DIGITS),
        fy=round(camera.focal_length, _DIGITS),
        cx=0.5 * camera.width,
        cy=0.5 * camera.height,
        position=_place(frame.pose.place),
        rotation=_quaternion(frame.pose.axes),
    )


def _labeled(thing: SeenThing, frame: CameraFrame) -> LabeledThing:
    solid, actor = thing.solid, thing.instance.actor
    in_camera = solid.seen_from(frame.pose)
    return LabeledThing(
        name=actor.name,
        kind=actor.kind,
        category=thing.category.label,
        class_id=int(thing.category),
        instance=thing.instance.number,
        size=solid.size,
        center=_place(solid.place),
        heading=round(math.atan2(solid.axes[1, 0], solid.axes[0, 0]), _DIGITS) + 0.0,
        rotation=_quaternion(solid.axes),
        center_in_camera=_place(in_camera.place),
        rotation_in_camera=_quaternion(in_camera.axes),
        visible_box=thing.visible,
        projected_box=_rounded_pixels(thing.projected),
        pixels=thing.pixels,
        occlusion=round(thing.occlusion, _DIGITS),
        truncation=round(thing.truncation, _DIGITS) + 0.0,
    )


def _place(point: Floats) -> tuple[float, float, float]:
    x, y, z = (np.round(point, _DIGITS) + 0.0).tolist()  # no -0.0
    return (x, y, z)


def _rounded_pixels(box: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    left, top, right, bottom = (round(value, _PIXEL_DIGITS) + 0.0 for value in box)
    return (left, top, right, bottom)


def _quaternion(axes: Floats) -> tuple[float, float, float, float]:
    """w, x, y, z with w at least 0, of a rotation matrix (3, 3)."""
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_matrix(axes).as_quat()
    x, y, z, w = (np.round(turned if turned[3] >= 0 else -turned, _DIGITS) + 0.0).tolist()
    return (w, x, y, z)
