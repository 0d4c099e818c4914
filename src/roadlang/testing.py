"""What authors of plugins test with: scenes of a text, roads, traces, a pytest fixture.

    from roadlang import testing

    def test_a_road_sways():
        (scene,) = testing.sample(ROAD_THAT_SWAYS, kinds=[Sway])
        assert scene.roads["bent"].length > 100

A `conftest.py` with `pytest_plugins = ["roadlang.testing"]` brings the fixture `roadlang_sample`,
which is `sample` with files in the test's `tmp_path`. Without pytest the functions work as well.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable
from dataclasses import MISSING, fields, replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from .diagnostics import Diagnostic, arguments, did_you_mean
from .plugins.discovery import load_registry, registry_of
from .plugins.hookspecs import hookimpl
from .plugins.kinds import Kind
from .plugins.registry import Registry
from .session.loading import LoadedScenario, loads
from .session.params import ParamValue

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .ir.batch import BatchRandom, RoadBatch
    from .ir.observation import Observation
    from .ir.trace import AgentTrace, Trace
    from .session.scene_set import SceneSet

PLUGIN = "tested"
"""The plugin that kinds under test belong to: `tested.sway` where a plain name is not enough."""


def sample(
    text: str,
    n: int | None = 1,
    *,
    kinds: Iterable[type[Kind]] = (),
    seed: int = 0,
    folder: str | Path = ".",
    **params: ParamValue,
) -> SceneSet:
    """Scenes of a text in which `kinds` can be named, in addition to those of all installed
    plugins.

    Files that the text names are in `folder`. Raises `roadlang.DiagnosticError`, whose text is
    what a user would see, for faults of the text and of the kinds.
    """
    return scenario(text, kinds=kinds, folder=folder, **params).sample(n, seed=seed)


def check(
    text: str,
    *,
    kinds: Iterable[type[Kind]] = (),
    folder: str | Path = ".",
    **params: ParamValue,
) -> tuple[Diagnostic, ...]:
    """What `roadlang check` says of a text: errors and warnings, in order of their places."""
    return scenario(text, kinds=kinds, folder=folder, **params).check()


def scenario(
    text: str,
    *,
    kinds: Iterable[type[Kind]] = (),
    folder: str | Path = ".",
    **params: ParamValue,
) -> LoadedScenario:
    """A text with `kinds` in it, to be checked or sampled."""
    if not isinstance(kinds, Iterable):
        raise arguments.wrong_type("kinds", "a list of classes", kinds)
    loaded = loads(text, folder=folder, **params)
    return LoadedScenario(loaded.text, loaded.path, loaded.params, registry_with(*kinds))


def registry_with(*kinds: type[Kind]) -> Registry:
    """All installed kinds, and `kinds` as those of a plugin called `tested`.

    They take the place of installed kinds of the same names, such as the ones in the plugin that
    is being tested; kinds that ship with roadlang keep theirs.

    Raises `TypeError` with the reason where they could not be loaded from a plugin.
    """
    if not kinds:
        return load_registry()
    registry = registry_of({PLUGIN: plugin_of(*kinds)}, installed=True)
    for broken in registry.broken:
        if broken.origin.plugin == PLUGIN:
            raise TypeError(broken.reason)
    tested = {(kind.verb, kind.name) for kind in kinds}
    entries = (
        entry
        for entry in registry.entries
        if entry.origin.is_shipped
        or entry.origin.plugin == PLUGIN
        or (entry.verb, entry.name) not in tested
    )
    return replace(registry, entries=tuple(entries))


def plugin_of(*kinds: type[Kind]) -> ModuleType:
    """A plugin that brings `kinds`."""
    module = ModuleType(PLUGIN)

    @hookimpl
    def roadlang_kinds() -> list[type[Kind]]:
        return list(kinds)

    vars(module)["roadlang_kinds"] = roadlang_kinds
    return module


def road_batch(
    points: ArrayLike,
    *,
    width: ArrayLike = 7.0,
    closed: bool = False,
    variants: int = 1,
    name: str = "road",
) -> RoadBatch:
    """A road through (P, 2) `points`, meters, in `variants` equal variants: what a perturber,
    signal or monitor gets, sampled about every meter.

    `width` in meters is a number, or (variants, 1). Raises `GeometryError` for points that no
    road goes through.
    """
    import numpy as np

    from .geometry import Curve, CurveFrame
    from .world.perturbing.root_roads import undisplaced_road
    from .world.perturbing.stations import default_stations

    variants = arguments.whole_number("variants", variants, least=1)
    curve = Curve.through(points, closed=closed)
    frame = CurveFrame.of(curve, default_stations(curve))
    widths = np.broadcast_to(np.asarray(width, dtype=float).reshape(-1, 1), (variants, 1))
    return undisplaced_road(name, name, frame, widths, 1.0, variants)


def random(variants: int = 1, seed: int = 0) -> BatchRandom:
    """Random numbers as a pass gets them, for each of `variants`."""
    import numpy as np

    from .evaluate.randomness import variant_keys
    from .ir.batch import BatchRandom

    variants = arguments.whole_number("variants", variants, least=1)
    attempts = np.arange(variants)
    return BatchRandom(variant_keys(seed, np.zeros_like(attempts), attempts))


def agent_trace(name: str = "ego", *, time: ArrayLike, **members: ArrayLike) -> AgentTrace:
    """What a drive signal or monitor gets of an agent: `time` is (T,) seconds.

    Other members of `AgentTrace` are numbers or (T,) arrays; those left out are NaN throughout, as
    of an engine that does not record them. Raises `TypeError` for members that do not exist,
    `ValueError` for arrays of another length and times that are not in order.
    """
    import numpy as np

    from .ir.trace import AgentTrace

    times = np.asarray(time, dtype=float)
    if times.ndim != 1 or not (np.isfinite(times).all() and (np.diff(times) > 0.0).all()):
        raise ValueError("`time` must be finite numbers in ascending order, of the shape (T,)")
    columns: dict[str, Any] = {"time": times}
    for member in fields(AgentTrace):
        if member.name in ("name", "time"):
            continue
        if member.name in members:
            value = np.asarray(members.pop(member.name), dtype=float)
            is_size = isinstance(member.default, float)
            if value.shape != () and (is_size or value.shape != times.shape):
                fitting = "a number" if is_size else f"a number or of the shape {times.shape}"
                raise ValueError(f"`{member.name}` must be {fitting}, not {value.shape}")
            columns[member.name] = float(value) if is_size else np.broadcast_to(value, times.shape)
        elif member.default is MISSING and member.default_factory is MISSING:
            columns[member.name] = np.full(times.shape, np.nan)
    if members:
        known = [member.name for member in fields(AgentTrace) if member.name != "name"]
        raise _unknown("an agent of a trace", next(iter(members)), known)
    return AgentTrace(arguments.text("name", name), **columns)


def trace(*agents: AgentTrace) -> Trace:
    """A drive of agents with the same times, as `judge` of a monitor gets it.

    Raises `TypeError` for what is no agent, `ValueError` for none and for agents with other times
    or of one name.
    """
    from .ir.trace import AgentTrace, Trace

    for agent in agents:
        if not isinstance(agent, AgentTrace):
            raise arguments.wrong_type("agents", "made by `agent_trace`", agent)
    if not agents:
        raise ValueError("`trace` needs an agent: `trace(agent_trace(time=[0, 1]))`")
    if any(agent.time.tolist() != agents[0].time.tolist() for agent in agents):
        raise ValueError("the agents of a trace must have the same `time`")
    if len({agent.name for agent in agents}) < len(agents):
        raise ValueError("the agents of a trace must have names of their own")
    return Trace(agents[0].time, {agent.name: agent for agent in agents})


def observation(**members: Any) -> Observation:
    """What a controller gets once a step: an agent at the start of a straight line along the x
    axis, which it follows at rest. `members` of `Observation` change that."""
    from .ir.observation import Observation

    position = {"x": members.get("station", 0.0), "y": members.get("cross_track_error", 0.0)}
    defaults: dict[str, Any] = {
        "time": 0.0,
        "step": 0.02,
        "agent": "ego",
        **position,
        "heading": members.get("heading_error", 0.0),
        "speed": 0.0,
        "steering": 0.0,
        "cross_track_error": 0.0,
        "heading_error": 0.0,
        "station": 0.0,
        "wheelbase": 2.7,
        "line_ahead": lambda distance: (position["x"] + distance, 0.0, 0.0, 0.0),
    }
    known = [member.name for member in fields(Observation)]
    for name in members:
        if name not in known:
            raise _unknown("an observation", name, known)
    return Observation(**{**defaults, **members})


def _unknown(owner: str, name: str, known: list[str]) -> TypeError:
    """For the caller to raise: what a member is meant to be, or all that there are."""
    help = did_you_mean(name, known) or (f"its members are {', '.join(known)}",)
    return TypeError(f"{owner} has no member `{name}`: {help[0]}")


with contextlib.suppress(ImportError):
    import pytest

    @pytest.fixture
    def roadlang_sample(tmp_path: Path) -> Callable[..., SceneSet]:
        """`sample`, where files that a text names are in the test's `tmp_path`."""

        def sample_in_folder(text: str, n: int | None = 1, **more: Any) -> SceneSet:
            return sample(text, n, **{"folder": tmp_path, **more})

        return sample_in_folder
