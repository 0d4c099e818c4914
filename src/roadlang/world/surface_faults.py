"""Patches of surfaces that no road has a place for. Imports no numpy: `check` asks for it."""

from __future__ import annotations

from collections.abc import Sequence

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..ir.scenario import ScenarioNetwork, ScenarioRoad

PATCHES = "surface_patches"


def patch_span(link: ScenarioRoad | ScenarioNetwork, place: int) -> Span | None:
    """Where a patch is written, as far as is known: itself, the list, or the statement."""
    spans = link.option_spans
    return spans.get(f"{PATCHES} {place}", spans.get(PATCHES, link.span))


def unknown_patch_road(span: Span | None, road: int, ids: Sequence[int]) -> Diagnostic | None:
    """RL411 for the number of a road that a network does not have. `ids` of its roads; none where
    the patch is one of a road."""
    if road in ids:
        return None
    help_ = f"its roads are {', '.join(map(str, ids))}" if ids else "leave `road` out"
    return diagnose(Code.UNKNOWN_ROAD_ID, span, id=road, help=help_)


def unknown_patch_lane(
    span: Span | None, road: str, lane: int, ids: Sequence[int]
) -> Diagnostic | None:
    """RL613 for the number of a lane that a road does not have."""
    if lane in ids:
        return None
    help_ = f"its lanes are {', '.join(map(str, ids))}"
    return diagnose(Code.UNKNOWN_LANE, span, road=road, lane=lane, help=help_)
