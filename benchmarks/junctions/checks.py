"""Checks of a plan of junctions, written without the code that made it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np
import shapely

from roadlang.geometry.junctions.one_way import one_way
from roadlang.geometry.lanes.cross_section import CrossSection
from roadlang.geometry.networks.junction_model import Arm, Connection, Junction, JunctionPlan
from roadlang.geometry.networks.network import RoadNetwork

LIMIT = 0.01
_TURN = math.radians(150.0)


@dataclass
class Report:
    """Faults by name of the check, for one junction."""

    junction: Junction
    faults: dict[str, float] = field(default_factory=dict)

    def note(self, check: str, amount: float) -> None:
        """The greatest amount of each fault counts."""
        self.faults[check] = max(self.faults.get(check, 0.0), amount)


def connection_points(connection: Connection, step: float = 0.1) -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 2) and headings (n,) along a connection, integrated piece by piece."""
    x, y, heading = connection.start
    points, headings = [(x, y)], [heading]
    for length, curvature in connection.pieces:
        count = max(1, math.ceil(length / step))
        for part in range(1, count + 1):
            s = length * part / count
            if abs(curvature) < 1e-12:
                dx, dy = s, 0.0
            else:
                dx = math.sin(curvature * s) / curvature
                dy = (1.0 - math.cos(curvature * s)) / curvature
            points.append(
                (
                    x + dx * math.cos(heading) - dy * math.sin(heading),
                    y + dx * math.sin(heading) + dy * math.cos(heading),
                )
            )
            headings.append(heading + curvature * s)
        x, y = points[-1]
        heading = headings[-1]
    return np.array(points), np.array(headings)


def check_junction(
    junction: Junction,
    plan: JunctionPlan,
    network: RoadNetwork,
    sections: dict[int, CrossSection],
) -> Report:
    """All checks of one junction. `sections` with the roads of roundabouts one-way."""
    report = Report(junction)
    area = shapely.Polygon(junction.area)
    if not area.is_valid or not area.exterior.is_ccw:
        report.note("area", 1.0)
        area = area.buffer(0)
    roads: dict[tuple[int, str], Any] = {}
    for arm in junction.arms:
        _check_face(report, arm, area, network, sections)
        roads[arm.edge, arm.end] = _road(arm, plan, network, sections)
    for road in roads.values():
        if road is not None and road.buffer(-0.005).intersects(area.buffer(-0.005)):
            report.note("area over road", 1.0)
    for (_, a), (_, b) in combinations(roads.items(), 2):
        if a is not None and b is not None and a.buffer(-0.005).intersects(b.buffer(-0.005)):
            report.note("roads overlap", 1.0)
    for connection in junction.connections:
        _check_connection(report, connection, (area, roads), plan, network, sections)
    _check_conflicts(report)
    return report


def _pose(edge: int, end: str, plan: JunctionPlan, network: RoadNetwork) -> tuple[float, float]:
    """Arc length of a face, and 1 where the road runs away from the junction."""
    trims = plan.trims[edge]
    if end == "start":
        return trims[0], 1.0
    return network.edge(edge).length - trims[1], -1.0


def _check_face(
    report: Report,
    arm: Arm,
    area: Any,
    network: RoadNetwork,
    sections: dict[int, CrossSection],
) -> None:
    edge = network.edge(arm.edge)
    s = arm.trim if arm.end == "start" else edge.length - arm.trim
    left, right = sections[arm.edge].half_widths(s)
    across = np.linspace(-float(right), float(left), 11)
    points = edge.curve.at(s) + across[:, None] * edge.curve.normal(s)
    gap = float(shapely.distance(area, shapely.points(points)).max())
    if gap > LIMIT:
        report.note("gap at face", gap)
    corners = [points[-1], points[0]] if arm.end == "start" else [points[0], points[-1]]
    for index, corner in zip((arm.left, arm.right), corners, strict=True):
        away = float(np.hypot(*(np.array(report.junction.area[index]) - corner)))
        if away > LIMIT:
            report.note("face corner", away)


def _road(
    arm: Arm, plan: JunctionPlan, network: RoadNetwork, sections: dict[int, CrossSection]
) -> Any:
    """The surface of a road over the 15 m beyond its trim."""
    edge = network.edge(arm.edge)
    start, stop = plan.trims[arm.edge][0], edge.length - plan.trims[arm.edge][1]
    # Of a road with both its ends at one junction neither end reaches into the other.
    ahead = min(15.0, (stop - start) / 2.0)
    if arm.end == "start":
        stop = start + ahead
    else:
        start = stop - ahead
    if stop - start < 0.05:
        return None
    s = np.linspace(start, stop, 61)
    left, right = sections[arm.edge].half_widths(s)
    points, normal = edge.curve.at(s), edge.curve.normal(s)
    ring = np.concatenate(
        [points + left[:, None] * normal, (points - right[:, None] * normal)[::-1]]
    )
    return shapely.Polygon(ring).buffer(0)


