"""Controllers that read a sensor which their agent does not have."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.values import PassCall, TextValue
from ..plugins.kinds import Controller


def missing_sensors(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL480 for each sensor that a controller names (`Controller.sensor_options`), and that its
    agent does not have."""
    for name in sorted(scenario.agents):
        actor = scenario.actors[name]
        for call in actor.drive:
            kind = scenario.kind(call)[1]
            for option in kind.sensor_options if issubclass(kind, Controller) else ():
                wanted = _sensor(option, call, scenario)
                if wanted not in (None, *(sensor.name for sensor in actor.sensors)):
                    yield _missing(str(wanted), option, call, actor, scenario)


def _sensor(option: str, call: PassCall, scenario: IndexedScenario) -> str | None:
    """The sensor that an option names; None where draws decide."""
    if option not in call.options:
        known = {schema.name: schema.default for schema in scenario.kind(call)[0].options}
        return str(known[option])
    value = scenario.resolved(call.options[option])
    return value.value if isinstance(value, TextValue) else None


def _missing(
    wanted: str, option: str, call: PassCall, actor: ScenarioActor, scenario: IndexedScenario
) -> Diagnostic:
    entry = scenario.kind(call)[0]
    known = ", ".join(f"`{sensor.name}`" for sensor in actor.sensors)
    has = f"the sensors of `{actor.name}` are {known}" if known else f"`{actor.name}` has no sensor"
    is_kind = scenario.registry.has("sense", wanted)
    sensor = f"sense with {wanted}" if is_kind else f"sense with ... as {wanted}"
    return diagnose(
        Code.INVALID_OPTION,
        call.option_spans.get(option, call.span),
        option=option,
        kind=f"{entry.verb} {entry.name}",
        reason=f"is `{wanted}`, but {has}",
        help=f"add it to the agent: `{sensor}`",
    )
