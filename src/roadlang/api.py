"""All that a plugin author imports.

What is needed only while a kind runs is imported when it is asked for: checking a scene file
imports the kinds that it names, and should not pay for scenes and traces.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import geometry
from .diagnostics import Diagnostic, DiagnosticError, diagnose, did_you_mean
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
)
from .plugins.hookspecs import hookimpl
from .plugins.kinds import (
    Adjuster,
    AgentKind,
    Backend,
    Controller,
    Distribution,
    Drawer,
    DrawnValue,
    DriveSignal,
    Extractor,
    Kind,
    Monitor,
    ObjectKind,
    Perturber,
    Piece,
    Reader,
    RoadNumber,
    Sampler,
    Searcher,
    Selector,
    Signal,
    Simulator,
)
from .plugins.option_types import (
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
    Jerk,
    Length,
    Like,
    Mass,
    Number,
    PixelPoint,
    Pixels,
    Point,
    RoadName,
    RoadOrNetwork,
    Scale,
    Speed,
    Stretch,
    String,
    Whole,
    Word,
    call_of,
    kind_of,
    list_of,
    map_of,
    one_of,
    quantity,
    record_of,
)
from .plugins.options import option

if TYPE_CHECKING:
    from .drive.contract import Control, Observation
    from .ir.batch import BatchRandom, RoadBatch
    from .ir.encoding import to_json
    from .ir.picture import Extraction, FoundObject, Picture
    from .ir.scene import Call, Scene, SceneActor, SceneNetwork, SceneNode, SceneRoad, Verdict
    from .ir.trace import AgentTrace, Trace

_LATER = {
    ".drive.contract": "Control Observation",
    ".ir.batch": "BatchRandom RoadBatch",
    ".ir.encoding": "to_json",
    ".ir.picture": "Extraction FoundObject Picture",
    ".ir.scene": "Call Scene SceneActor SceneNetwork SceneNode SceneRoad Verdict",
    ".ir.trace": "AgentTrace Trace",
}
_HOME = {name: module for module, names in _LATER.items() for name in names.split()}

__all__ = [
    "ACCELERATION",
    "ANGLE",
    "AREA",
    "CURVATURE",
    "FORCE",
    "FREQUENCY",
    "JERK",
    "LENGTH",
    "MASS",
    "PIXELS",
    "PURE",
    "SCALE",
    "SPEED",
    "TIME",
    "Acceleration",
    "Adjuster",
    "AgentKind",
    "AgentName",
    "AgentOrObject",
    "AgentTrace",
    "Angle",
    "Anything",
    "Backend",
    "BatchRandom",
    "Between",
    "Call",
    "Condition",
    "ConstraintNames",
    "Control",
    "Controller",
    "Curvature",
    "Diagnostic",
    "DiagnosticError",
    "Dimension",
    "Distribution",
    "Drawer",
    "DrawnValue",
    "DriveSignal",
    "Duration",
    "Extraction",
    "Extractor",
    "File",
    "Flag",
    "FoundObject",
    "Jerk",
    "Kind",
    "Length",
    "Like",
    "Mass",
    "Monitor",
    "Number",
    "ObjectKind",
    "Observation",
    "Perturber",
    "Picture",
    "Piece",
    "PixelPoint",
    "Pixels",
    "Point",
    "Reader",
    "RoadBatch",
    "RoadName",
    "RoadNumber",
    "RoadOrNetwork",
    "Sampler",
    "Scale",
    "Scene",
    "SceneActor",
    "SceneNetwork",
    "SceneNode",
    "SceneRoad",
    "Searcher",
    "Selector",
    "Signal",
    "Simulator",
    "Speed",
    "Stretch",
    "String",
    "Trace",
    "Verdict",
    "Whole",
    "Word",
    "call_of",
    "diagnose",
    "did_you_mean",
    "geometry",
    "hookimpl",
    "kind_of",
    "list_of",
    "map_of",
    "one_of",
    "option",
    "quantity",
    "record_of",
    "to_json",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOME[name], __package__), name)