def _check_connection(
    report: Report,
    connection: Connection,
    surfaces: tuple[Any, dict[tuple[int, str], Any]],
    plan: JunctionPlan,
    network: RoadNetwork,
    sections: dict[int, CrossSection],
) -> None:
    area, roads = surfaces
    points, headings = connection_points(connection)
    if connection.curvature > 0.25 + 1e-9:
        report.note("curvature", connection.curvature)
    if connection.curvature * max(connection.widths) / 2.0 >= 1.0:
        report.note("fold", connection.curvature)
    for lane, at, heading, inward in (
        (connection.source, points[0], headings[0], True),
        (connection.target, points[-1], headings[-1], False),
    ):
        s, away = _pose(lane.edge, lane.end, plan, network)
        curve = network.edge(lane.edge).curve
        offset = float(sections[lane.edge].offset(lane.lane, s))
        wanted = curve.at(s) + offset * curve.normal(s)
        gap = float(np.hypot(*(at - wanted)))
        facing = float(curve.heading(s)) + (0.0 if (away > 0) != inward else math.pi)
        turn = abs((heading - facing + math.pi) % (2 * math.pi) - math.pi)
        if gap > LIMIT:
            report.note("end position", gap)
        if turn > math.radians(0.1):
            report.note("end heading", turn)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    share = along / along[-1]
    half = (connection.widths[0] * (1 - share) + connection.widths[1] * share) / 2.0
    normal = np.column_stack([-np.sin(headings), np.cos(headings)])
    borders = np.concatenate([points + half[:, None] * normal, points - half[:, None] * normal])
    gap = float(shapely.distance(area, shapely.points(borders)).max())
    if gap > LIMIT:
        report.note("off the area", gap)
    own = {
        (connection.source.edge, connection.source.end),
        (connection.target.edge, connection.target.end),
    }
    for key, road in roads.items():
        if key not in own and road is not None:
            inner = road.buffer(-LIMIT)
            if shapely.intersects(inner, shapely.points(borders)).any():
                report.note("over a third arm", 1.0)


def _check_conflicts(report: Report) -> None:
    junction = report.junction
    listed = {frozenset((c.a, c.b)) for c in junction.conflicts}
    lines = {c.id: shapely.LineString(connection_points(c, 0.5)[0]) for c in junction.connections}
    for a, b in combinations(junction.connections, 2):
        if a.source == b.source or frozenset((a.id, b.id)) in listed:
            continue
        if a.target == b.target or lines[a.id].crosses(lines[b.id]):
            report.note("conflict not listed", 1.0)
    both = {frozenset(pair) for pair in junction.yields}
    if len(both) < len(junction.yields):
        report.note("both yield", 1.0)


def effective_sections(
    plan: JunctionPlan, sections: dict[int, CrossSection]
) -> dict[int, CrossSection]:
    """The sections of all roads, those of roundabouts one-way."""
    changed = {edge: one_way(sections[edge], forward) for edge, forward in plan.ring.items()}
    return {**sections, **changed}


@dataclass
class Figures:
    """What is counted over many junctions."""

    junctions: int = 0
    merged: int = 0
    turns: int = 0
    refused: int = 0
    faulty: int = 0
    faulty_merged: int = 0
    unreported: int = 0
    overlapping: int = 0
    """junctions with arms that overlap farther than any trim: the drawing has them so"""
    overlapping_merged: int = 0
    overlapping_faulty: int = 0
    overlapping_faulty_merged: int = 0
    overlapping_refused: int = 0
    faults: dict[str, int] = field(default_factory=dict)

    def add(self, report: Report, plan: JunctionPlan) -> None:
        """Counts a junction."""
        junction = report.junction
        merged = len(junction.nodes) > 1
        drawn_over = {edge for p in plan.problems if p.kind == "overlap" for edge in p.edges}
        apart = not drawn_over.isdisjoint(arm.edge for arm in junction.arms)
        self.overlapping += apart
        self.overlapping_merged += apart and merged
        self.overlapping_faulty += apart and bool(report.faults)
        self.overlapping_faulty_merged += apart and merged and bool(report.faults)
        self.junctions += 1
        self.merged += merged
        tight = sum(abs(refusal.angle) <= _TURN for refusal in junction.refused)
        self.refused += tight
        self.overlapping_refused += tight if apart else 0
        self.turns += tight + sum(
            abs(sum(length * curvature for length, curvature in c.pieces)) <= _TURN
            for c in junction.connections
        )
        if report.faults:
            self.faulty += 1
            self.faulty_merged += merged
            if not any(problem.junction == junction.id for problem in plan.problems):
                self.unreported += 1
        for name in report.faults:
            self.faults[name] = self.faults.get(name, 0) + 1
