"""Agents and objects of a concrete scene, and the calls of kinds in one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .read_only import Frozen
from .scene_route import SceneRoute
from .scene_sensor import SceneSensor


@dataclass(frozen=True, slots=True)
class Call(Frozen):
    """A kind with every option concrete, defaults included."""

    kind: str
    """its name, `pure_pursuit`; of another plugin with the plugin's, `acme.mpc`"""
    options: Mapping[str, Any] = field(default_factory=dict)
    """by name, in SI units and radians"""
    when: Mapping[str, Any] | None = None
    """condition of its start as JSON formula with its signals, where the call has one"""
    during: Mapping[str, Any] | None = None
    """condition without which it is not active, written `while`, where the call has one"""


@dataclass(frozen=True, slots=True)
class SceneActor(Frozen):
    """An agent or object, placed. A group has one for each copy, `name` with `[i]`."""

    name: str
    """`oncoming[2]` is the third of the group `oncoming`"""
    group: str
    """the name as declared"""
    kind: str
    """`car`, `tree`, ..."""
    x: float
    """center of the footprint, meters east"""
    y: float
    """center of the footprint, meters north"""
    heading: float
    """radians, counter-clockwise from east"""
    length: float
    """meters"""
    width: float
    """meters"""
    height: float
    """meters"""
    road: str | None = None
    """the road it stands on, if it stands on one"""
    start: float | None = None
    """arc length along `road`"""
    offset: float | None = None
    """left of the center line, meters"""
    lane: int | None = None
    """as in OpenDRIVE: -1 first to the right of the center line, 1 first to the left"""
    facing: str = "forward"
    """`forward` or `back`, along the road"""
    options: Mapping[str, Any] = field(default_factory=dict)
    """every option of the kind"""
    drive: tuple[Call, ...] = ()
    """the controllers of an agent, in order"""
    start_speed: float | None = None
    """of an agent at the start, m/s, in the direction of its heading; null: 0"""
    route: SceneRoute | None = None
    """of an agent through a network; null: it follows its road and lane"""
    sensors: tuple[SceneSensor, ...] = ()
    """of an agent, in the order of the scene file"""
    category: str = ""
    """what it is in files for other tools, one of a list: `car`, `pedestrian`, `tree`, ..."""
    role: str = ""
    """of a vehicle: `taxi`, `police`, `ambulance`, `fire`, or empty"""
