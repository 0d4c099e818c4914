"""`render_mode="rgb_array"`: what a picture shows, and where there is none."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.envs import SceneEnv, SceneVectorEnv
from tests.envs.scene_texts import FOLLOWED, STRAIGHT

GROUND, SURFACE = (0xF4, 0xF2, 0xEC), (0x75, 0x7B, 0x83)
EGO, OTHER = (0xC9, 0x2A, 0x2A), (0x1C, 0x7E, 0xD6)


def drawn(text: str) -> SceneEnv:
    env = SceneEnv(roadlang.loads(text), scenes=1, render_mode="rgb_array")
    env.reset(seed=0)
    return env


def is_color(picture: Any, color: tuple[int, int, int]) -> Any:
    return (picture == np.array(color, dtype=np.uint8)).all(axis=2)


def test_the_driven_agent_is_in_the_middle_on_its_road() -> None:
    picture = drawn(STRAIGHT).render()
    assert picture is not None
    assert picture.shape == (480, 480, 3)
    assert picture.dtype == np.uint8
    assert is_color(picture, EGO)[240, 240]
    assert is_color(picture, SURFACE)[240, 400]  # the road goes on to the east
    assert is_color(picture, GROUND)[100].all()  # north of it is nothing


def test_others_move_relative_to_the_driven_agent() -> None:
    env = drawn(FOLLOWED)
    before = is_color(env.render(), OTHER)
    assert before.any()
    for _ in range(10):
        env.step(np.array([0.0, -1.0]))
    assert (is_color(env.render(), OTHER) != before).any()


def test_without_a_mode_there_is_no_picture() -> None:
    env = SceneEnv(roadlang.loads(STRAIGHT), scenes=1)
    env.reset(seed=0)
    assert env.render() is None


def test_pictures_come_after_the_first_reset() -> None:
    env = SceneEnv(roadlang.loads(STRAIGHT), scenes=1, render_mode="rgb_array")
    with pytest.raises(RuntimeError, match="reset\\(\\) comes before the first render"):
        env.render()


def test_other_modes_are_refused() -> None:
    with pytest.raises(ValueError, match="`rgb_array` or None, not 'human'"):
        SceneEnv(roadlang.loads(STRAIGHT), scenes=1, render_mode="human")
    with pytest.raises(TypeError, match="one `SceneEnv` draws pictures"):
        SceneVectorEnv(roadlang.loads(STRAIGHT), 2, scenes=1, render_mode="rgb_array")
