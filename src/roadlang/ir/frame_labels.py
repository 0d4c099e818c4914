"""What is exactly known of one picture of a camera: its geometry, and all that is in it."""

from __future__ import annotations

from dataclasses import dataclass

LABELS_SCHEMA = "roadlang.labels/1"

Place = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Rectangle = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class CameraGeometry:
    """A camera at the moment of a picture.

    A point p of camera coordinates (meters right, down and forward) is at `position` + `rotation` p
    in the world, and in pixels at (`fx` p0 / p2 + `cx`, `fy` p1 / p2 + `cy`), from the top left
    corner of the picture.
    """

    agent: str
    """that carries it"""
    name: str
    """of the sensor"""
    width: int
    """pixels"""
    height: int
    """pixels"""
    fx: float
    """focal length in pixels, across"""
    fy: float
    """focal length in pixels, down"""
    cx: float
    """pixels from the left to the optical axis"""
    cy: float
    """pixels from the top to the optical axis"""
    position: Place
    """meters east, north and up"""
    rotation: Quaternion
    """w, x, y, z of the unit quaternion that turns camera coordinates to those of the world"""


@dataclass(frozen=True, slots=True)
class LabeledThing:
    """An agent or object whose box is in the picture, even if something hides it."""

    name: str
    """in the scene"""
    kind: str
    """of agent or object"""
    category: str
    """name of its class"""
    class_id: int
    """of its class, the value of its pixels in semantic pictures"""
    instance: int
    """the value of its pixels in instance pictures"""
    size: Place
    """length, width and height, meters"""
    center: Place
    """of the solid box, meters east, north and up"""
    heading: float
    """radians, counter-clockwise from east"""
    rotation: Quaternion
    """w, x, y, z: turns its own axes (ahead, left, up) to those of the world"""
    center_in_camera: Place
    """of the solid box, meters right, down and forward"""
    rotation_in_camera: Quaternion
    """w, x, y, z: turns its own axes (ahead, left, up) to those of the camera"""
    visible_box: Rectangle | None
    """left, top, right and bottom of its pixels: pixel (i, j) covers i to i + 1 and j to j + 1;
    null where none is seen"""
    projected_box: Rectangle
    """left, top, right and bottom of its solid box in pixels; may reach beyond the picture"""
    pixels: int
    """how many show it"""
    occlusion: float
    """0 to 1: of the part of the picture that its solid box covers, the share where something
    nearer is seen"""
    truncation: float
    """0 to 1: the share of `projected_box` outside the picture"""


@dataclass(frozen=True, slots=True)
class FrameLabels:
    """One picture of a camera."""

    scene: str
    """name of the scenario"""
    index: int
    """number of the scene"""
    time: float
    """seconds since the start of the drive"""
    camera: CameraGeometry
    things: tuple[LabeledThing, ...]
    """in the order of their instances"""
    schema: str = LABELS_SCHEMA
    """version of this format"""
