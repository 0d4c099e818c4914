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


BENT = (
    STRAIGHT + "road bent from main { perturb with sine { amplitude: 1m..2m, wavelength: 80m } }\n"
)


@pytest.mark.parametrize(
    ("require", "code"),
    [
        ("require far: always (deviation(bent, main) > 0.5m)\n", "RL601"),
        ("require far: always (deviation(bent, main) > 5m)\n", "RL600"),
        ("require wide: always (width(main) > 200m)\n", "RL600"),
    ],
)
def test_what_is_beyond_the_end_of_its_road_is_said_whatever_rejects_before_it(
    require: str, code: str
) -> None:
    agent = "agent ego is car on bent at 500m\nsample with random { attempts: 50 }\n"
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(BENT + agent + require).sample()
    [found] = caught.value.diagnostics
    assert found.code == code
    assert any("`ego` would stand " in text for text in found.help), found.help
    assert any("beyond the end of `bent`" in text for text in found.help), found.help
