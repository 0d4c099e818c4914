"""Plane geometry of roads: meters, radians, x east, y north, numpy float64.

Nothing is imported until a name is used.

- curves by arc length: `Curve`; through a few points that are far apart: `through_waypoints`;
  pieces to draw them from: `Straight`, `Arc`, `Clothoid`, `chain`; of straight lines with rounded
  corners: `filleted`
- many variants at once: `CurveFrame`, `CurveBatch`, `DisplacedBatch`, `displace`, `sample`,
  `undisplaced`
- windows that fade a displacement: `over`, `fade`, `ease`
- roads: `WidthProfile`, `OffsetProfile`, `Lane`, `CrossSection`, `drivable_borders`, `Road`,
  `offset` (without folding); end to end: `RoadToJoin`, `joined_curve`, `joined_section`, `seams`
- networks: `network_of_polylines`, `Node`, `Edge`, `RoadNetwork`, `Path`, `Step`,
  `anchored_nodes`, `junction_window`; lengths for scale bars: `round_length`
- junctions as maps state them: `MapJunction`, `MapTurn`, `MapControl`, `LaneEnd`; their
  plans:
  `plan_junctions`, `PlanOptions`, `JunctionPlan`, `Junction`, `signal_phases`, `minor_roads`;
  triangles of their areas, distance from these: `triangulated`, `outside_ring`
- lanes of a network, and how one leads into others: `LaneGraph`, `RoutePlace`
- lines painted along lanes: `border_lines`, `BorderLine`, `DashPattern`, `parking_lines`,
  `LINE_WIDTH`, `PARKING_LINE_WIDTH`, `PARKING_SPACE`; as figures draw them: `lane_strokes`,
  `LaneStroke`, `line_width`, `are_lines_seen`, `unfolded_lines`
- distances: `pointwise`, `lp_norm`, `quadrature`, `frechet`, `clearance`, `margin`
- rectangles on the ground: `Footprints`, `separation`, `distance_between`, `close_pairs`,
  `time_to_contact`, `encroachment_times`
- crossings: `crossings`, `self_crossings`; whether two places are on different levels: `are_apart`
- errors: `GeometryError`; types of arrays: `Floats`, `Integers`, `Booleans`
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .areas.encounters import encroachment_times as encroachment_times
    from .areas.encounters import time_to_contact as time_to_contact
    from .areas.footprints import Footprints as Footprints
    from .areas.footprints import close_pairs as close_pairs
    from .areas.footprints import distance_between as distance_between
    from .areas.footprints import separation as separation
    from .areas.levels import are_apart as are_apart
    from .areas.rings import outside_ring as outside_ring
    from .areas.triangulation import triangulated as triangulated
    from .arrays import Booleans as Booleans
    from .arrays import Floats as Floats
    from .arrays import Integers as Integers
    from .batches.batch import CurveBatch as CurveBatch
    from .batches.clearances import clearance as clearance
    from .batches.crossing import crossings as crossings
    from .batches.crossing import self_crossings as self_crossings
    from .batches.discrete_frechet import frechet as frechet
    from .batches.displacement import DisplacedBatch as DisplacedBatch
    from .batches.displacement import displace as displace
    from .batches.displacement import sample as sample
    from .batches.displacement import undisplaced as undisplaced
    from .batches.distances import lp_norm as lp_norm
    from .batches.distances import margin as margin
    from .batches.distances import pointwise as pointwise
    from .batches.distances import quadrature as quadrature
    from .batches.frame import CurveFrame as CurveFrame
    from .batches.moved_batch import MovedBatch as MovedBatch
    from .curves.curve import Curve as Curve
    from .curves.filleting import filleted as filleted
    from .curves.offsetting import offset as offset
    from .curves.profile import OffsetProfile as OffsetProfile
    from .curves.segments import Arc as Arc
    from .curves.segments import Chain as Chain
    from .curves.segments import Clothoid as Clothoid
    from .curves.segments import Straight as Straight
    from .curves.segments import chain as chain
    from .curves.segments import poses_along as poses_along
    from .curves.unfolding import unfolded_lines as unfolded_lines
    from .curves.waypoint_curve import through_waypoints as through_waypoints
    from .curves.width import WidthProfile as WidthProfile
    from .curves.window import ease as ease
    from .curves.window import fade as fade
    from .curves.window import over as over
    from .errors import GeometryError as GeometryError
    from .junctions.phases import signal_phases as signal_phases
    from .junctions.plan import PlanOptions as PlanOptions
    from .junctions.plan import plan_junctions as plan_junctions
    from .junctions.priority import minor_roads as minor_roads
    from .lanes.cross_section import CrossSection as CrossSection
    from .lanes.cross_section import drivable_borders as drivable_borders
    from .lanes.dash_pattern import DashPattern as DashPattern
    from .lanes.joining import RoadToJoin as RoadToJoin
    from .lanes.joining import joined_curve as joined_curve
    from .lanes.joining import joined_section as joined_section
    from .lanes.joining import parts_with_cut_tapers as parts_with_cut_tapers
    from .lanes.joining import seams as seams
    from .lanes.lane import Lane as Lane
    from .lanes.lane_paint import LINE_WIDTH as LINE_WIDTH
    from .lanes.lane_paint import PARKING_LINE_WIDTH as PARKING_LINE_WIDTH
    from .lanes.lane_paint import PARKING_SPACE as PARKING_SPACE
    from .lanes.lane_paint import BorderLine as BorderLine
    from .lanes.lane_paint import border_lines as border_lines
    from .lanes.lane_paint import parking_lines as parking_lines
    from .lanes.lanes import Marking as Marking
    from .lanes.road import Road as Road
    from .lanes.strokes_of_lanes import LaneStroke as LaneStroke
    from .lanes.strokes_of_lanes import are_lines_seen as are_lines_seen
    from .lanes.strokes_of_lanes import lane_strokes as lane_strokes
    from .lanes.strokes_of_lanes import line_width as line_width
    from .networks.joints import anchored_nodes as anchored_nodes
    from .networks.joints import junction_window as junction_window
    from .networks.junction_model import Junction as Junction
    from .networks.junction_model import JunctionPlan as JunctionPlan
    from .networks.junction_model import LaneEnd as LaneEnd
    from .networks.map_junctions import MapControl as MapControl
    from .networks.map_junctions import MapJunction as MapJunction
    from .networks.map_junctions import MapTurn as MapTurn
    from .networks.network import Edge as Edge
    from .networks.network import Node as Node
    from .networks.network import RoadNetwork as RoadNetwork
    from .networks.paths import Path as Path
    from .networks.paths import Step as Step
    from .networks.polylines import network_of_polylines as network_of_polylines
    from .numbers.round_lengths import round_length as round_length
    from .numbers.row_blocks import blocks as blocks
    from .routes.lane_graph import LaneGraph as LaneGraph
    from .routes.legs import RoutePlace as RoutePlace
    from .routes.shortest import ROOM_TO_BEGIN as ROOM_TO_BEGIN

_HOMES = {
    "Booleans": "arrays",
    "Floats": "arrays",
    "Integers": "arrays",
    "encroachment_times": "areas.encounters",
    "time_to_contact": "areas.encounters",
    "GeometryError": "errors",
    "Curve": "curves.curve",
    "Straight": "curves.segments",
    "Arc": "curves.segments",
    "Clothoid": "curves.segments",
    "Chain": "curves.segments",
    "chain": "curves.segments",
    "poses_along": "curves.segments",
    "filleted": "curves.filleting",
    "through_waypoints": "curves.waypoint_curve",
    "CurveFrame": "batches.frame",
    "CurveBatch": "batches.batch",
    "DisplacedBatch": "batches.displacement",
    "MovedBatch": "batches.moved_batch",
    "displace": "batches.displacement",
    "blocks": "numbers.row_blocks",
    "sample": "batches.displacement",
    "undisplaced": "batches.displacement",
    "over": "curves.window",
    "fade": "curves.window",
    "ease": "curves.window",
    "outside_ring": "areas.rings",
    "round_length": "numbers.round_lengths",
    "triangulated": "areas.triangulation",
    "WidthProfile": "curves.width",
    "OffsetProfile": "curves.profile",
    "Lane": "lanes.lane",
    "BorderLine": "lanes.lane_paint",
    "LINE_WIDTH": "lanes.lane_paint",
    "PARKING_LINE_WIDTH": "lanes.lane_paint",
    "PARKING_SPACE": "lanes.lane_paint",
    "border_lines": "lanes.lane_paint",
    "parking_lines": "lanes.lane_paint",
    "DashPattern": "lanes.dash_pattern",
    "LaneStroke": "lanes.strokes_of_lanes",
    "are_lines_seen": "lanes.strokes_of_lanes",
    "lane_strokes": "lanes.strokes_of_lanes",
    "line_width": "lanes.strokes_of_lanes",
    "unfolded_lines": "curves.unfolding",
    "Marking": "lanes.lanes",
    "are_apart": "areas.levels",
    "CrossSection": "lanes.cross_section",
    "drivable_borders": "lanes.cross_section",
    "Road": "lanes.road",
    "RoadToJoin": "lanes.joining",
    "joined_curve": "lanes.joining",
    "joined_section": "lanes.joining",
    "parts_with_cut_tapers": "lanes.joining",
    "seams": "lanes.joining",
    "offset": "curves.offsetting",
    "Junction": "networks.junction_model",
    "JunctionPlan": "networks.junction_model",
    "PlanOptions": "junctions.plan",
    "plan_junctions": "junctions.plan",
    "signal_phases": "junctions.phases",
    "minor_roads": "junctions.priority",
    "LaneEnd": "networks.junction_model",
    "MapControl": "networks.map_junctions",
    "MapJunction": "networks.map_junctions",
    "MapTurn": "networks.map_junctions",
    "LaneGraph": "routes.lane_graph",
    "ROOM_TO_BEGIN": "routes.shortest",
    "RoutePlace": "routes.legs",
    "Node": "networks.network",
    "Edge": "networks.network",
    "RoadNetwork": "networks.network",
    "Path": "networks.paths",
    "Step": "networks.paths",
    "network_of_polylines": "networks.polylines",
    "anchored_nodes": "networks.joints",
    "junction_window": "networks.joints",
    "pointwise": "batches.distances",
    "lp_norm": "batches.distances",
    "quadrature": "batches.distances",
    "margin": "batches.distances",
    "frechet": "batches.discrete_frechet",
    "clearance": "batches.clearances",
    "crossings": "batches.crossing",
    "self_crossings": "batches.crossing",
    "Footprints": "areas.footprints",
    "separation": "areas.footprints",
    "close_pairs": "areas.footprints",
    "distance_between": "areas.footprints",
}

__all__ = list(_HOMES)


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    # A function may bear its module's name: bind it here, over the submodule.
    value = globals()[name] = getattr(import_module(f".{_HOMES[name]}", __name__), name)
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
