"""The lights of a junction: phases one after the other, and again from the first."""

from __future__ import annotations

import pytest

from roadlang.ir.scene_junctions import SceneControl, SignalPhase

PHASES = (SignalPhase((0, 1), 10.0, 3.0, 2.0), SignalPhase((2,), 5.0, 3.0, 1.0))
SIGNALS = SceneControl("signals", phases=PHASES)


def test_a_cycle_is_all_of_its_phases() -> None:
    assert SIGNALS.changes == ((0.0, 10.0, 13.0, 15.0), (15.0, 20.0, 23.0, 24.0))
    assert SIGNALS.cycle == 24.0
    assert SceneControl("signals").cycle == 0.0
    assert SceneControl("signals").changes == ()


@pytest.mark.parametrize("lap", [0.0, 24.0, 48.0])
@pytest.mark.parametrize("offset", [0.0, 7.0])
@pytest.mark.parametrize(
    ("time", "first", "second"),
    [
        (0.0, "green", "red"), (9.9, "green", "red"), (10.0, "yellow", "red"),
        (12.9, "yellow", "red"), (13.0, "red", "red"), (14.9, "red", "red"),
        (15.0, "red", "green"), (20.0, "red", "yellow"), (23.0, "red", "red"),
    ],
)  # fmt: skip
def test_green_then_yellow_then_red(
    time: float, first: str, second: str, lap: float, offset: float
) -> None:
    control = SceneControl("signals", phases=PHASES, offset=offset)
    now = time + lap - offset
    assert [control.light(connection, now) for connection in (0, 1, 2)] == [first, first, second]
    assert control.light(7, now) == "red"


def test_without_phases_nobody_has_green() -> None:
    assert SceneControl("signals").light(0, 3.0) == "red"
