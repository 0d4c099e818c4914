"""Handles of scenes, and the texts that dragging, inserting and removing them makes, in lines."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator
from typing import Any

from roadlang import DiagnosticError
from roadlang.handles.handles import dragged, handles_of, inserted, removed
from roadlang.syntax import moved_places, network_edits, scene_edits
from tests.golden.comparing import SCENES
from tests.golden.scene_views import sampled
from tests.golden.summaries import number

_BY = ((4.5, -3.25), (-0.125, 2.0))
_PLACES = ((12.0, 3.5), (-1e-9, 0.004), (1234.5678, -0.5))
_NAMES = ("main", "bent", "town", "ego", "tree", "van", "nothing")
_TEXTS = {
    "points": "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 9m)] } }\n"
    "agent ego is car on main at 5m { drive with stanley }\nobject tree is tree at (3m, 4m)\n",
    "odd points": "road main { draw with waypoints { points: [(0m, 0m), (a, 0m)] } } # mine\n"
    "object van is parked_van at (1km, 4m), object tree is tree on main at 3m { offset: 2m }\n",
    "segments": "road main {\n\tdraw with segments { pieces: [straight(60m)] }\n}\nroad bent from "
    "main {\n\tperturb with nudges { at: [20m, 40m], by: [(1m, 0m), (0m, 2m)] }\n}\n",
    "sides": "road bent from main { perturb with sine }\nobject tree is tree on bent at 3m { side: "
    "right, offset: 2m }\nobject van is box on bent { side: left, offset: 50cm }\r\n",
    "network": "network town from plan { moved_at: [(1m, 2m)], moved_by: [(3m, -4m)] }\n"
    "road main from town { select: longest }\nagent ego is car on town at random",
    "network alone": "network town from plan\nnetwork bent from town { lanes: 2 }\n",
    "two points": "road main { draw with waypoints { points: [(0m, 0m), (6m, 0m)] } }",
    "faulty": "road main { draw with waypoints { points: [(0m, 0m), (6m, \nobject tree is tree",
}


def handle_lines(name: str) -> Iterator[str]:
    """The handles of a scene; each is dragged, one more is put beside it, and it is removed."""
    text = (SCENES / f"{name}.rl").read_text(encoding="utf-8")
    scene = sampled(name, 1)[0].record
    for place, handle in enumerate(handles_of(text, scene)):
        at = f"{number(handle.x)} {number(handle.y)}"
        yield f"{handle.sort} {handle.name} {handle.number} {number(handle.station)} at {at}"
        dx, dy = _BY[place % 2]
        to = (handle.x + dx, handle.y + dy)
        yield from _change("dragged", text, dragged, text, scene, handle, to, "nudges")
        yield from _change("inserted", text, inserted, text, scene, handle, to, "nudges")
        yield from _change("removed", text, removed, text, handle)


def edit_lines() -> Iterator[str]:
    """Every edit of every name in small texts, also where it makes no sense."""
    for title, text in _TEXTS.items():
        for name in _NAMES:
            yield f"{title}, {name}:"
            for to in _PLACES:
                yield from _change("moved", text, scene_edits.thing_moved, text, name, to)
            for sideways in (1.5, -7.0):
                along = scene_edits.thing_moved_along
                yield from _change("along", text, along, text, name, 12.345, sideways)
            yield from _change("removed", text, scene_edits.thing_removed, text, name)
            yield f"  waypoints {scene_edits.waypoints_of(text, name)}"
            for place in range(4):
                to = _PLACES[0]
                for edit in (scene_edits.waypoint_moved, scene_edits.waypoint_inserted):
                    yield from _change(
                        f"{edit.__name__} {place}", text, edit, text, name, place, to
                    )
                gone = scene_edits.waypoint_removed
                yield from _change(f"waypoint removed {place}", text, gone, text, name, place)
            yield from _moved_places(text, name)
            yield from _network(text, name)


def _moved_places(text: str, name: str) -> Iterator[str]:
    found = moved_places.moved_places_of(text, name)
    yield f"  places {found}"
    for station in (20.0, 20.4, 33.3, -1.0):
        moved = found.moved(station, (0.5, -0.25))
        write = moved_places.with_moved_places
        yield from _change(f"place {station}", text, write, text, name, moved, "nudges")
    fewer = found.without(20.0)
    yield from _change("fewer", text, moved_places.with_moved_places, text, name, fewer, "nudges")


def _network(text: str, name: str) -> Iterator[str]:
    yield f"  found network {network_edits.found_network(text, name)}"
    moves = network_edits.network_moves_of(text, name)
    yield f"  moves {moves}"
    if moves is not None:
        write = network_edits.with_network_moves
        yield from _change("moves again", text, write, text, name, moves)


def _change(title: str, text: str, change: Callable[..., str | None], *words: Any) -> Iterator[str]:
    """The lines that an edit changes, or why it is refused."""
    try:
        found = change(*words)
    except DiagnosticError as error:
        yield f"  {title}: {error}".replace("\n", " / ")
        return
    if found is None:
        return
    old, new = text.splitlines(keepends=True), found.splitlines(keepends=True)
    lines = [repr(line) for line in difflib.ndiff(old, new) if line[0] in "+-"]
    yield f"  {title}: {' '.join(lines) or 'nothing'}"
