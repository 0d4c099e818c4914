"""The base classes of kinds. A kind is a frozen dataclass; its fields are its options.

A kind of a verb derives from the verb's base class, sets `name`, declares its options as
fields and implements one method. Random options reach batch methods as columns (variants, 1),
so that numpy broadcasting over (variants, stations) just works.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from ..ir.dimension import Dimension

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .. import geometry
    from ..geometry import Curve
    from ..ir.batch import BatchRandom, RoadBatch
    from ..ir.picture import Extraction, Picture
    from ..ir.scene import Scene
    from ..ir.trace import Trace

    Floats = NDArray[np.float64]


class Kind:
    """Anything a plugin brings. The class docstring's first line is its help.

    A kind is a frozen dataclass that derives from the base class of its verb.
    """

    verb: ClassVar[str] = ""
    name: ClassVar[str] = ""
    rest: ClassVar[str] = ""
    """The list that takes all arguments without a name, of a kind that is written as a call."""
    is_default: ClassVar[bool] = False
    """of kinds in the wheel: what a file means that names no kind of the verb, such as the
    distribution of `1m..2m` (its options are `low` and `high`) or what draws without `sample`"""
    is_random: ClassVar[bool] = False
    """it draws random numbers other than its options, so that each candidate differs"""
    cost: ClassVar[float] = 0.0
    """work for a station, where that of a displacement is 1: cheap requirements are tried first"""
    member: ClassVar[bool] = False
    """a number or signal of an agent or object, written `ego.speed` instead of `speed(ego)`"""
    domain: ClassVar[str] = "road"
    """whether it is about roads ("road") or about drives ("drive")"""
    geometry_is_user_input: ClassVar[bool] = False
    """a `GeometryError` that it raises is about what the scene file asks for (RL472), not a fault
    of the plugin (RL470)"""
    required_methods: ClassVar[tuple[str, ...]] = ()
    """a kind implements at least one of these methods of its base"""


class Adjuster(Kind):
    """`adjust with`: image to image. `is_random`: it draws from `random`, so that each scene has
    an image of its own."""

    verb: ClassVar[str] = "adjust"
    required_methods: ClassVar[tuple[str, ...]] = ("adjust",)

    def adjust(self, pixels: NDArray[np.uint8], random: np.random.Generator) -> NDArray[np.uint8]:
        """(height, width, 3) BGR to the same shape."""
        raise NotImplementedError


class Extractor(Kind):
    """`extract with`: image to network."""

    verb: ClassVar[str] = "extract"
    required_methods: ClassVar[tuple[str, ...]] = ("extract",)

    def extract(self, picture: Picture) -> Extraction:
        """Find the roads (and, with a legend, the objects) of a picture."""
        raise NotImplementedError


class Reader(Kind):
    """`read with`: a file to what the statement declares (`reads`), chosen by `suffixes`."""

    verb: ClassVar[str] = "read"
    required_methods: ClassVar[tuple[str, ...]] = ("read",)
    geometry_is_user_input: ClassVar[bool] = True
    suffixes: ClassVar[tuple[str, ...]] = ()
    reads: ClassVar[tuple[str, ...]] = ("road",)

    def read(self, path: Path) -> Any:
        """A `Curve` or `Road` for a road, a `RoadNetwork` for a network, an array for an image."""
        raise NotImplementedError


class Drawer(Kind):
    """`draw with`: nothing to a curve."""

    verb: ClassVar[str] = "draw"
    required_methods: ClassVar[tuple[str, ...]] = ("draw",)
    geometry_is_user_input: ClassVar[bool] = True

    def draw(self, closed: bool) -> Curve:
        """The center line; `closed` is the road's option."""
        raise NotImplementedError


class Piece(Kind):
    """A piece of a drawn road, written as a call: `arc(40m, 60deg)`."""

    verb: ClassVar[str] = "piece"
    required_methods: ClassVar[tuple[str, ...]] = ("laid",)
    geometry_is_user_input: ClassVar[bool] = True

    def laid(self, curvature: float) -> geometry.Straight | geometry.Arc | geometry.Clothoid:
        """The piece as it goes on from a road of this curvature (1/m, left positive)."""
        raise NotImplementedError


class Selector(Kind):
    """How a road is chosen of a network, written as a call: `route((0m, 0m), (80m, 0m))`."""

    verb: ClassVar[str] = "select"
    required_methods: ClassVar[tuple[str, ...]] = ("select",)
    geometry_is_user_input: ClassVar[bool] = True

    def select(self, network: geometry.RoadNetwork) -> geometry.Path:
        """The way through the network."""
        raise NotImplementedError


