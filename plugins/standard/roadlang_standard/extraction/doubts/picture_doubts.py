"""How sure the roads of a drawing are by the picture in which they were found."""

from __future__ import annotations

from dataclasses import replace

from ..colors.tones import Image
from ..networks.found_network import NO_ROAD, FoundNetwork
from .contrast_of_sides import sure_by_sides
from .outlines import sure_by_outlines
from .share_of_marks import sure_by_share


def with_picture_doubts(
    found: FoundNetwork, image: Image, width: float | None = None
) -> FoundNetwork:
    """The same roads, in the picture (h, w, 3) in which they were found, those less sure that are
    edges, outlines or little of what the picture shows.

    A given `width` does not say where edges are: then all stay as sure as they are.
    """
    # What is at `NO_ROAD` or below is doubtful already: the picture need not be looked at.
    if width is not None or all(road.confidence <= NO_ROAD for road in found.roads):
        return found
    of_all = min(sure_by_share(found, image), sure_by_outlines(found.roads, image))
    sure = sure_by_sides(found.roads, image)
    pairs = zip(found.roads, sure, strict=True)
    return replace(found, roads=tuple(road.less_sure(min(of_all, one)) for road, one in pairs))
