"""What monitors and drive signals of plugins give for a drive is checked, and told of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    AgentName,
    AgentTrace,
    Code,
    Diagnostic,
    DiagnosticError,
    DriveSignal,
    Kind,
    Monitor,
    Simulator,
    Trace,
    option,
)
from tests.straight_road import STRAIGHT

SCENE = STRAIGHT + (
    "agent ego is car on main at 10m { drive with brake }\n"
    "expect good with odd { agent: ego }\n"
)  # fmt: skip
MEASURED = SCENE.replace("expect good with odd { agent: ego }", "expect good: always (ego.odd < 1)")


def monitor(gives: Any) -> type[Monitor]:
    @dataclass(frozen=True)
    class Odd(Monitor):
        """Judges as it is told to."""

        name: ClassVar[str] = "odd"
        domain: ClassVar[str] = "drive"
        agent: AgentName = option(help="the agent")

        def judge(self, trace: Trace) -> Any:
            return gives

    return Odd


def signal(column: str, factor: Any) -> type[DriveSignal]:
    @dataclass(frozen=True)
    class Odd(DriveSignal):
        """A column of the agent's trace, times a factor."""

        name: ClassVar[str] = "odd"
        agent: AgentName = option(help="the agent")

        def values(self) -> Any:
            assert isinstance(self.agent, AgentTrace)
            return factor * getattr(self.agent, column)

    return Odd


@dataclass(frozen=True)
class Parked(Simulator):
    """Nothing moves, and steering is not recorded."""

    name: ClassVar[str] = "parked"

    def drive(self, scene: Any, controllers: Any) -> Trace:
        time = np.linspace(0.0, 1.0, 11)
        still, unknown = np.zeros(11), np.full(11, np.nan)
        (actor,) = scene.agents
        names = "x y heading speed acceleration station cross_track_error progress contacts"
        columns = dict.fromkeys(names.split(), still) | {"steering": unknown}
        ego = AgentTrace(actor.name, time, **columns)
        return Trace(time, {actor.name: ego}, "parked")


def faults(text: str, *kinds: type[Kind]) -> tuple[Diagnostic, ...]:
    (scene,) = testing.sample(text, 1, kinds=[Parked, *kinds])
    return scene.run("parked").diagnostics


@pytest.mark.parametrize(
    ("gives", "says"),
    [
        (None, "gave robustness as None, not as real numbers"),
        ("fine", "gave robustness as text, not as real numbers"),
        (2j, "gave robustness as complex numbers, not as real numbers"),
        (object(), "gave robustness as objects of type object, not as real numbers"),
        (np.zeros(3), "gave a robustness of shape (3,), not one number"),
        ([], "gave a robustness of shape (0,), not one number"),
        (float("nan"), "gave a robustness that is not a number"),
        (False, "gave robustness as True or False, not as a number"),
    ],
)
def test_a_monitor_of_drives_that_gives_no_number(gives: Any, says: str) -> None:
    (found,) = faults(SCENE, monitor(gives))
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert f"`monitor tested.odd` (tested 0) {says}" in found.message
    assert found.span is not None


@pytest.mark.parametrize("gives", [1, np.float32(1.0), np.ones(1), [1.0]])
def test_one_number_of_any_kind_is_a_robustness(gives: Any) -> None:
    (scene,) = testing.sample(SCENE, 1, kinds=[Parked, monitor(gives)])
    assert scene.run("parked").verdicts["good"].robustness == 1.0


def test_true_and_false_of_a_monitor_of_roads_are_no_robustness() -> None:
    @dataclass(frozen=True)
    class Odd(Monitor):
        """Is never satisfied, but says so with a number that is 0."""

        name: ClassVar[str] = "odd"

        def robustness(self) -> Any:
            return np.array([False])

    with pytest.raises(DiagnosticError, match="gave robustness as True or False"):
        testing.sample(STRAIGHT + "require good with odd\n", 1, kinds=[Odd])


def test_a_signal_that_is_not_a_number_by_its_own_doing() -> None:
    (found,) = faults(MEASURED, signal("speed", np.nan))
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert "`drive_signal tested.odd` (tested 0) gave NaN at 0 s" in found.message
    assert found.span is not None


def test_a_signal_of_what_the_engine_does_not_record() -> None:
    (found,) = faults(MEASURED, signal("steering", 1.0))
    assert found.code == Code.SIGNAL_NOT_RECORDED
    assert found.help[0].startswith("the trace has no value of `ego.steering` at some times")
