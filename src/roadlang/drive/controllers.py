"""The controllers of a scene that are written in Python, as instances."""

from __future__ import annotations

from collections.abc import Mapping

from ..diagnostics import Span
from ..ir.scene import Call, Scene, SceneActor, SceneSensor
from ..plugins.finding import entry_of, find_entry
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Controller, ReadingArray, Sensor, implements
from ..plugins.options import schema_of
from ..plugins.registry import KindEntry, Registry
from ..simulation.calling.controllers import Driver, GuardedController
from ..simulation.calling.sensors import GuardedSensor
from .written_places import UNKNOWN, WrittenPlaces


def python_controllers(
    scene: Scene, registry: Registry, places: WrittenPlaces = UNKNOWN
) -> dict[str, Controller]:
    """Agent to what drives it, where the last unconditional controller is written in Python.
    `places`: where faults of controllers and sensors are shown."""
    found: dict[str, Controller] = {}
    expected = _expected_signals(scene, registry)
    for actor in scene.agents:
        driver = _driver(actor, registry, expected, places)
        if driver is not None:
            found[actor.name] = driver
    return found


def _driver(
    actor: SceneActor,
    registry: Registry,
    expected: Mapping[str, KindEntry],
    places: WrittenPlaces,
) -> Driver | None:
    name = actor.group
    sensors = [
        _sensor(sensor, registry, places.sensors.get((name, sensor.name)))
        for sensor in actor.sensors
    ]
    each = {
        place: _controller(call, registry, places.controllers.get((name, place)))
        for place, call in enumerate(actor.drive)
    }
    steady = [
        place
        for place, call in enumerate(actor.drive)
        if call.when is None and call.during is None and not _alters(each[place])
    ]
    undriven = all(controller is None for controller in each.values())
    if (undriven and not sensors) or (steady and each[steady[-1]] is None):
        return None
    spans = {place: places.controllers.get((name, place)) for place in each}
    return Driver(each, steady, {**expected, **_signals(actor, registry)}, sensors, spans)


def _alters(controller: GuardedController | None) -> bool:
    """Whether it is no controller but a fault of actuators."""
    return controller is not None and controller.alters


def sensor_arrays(actor: SceneActor, registry: Registry) -> dict[str, Mapping[str, ReadingArray]]:
    """What each sensor of an agent reads, by its name. Raises RL930, RL470."""
    return {sensor.name: _sensor(sensor, registry).arrays for sensor in actor.sensors}


def _sensor(sensor: SceneSensor, registry: Registry, span: Span | None = None) -> GuardedSensor:
    """Raises RL930 for a kind that is not installed."""
    entry = entry_of(registry, "sense", sensor.kind)
    with plugin_guard(entry, span):
        kind = entry.load()
    assert issubclass(kind, Sensor)
    return GuardedSensor(sensor, kind, entry, span)


def _expected_signals(scene: Scene, registry: Registry) -> dict[str, KindEntry]:
    """The drive signals that the scene's expectations are about, as far as they are installed."""
    names = {
        str(signal["kind"])
        for verdict in scene.expectations
        for signal in (verdict.formula or {}).get("signals", {}).values()
        if verdict.domain == "drive"
    }
    return {
        name: entry_of(registry, "drive_signal", name)
        for name in sorted(names)
        if registry.has("drive_signal", name)
    }


def _signals(actor: SceneActor, registry: Registry) -> dict[str, KindEntry]:
    """The drive signals in the conditions of an agent's controllers, by their names."""
    conditions = [part for call in actor.drive for part in (call.when, call.during) if part]
    names = {
        str(signal["kind"])
        for condition in conditions
        for signal in condition.get("signals", {}).values()
    }
    return {name: entry_of(registry, "drive_signal", name) for name in sorted(names)}


def _controller(call: Call, registry: Registry, span: Span | None) -> GuardedController | None:
    if not registry.has("drive", call.kind):
        return None
    entry = find_entry(registry, "drive", call.kind)
    with plugin_guard(entry, span):
        kind = entry.load()
        if not issubclass(kind, Controller):
            return None
        if not any(implements(kind, way) for way in ("control", "controls", "altered")):
            return None
        names = {option.name for option in schema_of(kind)}
    options = {key: value for key, value in call.options.items() if key in names}
    return GuardedController(kind, options, entry, span)
