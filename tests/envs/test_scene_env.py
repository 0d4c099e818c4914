"""A scene as an environment of gymnasium: spaces, rewards, ends."""

from __future__ import annotations

import math
import subprocess
import sys
import warnings
from typing import Any

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import roadlang
from roadlang.envs import SceneEnv, Transition
from tests.envs.scene_texts import ALONE, CUT_IN, FOLLOWED, STRAIGHT

STRAIGHT_ON = np.array([0.0, 0.5], dtype=np.float32)


def env(text: str, **settings: Any) -> SceneEnv:
    return SceneEnv(roadlang.loads(text), **{"scenes": 3, **settings})


@pytest.mark.parametrize("text", [ALONE, CUT_IN, FOLLOWED])
def test_gymnasium_has_nothing_to_complain_about(text: str) -> None:
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        check_env(env(text))
    assert [str(w.message) for w in found if "render" not in str(w.message)] == []


def test_there_is_no_step_before_the_first_reset() -> None:
    with pytest.raises(RuntimeError, match="comes before the first step"):
        env(ALONE).step(STRAIGHT_ON)


def test_rewards_and_ends_are_plain_finite_numbers() -> None:
    """What `check_env` lets pass: infinite rewards, and numpy's numbers."""
    one = env(ALONE)
    one.reset(seed=0)
    for _ in range(200):
        observed, reward, terminated, truncated, _ = one.step(one.action_space.sample())
        assert type(reward) is float
        assert math.isfinite(reward)
        assert type(terminated) is bool
        assert type(truncated) is bool
        assert one.observation_space.contains(observed)


def test_scenes_are_taken_as_sampled_and_as_read_from_files() -> None:
    scenes = roadlang.loads(ALONE).sample(2, seed=4)
    sampled, read = SceneEnv(list(scenes)), SceneEnv([scene.record for scene in scenes])
    for number in range(2):
        one, other = (env.reset(options={"scene": number})[0] for env in (sampled, read))
        np.testing.assert_array_equal(one, other)


def test_margins_are_those_of_the_expectations_of_the_first_scene() -> None:
    judged, plain = (
        roadlang.loads(text).sample(1)[0].record for text in (ALONE, ALONE.split("expect")[0])
    )
    one = SceneEnv([plain, judged])
    one.reset(options={"scene": 1})
    assert one.step(STRAIGHT_ON)[4]["margins"] == {}
    with pytest.raises(roadlang.DiagnosticError, match="a scene has no `expect` of this name"):
        SceneEnv([judged, plain]).reset(options={"scene": 1})


def test_who_hits_something_stands_where_it_did() -> None:
    """The front of a car of 4.5 m at the near side of a wall of 0.4 m, 20 m before another car."""
    text = STRAIGHT + (
        "agent lead is car on main at 60m\n"
        "object wall is barrier on main at 40m { offset: 0m, heading: 90deg }\n"
    )
    one = env(text)
    one.reset(seed=0)
    terminated = False
    while not terminated:
        observed, _, terminated, _, info = one.step(np.array([0.0, 1.0], dtype=np.float32))
    assert info["collided"]
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert seen["speed"] == 0.0
    assert seen["agent1_ahead"] == pytest.approx(20.0 + 0.2 + 0.5 * 4.5, abs=0.01)


def test_a_seed_decides_the_scenes_and_each_reset_draws_one() -> None:
    one, other = env(ALONE, scenes=20), env(ALONE, scenes=20)
    drawn = [one.reset(seed=3 if i == 0 else None)[1]["scene"] for i in range(10)]
    assert drawn == [other.reset(seed=3 if i == 0 else None)[1]["scene"] for i in range(10)]
    assert len(set(drawn)) > 3
    assert one.reset(options={"scene": 7})[1]["scene"] == 7
    with pytest.raises(ValueError, match="no scene 20"):
        one.reset(options={"scene": 20})


