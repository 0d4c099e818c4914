"""A scene, or a drive of it, as the text of an OpenSCENARIO file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from ..file_date import DATE
from ..opendrive.document import document as opendrive_document
from ..opendrive.document import turn_rule
from ..opendrive.elements import put
from ..opendrive.junctions import NumberedJunction, numbered_junctions
from ..opendrive.road_parts import road_parts
from ..opendrive.signals import signals
from . import actions
from .entities import put_agent, put_object
from .environment import put_environment
from .maneuvers import Event, Maneuvers, driven, maneuvers_of, start_of
from .positions import Place, Roads, route_places
from .traffic_signals import put_traffic_signals
from .triggers import at_time, put_trigger

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, Trace

_TOLERANCE = 0.005
"""Meters of reference lines, as of `emit opendrive`."""
_DURATION = 60.0
"""Seconds where the scene has none: those of the embedded engine."""


@dataclass(frozen=True)
class ScenarioFiles:
    """Writes the files of a scene: `road_file` is the name of the OpenDRIVE file."""

    scene: Scene
    roads: Roads
    junctions: tuple[NumberedJunction, ...]
    version: str
    road_file: str

    @classmethod
    def of(cls, scene: Scene, version: str, road_file: str) -> ScenarioFiles:
        """Of a scene."""
        parts = road_parts(scene, _TOLERANCE, "rule")
        junctions = numbered_junctions(scene, parts, turn_rule(scene, "rule"))
        return cls(scene, Roads(parts), junctions, version, road_file)

    def roads_text(self, version: str) -> str:
        """The OpenDRIVE file. Objects are in the scenario."""
        scene = replace(self.scene, objects=())
        return opendrive_document(scene, version, _TOLERANCE, "", "rule")

    def scenario_text(self) -> str:
        """What agents are to do."""
        options = {} if self.scene.simulate is None else self.scene.simulate.options
        duration = options.get("duration")
        return self._text(
            lambda actor: maneuvers_of(self.scene, self.roads, actor),
            _DURATION if duration is None else float(duration),
            has_routes=True,
        )

    def drive_text(self, trace: Trace) -> str:
        """What agents did."""
        duration = float(trace.time[-1]) if len(trace.time) else 0.0
        return self._text(lambda actor: driven(self.scene, trace, actor), duration)

    def _text(
        self,
        maneuvers: Callable[[SceneActor], Maneuvers],
        duration: float,
        has_routes: bool = False,
    ) -> str:
        scene = self.scene
        each = [maneuvers(actor) for actor in scene.agents]
        root = Element("OpenSCENARIO")
        _put_header(root, scene, self.version)
        put(root, "ParameterDeclarations")
        put(root, "CatalogLocations")
        network = put(root, "RoadNetwork")
        put(network, "LogicFile", filepath=self.road_file)
        put_traffic_signals(network, self.junctions, signals(self.junctions))
        entities = put(root, "Entities")
        for found in each:
            put_agent(entities, found.actor, found.unexpressed)
        for thing in scene.objects:
            put_object(entities, thing)
        storyboard = put(root, "Storyboard")
        self._put_init(storyboard, has_routes)
        _put_story(storyboard, each)
        put_trigger(storyboard, "StopTrigger", [[at_time(duration)]])
        indent(root, " ")
        return (
            '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"
        )

    def _put_init(self, storyboard: Element, has_routes: bool) -> None:
        inside = put(put(storyboard, "Init"), "Actions")
        put_environment(inside, self.scene.world)
        for actor in self.scene.agents:
            start = actions.teleport(start_of(actor, self.roads))
            found = [start, actions.at_speed(actor.start_speed or 0.0)]
            places = route_places(self.roads, actor) if has_routes else ()
            if places and actor.route is not None:
                name = f"{actor.name} route"
                found.append(actions.assign_route(name, places, actor.route.closed))
            _put_private(inside, actor.name, found)
        for thing in self.scene.objects:
            place = Place(thing.x, thing.y, thing.heading)
            _put_private(inside, thing.name, [actions.teleport(place)])


def _put_header(root: Element, scene: Scene, version: str) -> None:
    major, _, minor = version.partition(".")
    put(
        root,
        "FileHeader",
        revMajor=int(major),
        revMinor=int(minor),
        date=f"{DATE}T00:00:00",
        description=scene.title or scene.name or "scene",
        author="roadlang",
    )


def _put_private(inside: Element, name: str, found: Sequence[actions.Action]) -> None:
    private = put(inside, "Private", entityRef=name)
    for action in found:
        action(put(private, "PrivateAction"))


def _put_story(storyboard: Element, each: Sequence[Maneuvers]) -> None:
    """One maneuver group for each agent with events; no story without any."""
    active = [found for found in each if found.events]
    if not active:
        return
    act = put(put(storyboard, "Story", name="story"), "Act", name="act")
    for found in active:
        name = found.actor.name
        group = put(act, "ManeuverGroup", name=name, maximumExecutionCount=1)
        actors = put(group, "Actors", selectTriggeringEntities="false")
        put(actors, "EntityRef", entityRef=name)
        maneuver = put(group, "Maneuver", name=f"maneuver of {name}")
        for event in found.events:
            _put_event(maneuver, event)
    put_trigger(act, "StartTrigger", ())


def _put_event(maneuver: Element, event: Event) -> None:
    found = put(maneuver, "Event", name=event.name, priority="parallel", maximumExecutionCount=1)
    for number, action in enumerate(event.actions, 1):
        action(put(put(found, "Action", name=f"action {number}"), "PrivateAction"))
    if event.deletes:
        removal = put(put(found, "Action", name="leave"), "GlobalAction")
        entity = put(removal, "EntityAction", entityRef=event.deletes)
        put(entity, "DeleteEntityAction")
    put_trigger(found, "StartTrigger", event.groups)
