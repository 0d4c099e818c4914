"""Drives whose steps are written down once and repeated in a compiled loop: the same bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import ControlBatch, Controller, ObservationBatch
from roadlang.diagnostics import DiagnosticError
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.simulation import simulating
from roadlang.simulation.tapes.repeating import Repetition
from roadlang.simulation.vehicles import compiled

from .test_same_bytes import LOOP, bytes_of, drives, records

pytest.importorskip("numba")

BENT = """
road base {
  draw with segments { pieces: [straight(40m), arc(40m, 80deg), straight(40m)] }
  width: 8m, lanes: 2
}
road bent from base { perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m } }
agent ego is car on bent at 5m..20m { lane: -1, drive with DRIVER }
world { friction: 0.2..0.9 }
expect kept: always (abs(ego.cross_track_error) < 1m)
"""
STANLEY = BENT.replace("DRIVER", "stanley { speed: (9m/s)..(22m/s) }")
PURSUIT = BENT.replace("DRIVER", "pure_pursuit { speed: (9m/s)..(22m/s) }")
ON_A_LOOP = LOOP.replace("lane_follow", "pure_pursuit")


@pytest.fixture
def went(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether each attempt to repeat steps went on. numba counts as loaded."""
    found: list[bool] = []
    original = Repetition.drive

    def drive(self: Repetition, *arguments: Any) -> bool:
        found.append(original(self, *arguments))
        return found[-1]

    monkeypatch.setattr(Repetition, "drive", drive)
    monkeypatch.setattr(compiled, "LOADING", 0.0)
    return found


def without_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "is_installed", lambda: False)
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)


@pytest.mark.parametrize(
    ("text", "options"),
    [
        (STANLEY, {"control_step": 0.04}),
        (STANLEY, {"control_step": 0.1, "after_violation": 1.0}),
        (STANLEY, {"control_step": 0.3, "step": 0.1}),
        (PURSUIT, {"control_step": 0.04}),
        (ON_A_LOOP, {"control_step": 0.04}),
    ],
    ids=["stanley", "ends_early", "seldom", "pursuit", "loop"],
)
def test_repeated_steps_are_the_same_alone_together_and_without_numba(
    text: str, options: dict[str, Any], went: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes = records(text, 5)
    together = [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)]
    assert any(went), "steps were repeated"
    (alone,) = drives(scenes[3:4], duration=20.0, **options)
    assert bytes_of(alone) == together[3]
    without_numba(monkeypatch)
    assert [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)] == together


@dataclass(frozen=True)
class Weaving(Controller):
    """A stranger's: steers by its place."""

    name: ClassVar[str] = "weaving"
    is_elementwise: ClassVar[bool] = True
    looks: bool = False
    """at the speeds, to decide how to steer"""
    opens: bool = False
    """the acceleration, after 40 m; else it is infinite there"""

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        seen = observations
        steering = 0.02 * np.sin(0.1 * seen.x) - 0.05 * np.tanh(seen.cross_track_error)
        if self.looks and np.count_nonzero(seen.speed > 3.0):
            steering = 0.0 * seen.x
        left = 40.0 - seen.traveled
        end = np.log(left) if self.opens else 40.0 / np.maximum(left, 0.0)
        return ControlBatch(steering, end)


def weave(options: str, count: int = 3, **more: Any) -> list[dict[str, bytes]]:
    text = BENT.replace("DRIVER", f"weaving {{ {options} }}")
    sampled = testing.scenario(text, kinds=[Weaving])
    scenes = [scene.record for scene in sampled.sample(count)]
    controllers = [python_controllers(scene, sampled.registry) for scene in scenes]
    _, simulator = simulator_of(scenes[0], sampled.registry, "builtin", {"duration": 8.0, **more})
    return [bytes_of(trace) for trace in simulator.drive_all(scenes, controllers)]


def test_a_kind_of_a_plugin_is_repeated_too(
    went: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    with np.errstate(invalid="ignore", divide="ignore"):
        fast = weave("opens: true", duration=30.0)
        assert any(went)
        assert not all(went), "what is left open is decided at every step"
        without_numba(monkeypatch)
        assert weave("opens: true", duration=30.0) == fast


def test_one_that_looks_at_numbers_is_called_at_every_step(
    went: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    called = weave("looks: true", duration=5.0)
    assert not went
    without_numba(monkeypatch)
    assert weave("looks: true", duration=5.0) == called


def test_a_number_that_becomes_infinite_is_reported_as_at_every_step(
    went: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    with np.errstate(invalid="ignore", divide="ignore"):
        with pytest.raises(DiagnosticError) as fast:
            weave("", duration=40.0)
        assert any(went)
        without_numba(monkeypatch)
        with pytest.raises(DiagnosticError) as plain:
            weave("", duration=40.0)
    assert str(fast.value) == str(plain.value)


def test_agents_that_meet_are_not_repeated(went: list[bool]) -> None:
    other = "agent other is car on bent at 60m { lane: -1, drive with stanley { speed: 5m/s } }"
    drives(records(STANLEY + other, 1), duration=4.0)
    assert not went


def test_the_loop_goes_on_where_the_samples_do_not_fall_together(went: list[bool]) -> None:
    """A period longer than the drive."""
    drives(records(STANLEY, 1), duration=0.15, control_step=0.04)
    assert simulating.EngineSettings(duration=0.15).ticks(0.15) < 10
    assert went
    assert not any(went)