class Perturber(Kind):
    """`perturb with`: a road to itself, displaced.

    Implement `displacement` (one variant, options are floats) or, for speed, `displacements`
    (a batch, random options are (variants, 1) columns). Displacements are meters along the left
    normal, or, with a last axis of two, meters east and north; with `over`, and in a network, the
    runner keeps of the latter the part along the normal.
    """

    verb: ClassVar[str] = "perturb"
    required_methods: ClassVar[tuple[str, ...]] = ("displacement", "displacements")
    geometry_is_user_input: ClassVar[bool] = True
    is_random: ClassVar[bool] = True
    """it draws from `random`: set to False where the options alone tell the displacement"""

    def displacement(self, road: RoadBatch, random: np.random.Generator) -> Floats:
        """(stations,) or (stations, 2) meters of one variant (`road` has one)."""
        raise NotImplementedError

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """(variants, stations) or (variants, stations, 2) meters; one row where all variants are
        the same. The runner loops over `displacement` without it."""
        raise NotImplementedError

    def displacement_bound(self) -> Floats | float:
        """The greatest displacement, meters, that the options allow: a number, or (variants, 1).

        Requirements that it decides need no geometry. It must be monotonic in every option;
        without it nothing is known. A displacement beyond it is RL474.
        """
        return float("inf")


class Controller(Kind):
    """`drive with`: what steers an agent. `control` is for controllers written in Python."""

    verb: ClassVar[str] = "drive"

    def control(self, observation: Any) -> Any:
        """From an `Observation` to a `Control`, once a step."""
        raise NotImplementedError


class Signal(Kind):
    """A road signal over arc length, written as a call: `curvature(bent)`.

    `unit` is the unit of the values, or override `dimension_of`.
    """

    verb: ClassVar[str] = "signal"
    required_methods: ClassVar[tuple[str, ...]] = ("values",)
    unit: ClassVar[str] = ""
    cost: ClassVar[float] = 20.0

    def values(self) -> Floats:
        """(variants, stations), SI units. Fields that name roads hold `RoadBatch`es."""
        raise NotImplementedError

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        """Least and greatest value that the options allow: numbers, or (variants, 1) columns.

        Requirements that they decide need no geometry; without them nothing is known. `options`
        holds all options by name: a `RoadBounds` for each road, and numbers, or columns
        (variants, 1). It must be monotonic in every number. A value beyond the range is RL474.
        """
        return float("-inf"), float("inf")

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        """The dimension of the values; `options` has the constant options by name."""
        from ..ir.units import parse_unit

        return parse_unit(cls.unit).dimension


class RoadNumber(Signal):
    """A number of a road, written as a call: `length(bent)`. `values` has shape (variants, 1).

    `member`: a number of an agent or object on a road, written `ego.start`.
    """

    verb: ClassVar[str] = "number"


class DriveSignal(Signal):
    """A drive signal over time. `member`: written `ego.speed`, else as a call.

    A field that names an agent holds its `AgentTrace`; of a signal written as a call, a tuple of
    them, as the name may stand for a group. `values` has shape (steps,).
    """

    verb: ClassVar[str] = "drive_signal"
    required_methods: ClassVar[tuple[str, ...]] = ("values", "values_in")
    domain: ClassVar[str] = "drive"
    member: ClassVar[bool] = True

    def values(self) -> Floats:
        """(steps,) SI units, of the agents in the fields."""
        raise NotImplementedError

    def values_in(self, trace: Trace) -> Floats:
        """(steps,) of a signal that needs more of the drive than the agents in its fields, such as
        its time axis; `values` is then not called."""
        return self.values()


class Monitor(Kind):
    """`require/expect N with`: a judge instead of STL."""

    verb: ClassVar[str] = "monitor"

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.required_methods = ("judge",) if cls.domain == "drive" else ("robustness",)

    def robustness(self) -> Floats:
        """(variants,) positive where satisfied, of a judge of roads (`domain` "road")."""
        raise NotImplementedError

    def judge(self, trace: Trace) -> float:
        """Positive where satisfied, of a judge of drives (`domain` "drive")."""
        raise NotImplementedError


