"""What backends and the simulator cannot express of a scenario, before it is sampled."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ..drive.sensor_offers import refused_sensor
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.scenario_contents import ScenarioContents
from ..ir.values import PassCall, Value
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import implements
from .constant_kinds import constant_kind


def unsupported_parts(scenario: IndexedScenario) -> list[Diagnostic]:
    """RL243 for each part that an `emit` or `simulate` does not support, RL257 for each sensor."""
    source = scenario.source
    calls = [call for call in (source.simulate, *source.emits) if call is not None]
    found: list[Diagnostic] = []
    for call in calls:
        try:
            found += _reported(call, scenario)
        except DiagnosticError as error:
            found += error.diagnostics
    return [*found, *_sensors_not_offered(scenario)]


def _sensors_not_offered(scenario: IndexedScenario) -> list[Diagnostic]:
    """RL257 for each sensor that the simulator of the scene does not offer."""
    simulate = scenario.source.simulate
    sensors = [sensor for agent in scenario.source.agents for sensor in agent.sensors]
    if simulate is None or not sensors:
        return []
    built = constant_kind(simulate, scenario)
    if built is None:
        return []
    simulator = (scenario.kind(simulate)[0], built)
    refused = (
        refused_sensor(scenario.kind(s.call)[0], s.name, simulator, scenario.registry, s.call.span)
        for s in sensors
    )
    return [found for found in refused if found is not None]


def _reported(call: PassCall, scenario: IndexedScenario) -> Iterator[Diagnostic]:
    entry, kind = scenario.kind(call)
    if not implements(kind, "unsupported"):
        return
    built = constant_kind(call, scenario)
    if built is None:  # an option that is only known when scenes are made
        return
    with plugin_guard(entry, call.span):
        found = built.unsupported(_contents(scenario))
        reasons = [found] if isinstance(found, str) else list(found)
    for reason in reasons:
        if not isinstance(reason, str):
            raise wrong_result(entry, call.span, f"gave {reason!r} as a reason, not text")
        name = f"{call.verb} {entry.recorded}"
        yield diagnose(Code.UNSUPPORTED_PART, call.span, kind=name, reason=reason)


def _contents(scenario: IndexedScenario) -> ScenarioContents:
    source = scenario.source
    return ScenarioContents(
        networks=tuple(network.name for network in source.networks),
        roads=tuple(road.name for road in source.roads),
        agents=_kinds(source.agents, scenario),
        objects=_kinds(source.objects, scenario),
        controllers={
            agent.name: tuple(scenario.kind(call)[0].recorded for call in agent.drive)
            for agent in source.agents
            if agent.drive
        },
        world=tuple(name for name in source.world),
        expectations=tuple(constraint.name for constraint in source.expectations),
    )


def _kinds(
    actors: Iterable[ScenarioActor], scenario: IndexedScenario
) -> dict[str, tuple[str, ...]]:
    return {actor.name: tuple(_calls(actor.kind, scenario)) for actor in actors}


def _calls(kind: Value, scenario: IndexedScenario) -> dict[str, None]:
    """The kinds of agents and objects that a value may be, each once, in order."""
    contents = scenario.dependencies.contents(kind)
    calls = (part for part in contents if isinstance(part, PassCall))
    actors = (call for call in calls if call.verb in ("agent", "object"))
    return dict.fromkeys(scenario.kind(call)[0].recorded for call in actors)
