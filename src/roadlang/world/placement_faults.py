"""Faults that need no geometry to be found. Imports no numpy: files are checked without it."""

from __future__ import annotations

import math

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..ir.scenario import ScenarioActor, ScenarioImage

DEFAULT_APART = 0.5
"""Meters between two things of which neither says more or less"""


def missing_scale(image: ScenarioImage, world_file: str | None = None) -> Diagnostic:
    """RL406: neither the image nor its file says how large a pixel is. `world_file`: what is wrong
    with the one beside it."""
    beside = () if world_file is None else (world_file,)
    help_ = (*beside, "add `scale: 0.35m/px` with the true number")
    return diagnose(Code.MISSING_SCALE, image.span, name=image.name, help=help_)


def no_place_on_earth(image: ScenarioImage, latitude: float, longitude: float) -> Diagnostic | None:
    """RL480 where the `origin` of an image is not a latitude and longitude, in degrees."""
    if abs(latitude) < 90.0 and abs(longitude) <= 180.0:
        return None
    return diagnose(
        Code.INVALID_OPTION,
        image.span,
        option="origin",
        kind="image",
        reason=f"({latitude:g}deg, {longitude:g}deg) is not a latitude and longitude",
        help="it is written `(latitude, longitude)`",
    )


def unknown_lane(
    actor: ScenarioActor, lane: int, known: tuple[int, ...], span: Span | None = None
) -> Diagnostic | None:
    """RL613 where the lanes of the road of an actor have other numbers; at `span`, or where its
    own lane or position is written."""
    if lane in known:
        return None
    place = span or actor.span_of("lane" if "lane" in actor.options else "at")
    help_ = f"its lanes are {', '.join(map(str, known))}"
    return diagnose(Code.UNKNOWN_LANE, place, road=actor.on, lane=lane, help=help_)


def row_or_anywhere(spacing: float, more: str = "") -> str:
    """What to do with copies on a road that all stand in one place. `spacing`: meters that they
    need in a row; `more`: of those that differ in length between scenes."""
    row = f"`spacing: {math.ceil(spacing)}m`{more}"
    return f"put its copies in a row with {row}, or anywhere with `at random`"


def beyond_the_end(name: str, meters: float, road: str) -> str:
    """That there is not enough of a road for an agent or object, in words."""
    return f"`{name}` would stand {float(f'{meters:.3g}'):g}m beyond the end of {road}"
