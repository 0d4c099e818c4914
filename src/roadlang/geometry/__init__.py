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
    from .arrays import Booleans as Booleans
    from .arrays import Floats as Floats
    from .arrays import Integers as Integers
    from .batch import CurveBatch as CurveBatch
    from .clearances import clearance as clearance
    from .cross_section import CrossSection as CrossSection
    from .cross_section import drivable_borders as drivable_borders
    from .crossing import crossings as crossings
    from .crossing import self_crossings as self_crossings
    from .curve import Curve as Curve
    from .dash_pattern import DashPattern as DashPattern
    from .discrete_frechet import frechet as frechet
    from .displacement import DisplacedBatch as DisplacedBatch
    from .displacement import displace as displace
    from .displacement import sample as sample
    from .displacement import undisplaced as undisplaced
    from .distances import lp_norm as lp_norm
    from .distances import margin as margin
    from .distances import pointwise as pointwise
    from .distances import quadrature as quadrature
    from .encounters import encroachment_times as encroachment_times
    from .encounters import time_to_contact as time_to_contact
    from .errors import GeometryError as GeometryError
    from .filleting import filleted as filleted
    from .footprints import Footprints as Footprints
    from .footprints import close_pairs as close_pairs
    from .footprints import distance_between as distance_between
    from .footprints import separation as separation
    from .frame import CurveFrame as CurveFrame
    from .joining import RoadToJoin as RoadToJoin
    from .joining import joined_curve as joined_curve
    from .joining import joined_section as joined_section
    from .joining import parts_with_cut_tapers as parts_with_cut_tapers
    from .joining import seams as seams
    from .joints import anchored_nodes as anchored_nodes
    from .joints import junction_window as junction_window
    from .junctions.model import Junction as Junction
    from .junctions.model import JunctionPlan as JunctionPlan
    from .junctions.model import LaneEnd as LaneEnd
    from .junctions.phases import signal_phases as signal_phases
    from .junctions.plan import PlanOptions as PlanOptions
    from .junctions.plan import plan_junctions as plan_junctions
    from .junctions.priority import minor_roads as minor_roads
    from .lane import Lane as Lane
    from .lane_paint import LINE_WIDTH as LINE_WIDTH
    from .lane_paint import PARKING_LINE_WIDTH as PARKING_LINE_WIDTH
    from .lane_paint import PARKING_SPACE as PARKING_SPACE
    from .lane_paint import BorderLine as BorderLine
    from .lane_paint import border_lines as border_lines
    from .lane_paint import parking_lines as parking_lines
    from .lanes import Marking as Marking
    from .levels import are_apart as are_apart
    from .map_junctions import MapControl as MapControl
    from .map_junctions import MapJunction as MapJunction
    from .map_junctions import MapTurn as MapTurn
    from .moved_batch import MovedBatch as MovedBatch
    from .network import Edge as Edge
    from .network import Node as Node
    from .network import RoadNetwork as RoadNetwork
    from .offsetting import offset as offset
    from .paths import Path as Path
    from .paths import Step as Step
    from .polylines import network_of_polylines as network_of_polylines
    from .profile import OffsetProfile as OffsetProfile
    from .rings import outside_ring as outside_ring
    from .road import Road as Road
    from .round_lengths import round_length as round_length
    from .routes.lane_graph import LaneGraph as LaneGraph
    from .routes.legs import RoutePlace as RoutePlace
    from .routes.shortest import ROOM_TO_BEGIN as ROOM_TO_BEGIN
    from .row_blocks import blocks as blocks
    from .segments import Arc as Arc
    from .segments import Chain as Chain
    from .segments import Clothoid as Clothoid
    from .segments import Straight as Straight
    from .segments import chain as chain
    from .segments import poses_along as poses_along
    from .strokes_of_lanes import LaneStroke as LaneStroke
    from .strokes_of_lanes import are_lines_seen as are_lines_seen
    from .strokes_of_lanes import lane_strokes as lane_strokes
    from .strokes_of_lanes import line_width as line_width
    from .triangulation import triangulated as triangulated
    from .unfolding import unfolded_lines as unfolded_lines
    from .waypoint_curve import through_waypoints as through_waypoints
    from .width import WidthProfile as WidthProfile
    from .window import ease as ease
    from .window import fade as fade
    from .window import over as over

_HOMES = {
    "Booleans": "arrays",
    "Floats": "arrays",
    "Integers": "arrays",
    "encroachment_times": "encounters",
    "time_to_contact": "encounters",
    "GeometryError": "errors",
    "Curve": "curve",
    "Straight": "segments",
    "Arc": "segments",
    "Clothoid": "segments",
    "Chain": "segments",
    "chain": "segments",
    "poses_along": "segments",
    "filleted": "filleting",
    "through_waypoints": "waypoint_curve",
    "CurveFrame": "frame",
    "CurveBatch": "batch",
    "DisplacedBatch": "displacement",
    "MovedBatch": "moved_batch",
    "displace": "displacement",
    "blocks": "row_blocks",
    "sample": "displacement",
    "undisplaced": "displacement",
    "over": "window",
    "fade": "window",
    "ease": "window",
    "outside_ring": "rings",
    "round_length": "round_lengths",
    "triangulated": "triangulation",
    "WidthProfile": "width",
    "OffsetProfile": "profile",
    "Lane": "lane",
    "BorderLine": "lane_paint",
    "LINE_WIDTH": "lane_paint",
    "PARKING_LINE_WIDTH": "lane_paint",
    "PARKING_SPACE": "lane_paint",
    "border_lines": "lane_paint",
    "parking_lines": "lane_paint",
    "DashPattern": "dash_pattern",
    "LaneStroke": "strokes_of_lanes",
    "are_lines_seen": "strokes_of_lanes",
    "lane_strokes": "strokes_of_lanes",
    "line_width": "strokes_of_lanes",
    "unfolded_lines": "unfolding",
    "Marking": "lanes",
    "are_apart": "levels",
    "CrossSection": "cross_section",
    "drivable_borders": "cross_section",
    "Road": "road",
    "RoadToJoin": "joining",
    "joined_curve": "joining",
    "joined_section": "joining",
    "parts_with_cut_tapers": "joining",
    "seams": "joining",
    "offset": "offsetting",
    "Junction": "junctions.model",
    "JunctionPlan": "junctions.model",
    "PlanOptions": "junctions.plan",
    "plan_junctions": "junctions.plan",
    "signal_phases": "junctions.phases",
    "minor_roads": "junctions.priority",
    "LaneEnd": "junctions.model",
    "MapControl": "map_junctions",
    "MapJunction": "map_junctions",
    "MapTurn": "map_junctions",
    "LaneGraph": "routes.lane_graph",
    "ROOM_TO_BEGIN": "routes.shortest",
    "RoutePlace": "routes.legs",
    "Node": "network",
    "Edge": "network",
    "RoadNetwork": "network",
    "Path": "paths",
    "Step": "paths",
    "network_of_polylines": "polylines",
    "anchored_nodes": "joints",
    "junction_window": "joints",
    "pointwise": "distances",
    "lp_norm": "distances",
    "quadrature": "distances",
    "margin": "distances",
    "frechet": "discrete_frechet",
    "clearance": "clearances",
    "crossings": "crossing",
    "self_crossings": "crossing",
    "Footprints": "footprints",
    "separation": "footprints",
    "close_pairs": "footprints",
    "distance_between": "footprints",
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
