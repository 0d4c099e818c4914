"""A scene as the text of a Scenic program."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from roadlang_standard.extraction.colors.colors import bgr

from ..target_speed import target_speed
from .checks import on_lanes, touching
from .names import variable_names

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor

_CLASSES = {
    **dict.fromkeys(("car", "van", "truck", "bus", "tractor"), "Car"),
    "motorcycle": "Vehicle",
    "bicycle": "Vehicle",
    "pedestrian": "Pedestrian",
}
"""Of Scenic's driving model, for categories of agents; all else is an `Object`."""
_NOT_VEHICLES = ("Object", "Pedestrian")
"""Classes that need not be on the road; Scenic has pedestrians only on sidewalks."""
_FOLLOWS_LANE = frozenset(("lane_follow", "pure_pursuit", "stanley"))
_AVOIDS = frozenset(("car_follow", "traffic"))


@dataclass(frozen=True)
class ScenicProgram:
    """Writes the program of a scene. `map_file` is the name of its map, beside the program, and
    `points` into how many points Scenic cuts each piece of a reference line."""

    scene: Scene
    model: str
    behaviors: bool
    map_file: str
    points: int

    def text(self) -> str:
        """Of the whole file."""
        scene, source = self.scene, self.scene.provenance
        names = [actor.name for actor in scene.agents]
        ego = next((name for name in names if name == "ego"), names[0] if names else None)
        things = sorted((*scene.agents, *scene.objects), key=lambda thing: thing.name != ego)
        variables = variable_names(thing.name for thing in things if thing.name != ego)
        inside, crowded = on_lanes(scene, things), touching(things)
        lines = [
            f'"""{_plain(scene.title or scene.name)}',
            "",
            f"Scene {scene.index} of {_plain(source.source or scene.name)}, seed {source.seed}. "
            "Run it with --2d.",
            '"""',
            "",
            f"param map = localPath({json.dumps(self.map_file)})",
            f"param map_options = {{'ref_points': {self.points}}}",
            "",
            f"model {self.model}",
        ]
        agents = frozenset(names)
        for thing in things:
            name = "ego" if thing.name == ego else variables[thing.name]
            kind = _CLASSES.get(thing.category, "Object") if thing.name in agents else "Object"
            at = f"({_number(thing.x)}, {_number(thing.y)})"
            lines += ["", f"{name} = new {kind} at {at}, facing {_number(_heading(thing))},"]
            is_free = kind in _NOT_VEHICLES or thing.name not in inside
            specifiers = ",\n    ".join(self._properties(thing, is_free, thing.name in crowded))
            lines.append(f"    {specifiers}")
        return "\n".join(lines) + "\n"

    def _properties(self, thing: SceneActor, is_free: bool, crowded: bool) -> Iterator[str]:
        yield f"with name {json.dumps(thing.name)}"
        size = (thing.length, thing.width, thing.height)
        yield ", ".join(
            f"with {what} {_number(value)}"
            for what, value in zip(("length", "width", "height"), size, strict=True)
        )
        color = _color(thing)
        if color:
            yield f"with color {color}"
        if is_free:
            yield "with regionContainedIn everywhere"
        yield "with requireVisible False"
        if crowded:
            yield "with allowCollisions True"
        if thing.start_speed:
            yield f"with speed {_number(thing.start_speed)}"
        behavior = self._behavior(thing) if self.behaviors and not is_free else None
        if behavior:
            yield f"with behavior {behavior}"

    def _behavior(self, actor: SceneActor) -> str | None:
        """Where one of Scenic's does what the first controller does from the start."""
        if not actor.drive or not _drives_with_its_lane(self.scene, actor):
            return None
        call = actor.drive[0]
        if call.when is not None or call.during is not None:
            return None
        speed = _number(target_speed(self.scene, actor, call))
        if call.kind in _FOLLOWS_LANE:
            return f"FollowLaneBehavior(target_speed={speed})"
        if call.kind in _AVOIDS:
            return f"DriveAvoidingCollisions(target_speed={speed})"
        return None


def _drives_with_its_lane(scene: Scene, actor: SceneActor) -> bool:
    road = next((road for road in scene.roads if road.name == actor.road), None)
    if road is None:
        return False
    wanted = "backward" if actor.facing == "back" else "forward"
    return any(lane.id == actor.lane and lane.direction == wanted for lane in road.lane_list)


def _heading(thing: SceneActor) -> float:
    """Scenic counts from north."""
    return math.remainder(thing.heading - math.pi / 2.0, math.tau)


def _color(thing: SceneActor) -> str | None:
    name = thing.options.get("color")
    if not isinstance(name, str):
        return None
    try:
        blue, green, red = bgr(name)
    except ValueError:
        return None
    return f"({', '.join(_number(round(part / 255.0, 4)) for part in (red, green, blue))})"


def _number(value: float) -> str:
    return f"{value + 0.0:.12g}"


def _plain(text: str) -> str:
    """In one line, with nothing that ends the docstring."""
    return " ".join(text.split()).replace("\\", "/").replace('"', "'")
