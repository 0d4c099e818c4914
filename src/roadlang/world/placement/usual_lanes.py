"""The lane of an agent that says nothing about where across its road it begins."""

from __future__ import annotations

from ...evaluate.copies import CopyBatch
from ...geometry import CrossSection
from ...geometry.arrays import Booleans
from ...ir.category import PEDESTRIAN
from ...ir.scenario import ScenarioActor
from .copies import kinds_of, most_copies

ON_FOOT = "on foot"
"""Stands, beside the words that a file may write for `lane`, for a lane of pedestrians, or where
there is none for the first one of vehicles."""
_ACROSS = frozenset({"lane", "side", "offset"})


def walk_at_side(actor: ScenarioActor, copies: CopyBatch) -> Booleans | None:
    """(R,) which copies are pedestrians that begin in a lane for pedestrians if there is one, as
    nothing else is said; None where none is."""
    if _ACROSS & actor.options.keys() or actor.name not in copies.scenario.agents:
        return None
    walk = kinds_of(actor, copies.candidates).are_pedestrians
    if not walk.any():
        return None
    most = most_copies(actor, copies.candidates)
    found: Booleans = walk[copies.rows * most + copies.copies - 1]
    return found


def lanes_on_foot(section: CrossSection) -> list[int]:
    """The ids of the lanes for pedestrians alone."""
    lanes = (lane for lane in section.lanes if not lane.drivable)
    return [lane.id for lane in lanes if PEDESTRIAN in lane.users]