def test_each_number_of_an_observation_is_what_its_name_says() -> None:
    one = env(STRAIGHT)
    one.reset(seed=0)
    for _ in range(10):
        observed, *_ = one.step(STRAIGHT_ON)
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert seen["speed"] == pytest.approx(2.0, abs=0.15)  # 1 s at 2 m/s^2, less rolling resistance
    assert seen["acceleration"] == pytest.approx(2.0, abs=0.2)
    assert seen["left_edge"] == pytest.approx(4.0)
    assert seen["right_edge"] == pytest.approx(4.0)
    assert seen["path_ahead_20m"] == pytest.approx(20.0, abs=1e-3)
    assert seen["path_left_20m"] == pytest.approx(0.0, abs=1e-3)
    assert seen["speed_limit"] == 100.0
    assert seen["agent1_seen"] == 0.0


def test_a_speed_limit_is_seen() -> None:
    one = env(STRAIGHT.replace("lanes: 1", "lanes: 1, speed_limit: 50km/h"))
    observed, _ = one.reset(seed=0)
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert seen["speed_limit"] == pytest.approx(50 / 3.6, abs=1e-4)


def test_other_agents_are_seen_from_the_driven_one() -> None:
    one = env(STRAIGHT + "agent ahead is car on main at 30m { offset: 2m, facing: back }")
    observed, _ = one.reset(seed=0)
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert (seen["agent1_seen"], seen["agent2_seen"]) == (1.0, 0.0)
    assert seen["agent1_ahead"] == pytest.approx(25.0, abs=1e-3)
    assert seen["agent1_left"] == pytest.approx(2.0, abs=1e-3)


def test_the_reward_is_the_margin_of_an_expectation() -> None:
    one = env(ALONE, reward="in_lane")
    one.reset(seed=1)
    _, reward, _, _, info = one.step(np.array([0.3, 0.5], dtype=np.float32))
    observed, reward, _, _, info = one.step(np.array([0.3, 0.5], dtype=np.float32))
    error = dict(zip(one.names, observed.tolist(), strict=True))["cross_track_error"]
    assert reward == pytest.approx(2.0 - abs(error), abs=1e-5)
    assert info["margins"] == {"in_lane": reward}


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("always (ego.speed < 30m/s)", lambda e: 30.0 - e["speed"]),
        ("always (ego.speed < 30m/s and ego.speed > 1m/s)", lambda e: e["speed"] - 1.0),
        ("ego.speed > 5m/s or not (ego.speed > 2m/s)", lambda e: 2.0 - e["speed"]),
        ("always (ego.speed > 1m/s -> ego.speed * 2 < 10m/s)", lambda e: 10.0 - 2 * e["speed"]),
        ("always (ego.speed < 120m/s)", lambda e: min(120.0 - e["speed"], 100.0)),
        ("always (ego.speed < 1000m/s)", lambda e: 100.0),
        ("eventually (ego.speed == 3m/s)", lambda e: -abs(e["speed"] - 3.0)),
    ],
)
def test_a_formula_as_reward(formula: str, expected: object) -> None:
    one = env(STRAIGHT, reward=formula)
    one.reset(seed=0)
    observed, reward, *_ = one.step(STRAIGHT_ON)
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert callable(expected)
    assert reward == pytest.approx(max(expected(seen), -100.0), abs=1e-5)


def test_a_reward_may_look_one_sample_back() -> None:
    """The jerk, next to a signal that is known from what is now."""
    one = env(STRAIGHT, reward="always (ego.speed < 90m/s and ego.jerk < 60m/s^3)")
    before = dict(zip(one.names, one.reset(seed=0)[0].tolist(), strict=True))["acceleration"]
    for _ in range(3):
        observed, reward, *_ = one.step(STRAIGHT_ON)
        now = dict(zip(one.names, observed.tolist(), strict=True))["acceleration"]
        assert reward == pytest.approx(60.0 - (now - before) / one.settings.step, abs=1e-4)
        before = now


def test_weights_of_operands_count_in_the_reward() -> None:
    """As they do in the robustness: weights 3 and 1 are shares of 3/4 and 1/4."""
    text = (
        f"{STRAIGHT}\nlet slow = ego.speed < 30m/s\n"
        "expect fine: always (slow and ego.speed > 1m/s) { weights: { slow: 3 } }\n"
    )
    one = env(text, reward="fine")
    one.reset(seed=0)
    rewards = []
    for _ in range(20):
        observed, reward, *_ = one.step(STRAIGHT_ON)
        speed = dict(zip(one.names, observed.tolist(), strict=True))["speed"]
        over = speed - 1.0
        expected = min((30.0 - speed) * 0.25, over * 0.75 if over > 0 else over * 0.25)
        assert reward == pytest.approx(expected, abs=1e-5)
        rewards.append(reward)
    assert min(rewards) < 0 < max(rewards)


