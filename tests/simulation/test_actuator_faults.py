"""Faults of actuators: what becomes of the controls that controllers decide on."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Control, Controller, Mirror, Observation
from roadlang.drive.controllers import python_controllers
from roadlang.geometry.arrays import Floats
from roadlang.session.scene import Scene

STEP = 0.04
COUNT = 75
SPEED = 8.0
ROAD = "road main { draw with waypoints { points: [(0m, 0m), (300m, 0m)] }, width: 30m }\n"
TIME = STEP * np.arange(COUNT)
STEERING, ACCELERATION = 0.04 * np.sin(2.0 * TIME), 0.5 * np.cos(TIME)


@dataclass(frozen=True)
class Wave(Controller):
    """Steers in waves."""

    name: ClassVar[str] = "wave"

    def control(self, observation: Observation) -> Control:
        time = observation.time
        return Control(0.04 * math.sin(2.0 * time), 0.5 * math.cos(time))


def sampled(faults: str, n: int = 1) -> list[Scene]:
    drive = f"start_speed: {SPEED}m/s, drive with wave\n{faults}"
    text = f"{ROAD}agent ego is car on main at 5m {{ {drive} }}"
    return list(testing.sample(text, n, kinds=[Wave]))


def decided(faults: str, scene: int = 0) -> tuple[Floats, Floats]:
    """Steering and acceleration at each step of an agent that moves at 8 m/s."""
    found = sampled(faults, scene + 1)[scene]
    mirror = Mirror(found.record, python_controllers(found.record, found.registry), STEP)
    out = []
    for number in range(COUNT):
        pose = np.array([[5.0 + SPEED * STEP * number, 0.0, 0.0, SPEED]])
        mirror.follow(pose, np.zeros(1), passed=number > 0)
        decision = mirror.decide()
        out.append((decision.steering[0], decision.acceleration[0]))
    steering, acceleration = np.array(out).T
    return steering, acceleration


def test_without_a_fault_what_is_wanted_is_done() -> None:
    steering, acceleration = decided("")
    np.testing.assert_allclose(steering, STEERING, atol=1e-9)
    np.testing.assert_allclose(acceleration, ACCELERATION, atol=1e-9)


def test_a_late_actuator_does_what_was_wanted_before() -> None:
    steering, acceleration = decided("drive with steering_fault { delay: 0.2s }")
    np.testing.assert_allclose(steering[5:], STEERING[:-5], atol=1e-9)
    np.testing.assert_allclose(steering[:5], STEERING[0], atol=1e-9)
    np.testing.assert_allclose(acceleration, ACCELERATION, atol=1e-9)


def test_gain_and_bias() -> None:
    steering, acceleration = decided("drive with throttle_fault { gain: 0.5, bias: -1m/s^2 }")
    np.testing.assert_allclose(acceleration, 0.5 * ACCELERATION - 1.0, atol=1e-9)
    np.testing.assert_allclose(steering, STEERING, atol=1e-9)


def test_noise_is_as_large_as_stated_and_another_in_each_scene() -> None:
    fault = "drive with steering_fault { noise: 0.5deg }"
    first, second = (decided(fault, scene)[0] - STEERING for scene in (0, 1))
    assert first.std() == pytest.approx(math.radians(0.5), rel=0.25)
    assert abs(np.corrcoef(first, second)[0, 1]) < 0.35
    np.testing.assert_array_equal(decided(fault)[0] - STEERING, first)


def test_a_stuck_actuator_stays_while_the_fault_is_there() -> None:
    steering, _ = decided(
        "drive with steering_fault { stuck: true, while: ego.x > 13m and ego.x < 21m }"
    )
    x = 5.0 + SPEED * TIME
    there = (x > 13.0) & (x < 21.0)
    assert 20 < there.sum() < 30
    np.testing.assert_allclose(steering[there], STEERING[there][0], atol=1e-9)
    np.testing.assert_allclose(steering[~there], STEERING[~there], atol=1e-9)


def test_whoever_is_in_charge_has_the_same_steering() -> None:
    steering, _ = decided(
        "drive with steering_fault { bias: 1deg }\n drive with wave { when: ego.x > 13m }"
    )
    np.testing.assert_allclose(steering, STEERING + math.radians(1.0), atol=1e-9)


def test_of_two_faults_the_second_gets_what_the_first_does() -> None:
    steering, _ = decided(
        "drive with steering_fault { bias: 1deg }\n drive with steering_fault { gain: 2 }"
    )
    np.testing.assert_allclose(steering, 2.0 * (STEERING + math.radians(1.0)), atol=1e-9)


def test_a_scene_is_the_same_alone_and_among_others() -> None:
    fault = "drive with steering_fault { noise: 0.5deg, bias: -2deg..2deg, delay: 0s..0.3s }"
    scenes = testing.sample(
        f"{ROAD}agent ego is car on main at 5m {{ drive with wave\n{fault} }}", 3, kinds=[Wave]
    )
    together = [drive.trace.agents["ego"].y for drive in scenes.run("builtin", duration=2.0)]
    for scene, path in zip(scenes, together, strict=True):
        alone = scene.run("builtin", duration=2.0).trace.agents["ego"].y
        np.testing.assert_array_equal(alone, path)
    assert not np.array_equal(together[1], together[2])
