"""A concrete scene: one sample of every random value, with geometry. SI units and radians."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .read_only import Frozen

SCENE_SCHEMA = "roadlang.scene/2"


@dataclass(frozen=True, slots=True)
class SceneRoad:
    """One curve. `stations` is arc length along this road itself; all tuples are as long.

    `reference_stations` is the arc length of the root road at the same points: the positions of
    the requirements. `base` is the (n, 2) center line of the root road, for the ghost.
    """

    name: str
    stations: tuple[float, ...]
    reference_stations: tuple[float, ...]
    x: tuple[float, ...]
    y: tuple[float, ...]
    heading: tuple[float, ...]
    curvature: tuple[float, ...]
    width: tuple[float, ...]
    lanes: int
    closed: bool
    length: float
    root: str
    network: str | None = None
    """the network this is an edge of, else None"""
    edge: int | None = None
    derived: bool = False
    """True for the last road of a chain: what is driven, drawn in full and built"""


@dataclass(frozen=True, slots=True)
class SceneNode:
    """A point where roads of a network meet or end; x and y in meters."""

    id: int
    x: float
    y: float
    roads: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SceneNetwork:
    """Its roads are in `Scene.roads`, named `town/3` for edge 3 of network `town`."""

    name: str
    nodes: tuple[SceneNode, ...]
    roads: tuple[str, ...]
    confidence: float = 1.0
    mask: str | None = None
    """PNG of the road pixels, base64, where the extractor has one (`road: tiles`)"""
    mask_scale: float | None = None
    mask_origin: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Call(Frozen):
    """A kind with every option concrete, defaults included."""

    kind: str
    options: Mapping[str, Any] = field(default_factory=dict)
    when: Mapping[str, Any] | None = None
    """condition as JSON formula with its signals, where the call has one"""


@dataclass(frozen=True, slots=True)
class SceneActor(Frozen):
    """An agent or object, placed. A group has one for each copy, `name` with `[i]`."""

    name: str
    group: str
    kind: str
    x: float
    y: float
    heading: float
    length: float
    width: float
    height: float
    road: str | None = None
    start: float | None = None
    """arc length along `road`"""
    offset: float | None = None
    """left of the center line, meters"""
    lane: int | None = None
    facing: str = "forward"
    options: Mapping[str, Any] = field(default_factory=dict)
    drive: tuple[Call, ...] = ()


@dataclass(frozen=True, slots=True)
class Stretch:
    """Where a requirement is violated: arc length of the root road, meters."""

    road: str
    start: float
    end: float


@dataclass(frozen=True, slots=True)
class RoadPlace:
    """A place on a road: arc length of the root road, meters."""

    road: str
    station: float


@dataclass(frozen=True, slots=True)
class Profile:
    """Values along a road: `stations` is arc length of the root road, as long as `values`."""

    road: str
    stations: tuple[float, ...]
    values: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class SceneSignal:
    """A `let` that names a signal over roads; of a network, a profile for each of its roads."""

    name: str
    text: str
    unit: str
    """SI unit of the values, such as `m` or `1/m`; empty for dimensionless numbers"""
    profiles: tuple[Profile, ...]


@dataclass(frozen=True, slots=True)
class Verdict(Frozen):
    """A `require` or `expect` of this scene. `robustness` is None for what is judged later."""

    name: str
    text: str
    domain: str
    robustness: float | None
    satisfied: bool | None
    violated: tuple[Stretch, ...] = ()
    formula: Mapping[str, Any] | None = None
    profiles: tuple[Profile, ...] = ()
    """of `always p` and `eventually p` over roads: the robustness of `p` along each road"""
    tightest: RoadPlace | None = None
    """where the robustness is attained: the least of `always p`, the greatest of `eventually p`"""


@dataclass(frozen=True, slots=True)
class Provenance(Frozen):
    """What this scene was made from and by. `plugins` maps distribution to version."""

    roadlang: str
    seed: int
    scene: int
    attempt: int
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    source: str = ""
    overrides: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Scene(Frozen):
    """All that a backend gets."""

    name: str
    title: str
    index: int
    provenance: Provenance
    values: Mapping[str, Any] = field(default_factory=dict)
    """params and lets that are values"""
    draws: Mapping[str, Any] = field(default_factory=dict)
    """every random value by its place"""
    units: Mapping[str, str] = field(default_factory=dict)
    """SI units of the values and draws that have one, by name and place"""
    networks: tuple[SceneNetwork, ...] = ()
    roads: tuple[SceneRoad, ...] = ()
    agents: tuple[SceneActor, ...] = ()
    objects: tuple[SceneActor, ...] = ()
    world: Mapping[str, Any] = field(default_factory=dict)
    signals: tuple[SceneSignal, ...] = ()
    """the `let`s that name signals over roads, with their values"""
    requirements: tuple[Verdict, ...] = ()
    expectations: tuple[Verdict, ...] = ()
    simulate: Call | None = None
    schema: str = SCENE_SCHEMA
