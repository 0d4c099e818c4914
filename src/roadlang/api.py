"""All that a plugin author imports; what only running kinds need is imported at its first use."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import geometry
from .diagnostics.renamed_names import current_name
from .ir.dimension import (
    ACCELERATION,
    ANGLE,
    AREA,
    CURVATURE,
    FORCE,
    FREQUENCY,
    JERK,
    LENGTH,
    MASS,
    PIXELS,
    PURE,
    SCALE,
    SPEED,
    TIME,
    Dimension,
)  # fmt: skip
from .plugins.annotations import (
    Acceleration,
    AgentName,
    AgentOrObject,
    Angle,
    Anything,
    Between,
    Condition,
    ConstraintNames,
    Curvature,
    Duration,
    File,
    Flag,
    ImageName,
    Integer,
    Jerk,
    Length,
    LengthInterval,
    Like,
    ListOf,
    Mass,
    Number,
    PixelPoint,
    Pixels,
    Point,
    PointInSpace,
    RoadName,
    RoadOrNetwork,
    Scale,
    Speed,
    String,
    Word,
    call_of,
    kind_of,
    list_of,
    map_of,
    one_of,
    pair_of,
    quantity,
    record_of,
)
from .plugins.kinds import (
    LANE_END_GAP,
    ROAD_PLACES,
    STANDING_GAP,
    Adjuster,
    AgentKind,
    Axis,
    Backend,
    Controller,
    Distribution,
    Drawer,
    DrawnValue,
    DriveSignal,
    Extractor,
    InitialSpeed,
    JunctionControl,
    Kind,
    LaneKind,
    Monitor,
    ObjectKind,
    Perturber,
    Piece,
    Position,
    Reader,
    ReadingArray,
    Region,
    RightOfWay,
    RoadNumber,
    Sampler,
    Search,
    Searcher,
    Selector,
    Sensor,
    Signal,
    Simulator,
    Standing,
)
from .plugins.option_error import OptionError
from .plugins.options import option
from .version import API_VERSION

if TYPE_CHECKING:
    from .diagnostics import (
        Code,
        Diagnostic,
        DiagnosticError,
        Fix,
        Label,
        Source,
        Span,
        diagnose,
        did_you_mean,
    )
    from .files.table_text import number_in
    from .images.plugin_input import read_image, read_input, read_text
    from .ir.actuation import ActuationBatch
    from .ir.batch import BatchRandom, RoadBatch
    from .ir.category import GREENERY, ON_FOOT, VEHICLES
    from .ir.control import Control, ControlBatch
    from .ir.dataset import Dataset, DatasetFrame
    from .ir.encoding import scene_from_json, to_json
    from .ir.frame_labels import CameraGeometry, FrameLabels, LabeledThing
    from .ir.observation import Observation, ObservationBatch
    from .ir.picture import Extraction, FoundObject, Picture
    from .ir.placed_batch import PlacedBatch
    from .ir.readings import Reading, SensorRecord
    from .ir.road_bounds import RoadBounds
    from .ir.scenario_contents import ScenarioContents
    from .ir.scene import (
        Call,
        Profile,
        Provenance,
        RoadPlace,
        Scene,
        SceneActor,
        SceneNetwork,
        SceneNode,
        SceneRoad,
        SceneSensor,
        SceneSignal,
        Verdict,
        ViolatedSegment,
    )
    from .ir.scene_junctions import (
        SceneArm,
        SceneConflict,
        SceneConnection,
        SceneControl,
        SceneJunction,
        SceneLaneEnd,
        SceneRefusal,
        SignalPhase,
    )
    from .ir.scene_lane import SceneLane
    from .ir.scene_road import RoadPart
    from .ir.scene_route import RouteStep, RouteTurn, SceneRoute
    from .ir.scene_surface import SurfaceName, SurfacePatch
    from .ir.sensed_batch import SensedBatch, SolidThings
    from .ir.surface_stretches import SurfaceStretch, junction_surface, surface_stretches
    from .ir.surroundings import LanePlace, LanePlaces, LanesBeside, Neighbor, Neighbors
    from .ir.trace import AgentTrace, Trace
    from .plugins.hookspecs import hookimpl
    from .plugins.program_environment import program_environment
    from .scenes.figure_colors import FIGURE_COLORS, FigureColors
    from .scenes.junction_curbs import CurbCorner, beside_curb, junction_curbs
    from .scenes.junction_paint import PaintedShape, crosswalk_paint, junction_paint
    from .scenes.paint_rings import paint_rings
    from .scenes.shown_junctions import shown_junctions
    from .scenes.signal_heads import SignalHead, signal_heads
    from .scenes.surface_heights import CURB_HEIGHT, PAINT_HEIGHT
    from .simulation.calling.decision import Decision
    from .simulation.lanes.surfaces import road_surface, surface_names
    from .simulation.lines.lane_guides import lane_guide
    from .simulation.lines.route_lines import route_points
    from .simulation.mirroring import Mirror
    from .simulation.observing.observation_vector import ObservationVector
    from .simulation.observing.sensing import DueReading
    from .simulation.simulating import EngineSettings, simulate_scenes
    from .simulation.surroundings.contacts import Contact
    from .simulation.vehicles.bodies import Body, body_of, vehicle_parameters
    from .simulation.vehicles.line_steering import line_steering

# Checking a scene file imports the kinds that it names, and should not pay for scenes and traces.
_LATER = {
    ".diagnostics": "Code Diagnostic DiagnosticError Fix Label Source Span diagnose did_you_mean",
    ".ir.actuation": "ActuationBatch",
    ".ir.batch": "BatchRandom RoadBatch",
    ".ir.category": "GREENERY ON_FOOT VEHICLES",
    ".ir.placed_batch": "PlacedBatch",
    ".ir.control": "Control ControlBatch",
    ".ir.observation": "Observation ObservationBatch",
    ".ir.dataset": "Dataset DatasetFrame",
    ".ir.encoding": "scene_from_json to_json",
    ".ir.frame_labels": "CameraGeometry FrameLabels LabeledThing",
    ".ir.picture": "Extraction FoundObject Picture",
    ".ir.readings": "Reading SensorRecord",
    ".ir.road_bounds": "RoadBounds",
    ".ir.scenario_contents": "ScenarioContents",
    ".ir.scene": (
        "Call Profile Provenance RoadPlace Scene SceneActor SceneNetwork SceneNode SceneRoad"
        " SceneSensor SceneSignal Verdict ViolatedSegment"
    ),
    ".ir.scene_lane": "SceneLane",
    ".ir.scene_road": "RoadPart",
    ".ir.scene_route": "RouteStep RouteTurn SceneRoute",
    ".ir.scene_junctions": (
        "SceneArm SceneConflict SceneConnection SceneControl SceneJunction SceneLaneEnd"
        " SceneRefusal SignalPhase"
    ),
    ".ir.scene_surface": "SurfaceName SurfacePatch",
    ".ir.sensed_batch": "SensedBatch SolidThings",
    ".ir.surface_stretches": "SurfaceStretch junction_surface surface_stretches",
    ".ir.surroundings": "LanePlace LanePlaces LanesBeside Neighbor Neighbors",
    ".ir.trace": "AgentTrace Trace",
    ".files.table_text": "number_in",
    ".images.plugin_input": "read_image read_input read_text",
    ".plugins.hookspecs": "hookimpl",
    ".plugins.program_environment": "program_environment",
    ".scenes.figure_colors": "FIGURE_COLORS FigureColors",
    ".scenes.junction_curbs": "CurbCorner beside_curb junction_curbs",
    ".scenes.junction_paint": "PaintedShape crosswalk_paint junction_paint",
    ".scenes.paint_rings": "paint_rings",
    ".scenes.shown_junctions": "shown_junctions",
    ".scenes.signal_heads": "SignalHead signal_heads",
    ".scenes.surface_heights": "CURB_HEIGHT PAINT_HEIGHT",
    ".simulation.calling.decision": "Decision",
    ".simulation.lanes.surfaces": "road_surface surface_names",
    ".simulation.lines.lane_guides": "lane_guide",
    ".simulation.lines.route_lines": "route_points",
    ".simulation.mirroring": "Mirror",
    ".simulation.observing.observation_vector": "ObservationVector",
    ".simulation.observing.sensing": "DueReading",
    ".simulation.simulating": "EngineSettings simulate_scenes",
    ".simulation.surroundings.contacts": "Contact",
    ".simulation.vehicles.bodies": "Body body_of vehicle_parameters",
    ".simulation.vehicles.line_steering": "line_steering",
}
_HOME = {name: module for module, names in _LATER.items() for name in names.split()}

__all__ = [
    "ACCELERATION", "ANGLE", "API_VERSION", "AREA", "CURB_HEIGHT", "CURVATURE", "FIGURE_COLORS",
    "FORCE", "FREQUENCY", "GREENERY", "JERK", "LANE_END_GAP", "LENGTH", "MASS", "ON_FOOT",
    "PAINT_HEIGHT", "PIXELS", "PURE", "ROAD_PLACES", "SCALE", "SPEED", "STANDING_GAP", "TIME",
    "VEHICLES", "Acceleration", "ActuationBatch", "Adjuster", "AgentKind", "AgentName",
    "AgentOrObject", "AgentTrace", "Angle", "Anything", "Axis", "Backend", "BatchRandom", "Between",
    "Body", "Call", "CameraGeometry", "Code", "Condition", "ConstraintNames", "Contact", "Control",
    "ControlBatch", "Controller", "CurbCorner", "Curvature", "Dataset", "DatasetFrame", "Decision",
    "Diagnostic", "DiagnosticError", "Dimension", "Distribution", "Drawer", "DrawnValue",
    "DriveSignal", "DueReading", "Duration", "EngineSettings", "Extraction", "Extractor",
    "FigureColors", "File", "Fix", "Flag", "FoundObject", "FrameLabels", "ImageName",
    "InitialSpeed", "Integer", "Jerk", "JunctionControl", "Kind", "Label", "LabeledThing",
    "LaneKind", "LanePlace", "LanePlaces", "LanesBeside", "Length", "LengthInterval", "Like",
    "ListOf", "Mass", "Mirror", "Monitor", "Neighbor", "Neighbors", "Number", "ObjectKind",
    "Observation", "ObservationBatch", "ObservationVector", "OptionError", "PaintedShape",
    "Perturber", "Picture", "Piece", "PixelPoint", "Pixels", "PlacedBatch", "Point", "PointInSpace",
    "Position", "Profile", "Provenance", "Reader", "Reading", "ReadingArray", "Region",
    "RightOfWay", "RoadBatch", "RoadBounds", "RoadName", "RoadNumber", "RoadOrNetwork", "RoadPart",
    "RoadPlace", "RouteStep", "RouteTurn", "Sampler", "Scale", "ScenarioContents", "Scene",
    "SceneActor", "SceneArm", "SceneConflict", "SceneConnection", "SceneControl", "SceneJunction",
    "SceneLane", "SceneLaneEnd", "SceneNetwork", "SceneNode", "SceneRefusal", "SceneRoad",
    "SceneRoute", "SceneSensor", "SceneSignal", "Search", "Searcher", "Selector", "SensedBatch",
    "Sensor", "SensorRecord", "Signal", "SignalHead", "SignalPhase", "Simulator", "SolidThings",
    "Source", "Span", "Speed", "Standing", "String", "SurfaceName", "SurfacePatch",
    "SurfaceStretch", "Trace", "Verdict", "ViolatedSegment", "Word", "beside_curb", "body_of",
    "call_of", "crosswalk_paint", "diagnose", "did_you_mean", "geometry", "hookimpl",
    "junction_curbs", "junction_paint", "junction_surface", "kind_of", "lane_guide",
    "line_steering", "list_of", "map_of", "number_in", "one_of", "option", "paint_rings", "pair_of",
    "program_environment", "quantity", "read_image", "read_input", "read_text", "record_of",
    "road_surface", "route_points", "scene_from_json", "shown_junctions", "signal_heads",
    "simulate_scenes", "surface_names", "surface_stretches", "to_json", "vehicle_parameters",
]  # fmt: skip


_RENAMED = {"Stretch": "ViolatedSegment", "Whole": "Integer"}


def __getattr__(name: str) -> Any:
    if name == "__path__":  # each `from roadlang.api import` asks for it, in steps of drives too
        raise AttributeError(name)
    current = current_name(__name__, name, _RENAMED)
    if current in globals():
        return globals()[current]
    if current not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(_HOME[current], __package__), current)
    if current == name:  # found at once from now on: controllers import it in every step
        globals()[name] = found
    return found


def __dir__() -> list[str]:
    return __all__
