"""A concrete scene: one sample of every random value, with geometry. SI units and radians."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .read_only import Frozen
from .scene_actor import Call as Call
from .scene_actor import SceneActor as SceneActor
from .scene_junctions import SceneJunction
from .scene_road import SceneRoad as SceneRoad
from .scene_sensor import SceneSensor as SceneSensor
from .sent_records import sent_by_members

SCENE_SCHEMA = "roadlang.scene/2"


@dataclass(frozen=True, slots=True)
class SceneNode:
    """A point where roads of a network meet or end; x and y in meters."""

    id: int
    """its number in the network"""
    x: float
    """meters east"""
    y: float
    """meters north"""
    roads: tuple[str, ...]
    """names of the roads that end here"""


@dataclass(frozen=True, slots=True)
class SceneNetwork:
    """Its roads are in `Scene.roads`, named `town/3` for edge 3 of network `town`."""

    name: str
    """as declared"""
    nodes: tuple[SceneNode, ...]
    """where its roads meet or end"""
    roads: tuple[str, ...]
    """names of its roads"""
    confidence: float = 1.0
    """of the extractor, 0 to 1"""
    mask: str | None = None
    """PNG of the road pixels, base64, where the extractor has one (`road: tiles`)"""
    mask_scale: float | None = None
    """meters for each pixel of the mask"""
    mask_origin: tuple[float, float] = (0.0, 0.0)
    """x and y of the lower left corner of the mask, meters"""
    junctions: tuple[SceneJunction, ...] = ()
    """where its roads meet"""
    origin: tuple[float, float] | None = None
    """latitude and longitude of (0, 0), degrees, where the map says so"""


@dataclass(frozen=True, slots=True)
class ViolatedSegment:
    """Where a requirement is violated: arc length of the root road, meters."""

    road: str
    """name of the road"""
    start: float
    """meters"""
    end: float
    """meters"""


@sent_by_members
@dataclass(frozen=True, slots=True)
class RoadPlace:
    """A place on a road: arc length of the root road, meters."""

    road: str
    """name of the road"""
    station: float
    """meters"""


@sent_by_members
@dataclass(frozen=True, slots=True)
class Profile:
    """Values along a road: `stations` is arc length of the root road, as long as `values`."""

    road: str
    """name of the road"""
    stations: tuple[float, ...] = field(repr=False)
    """arc length of the root road, meters"""
    values: tuple[float, ...] = field(repr=False)
    """one for each station, SI units"""


@dataclass(frozen=True, slots=True)
class SceneSignal:
    """A `let` that names a signal over roads; of a network, a profile for each of its roads."""

    name: str
    """as declared"""
    text: str
    """its formula"""
    unit: str
    """SI unit of the values, such as `m` or `1/m`; empty for dimensionless numbers"""
    profiles: tuple[Profile, ...]
    """its values, for each road"""


@sent_by_members
@dataclass(frozen=True, slots=True)
class Verdict(Frozen):
    """A `require` or `expect` of this scene. `robustness` is None for what is judged later."""

    name: str
    """as declared"""
    text: str
    """the formula as the language writes it, or the kind of monitor"""
    domain: str
    """`road`, `drive`, or `scene` for numbers alone"""
    robustness: float | None
    """in the unit of the comparison that decides; null for what a drive decides"""
    satisfied: bool | None
    """null for what a drive decides"""
    violated: tuple[ViolatedSegment, ...] = ()
    """where along the roads it fails"""
    formula: Mapping[str, Any] | None = None
    """what a drive must satisfy; null for what is decided here"""
    profiles: tuple[Profile, ...] = ()
    """of `always p` and `eventually p` over roads: the robustness of `p` along each road"""
    tightest: RoadPlace | None = None
    """where the robustness is attained: the least of `always p`, the greatest of `eventually p`"""


@dataclass(frozen=True, slots=True)
class Provenance(Frozen):
    """What this scene was made from and by. `plugins` maps distribution to version."""

    roadlang: str
    """version"""
    seed: int
    """of the run"""
    scene: int
    """number of the scene"""
    attempt: int
    """which draw of this scene was accepted, from 0"""
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    """version by distribution"""
    source: str = ""
    """name of the scene file, without its folder"""
    overrides: Mapping[str, str] = field(default_factory=dict)
    """params set by the user, as written"""


@dataclass(frozen=True, slots=True)
class Scene(Frozen):
    """All that a backend gets."""

    name: str
    """of the scenario"""
    title: str
    """of the scenario"""
    index: int
    """number of the scene, from 0"""
    provenance: Provenance
    """what it was made from and by"""
    values: Mapping[str, Any] = field(default_factory=dict)
    """params and lets that are values"""
    draws: Mapping[str, Any] = field(default_factory=dict)
    """every random value by its place"""
    units: Mapping[str, str] = field(default_factory=dict)
    """SI units of the values and draws that have one, by name and place"""
    networks: tuple[SceneNetwork, ...] = ()
    """networks, whose roads are among the roads"""
    roads: tuple[SceneRoad, ...] = ()
    """roads, edges of networks among them"""
    agents: tuple[SceneActor, ...] = ()
    """what moves"""
    objects: tuple[SceneActor, ...] = ()
    """what stands still"""
    markings: tuple[SceneActor, ...] = ()
    """crosswalks: paint on the road, that nothing hits or keeps clear of"""
    world: Mapping[str, Any] = field(default_factory=dict)
    """light, weather and grip; a key is absent where the scene file says nothing of it"""
    signals: tuple[SceneSignal, ...] = ()
    """the `let`s that name signals over roads, with their values"""
    requirements: tuple[Verdict, ...] = ()
    """what filtered this scene"""
    expectations: tuple[Verdict, ...] = ()
    """what judges the system under test"""
    simulate: Call | None = None
    """where the scene is to be driven, with every option"""
    schema: str = SCENE_SCHEMA
    """version of this format"""

    @property
    def standing(self) -> tuple[SceneActor, ...]:
        """All that formulas can name and that does not move: objects, then markings."""
        return (*self.objects, *self.markings)

    @property
    def stem(self) -> str:
        """What the names of all files of this scene begin with: `scene-0000`."""
        return file_stem(self.index)


def file_stem(scene: int) -> str:
    """What the names of the files of a scene, by its number, begin with."""
    return f"scene-{scene:04d}"