@pytest.mark.parametrize("measure", ["time", "time_left"])
def test_a_shift_in_time_is_no_reward(measure: str) -> None:
    text = f"{STRAIGHT}\nexpect slow: always (ego.speed < 4m/s) {{ robustness: {measure} }}\n"
    with pytest.raises(roadlang.DiagnosticError, match=r"RL730.*shift in time"):
        env(text, reward="slow")


def test_a_function_as_reward() -> None:
    def smooth(happened: Transition) -> object:
        change = np.abs(happened.action - happened.previous_action)[:, 0]
        return happened.moved + happened.margins["in_lane"] - change

    one = env(ALONE, reward=smooth)
    one.reset(seed=0)
    _, first, _, _, info = one.step(np.array([0.5, 0.0], dtype=np.float32))
    assert first == pytest.approx(info["margins"]["in_lane"] - 0.5)
    _, second, _, _, info = one.step(np.array([0.5, 0.0], dtype=np.float32))
    assert second == pytest.approx(info["margins"]["in_lane"])
    broken = env(ALONE, reward=lambda happened: happened.speed / 0.0 * 0.0)
    broken.reset(seed=0)
    with np.errstate(all="ignore"), pytest.raises(ValueError, match="not finite"):
        broken.step(STRAIGHT_ON)


def test_without_expectations_the_reward_is_the_meters_made() -> None:
    one = env(STRAIGHT)
    one.reset(seed=0)
    total = sum(one.step(STRAIGHT_ON)[1] for _ in range(20))
    assert total == pytest.approx(0.5 * 2.0 * 2.0**2, rel=0.1)


@pytest.mark.parametrize(
    ("settings", "code", "text"),
    [
        ({"reward": "in_lne"}, "RL730", "did you mean `in_lane`"),
        ({"reward": "always (eventually[0s, 1s] (ego.speed > 1m/s))"}, "RL730", "temporal"),
        ({"reward": "always (ego.sped > 1m/s)"}, "RL227", "did you mean `speed`"),
        ({"agent": "eog"}, "RL731", "did you mean `ego`"),
    ],
)
def test_what_cannot_be_is_explained(settings: dict[str, Any], code: str, text: str) -> None:
    with pytest.raises(roadlang.DiagnosticError) as found:
        env(ALONE, **settings)
    assert code in str(found.value)
    assert text in str(found.value)


def test_an_action_is_made_of_numbers() -> None:
    one = env(STRAIGHT)
    one.reset()
    with pytest.raises(ValueError, match="not a number"):
        one.step(np.array([math.nan, 0.0], dtype=np.float32))


def test_what_holds_no_scenes_is_refused() -> None:
    drive: Any = roadlang.loads(ALONE).sample()[0].run(duration=0.5)
    wrong: list[Any] = [None, drive, [drive], ["scene.rl"]]
    for source in wrong:
        with pytest.raises(TypeError, match="`source` must be a scene file"):
            SceneEnv(source)


def test_an_environment_says_what_it_drives() -> None:
    assert repr(env(ALONE, scenes=1)) == "<SceneEnv: ego in 1 scene>"
    assert repr(env(ALONE)) == "<SceneEnv: ego in 3 scenes>"


def test_options_of_a_reset_are_a_map() -> None:
    options: Any = 3
    with pytest.raises(TypeError, match="`options` must be a map"):
        env(ALONE).reset(options=options)


def ends_with(text: str, action: tuple[float, float], **settings: Any) -> dict[str, object]:
    one = env(text, **settings)
    one.reset(seed=0)
    for _ in range(1000):
        *_, terminated, truncated, info = one.step(np.array(action, dtype=np.float32))
        if terminated or truncated:
            return {**info, "terminated": terminated, "truncated": truncated}
    raise AssertionError("it does not end")


