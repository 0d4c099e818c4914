"""The abstract scenario: every statement resolved and typed, its values possibly random."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..diagnostics import Span
from .dimension import Dimension
from .read_only import FrozenDict
from .schema import UNWRITTEN
from .values import NO_OPTIONS, NO_SPANS, Condition, Options, PassCall, TextValue, Value

SCENARIO_SCHEMA = "roadlang.scenario/2"


LANE_OPTIONS = (
    "lanes",
    "left",
    "right",
    "oneway",
    "sidewalks",
    "center_marking",
    "speed_limit",
)
"""The options of roads and networks that say which lanes there are, and nothing of the curve."""


@dataclass(frozen=True, slots=True)
class Input:
    """A file that the scenario was made from; the digest is filled in when it is read."""

    path: str
    sha256: str = ""


@dataclass(frozen=True, slots=True)
class ScenarioHeader:
    """Name and title of a scenario."""

    name: str
    title: str = ""


@dataclass(frozen=True, slots=True)
class Named:
    """A `param` or `let` that is a number, word, list or point. A `let` that names a signal or a
    formula is written out where it is used."""

    name: str
    value: Value
    dimension: Dimension | None
    is_param: bool
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class FileSource:
    """`path` as written; `resolved` against the folder of the file that names it."""

    path: str
    resolved: str


@dataclass(frozen=True, slots=True)
class TextSource:
    """A picture typed as text, one character a pixel."""

    text: str


@dataclass(frozen=True, slots=True)
class NameSource:
    """Another image, network or road."""

    name: str
    role: str


Source = FileSource | TextSource | NameSource


@dataclass(frozen=True, slots=True)
class ScenarioImage:
    """`options`: `scale` (m/px), `legend`."""

    name: str
    source: Source
    options: Options = NO_OPTIONS
    passes: tuple[PassCall, ...] = ()
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class ScenarioNetwork:
    """`passes` in the order written: the `extract` of an image or the `read` of a file, which are
    filled in where the source has none, then `perturb`s."""

    name: str
    source: Source
    options: Options = NO_OPTIONS
    passes: tuple[PassCall, ...] = ()
    span: Span | None = None
    option_spans: FrozenDict[str, Span] = field(
        default=NO_SPANS, compare=False, metadata=UNWRITTEN
    )  # where the values of options and the members of lists are written


@dataclass(frozen=True, slots=True)
class ScenarioRoad:
    """`source` is None for a drawn road; `options`: `select`, `width`, `closed`, the
    `LANE_OPTIONS`."""

    name: str
    source: Source | None
    options: Options = NO_OPTIONS
    passes: tuple[PassCall, ...] = ()
    span: Span | None = None
    option_spans: FrozenDict[str, Span] = field(
        default=NO_SPANS, compare=False, metadata=UNWRITTEN
    )  # where the values of options and the members of lists are written


@dataclass(frozen=True, slots=True)
class ScenarioConstraint:
    """A `require` or an `expect`: a formula or the call of a monitor."""

    name: str
    test: Condition | PassCall
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class NamedSignal:
    """A `let` that names a signal over roads. `condition` is `signal >= 0`, whose robustness at a
    station is the signal's value there."""

    name: str
    condition: Condition
    dimension: Dimension
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class ScenarioSensor:
    """A sensor of an agent."""

    name: str
    call: PassCall


@dataclass(frozen=True, slots=True)
class ScenarioActor:
    """An agent or object. `kind` is the call of an agent or object kind, or a draw among such.

    `at` is a length along the road, a fraction of its length (`Operation`s of such too) or a
    point (`Items` of two lengths), or the call of a kind of position; `at_fraction` tells the first
    two apart. `options`: those of `AgentOptions`. `option_spans`: where `at` and the options are
    written, as far as they are.
    """

    name: str
    kind: Value
    on: str | None
    at: Value
    at_fraction: bool = False
    options: Options = NO_OPTIONS
    drive: tuple[PassCall, ...] = ()
    sensors: tuple[ScenarioSensor, ...] = ()
    span: Span | None = None
    option_spans: FrozenDict[str, Span] = NO_SPANS

    def span_of(self, name: str) -> Span | None:
        """Where `at` or an option is written; the statement, where it is not."""
        return self.option_spans.get(name, self.span)

    @property
    def is_beside_road(self) -> bool:
        """Whether `side` places it next to its road; with a kind of lane it says on which side the
        lane is."""
        return "side" in self.options and self.options.get("lane") in (None, TextValue("none"))


@dataclass(frozen=True, slots=True)
class Scenario:
    """All of a scene file and what it includes. Each group in an order in which it can be
    evaluated: what a thing depends on comes before it."""

    header: ScenarioHeader
    values: tuple[Named, ...] = ()
    images: tuple[ScenarioImage, ...] = ()
    networks: tuple[ScenarioNetwork, ...] = ()
    roads: tuple[ScenarioRoad, ...] = ()
    signals: tuple[NamedSignal, ...] = ()
    requirements: tuple[ScenarioConstraint, ...] = ()
    expectations: tuple[ScenarioConstraint, ...] = ()
    agents: tuple[ScenarioActor, ...] = ()
    objects: tuple[ScenarioActor, ...] = ()
    world: Options = NO_OPTIONS
    sample: PassCall | None = None
    simulate: PassCall | None = None
    falsify: PassCall | None = None
    emits: tuple[PassCall, ...] = ()
    inputs: tuple[Input, ...] = ()
    schema: str = SCENARIO_SCHEMA