class Distribution(Kind):
    """A random value, written as a call: `normal(1m, 0.5m)`. Options are those of the call."""

    verb: ClassVar[str] = "distribution"
    required_methods: ClassVar[tuple[str, ...]] = ("quantile",)

    def quantile(self, uniform: Floats) -> Any:
        """(variants,) numbers in [0, 1) to values of the same shape."""
        raise NotImplementedError

    def support(self) -> tuple[float, float] | None:
        """Least and greatest value, for bounds; None when not known. Options are plain numbers.

        Where options are drawn themselves it is evaluated at all ends of their ranges, so both must
        be monotonic in every option. A value beyond it is RL474.
        """
        return None

    def levels(self, steps: int) -> Iterable[float]:
        """Numbers in [0, 1] at which `quantile` gives the values that `sample with grid` visits:
        `steps` of them where it is continuous, the middle of each step by default."""
        return [(step + 0.5) / steps for step in range(steps)]


class DrawnValue(Protocol):
    """A random value of the scenario, as samplers see it."""

    place: str

    def levels(self, steps: int) -> Sequence[float]:
        """Numbers in [0, 1] that a grid visits."""
        ...


class Sampler(Kind):
    """`sample with`: which points of the unit cube of all draws are tried.

    `sequential`: candidates are one stream and scene i is the i-th accepted of it; otherwise
    each scene has a stream of attempts of its own.
    """

    verb: ClassVar[str] = "sample"
    sequential: ClassVar[bool] = True

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.required_methods = ("points",) if cls.sequential else ()

    def points(self, indices: NDArray[np.int64], draws: Sequence[DrawnValue], seed: int) -> Floats:
        """(candidates, draws) in [0, 1]; a function of each index alone."""
        raise NotImplementedError

    def size(self, draws: Sequence[DrawnValue]) -> int | None:
        """How many candidates there are; None: without end."""
        return None

    def limit(self) -> int | None:
        """How many candidates are tried before a scene is given up; None: as many as take about
        five seconds."""
        return None

    def steer(self, known: Floats, uniform: Floats) -> Floats:
        """(V, d) proposals in [0, 1) from points (n, d) that are good, and from random numbers
        (V, `numbers(d)`) in [0, 1): a sampler that has this learns where the requirements hold."""
        raise NotImplementedError

    def pilot_size(self) -> int:
        """How many candidates are measured at most before scenes are steered."""
        return 20_000

    def numbers(self, dimensions: int) -> int:
        """How many random numbers `steer` needs for a proposal, at least `dimensions`."""
        return dimensions


class Simulator(Kind):
    """`simulate with`: where scenes are driven."""

    verb: ClassVar[str] = "simulate"
    required_methods: ClassVar[tuple[str, ...]] = ("drive", "drive_all")

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        """What happened. `controllers` are those written in Python, by the agents they drive."""
        raise NotImplementedError

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        """Drive several scenes; an engine that takes long to start is started once for all."""
        for scene, own in zip(scenes, controllers, strict=True):
            yield self.drive(scene, own)


class Searcher(Kind):
    """`falsify with`: how scenes that break an `expect` are searched."""

    verb: ClassVar[str] = "falsify"


class Backend(Kind):
    """`emit`: a scene to files, or to an engine."""

    verb: ClassVar[str] = "emit"
    required_methods: ClassVar[tuple[str, ...]] = ("files", "collection", "send")

    def files(self, scene: Scene) -> Mapping[str, bytes | str]:
        """Contents by file ending: `{"json": "..."}` becomes `scene-0000.json`."""
        return {}

    def collection(self, scenes: Iterable[Scene]) -> Mapping[str, bytes | str]:
        """Contents by file name of what is written once for all scenes."""
        return {}

    def send(self, scene: Scene) -> None:
        """Deliver to an engine. Raises `DiagnosticError` when it cannot."""


class AgentKind(Kind):
    """What may stand behind `agent N is`; fields with defaults are its size and looks."""

    verb: ClassVar[str] = "agent"


class ObjectKind(Kind):
    """What may stand behind `object N is` and in a legend."""

    verb: ClassVar[str] = "object"


BASES: tuple[type[Kind], ...] = (
    Adjuster, Extractor, Reader, Drawer, Piece, Selector, Perturber,
    Controller, Signal, RoadNumber, DriveSignal, Monitor, Distribution, Sampler,
    Simulator, Searcher, Backend, AgentKind, ObjectKind,
)  # fmt: skip
VERBS: tuple[str, ...] = tuple(base.verb for base in BASES)
_BASE_OF = {base.verb: base for base in BASES}


def base_of(verb: str) -> type[Kind]:
    """The base class of the kinds of a verb."""
    return _BASE_OF[verb]


def implements(kind: type[Kind], method: str) -> bool:
    """Whether a kind has a method of its base by itself, or merely inherits it."""
    own, inherited = getattr(kind, method), getattr(base_of(kind.verb), method)
    return getattr(own, "__func__", own) is not getattr(inherited, "__func__", inherited)
