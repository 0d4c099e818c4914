"""The pieces of reference lines as XML."""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree.ElementTree import Element

from .elements import put
from .pieces import ReferencePiece

_SHORTER = 5e-9
"""Share by which the length of a cubic is understated: Scenic fails on one that is longer than what
it finds itself, by so little as a rounding error."""
_CUBIC = ("aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV")


def put_plan_view(parent: Element, pieces: Iterable[ReferencePiece]) -> None:
    """The `planView` of a road."""
    view = put(parent, "planView")
    for piece in pieces:
        shown = 1.0 - _SHORTER if piece.shape == "paramPoly3" else 1.0
        found = put(
            view,
            "geometry",
            s=piece.s,
            x=piece.x,
            y=piece.y,
            hdg=piece.heading,
            length=piece.length * shown,
        )
        match piece.shape:
            case "line":
                put(found, "line")
            case "arc":
                put(found, "arc", curvature=piece.numbers[0])
            case "spiral":
                put(found, "spiral", curvStart=piece.numbers[0], curvEnd=piece.numbers[1])
            case "paramPoly3":
                numbers = dict(zip(_CUBIC, piece.numbers, strict=True))
                put(found, "paramPoly3", **numbers, pRange="normalized")


def put_elevation(parent: Element, pieces: Iterable[tuple[float, ...]]) -> None:
    """The `elevationProfile` of a road, of straight pieces: start, height and slope of each."""
    profile = put(parent, "elevationProfile")
    for start, height, slope in pieces:
        put(profile, "elevation", s=start, a=height, b=slope, c=0.0, d=0.0)
    put(parent, "lateralProfile")
