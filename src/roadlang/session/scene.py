"""A scene for Python users: its roads as arrays, its figure, its drive.

A facade: a scene is driven by the module of drives, which know their scene.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from ..diagnostics import Code, DiagnosticError, arguments, diagnose
from .profiles import Profiles, read_only

if TYPE_CHECKING:
    from ..drive.written_places import WrittenPlaces
    from ..geometry.arrays import Floats
    from ..ir.scene import Provenance, SceneActor, SceneNetwork, SceneRoad, Verdict
    from ..ir.scene import Scene as SceneRecord
    from ..plugins.registry import Registry
    from .drives import Drive
    from .loading import LoadedScenario


FIGURE = "svg"
"""The `emit` whose file is the figure of a scene, and its ending."""


@cache
def installed() -> Registry:
    """The kinds of all installed plugins."""
    from ..plugins.discovery import load_registry

    return load_registry()


class RoadArrays:
    """A road of a scene as numpy arrays over its S stations, which cannot be written to.

    Meters, radians, 1/m; x east, y north. `record` is the road as backends get it.
    """

    def __init__(self, record: SceneRoad) -> None:
        self.record = record
        self.name = record.name
        self.length = record.length
        """meters along the center line"""
        self.lanes = record.lanes
        self.closed = record.closed
        self.derived = record.derived
        """whether this is the last road of a chain: the one that is driven and built"""
        self.root = record.root
        """name of the road that this one was made from by perturbing; its own, if none"""

    def __repr__(self) -> str:
        return f"<road {self.name}: {self.length:.6g} m, {self.lanes} lanes>"

    @cached_property
    def stations(self) -> Floats:
        """(S,) arc length along this road."""
        return read_only(self.record.stations)

    @cached_property
    def reference_stations(self) -> Floats:
        """(S,) arc length of the root road at the same points: the positions of requirements."""
        return read_only(self.record.reference_stations)

    @cached_property
    def points(self) -> Floats:
        """(S, 2) x and y of the center line."""
        import numpy as np

        return read_only(np.column_stack((self.record.x, self.record.y)))

    @cached_property
    def x(self) -> Floats:
        """(S,) meters east."""
        return read_only(self.record.x)

    @cached_property
    def y(self) -> Floats:
        """(S,) meters north."""
        return read_only(self.record.y)

    @cached_property
    def heading(self) -> Floats:
        """(S,) counter-clockwise from east, continuous along the road."""
        return read_only(self.record.heading)

    @cached_property
    def curvature(self) -> Floats:
        """(S,) left positive."""
        return read_only(self.record.curvature)

    @cached_property
    def width(self) -> Floats:
        """(S,) of all lanes together."""
        return read_only(self.record.width)

    def to_dict(self) -> dict[str, Floats]:
        """Columns for `pandas.DataFrame`: station, x, y, heading, curvature, width."""
        return {
            "station": self.stations,
            "x": self.x,
            "y": self.y,
            "heading": self.heading,
            "curvature": self.curvature,
            "width": self.width,
        }


class Scene:
    """One concrete scene. `record` is the plain dataclass that backends and simulators get.

    Notebooks show its figure.
    """

    def __init__(self, record: SceneRecord, loaded: LoadedScenario | None = None) -> None:
        self.record = record
        self._loaded = loaded

    def __reduce__(self) -> tuple[Any, ...]:
        # By its parts: the views that properties keep cannot be pickled.
        return type(self), (self.record, self._loaded)

    @classmethod
    def from_json(cls, text: str | bytes, path: str | None = None) -> Scene:
        """The scene in a document that `emit json` or `to_json` wrote; `path` is the file that it
        comes from.

        Raises `DiagnosticError` (RL461) for anything else.
        """
        from ..ir.encoding import scene_from_json
        from .recorded_options import check_options

        if not isinstance(text, str | bytes):
            raise arguments.wrong_type("text", "the text of a document", text)
        try:
            record = scene_from_json(text)
            check_options(record, installed())
        except ValueError as error:
            raise DiagnosticError(
                diagnose(Code.NOT_A_SCENE, path=path, reason=str(error))
            ) from error
        return cls(record)

    def __repr__(self) -> str:
        roads = ", ".join(self.roads)
        return f"<scene {self.index} of {self.name or 'a scenario without a name'}: {roads}>"

    @property
    def name(self) -> str:
        """Of the scenario."""
        return self.record.name

    @property
    def title(self) -> str:
        """Of the scenario, for people; empty where it has none."""
        return self.record.title

    @property
    def index(self) -> int:
        """The number of the scene, from 0."""
        return self.record.index

    @property
    def provenance(self) -> Provenance:
        """Seed, attempt, versions, digests of inputs."""
        return self.record.provenance

    @property
    def values(self) -> Mapping[str, Any]:
        """Params and `let`s that are values, by name, in SI units and radians."""
        return MappingProxyType(dict(self.record.values))

    @property
    def draws(self) -> Mapping[str, Any]:
        """Every random value by the place of its draw (`bent/perturb 1/amplitude`)."""
        return MappingProxyType(dict(self.record.draws))

    @property
    def units(self) -> Mapping[str, str]:
        """The SI units of the values and draws that have one, by name and place."""
        return MappingProxyType(dict(self.record.units))

    @property
    def world(self) -> Mapping[str, Any]:
        """What `world { ... }` says."""
        return MappingProxyType(dict(self.record.world))

    @cached_property
    def roads(self) -> Mapping[str, RoadArrays]:
        """By name; edge 3 of network `town` is `town/3`."""
        return MappingProxyType({road.name: RoadArrays(road) for road in self.record.roads})

    @cached_property
    def networks(self) -> Mapping[str, SceneNetwork]:
        """By name; their roads are in `roads`."""
        return MappingProxyType({network.name: network for network in self.record.networks})

    @cached_property
    def agents(self) -> Mapping[str, SceneActor]:
        """By name; the third of the group `oncoming` is `oncoming[2]`."""
        return MappingProxyType({actor.name: actor for actor in self.record.agents})

    @cached_property
    def objects(self) -> Mapping[str, SceneActor]:
        """By name, as `agents`; crosswalks too."""
        return MappingProxyType({actor.name: actor for actor in self.record.standing})

    @cached_property
    def requirements(self) -> Mapping[str, Verdict]:
        """Each `require` with its robustness in this scene."""
        return MappingProxyType({verdict.name: verdict for verdict in self.record.requirements})

    @cached_property
    def expectations(self) -> Mapping[str, Verdict]:
        """Each `expect`; what is about the drive has no robustness before the scene is driven."""
        return MappingProxyType({verdict.name: verdict for verdict in self.record.expectations})

    @cached_property
    def signals(self) -> Mapping[str, Profiles]:
        """Each `let` that names a signal over roads, with its values along them."""
        found = {s.name: Profiles(s.name, s.text, s.unit, s.profiles) for s in self.record.signals}
        return MappingProxyType(found)

    @cached_property
    def robustness(self) -> Mapping[str, Profiles]:
        """The robustness along the roads of each `require` and `expect` that is `always p` or
        `eventually p`: that of `p`. The number for the scene is in `requirements`."""
        verdicts = (*self.record.requirements, *self.record.expectations)
        found = {v.name: Profiles(v.name, v.text, "", v.profiles) for v in verdicts if v.profiles}
        return MappingProxyType(found)

    def to_json(self) -> str:
        """The scene as `emit json` writes it (`roadlang schema scene`)."""
        from ..ir.encoding import to_json

        return to_json(self.record)

    def svg(self, **options: Any) -> str:
        """The figure that `emit svg` draws; `options` are those of the kind, in pixels and SI.

        `photo` is the name of an image, of a network or road that is made from one, or a `Picture`.
        Raises `DiagnosticError` for an option that `emit svg` does not have.
        """
        from ..plugins.configured import configured
        from ..plugins.finding import entry_of
        from ..plugins.guard import plugin_guard
        from .option_pictures import with_pictures

        entry = entry_of(self.registry, "emit", FIGURE)
        options = with_pictures(options, entry, self._loaded)
        entry, kind = configured(self.registry, "emit", FIGURE, options)
        with plugin_guard(entry, None):
            return str(kind.files(self.record)[FIGURE])

    def _repr_svg_(self) -> str:
        return self.svg()

    def run(self, engine: str | None = None, **options: Any) -> Drive:
        """Drive the scene in a simulator and judge its expectations.

        `engine` is the name of a `simulate` kind; without it the file's, or the first that is
        installed. `options` are those of the kind in SI units: `duration=10.0`. Raises
        `DiagnosticError` where the engine fails.
        """
        from .drives import drive

        return drive([self], self.registry, engine, options, self.places)[0]

    @property
    def places(self) -> WrittenPlaces:
        """Where its file has what a drive may find faults with; nothing of a scene from JSON."""
        from ..drive.written_places import UNKNOWN

        return UNKNOWN if self._loaded is None else self._loaded.places

    def save(self, path: str | Path) -> Path:
        """Write the scene as JSON, whole or not at all. Raises `DiagnosticError` RL460."""
        from ..files.writing import write_file

        return write_file(arguments.file_to_write("path", path), self.to_json())

    @property
    def registry(self) -> Registry:
        """The kinds that figures and drives are made with."""
        return installed() if self._loaded is None else self._loaded.registry
