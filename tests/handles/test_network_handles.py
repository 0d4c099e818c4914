"""Junctions and streets of networks go where they are dragged; the scene is planned around them."""

from __future__ import annotations

import math

import numpy as np
import pytest

import roadlang
from roadlang.diagnostics import DiagnosticError
from roadlang.handles.handle import SPACING, Handle
from roadlang.handles.handles import dragged, handles_of, removed
from roadlang.ir.scene import Scene
from roadlang.syntax.network_edits import network_moves_of

PICTURE = '''image plan from """
.......#.......
.......#.......
.#############.
.......#.......
.......#.......
.......#######.
""" { scale: 12m/px, legend: { "#": road } }
'''
TOWN = PICTURE + "network town from plan {  # mine\n  lanes: 2\n}\n"
BENT = PICTURE + (
    "network town from plan\n"
    "network bent from town { perturb with sine { amplitude: 1m, wavelength: 80m } }\n"
)


def scene_of(text: str) -> Scene:
    return roadlang.loads(text).sample(1, seed=0)[0].record


def handles(text: str) -> list[Handle]:
    return list(handles_of(text, scene_of(text)))


def nearest(text: str, place: tuple[float, float]) -> float:
    return min(math.dist((h.x, h.y), place) for h in handles(text))


@pytest.mark.parametrize("text", [TOWN, BENT], ids=["found", "perturbed"])
def test_a_dragged_junction_is_where_it_was_dropped(text: str) -> None:
    for _ in range(2):  # also one that was moved before
        handle = next(h for h in handles(text) if h.sort == "junction")
        to = (handle.x + 4.5, handle.y - 3.25)
        changed = dragged(text, scene_of(text), handle, to, "nudges")
        assert changed is not None
        text = changed
        scene = scene_of(text)
        network = scene.networks[-1]
        assert min(math.dist((n.x, n.y), to) for n in network.nodes) < 0.01
        assert min(np.hypot(*(np.array(j.area).mean(axis=0) - to)) for j in network.junctions) < 4.0
    assert text.count("moved_by") == 1
    assert text.startswith(PICTURE)


def test_every_handle_of_a_network_is_where_it_was_dropped() -> None:
    found = handles(TOWN)
    assert 8 < len(found) < 40
    for handle in found:
        to = (handle.x - 2.0, handle.y + 3.0)
        changed = dragged(TOWN, scene_of(TOWN), handle, to, "nudges")
        assert changed is not None
        assert nearest(changed, to) < 0.01, handle
        assert "# mine\n  lanes: 2\n  moved_at" in changed


def test_no_handle_of_a_network_lies_on_another() -> None:
    """Nor do places that were moved, of which one is near a junction."""
    text = TOWN
    for sort, by in (("street", 6.0), ("junction", 5.0)):
        handle = next(h for h in handles(text) if h.sort == sort)
        changed = dragged(text, scene_of(text), handle, (handle.x + by, handle.y + by), "nudges")
        assert changed is not None
        text = changed
        places = np.array([(h.x, h.y) for h in handles(text)])
        apart = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
        assert len(places) > 8
        assert apart[~np.eye(len(places), dtype=bool)].min() > 0.4 * SPACING


def test_a_moved_place_goes_back() -> None:
    text = TOWN
    for handle in (handles(TOWN)[0], handles(TOWN)[-1]):
        changed = dragged(text, scene_of(text), handle, (handle.x + 3.0, handle.y), "nudges")
        assert changed is not None
        text = changed
    for _ in range(2):
        moved = next(h for h in handles(text) if removed(text, h) not in (None, text))
        back = removed(text, moved)
        assert back is not None
        text = back
    before, after = scene_of(TOWN), scene_of(text)
    for old, new in zip(before.roads, after.roads, strict=True):
        assert old.length == pytest.approx(new.length, abs=0.05)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_place_that_is_moved_again_leaves_the_others_where_they_are(number: int) -> None:
    at, by = [(20.0, 42.0), (90.0, 42.0), (140.0, 42.0)], [(1.0, 2.0), (2.0, -1.0), (-1.5, 0.5)]
    written = [", ".join(f"({x}m, {y}m)" for x, y in places) for places in (at, by)]
    text = TOWN.replace("lanes: 2", "moved_at: [{}], moved_by: [{}]".format(*written))
    place = tuple(a + b for a, b in zip(at[number], by[number], strict=True))
    handle = min(handles(text), key=lambda found: math.dist((found.x, found.y), place))
    assert math.dist((handle.x, handle.y), place) < 0.6
    changed = dragged(text, scene_of(text), handle, (handle.x + 0.5, handle.y - 0.25), "nudges")
    assert changed is not None
    moves = network_moves_of(changed, "town")
    assert moves is not None
    expected = [*by[:number], (by[number][0] + 0.5, by[number][1] - 0.25), *by[number + 1 :]]
    np.testing.assert_allclose(moves.at, at)
    np.testing.assert_allclose(moves.by, expected, atol=0.01)


def test_what_would_fold_the_network_stays() -> None:
    handle = handles(TOWN)[0]
    assert dragged(TOWN, scene_of(TOWN), handle, (handle.x + 60.0, handle.y), "nudges") is None


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ("moved_at: [(0m, 0m)], moved_by: [(60m, 0m)]", "RL472"),
        ("moved_at: [(0m, 0m)]", "RL480"),
        ("moved_by: [(0m, 0m)]", "RL480"),
        ("moved_at: [(0m, 0m)], moved_by: [(1m, 0m), (0m, 1m)]", "RL480"),
        ("moved_at: [(0m..9m, 0m)], moved_by: [(6m, 0m)]", "RL229"),
    ],
)
def test_moves_that_cannot_be_made_are_said(options: str, code: str) -> None:
    text = f"{PICTURE}network town from plan {{ {options} }}\n"
    with pytest.raises(DiagnosticError, match=code):
        roadlang.loads(text).sample(1)
    assert code == "RL472" or [found.code for found in roadlang.loads(text).check()] == [code]


def test_only_networks_that_were_found_are_moved() -> None:
    text = BENT.replace("{ perturb", "{ moved_at: [(0m, 0m)], moved_by: [(1m, 0m)], perturb")
    with pytest.raises(DiagnosticError, match="an image or a file"):
        roadlang.loads(text).sample(1)


STREET = '''image NAME from """
...............
.#############.
...............
""" { scale: 12m/px, legend: { "#": road } }
network of_NAME from NAME
'''
ROAD = "road over_NAME from of_NAME { select: longest }\n"


@pytest.mark.parametrize(
    ("text", "sorts"),
    [
        (STREET, {"street"}),
        (STREET + ROAD, {"place"}),
        (STREET + ROAD + (STREET + ROAD).replace("NAME", "other"), {"place"}),
        (STREET + ROAD + STREET.replace("NAME", "other"), {"place", "street"}),
    ],
    ids=["alone", "under a road", "two of them", "one of two"],
)
def test_a_network_that_a_road_runs_all_over_leaves_the_handles_to_it(
    text: str, sorts: set[str]
) -> None:
    found = handles(text.replace("NAME", "first"))
    assert {handle.sort for handle in found} == sorts
    if "street" in sorts and "place" in sorts:
        assert {h.name for h in found if h.sort == "street"} == {"of_other"}
