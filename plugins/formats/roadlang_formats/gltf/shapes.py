"""What agents and objects look like: simple bodies that are exactly as large as they say."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from .meshes import Faces, joined
from .solids import box, tapered, wheel

Shape = Callable[[str, float, float, float], Iterator[Faces]]
"""Of a material, length, width and height: parts around (0, 0), standing on the ground."""
_BODY = 0.98
"""Share of its width that the body of a vehicle has between the outer sides of its wheels."""


def body(
    category: str, material: str, length: float, width: float, height: float
) -> tuple[Faces, ...]:
    """The parts of an agent or object; of a category that has no shape a box."""
    return joined(_SHAPES.get(category, _block)(material, length, width, height))


def _block(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    yield box(paint, (-length / 2, -width / 2, 0.0), (length / 2, width / 2, height))


def _car(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    yield from _wheels(length, width, height)
    x, y = length / 2, _BODY * width / 2
    yield box(paint, (-x, -y, 0.18 * height), (x, y, 0.6 * height))
    yield box("glass", (-0.78 * x, -0.88 * y, 0.6 * height), (0.44 * x, 0.88 * y, 0.93 * height))
    yield box(paint, (-0.72 * x, -0.86 * y, 0.93 * height), (0.36 * x, 0.86 * y, height))


def _van(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    yield from _wheels(length, width, height)
    x, y = length / 2, _BODY * width / 2
    front = x - min(1.6, 0.3 * length)
    yield box(paint, (-x, -y, 0.16 * height), (front, y, height))
    yield box(paint, (front, -y, 0.16 * height), (x, y, 0.5 * height))
    yield box("glass", (front, -0.92 * y, 0.5 * height), (0.95 * x, 0.92 * y, 0.85 * height))


def _wheels(length: float, width: float, height: float) -> Iterator[Faces]:
    radius = min(0.5, 0.23 * height, 0.15 * length)
    broad = min(0.25, 0.2 * width)
    for x in (-0.3 * length, 0.3 * length):
        for edge in (-width / 2, width / 2 - broad):
            yield wheel("tire", x, (edge, edge + broad), radius)


def _two_wheeler(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    radius = min(0.35, 0.2 * length)
    for x in (radius - length / 2, length / 2 - radius):
        yield wheel("tire", x, (-0.04, 0.04), radius)
    low = min(1.2 * radius, 0.5 * height)
    x = length / 2 - radius
    yield box(paint, (-x, -0.06, low), (x, 0.06, 1.2 * low))
    yield box("metal", (0.7 * x, -width / 2, 1.3 * low), (x, width / 2, 1.4 * low))
    yield box(paint, (-0.2 * length, -0.3 * width, 1.2 * low), (0.1 * length, 0.3 * width, height))


def _walker(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    x, y = length / 2, width / 2
    yield box("tire", (-0.6 * x, -0.7 * y, 0.0), (0.6 * x, 0.7 * y, 0.48 * height))
    yield box(paint, (-x, -y, 0.48 * height), (x, y, 0.85 * height))
    yield box("skin", (-0.6 * x, -0.5 * y, 0.85 * height), (0.6 * x, 0.5 * y, height))


def _animal(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    x, y = length / 2, width / 2
    yield box(paint, (-x, -y, 0.4 * height), (0.7 * x, y, 0.85 * height))
    yield box(paint, (0.6 * x, -0.6 * y, 0.55 * height), (x, 0.6 * y, height))
    for foot in (-0.8 * x, 0.5 * x):
        yield box(paint, (foot, -0.8 * y, 0.0), (foot + 0.2 * x, 0.8 * y, 0.4 * height))


def _tree(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    side = max(length, width) / 2
    yield tapered("trunk", (0.13 * side, 0.1 * side), (0.0, 0.3 * height))
    for below, above, low, high in ((1.0, 0.35, 0.22, 0.6), (0.75, 0.2, 0.5, 0.8)):
        yield tapered(
            paint,
            (below, above),
            (low * height, high * height),
            (length / 2, width / 2),
        )
    yield tapered(paint, (0.5, 0.02), (0.7 * height, height), (length / 2, width / 2))


def _bush(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    stretch = (length / 2, width / 2)
    for below, above, low, high in ((0.8, 1.0, 0.0, 0.45), (1.0, 0.5, 0.45, 1.0)):
        yield tapered(paint, (below, above), (low * height, high * height), stretch)


def _building(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    x, y = length / 2, width / 2
    roof = height - min(0.3, 0.1 * height)
    # Walls stand a little behind the windows, which are as far out as the building is large.
    yield box(paint, (-0.99 * x, -0.99 * y, 0.0), (0.99 * x, 0.99 * y, roof))
    yield box("roof", (-x, -y, roof), (x, y, height))
    for floor in range(int(roof / 3.0)):
        low = 3.0 * floor + 1.0
        yield box("glass", (-x, -0.8 * y, low), (x, 0.8 * y, low + 1.2))
        yield box("glass", (-0.8 * x, -y, low), (0.8 * x, y, low + 1.2))


def _pole(_paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    yield tapered("metal", (0.6, 0.4), (0.0, 0.9 * height), (length / 2, width / 2))
    yield box("metal", (-length / 2, -width / 2, 0.9 * height), (length / 2, width / 2, height))


def _cone(paint: str, length: float, width: float, height: float) -> Iterator[Faces]:
    x, y = length / 2, width / 2
    yield box(paint, (-x, -y, 0.0), (x, y, 0.06 * height))
    yield tapered(paint, (0.7, 0.12), (0.06 * height, height), (x, y))


_SHAPES: Mapping[str, Shape] = {
    "car": _car,
    **dict.fromkeys(("van", "truck", "bus", "tractor"), _van),
    "motorcycle": _two_wheeler,
    "bicycle": _two_wheeler,
    "pedestrian": _walker,
    "animal": _animal,
    "tree": _tree,
    "bush": _bush,
    "hedge": _bush,
    "building": _building,
    **dict.fromkeys(("pole", "lamp", "sign", "traffic_light"), _pole),
    "cone": _cone,
}
"""By category."""
