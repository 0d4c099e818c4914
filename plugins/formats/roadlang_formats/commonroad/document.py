"""A scene, and perhaps its drive, as the text of a CommonRoad file."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from roadlang_formats.lanelets.network import lanelet_map

from ..file_date import DATE
from .elements import put
from .lanelet_elements import put_lanelets, written_lanelets
from .numbering import Numbering
from .obstacles import put_obstacles
from .planning import put_planning_problem
from .road_rules import RoadRules, put_intersections

if TYPE_CHECKING:
    from roadlang.api import Scene, Trace

TOLERANCE = 0.01
"""Meters by which borders may be off."""
TIME_STEP = 0.1
"""Seconds of a time step where nothing was driven."""
_UNKNOWN_PLACE = 999
_NO_GEO_NAME = -999


def document(scene: Scene, trace: Trace | None = None) -> str:
    """The file of a scene; with a drive, the other agents are dynamic obstacles."""
    step = TIME_STEP
    if trace is not None and len(trace.time) > 1:
        step = float(trace.time[1] - trace.time[0])
    numbering = Numbering()
    lanelets = lanelet_map(scene, TOLERANCE)
    ids = {number: numbering.next() for number in written_lanelets(lanelets)}
    rules = RoadRules.of(lanelets, ids, numbering, step)
    root = Element("commonRoad", _attributes(scene, trace, step))
    _put_location(root, scene)
    tags = put(root, "scenarioTags")
    put(tags, "simulated")
    put_lanelets(root, lanelets, ids, rules)
    rules.put(root)
    put_intersections(root, lanelets, ids, numbering)
    put_obstacles(root, scene, trace, numbering)
    put_planning_problem(root, scene, trace, lanelets, ids, numbering, step)
    indent(root, " ")
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"


def _attributes(scene: Scene, trace: Trace | None, step: float) -> dict[str, str]:
    words = re.findall(r"[A-Za-z0-9]+", scene.name) or ["Scene"]
    name = "".join(word[:1].upper() + word[1:] for word in words)
    driven = "_T-1" if trace is not None else ""
    return {
        "commonRoadVersion": "2020a",
        "benchmarkID": f"ZAM_{name}-{scene.index + 1}_1{driven}",
        "date": DATE,
        "author": "roadlang",
        "affiliation": "roadlang",
        "source": "roadlang",
        "timeStepSize": f"{step:.6f}".rstrip("0").rstrip("."),
    }


def _put_location(root: Element, scene: Scene) -> None:
    origins = [network.origin for network in scene.networks if network.origin is not None]
    location = put(root, "location")
    put(location, "geoNameId", _NO_GEO_NAME)
    latitude, longitude = origins[0] if origins else (_UNKNOWN_PLACE, _UNKNOWN_PLACE)
    put(location, "gpsLatitude", latitude)
    put(location, "gpsLongitude", longitude)
