"""A junction of a place whose turns are fitted: its parts, and what could not be built."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ..arrays import Floats
from ..networks.junction_model import Connection, Junction, LaneEnd, Point, Problem, Refusal
from .area import ring_with_faces, surface
from .arms import ArmKey, ArmLane, ArmLine
from .conflicts import conflicts_of, line_shares
from .connecting import SHARPEST, Connected, pair_widths
from .connection_curves import TIGHTEST, sampled
from .lane_pairs import LanePair
from .places import JunctionSite
from .priority import yields
from .sweeping import TOLERANCE, road_beyond, strip

_TOLERANCE = 0.01
_MOST_TURNED = 1.98
"""Times its radius: a wider lane would run backward at its inner border."""


@dataclass(frozen=True)
class Built:
    """A junction, and what is wrong with it."""

    junction: Junction
    problems: tuple[Problem, ...]


def junction_of(
    place: JunctionSite,
    found: Connected,
    trims: Mapping[ArmKey, float],
    lines: Mapping[ArmKey, ArmLine],
    ring: Mapping[int, bool],
) -> Built:
    """`lines` are both ends of every road of the network, `ring` the roads of roundabouts."""
    widths = [_connection_widths(found, row) for row in range(len(found.pairs))]
    rows = [int(row) for row in np.flatnonzero(found.usable)]
    connections = tuple(_connection(id, found, row, widths[row]) for id, row in enumerate(rows))
    longest = max((connection.length for connection in connections), default=0.0)
    points, _ = sampled(found.fits, line_shares(longest))
    conflicts = conflicts_of(connections, points[rows])
    at_ring = any(arm.edge.id in ring for arm in found.arms)
    entering = {arm.edge.id for arm in found.arms if arm.edge.id not in ring} if at_ring else ()
    area = surface(place, found, trims, widths, place.halves(lines))
    outline, arms, gaps = ring_with_faces(area, found, trims)
    is_joint = len(place.nodes) == 1 and len(arms) == 2
    junction = Junction(
        place.id,
        place.nodes,
        "roundabout" if at_ring else "joint" if is_joint else "junction",
        outline,
        arms,
        connections,
        conflicts,
        yields(connections, conflicts, entering),
        tuple(_refusal(found, row) for row in np.flatnonzero(~found.usable).tolist()),
        place.inside,
    )
    return Built(junction, _problems(junction, found, trims, widths, gaps))


def _connection_widths(found: Connected, row: int) -> tuple[float, float]:
    """Those of the two lanes of a turn; less where the turn is sharper than they are wide. Sharper
    turns than are planned come from maps, which may have a kink in a wide one."""
    most = _MOST_TURNED / min(max(float(found.fits.peak[row]), 1e-9), TIGHTEST)
    source, target = pair_widths(found, found.pairs[row])
    return min(source, most), min(target, most)


def _lanes(found: Connected, pair: LanePair) -> tuple[ArmLane, ArmLane]:
    source = found.lanes[pair.source].inbound[pair.source_lane]
    return source, found.lanes[pair.target].outbound[pair.target_lane]


def _ends(found: Connected, pair: LanePair) -> tuple[LaneEnd, LaneEnd]:
    source, target = _lanes(found, pair)
    return (
        LaneEnd(*found.arms[pair.source].key, source.id),
        LaneEnd(*found.arms[pair.target].key, target.id),
    )


def _connection(id: int, found: Connected, row: int, widths: tuple[float, float]) -> Connection:
    pair, face = found.pairs[row], found.faces[found.pairs[row].source]
    lane, _ = _lanes(found, pair)
    x, y = face.beside(lane.offset)
    heading = (face.heading + 2.0 * math.pi) % (2.0 * math.pi) - math.pi
    stop_line: tuple[Point, Point] = (
        face.beside(lane.offset - lane.width / 2.0),
        face.beside(lane.offset + lane.width / 2.0),
    )
    pieces = found.fits.pieces(row)
    ends = _ends(found, pair)
    return Connection(id, *ends, pair.turn, (x, y, heading), pieces, widths, stop_line)


def _refusal(found: Connected, row: int) -> Refusal:
    pair = found.pairs[row]
    if found.fits.drivable[row]:
        over = [found.arms[arm].edge.id for arm in np.flatnonzero(found.swept[row])]
        reason = f"it runs over road {', '.join(map(str, over))}"
    else:
        radius = 1.0 / max(float(found.fits.peak[row]), 1e-9)
        degrees = abs(math.degrees(pair.angle))
        reason = f"a turn of {degrees:.0f} degrees has room for a radius of {radius:.1f} m only"
    return Refusal(*_ends(found, pair), pair.turn, pair.angle, reason)


def _problems(
    junction: Junction,
    found: Connected,
    trims: Mapping[ArmKey, float],
    widths: list[tuple[float, float]],
    gaps: Floats,
) -> tuple[Problem, ...]:
    id = junction.id
    problems = []
    for refusal in junction.refused:
        if abs(refusal.angle) <= SHARPEST:
            ends = refusal.source.edge, refusal.target.edge
            sweeps = "over road" in refusal.reason
            problems.append(Problem("sweep" if sweeps else "refused", id, ends))
    served = {connection.source for connection in junction.connections}
    for arm, lanes in zip(found.arms, found.lanes, strict=True):
        entries = {LaneEnd(*arm.key, lane.id) for lane in lanes.inbound}
        if entries - served:
            problems.append(Problem("stuck", id, (arm.edge.id,)))
    problems += _overlaps(id, found, trims)
    problems += _outside(junction, found, widths)
    for arm, gap in zip(found.arms, gaps.max(axis=1, initial=0.0), strict=True):
        if gap > _TOLERANCE:
            problems.append(Problem("outside", id, (arm.edge.id,), float(gap)))
    return tuple(dict.fromkeys(problems))


def _overlaps(id: int, found: Connected, trims: Mapping[ArmKey, float]) -> list[Problem]:
    """Roads that overlap beyond their faces."""
    import shapely

    roads = [road_beyond(arm, trims, TOLERANCE / 2.0) for arm in found.arms]
    problems = []
    for (i, first), (j, second) in combinations(enumerate(roads), 2):
        if first is None or second is None or not shapely.intersects(first, second):
            continue
        shared = shapely.intersection(first, second)
        along = max(float(shared.area) / max(_width(found.arms[k]) for k in (i, j)), 0.01)
        box = shapely.bounds(shared)
        along = max(along, float(np.hypot(box[2] - box[0], box[3] - box[1])))
        edges = found.arms[i].edge.id, found.arms[j].edge.id
        problems.append(Problem("overlap", id, edges, along))
    return problems


def _width(arm: ArmLine) -> float:
    return float(arm.left[0] + arm.right[0])


def _outside(
    junction: Junction, found: Connected, widths: list[tuple[float, float]]
) -> list[Problem]:
    """Connections that leave the area."""
    import shapely

    rows = np.flatnonzero(found.usable).tolist()
    if len(rows) == 0:
        return []
    area = shapely.Polygon(junction.area)
    outer = area.buffer(_TOLERANCE / 2.0, quad_segs=2)
    shapely.prepare(outer)
    problems = []
    for row in rows:
        surface = strip(found.fits, row, widths[row])
        if shapely.covers(outer, surface):
            continue
        corners = shapely.points(shapely.get_coordinates(surface))
        gap = float(shapely.distance(area, corners).max())
        if gap > _TOLERANCE:
            pair = found.pairs[row]
            edges = found.arms[pair.source].edge.id, found.arms[pair.target].edge.id
            problems.append(Problem("outside", junction.id, edges, gap))
    return problems
