"""Which scenes are missing where a sampler has fewer points than were asked for."""

from __future__ import annotations

import pytest

import roadlang
from tests.straight_road import STRAIGHT

GRID = (
    STRAIGHT + "param size = choice(1m, 2m, 3m, 4m)\nrequire big: size > LEAST\nsample with grid\n"
)


@pytest.mark.parametrize(
    ("least", "n", "found", "missing", "tried"),
    [
        ("0m", None, 4, (), 4),  # all of the grid
        ("2.5m", None, 2, (), 4),  # those of it that are accepted
        ("0m", 3, 3, (), 3),
        ("0m", 6, 4, (4, 5), 4),
        ("2.5m", 3, 2, (2,), 4),
        ("2.5m", 2, 2, (), 4),
        ("2.5m", 1, 1, (), 3),
    ],
)
def test_a_grid_has_the_scenes_that_it_has(
    least: str, n: int | None, found: int, missing: tuple[int, ...], tried: int
) -> None:
    scenes = roadlang.loads(GRID.replace("LEAST", least)).sample(n)
    assert len(scenes) == found
    assert scenes.result.candidates == tried
    assert scenes.result.missing == missing
    assert [scene.index for scene in scenes] == list(range(found))


@pytest.mark.parametrize("n", [None, 1, 3])
def test_a_grid_without_an_accepted_point_has_no_scene(n: int | None) -> None:
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(GRID.replace("LEAST", "9m")).sample(n)
    assert len(caught.value.result) == 0
    assert 0 in caught.value.result.result.missing


@pytest.mark.parametrize(("n", "found"), [(None, 1), (3, 3)])
def test_an_endless_sequence_goes_on_until_there_are_enough(n: int | None, found: int) -> None:
    text = (
        GRID.replace("LEAST", "1m")
        .replace("choice(1m, 2m, 3m, 4m)", "0m..4m")
        .replace("grid", "halton")
    )
    scenes = roadlang.loads(text).sample(n)
    assert len(scenes) == found
    assert scenes.result.missing == ()
