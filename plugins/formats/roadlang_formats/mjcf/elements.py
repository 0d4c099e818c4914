"""XML elements of MJCF."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree.ElementTree import Element, SubElement

Attribute = str | int | float | Sequence[float]


def put(parent: Element, tag: str, **attributes: Attribute) -> Element:
    """A new child; a trailing underscore of a name is left out (`class_`)."""
    written = {name.rstrip("_"): _text(value) for name, value in attributes.items()}
    return SubElement(parent, tag, written)


def _text(value: Attribute) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, (int, float)):
        return number(value)
    return " ".join(map(number, value))


def number(value: float) -> str:
    """A tenth of a micrometer on a map of a kilometer; 0.0 takes the sign off -0."""
    return f"{value + 0.0:.10g}"
