"""XML elements of CommonRoad, with decimals that its schema allows: no exponents."""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree.ElementTree import Element, SubElement

Child = str | int | float


def decimal(value: float) -> str:
    """To a micrometer, without zeros at the end."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def put(parent: Element, tag: str, text: Child | None = None, **attributes: str | int) -> Element:
    """A new child with a text."""
    found = SubElement(parent, tag, {name: str(value) for name, value in attributes.items()})
    if text is not None:
        found.text = decimal(text) if isinstance(text, float) else str(text)
    return found


def put_point(parent: Element, x: float, y: float) -> None:
    """A `point`."""
    point = put(parent, "point")
    put(point, "x", float(x))
    put(point, "y", float(y))


def put_exact(parent: Element, tag: str, value: float | int) -> None:
    """A value in `exact`."""
    put(put(parent, tag), "exact", value)


def put_rectangle(parent: Element, length: float, width: float, *pose: float) -> None:
    """A `rectangle`; `pose`: its orientation and the x and y of its center, where it has one."""
    shape = put(parent, "rectangle")
    put(shape, "length", float(length))
    put(shape, "width", float(width))
    if pose:
        orientation, x, y = pose
        put(shape, "orientation", float(orientation))
        center = put(shape, "center")
        put(center, "x", float(x))
        put(center, "y", float(y))


def put_references(parent: Element, tag: str, ids: Iterable[int]) -> None:
    """Elements that refer to others."""
    for id in ids:
        put(parent, tag, ref=id)
