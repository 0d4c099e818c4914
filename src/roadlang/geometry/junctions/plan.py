"""The plan of all junctions of a network: a pure function of its geometry."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..lanes.cross_section import CrossSection
from ..networks.junction_model import Junction, JunctionPlan
from ..networks.network import RoadNetwork
from .arms import ArmKey
from .building import junction_of
from .layout import laid_out
from .mapped import plan_of_map
from .mirroring import mirrored
from .one_way import sections_with_rings
from .overlaps import junction_overlaps, overlaps
from .roundabouts import ring_directions
from .u_turns import with_u_turns


@dataclass(frozen=True, slots=True)
class PlanOptions:
    """`left_hand`: traffic keeps left. `roundabouts`: rings that are nearly circles become one-way,
    and what enters them yields. `u_turns`: junctions have turns back into the road that one comes
    from, where there is room."""

    left_hand: bool = False
    roundabouts: bool = True
    u_turns: bool = False


def plan_junctions(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    options: PlanOptions | None = None,
) -> JunctionPlan:
    """The junctions of a network whose edges have these cross-sections.

    Deterministic: sorted by ids, no random choice. Raises KeyError for an edge without section.
    """
    options = options or PlanOptions()
    if options.left_hand:
        flipped = {id: section.mirrored() for id, section in sections.items()}
        image = network.transformed(np.diag([1.0, -1.0]))
        return mirrored(plan_junctions(image, flipped, replace(options, left_hand=False)))
    if network.junctions is not None:
        return plan_of_map(network, sections)
    rings = ring_directions(network, sections) if options.roundabouts else {}
    ring, sections = sections_with_rings(sections, rings)
    layout = laid_out(network, sections, ring)
    trims, lines = dict(layout.trims), layout.finder.arms
    junctions: list[Junction] = []
    found = list(layout.finder.vanished())
    for place, turns in zip(layout.places, layout.turns, strict=True):
        if options.u_turns:
            turns = with_u_turns(place, turns, trims, lines)
        built = junction_of(place, turns, trims, lines, ring)
        junctions.append(built.junction)
        found += built.problems
    inside = {edge for place in layout.places for edge in place.inside}
    found += junction_overlaps(junctions)
    by_edge = _trims_by_edge(network, trims, inside)
    known = {frozenset(problem.edges) for problem in found if problem.kind == "overlap"}
    found += overlaps(network, sections, by_edge, known)
    return JunctionPlan(tuple(junctions), by_edge, tuple(found), ring)


def _trims_by_edge(
    network: RoadNetwork, trims: Mapping[ArmKey, float], inside: Collection[int]
) -> dict[int, tuple[float, float]]:
    """For every edge; of one inside a junction the two halves."""
    found = {}
    for edge in sorted(network.edges, key=lambda edge: edge.id):
        half = edge.length / 2.0
        ends = trims.get((edge.id, "start"), 0.0), trims.get((edge.id, "end"), 0.0)
        found[edge.id] = (half, half) if edge.id in inside else ends
    return found
