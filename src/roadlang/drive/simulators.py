"""Drives scenes in a simulator and judges what happened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..diagnostics import Code, DiagnosticError, diagnose
from ..ir.readings import SensorRecord
from ..ir.scene import Call, Scene
from ..ir.trace import Trace
from ..judging.drives import Judgment, judge
from ..judging.drives_together import robustness_together
from ..plugins.configured import configured
from ..plugins.finding import entry_of
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Simulator
from ..plugins.registry import KindEntry, Registry
from ..simulation.simulating import EngineSettings
from .controllers import python_controllers
from .sensor_offers import refuse_sensors
from .sensors import sensor_recorders
from .written_places import UNKNOWN, WrittenPlaces


@dataclass(frozen=True)
class Driven:
    """What happened to one scene, and how its expectations came out."""

    scene: Scene
    trace: Trace
    judgment: Judgment
    readings: tuple[SensorRecord, ...] = ()
    """of the sensors, where they were to be recorded"""


def simulator_of(
    scene: Scene, registry: Registry, engine: str | None, options: Mapping[str, Any]
) -> tuple[KindEntry, Simulator]:
    """The simulator of `simulator_call`. Raises what that and `configured` raise."""
    call = simulator_call(scene, registry, engine, options)
    return configured(registry, "simulate", call.kind, call.options)


def simulator_call(
    scene: Scene, registry: Registry, engine: str | None, options: Mapping[str, Any]
) -> Call:
    """The simulator called `engine`, else the scene's, else the first there is, with its options.

    `options` (SI units) come before those of the scene's `simulate with`, which count where it
    names the same engine. Raises `DiagnosticError` RL930 for an engine that is not there, RL926
    where there is none at all.
    """
    call = scene.simulate
    if engine is None:
        engine = call.kind if call is not None else _first_engine(registry)
    entry = entry_of(registry, "simulate", engine)
    is_of_scene = call is not None and entry_of(registry, "simulate", call.kind) == entry
    written = dict(call.options) if call is not None and is_of_scene else {}
    return Call(entry.recorded, {**written, **options})


def _first_engine(registry: Registry) -> str:
    """What drives scenes that name no engine: a shipped one, whatever else is installed."""
    first = next(registry.defaults("simulate"), next(registry.of("simulate"), None))
    if first is None:
        help_ = registry.hints or ("`--no-plugin` may have left it out",)
        raise DiagnosticError(diagnose(Code.UNKNOWN_KIND_OR_PLUGIN, name="simulate", help=help_))
    return first.qualified


def scenes_at_once(registry: Registry, engine: str | None) -> int:
    """The greatest number of scenes that the simulator called `engine`, else the first there is,
    drives in one call. Raises as `simulator_call`."""
    entry = entry_of(registry, "simulate", engine or _first_engine(registry))
    with plugin_guard(entry, None):
        kind: Any = entry.load()
    return int(kind.at_once)


def engine_settings(registry: Registry) -> EngineSettings:
    """How the embedded engine drives, for who steps it.

    Raises `DiagnosticError` RL926 where no installed simulator is the embedded engine."""
    settings: EngineSettings = embedded_engine(registry)[1].settings  # type: ignore[attr-defined]
    return settings


def embedded_engine(registry: Registry) -> tuple[KindEntry, Simulator]:
    """The simulator that is the embedded engine. Raises as `engine_settings`."""
    for entry in registry.defaults("simulate"):
        with plugin_guard(entry, None):
            simulator: Simulator = entry.load()()  # type: ignore[assignment]
        if isinstance(getattr(simulator, "settings", None), EngineSettings):
            return entry, simulator
    raise DiagnosticError(diagnose(Code.UNKNOWN_KIND_OR_PLUGIN, name="simulate"))


def drive_scenes(
    scenes: Sequence[Scene],
    registry: Registry,
    engine: str | None,
    options: Mapping[str, Any],
    *,
    record_sensors: bool = False,
    places: WrittenPlaces = UNKNOWN,
) -> tuple[Driven, ...]:
    """Drive each scene, all with one engine, and judge its expectations. `places`: where faults of
    controllers and sensors are shown."""
    entry, simulator = simulator_of(scenes[0], registry, engine, options)
    controllers = [python_controllers(scene, registry, places) for scene in scenes]
    refuse_sensors(scenes, (entry, simulator), registry)
    recorders = [sensor_recorders(of_scene) if record_sensors else [] for of_scene in controllers]
    with plugin_guard(entry, None):
        traces = list(simulator.drive_all(scenes, controllers))
    for trace in traces:
        if not isinstance(trace, Trace):
            raise wrong_result(entry, None, f"gave a {type(trace).__name__}, not a Trace")
    if len(traces) != len(scenes):
        raise wrong_result(entry, None, f"gave {len(traces)} traces of {len(scenes)} scenes")
    for scene, trace in zip(scenes, traces, strict=True):
        missing = [agent.name for agent in scene.agents if agent.name not in trace.agents]
        if missing:
            fault = f"gave a trace of `{scene.name}` without the agent `{missing[0]}`"
            raise wrong_result(entry, None, fault)
    known = robustness_together(scenes, traces, registry)
    return tuple(
        Driven(scene, trace, judge(scene, trace, registry, rho), tuple(r.record for r in each))
        for scene, trace, rho, each in zip(scenes, traces, known, recorders, strict=True)
    )
