"""Sensors that a simulator does not offer. Imported by `check`, so it imports nothing heavy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..plugins.finding import entry_of
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Sensor, Simulator, implements
from ..plugins.registry import KindEntry, Registry

if TYPE_CHECKING:
    from ..ir.scene import Scene


def refused_sensor(
    sensor: KindEntry,
    name: str,
    simulator: tuple[KindEntry, Simulator],
    registry: Registry,
    span: Span | None = None,
) -> Diagnostic | None:
    """RL257 where a simulator does not offer sensors of a kind. `name`: that of the sensor."""
    entry, built = simulator
    if _offers(entry, built, sensor, span):
        return None
    offering = [
        other.recorded for other in registry.of("simulate") if _may_offer(other, sensor, span)
    ]
    help_ = [f"write `simulate with {other}`" for other in offering if other != entry.recorded]
    return diagnose(
        Code.SENSOR_NOT_OFFERED, span, kind=entry.recorded, sensor=name,
        sort=sensor.recorded, help=help_ or "no installed simulator offers it",
    )  # fmt: skip


def refuse_sensors(
    scenes: Sequence[Scene], simulator: tuple[KindEntry, Simulator], registry: Registry
) -> None:
    """Raises `DiagnosticError` RL257 where a scene has a sensor that its simulator does not offer,
    and RL930 for one of a plugin that is not installed."""
    kinds = {
        sensor.kind: sensor.name
        for scene in scenes
        for agent in scene.agents
        for sensor in agent.sensors
    }
    for kind, name in kinds.items():
        refused = refused_sensor(entry_of(registry, "sense", kind), name, simulator, registry)
        if refused is not None:
            raise DiagnosticError(refused)


def _may_offer(entry: KindEntry, sensor: KindEntry, span: Span | None) -> bool:
    """Whether a simulator offers it with the options that it has by default."""
    try:
        with plugin_guard(entry, None):
            kind = entry.load()
            assert issubclass(kind, Simulator)
            return implements(kind, "offers") and _offers(entry, kind(), sensor, span)
    except DiagnosticError:
        return False  # one that does not work is no help


def _offers(entry: KindEntry, built: Simulator, sensor: KindEntry, span: Span | None) -> bool:
    with plugin_guard(sensor, span):
        kind = sensor.load()
        assert issubclass(kind, Sensor)
    with plugin_guard(entry, None):
        found: object = built.offers(kind)
    if not isinstance(found, bool):
        raise wrong_result(entry, None, f"gave {found!r} for `offers`, not True or False")
    return found