def test_how_episodes_end() -> None:
    wall = STRAIGHT + "object wall is barrier on main at 60m"
    assert ends_with(wall, (0.0, 1.0))["collided"]
    assert ends_with(STRAIGHT, (0.5, 1.0))["off_road"]
    assert ends_with(STRAIGHT, (0.0, 1.0))["arrived"]
    late = ends_with(STRAIGHT, (0.0, 0.0), duration=2.0)
    assert (late["terminated"], late["truncated"]) == (False, True)
    strict = ends_with(ALONE, (0.3, 1.0), violation_ends=True)
    assert strict["violated"]
    assert not strict["off_road"]


def test_another_agent_than_the_first_can_be_driven() -> None:
    one = env(FOLLOWED, agent="lead")
    observed, _ = one.reset(seed=0)
    seen = dict(zip(one.names, observed.tolist(), strict=True))
    assert seen["agent1_ahead"] == pytest.approx(-20.0, abs=1.0)


def test_scenes_themselves_are_a_source_too() -> None:
    scenes = roadlang.loads(ALONE).sample(4, seed=9)
    from_scenes = SceneEnv(list(scenes))
    from_file = SceneEnv(roadlang.loads(ALONE), scenes=4, scene_seed=9)
    assert (from_scenes.reset(seed=5)[0] == from_file.reset(seed=5)[0]).all()


def test_records_of_scenes_need_no_file() -> None:
    (scene,) = roadlang.loads(ALONE).sample(1, seed=9)
    read = roadlang.Scene.from_json(scene.to_json())
    expected = SceneEnv([scene]).reset(seed=5)[0]
    for made in (SceneEnv([scene.record]), SceneEnv([read]), SceneEnv([read.record])):
        assert (made.reset(seed=5)[0] == expected).all()


def test_without_gymnasium_the_error_names_the_extra() -> None:
    code = "import sys; sys.modules['gymnasium'] = None; import roadlang.envs"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert 'pip install "roadlang[gym]"' in found.stderr


@pytest.mark.parametrize("number", [-1, 3, 1.0, "0", None])
def test_a_scene_that_there_is_not_is_no_start(number: object) -> None:
    with pytest.raises(ValueError, match="there are 3, from 0"):
        env(ALONE).reset(options={"scene": number})


@pytest.mark.parametrize("number", [0, 2, np.int64(1)])
def test_the_scene_to_start_with_can_be_chosen(number: int) -> None:
    assert env(ALONE).reset(options={"scene": number})[1]["scene"] == number


def test_margins_of_what_is_measured_over_time() -> None:
    """What the car gains in a step of 40 ms, divided by the step."""
    text = ALONE + "expect a: always (ego.acceleration < 9m/s^2)\n"
    text += "expect j: always (ego.jerk < 50m/s^3)\n"
    known = []
    for name in ("a", "j"):
        one = env(text, reward=name)
        one.reset(seed=1)
        pedals = np.array([[0.0, 0.1], [0.0, 0.6], [0.0, -0.3], [0.0, 0.2]], dtype=np.float32)
        known.append([one.step(pedal)[4]["margins"][name] for pedal in pedals])
    acceleration, jerk = 9.0 - np.array(known[0]), 50.0 - np.array(known[1])
    np.testing.assert_allclose(jerk[1:], np.diff(acceleration) / one.settings.step, rtol=1e-3)


@pytest.mark.parametrize("pedal", [-1.0, -0.5, -0.03, 0.03, 0.5, 1.0])
def test_an_action_is_a_share_of_what_a_car_can_speed_up_or_brake(pedal: float) -> None:
    """Above zero of the one, below of the other."""

    def driven(**settings: float) -> Any:
        one = env(STRAIGHT.replace("at 5m", "at 5m { start_speed: 10m/s }"), **settings)
        one.reset(seed=0)
        return [one.step(np.array([0.0, pedal], dtype=np.float32))[0] for _ in range(5)]

    plain = driven(acceleration=2.0, deceleration=6.0)
    other_pull = driven(acceleration=3.0, deceleration=6.0)
    other_brake = driven(acceleration=2.0, deceleration=3.0)
    same, different = (other_brake, other_pull) if pedal > 0.0 else (other_pull, other_brake)
    np.testing.assert_array_equal(plain, same)
    assert (np.array(plain) != different).any()
