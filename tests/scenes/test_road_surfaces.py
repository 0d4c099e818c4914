"""What roads of scenes are made of or covered by: said, drawn, inherited, joined."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang import testing
from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scene import Scene, SceneRoad
from roadlang.ir.surface_stretches import surface_stretches
from tests.formats.small_maps import lane, section, straight, xodr

STRAIGHT = "draw with segments { pieces: [straight(200m)] }, lanes: 2"
TOWN = '''image plan from """
...#...
...#...
#######
...#...
""" { scale: 20m/px, legend: { "#": road } }
network town from plan { lanes: 2, surface: snow, %s }
'''


def scenes(text: str, count: int = 1) -> list[Scene]:
    return [sample.record for sample in testing.sample(text, count)]


def road(text: str, name: str = "main") -> SceneRoad:
    (scene,) = scenes(text)
    return next(one for one in scene.roads if one.name == name)


def test_a_surface_and_a_stretch_of_it_are_drawn_for_each_scene() -> None:
    text = f"""road main {{ {STRAIGHT}, surface: choice(wet, ice)
        surface_patches: [{{ surface: snow, over: [40m, 50m..80m], side: right }}] }}"""
    found = [scene.roads[0] for scene in scenes(text, 12)]
    assert {one.surface for one in found} == {"wet", "ice"}
    ends = [one.surface_patches[0].end for one in found]
    assert len(set(ends)) == 12
    assert 50.0 <= min(ends) <= max(ends) <= 80.0
    assert all(one.surface_patches[0].lanes == (-1,) for one in found)


def test_patches_lie_on_lanes_and_the_last_one_counts() -> None:
    found = road(f"""road main {{ {STRAIGHT}, surface_patches: [
        {{ surface: wet, over: [40m, 80m] }}, {{ surface: ice, over: [60m, 70m], lane: 1 }}] }}""")
    assert [
        (each.start, each.end, each.surfaces) for each in surface_stretches(found, (1, -1))
    ] == [
        (0.0, 40.0, (None, None)),
        (40.0, 60.0, ("wet", "wet")),
        (60.0, 70.0, ("ice", "wet")),
        (70.0, 80.0, ("wet", "wet")),
        (80.0, 200.0, (None, None)),
    ]


def test_a_bent_road_has_the_surfaces_of_its_root_at_the_same_places() -> None:
    text = f"""road main {{ {STRAIGHT}, surface_patches: [{{ surface: ice, over: [100m, 120m] }}] }}
        road bent from main {{ perturb with bump {{ at: 60m, height: 6m, length: 80m }} }}
        road dry from bent {{ surface_patches: [] }}"""
    patch = road(text, "bent").surface_patches[0]
    assert patch.start > 100.5
    assert patch.end - patch.start == pytest.approx(20.0, abs=0.1)
    assert road(text, "dry").surface_patches == ()


def test_the_parts_of_a_joined_road_keep_their_surfaces() -> None:
    found = road(f"""road a {{ {STRAIGHT}
            surface_patches: [{{ surface: wet, over: [190m, 300m] }}] }}
        road b {{ {STRAIGHT}, surface: gravel }}
        road main from a {{ then: b }}""")
    patches = found.surface_patches
    assert [patch.surface for patch in patches] == ["wet", "gravel"]
    assert [(patch.start, patch.end) for patch in patches] == [
        pytest.approx((190.0, 200.0)),
        pytest.approx((200.0, 400.0)),
    ]


def test_a_patch_of_a_network_lies_on_the_road_that_it_names() -> None:
    (scene,) = scenes(TOWN % "surface_patches: [{ surface: ice, over: [5m, 20m], road: 1 }]")
    by_edge = {one.edge: one for one in scene.roads}
    assert {one.surface for one in scene.roads} == {"snow"}
    assert {edge for edge, one in by_edge.items() if one.surface_patches} == {1}
    (patch,) = by_edge[1].surface_patches
    assert (patch.start, patch.end) == pytest.approx((5.0, 20.0))


def test_a_patch_of_a_network_lies_on_the_roads_that_have_its_lane(tmp_path: Path) -> None:
    """Road 1 has four lanes, road 2 has two."""
    (tmp_path / "town.xodr").write_text(
        xodr(
            straight(1, 0.0, 50.0, lanes=section(0, [lane(2), lane(1)], [lane(-1), lane(-2)])),
            straight(2, 0.0, 90.0),
        )
    )
    town = f'network town from "{tmp_path / "town.xodr"}" '
    town += "{ surface_patches: [{ surface: ice, %s }] }"
    (scene,) = scenes(town % "lane: -2")
    patches = {one.edge: [patch.lanes for patch in one.surface_patches] for one in scene.roads}
    assert patches == {1: [(-2,)], 2: []}
    for fault in ("lane: -3", "lane: -2, road: 2"):
        with pytest.raises(DiagnosticError) as caught:
            scenes(town % fault)
        assert caught.value.diagnostics[0].code == "RL613"


@pytest.mark.parametrize("where", ["lane: 1, side: right", "lane: -1, side: left"])
def test_a_patch_on_a_side_without_its_lane_is_on_no_lane(where: str) -> None:
    found = road(f"road main {{ {STRAIGHT}, surface_patches: [{{ surface: ice, {where} }}] }}")
    assert found.surface_patches == ()


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (f"road main {{ {STRAIGHT}, surface: mud }}", "RL2"),
        (f"road main {{ {STRAIGHT}, surface_patches: [{{ over: [4m, 9m] }}] }}", "RL221"),
        (f"road main {{ {STRAIGHT}, surface_patches: [{{ surface: wet, lane: 3 }}] }}", "RL613"),
        (f"road main {{ {STRAIGHT}, surface_patches: [{{ surface: wet, lane: 0 }}] }}", "RL613"),
        (f"road main {{ {STRAIGHT}, surface_patches: [{{ surface: wet, road: 3 }}] }}", "RL411"),
        (
            f"road main {{ {STRAIGHT}, surface_patches: [{{ surface: wet, over: [1km, 2km] }}] }}",
            "RL414",
        ),
        (TOWN % "surface_patches: [{ surface: ice, road: 9 }]", "RL411"),
    ],
)
def test_what_cannot_be_is_said(text: str, code: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        scenes(text)
    assert caught.value.diagnostics[0].code.startswith(code)


@pytest.mark.parametrize("surface", ["ice", "choice(wet, ice)"])
def test_patches_that_are_drawn_for_each_scene_are_checked_as_those_that_are_the_same(
    surface: str, tmp_path: Path
) -> None:
    """Road 1 has four lanes, road 2 has two."""
    (tmp_path / "town.xodr").write_text(
        xodr(
            straight(1, 0.0, 50.0, lanes=section(0, [lane(2), lane(1)], [lane(-1), lane(-2)])),
            straight(2, 0.0, 90.0),
        )
    )
    town = f'network town from "{tmp_path / "town.xodr"}" '
    town += f"{{ surface_patches: [{{ surface: {surface}, WHERE }}] }}"
    for scene in scenes(town.replace("WHERE", "lane: -2"), 4):
        assert {one.edge: len(one.surface_patches) for one in scene.roads} == {1: 1, 2: 0}
    for where, code in {
        "lane: -3": "RL613",
        "lane: -2, road: 2": "RL613",
        "road: 9": "RL411",
    }.items():
        with pytest.raises(DiagnosticError) as caught:
            scenes(town.replace("WHERE", where), 4)
        assert caught.value.diagnostics[0].code == code
