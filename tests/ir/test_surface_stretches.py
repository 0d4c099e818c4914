"""The surfaces of a road from stretch to stretch, and of the junctions where roads meet."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang.ir.scene_junctions import SceneArm, SceneJunction
from roadlang.ir.scene_road import SceneRoad
from roadlang.ir.scene_surface import SurfaceName, SurfacePatch
from roadlang.ir.surface_stretches import SurfaceStretch, junction_surface, surface_stretches

ROAD = SceneRoad(
    "main", (0.0, 100.0), (0.0, 100.0), (0.0, 100.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0),
    (7.0, 7.0), 2, False, 100.0, "main", surface="asphalt",
)  # fmt: skip


def stretches(*patches: SurfacePatch) -> list[tuple[float, float, tuple[SurfaceName | None, ...]]]:
    found = surface_stretches(replace(ROAD, surface_patches=patches), (1, -1))
    return [(each.start, each.end, each.surfaces) for each in found]


def test_a_road_without_patches_is_one_stretch() -> None:
    assert surface_stretches(ROAD, (1, -1)) == (SurfaceStretch(0.0, 100.0, ("asphalt", "asphalt")),)


def test_a_patch_covers_its_lanes_between_its_ends() -> None:
    assert stretches(SurfacePatch("ice", 20.0, 30.0, (-1,))) == [
        (0.0, 20.0, ("asphalt", "asphalt")),
        (20.0, 30.0, ("asphalt", "ice")),
        (30.0, 100.0, ("asphalt", "asphalt")),
    ]


def test_a_patch_without_lanes_covers_all_and_ends_with_the_road() -> None:
    assert stretches(SurfacePatch("snow", 80.0, 120.0), SurfacePatch("wet", -5.0, 10.0)) == [
        (0.0, 10.0, ("wet", "wet")),
        (10.0, 80.0, ("asphalt", "asphalt")),
        (80.0, 100.0, ("snow", "snow")),
    ]


def test_of_patches_that_overlap_the_last_counts() -> None:
    assert stretches(SurfacePatch("ice", 20.0, 60.0), SurfacePatch("wet", 40.0, 80.0)) == [
        (0.0, 20.0, ("asphalt", "asphalt")),
        (20.0, 40.0, ("ice", "ice")),
        (40.0, 80.0, ("wet", "wet")),
        (80.0, 100.0, ("asphalt", "asphalt")),
    ]


def test_patches_of_the_same_surface_that_meet_are_one_stretch() -> None:
    assert stretches(
        SurfacePatch("ice", 20.0, 40.0), SurfacePatch("ice", 40.0, 50.0),
        SurfacePatch("asphalt", 70.0, 80.0),
    ) == [
        (0.0, 20.0, ("asphalt", "asphalt")),
        (20.0, 50.0, ("ice", "ice")),
        (50.0, 100.0, ("asphalt", "asphalt")),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("surfaces", "of_junction"),
    [(("wet", "wet"), "wet"), (("wet", "ice"), None), (("wet", None), None), ((None,), None)],
)
def test_a_junction_has_the_surface_that_all_its_roads_have(
    surfaces: tuple[SurfaceName | None, ...], of_junction: SurfaceName | None
) -> None:
    roads = {
        f"arm{n}": replace(ROAD, name=f"arm{n}", surface=surface)
        for n, surface in enumerate(surfaces)
    }
    arms = tuple(SceneArm(name, "start", 0.0, 0, 1) for name in roads)
    junction = SceneJunction(0, (0,), "junction", (), arms, ())
    assert junction_surface(junction, roads) == of_junction
