"""XML elements, with numbers that are written the same way on every machine."""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement

Attribute = str | int | float


def put(parent: Element, tag: str, **attributes: Attribute) -> Element:
    """A new child; a trailing underscore of a name is left out (`from_`)."""
    return SubElement(parent, tag, written(attributes))


def written(attributes: dict[str, Attribute]) -> dict[str, str]:
    """Attributes as text."""
    return {name.rstrip("_"): _text(value) for name, value in attributes.items()}


def _text(value: Attribute) -> str:
    if isinstance(value, float):
        # Twelve digits are a nanometer on a map of a kilometer; 0.0 takes the sign off -0.
        return f"{value + 0.0:.12g}"
    return str(value)


def linear_pieces(s: list[float], values: list[float], tolerance: float) -> list[tuple[float, ...]]:
    """Start, value and slope of few straight pieces through values at increasing `s`."""
    pieces: list[tuple[float, ...]] = []
    first = 0
    while first < len(s) - 1:
        end = first + 1
        low, high = -float("inf"), float("inf")
        slope = (values[end] - values[first]) / (s[end] - s[first])
        for at in range(first + 1, len(s)):
            run = s[at] - s[first]
            rise = values[at] - values[first]
            if not low <= rise / run <= high:
                break
            end, slope = at, rise / run
            low = max(low, (rise - tolerance) / run)
            high = min(high, (rise + tolerance) / run)
        pieces.append((s[first], values[first], 0.0 if abs(slope) < 1e-12 else slope))
        first = end
    return pieces or [(s[0], values[0], 0.0)]
