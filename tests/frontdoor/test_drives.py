"""Drives for Python users: traces as columns, and how the expectations came out over several."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DriveSet, stl, testing
from roadlang.api import Controller, DriveSignal, Scene, Simulator, Trace

TIME = np.linspace(0.0, 2.0, 21)
TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
agent ego is car on main at 5m..10m { drive with lane_follow { speed: 10m/s } }
expect slow: always (ego.speed < 12m/s)
expect central: always (abs(ego.cross_track_error) < 1m)
simulate with sled
"""


@dataclass(frozen=True)
class Sled(Simulator):
    """Slides along at a speed that rises with the scene; knows nothing of lanes."""

    name: ClassVar[str] = "sled"

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        speed = 10.0 + scene.index
        return testing.trace(
            testing.agent_trace(
                "ego", time=TIME, x=speed * TIME, y=0.0, heading=0.0, speed=speed, station=0.0
            )
        )


@dataclass(frozen=True)
class Two(Simulator):
    """Two that stand still, apart."""

    name: ClassVar[str] = "two"

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        still: dict[str, Any] = {"time": TIME, "y": 0.0, "heading": 0.0, "speed": 0.0}
        return testing.trace(
            testing.agent_trace("ego", x=0.0, station=0.0, **still),
            testing.agent_trace("late", x=90.0, station=90.0, **still),
        )


def drives(text: str = TEXT, n: int = 4) -> DriveSet:
    return testing.sample(text, n, kinds=[Sled]).run()


def test_a_drive_is_columns_of_which_what_is_not_recorded_is_nan() -> None:
    (drive,) = drives(n=1)
    columns = drive.to_dict()
    assert drive.duration == 2.0
    np.testing.assert_array_equal(columns["ego.x"], 10.0 * TIME)
    assert np.isnan(columns["ego.steering"]).all()
    assert len(drive.to_csv().splitlines()) == 1 + len(TIME)


def test_what_cannot_be_evaluated_is_not_satisfied() -> None:
    (drive,) = drives(n=1)
    assert drive.verdicts["slow"].satisfied is True
    assert drive.verdicts["central"].satisfied is None
    assert not drive.satisfied
    (found,) = drive.diagnostics
    assert found.code == "RL701"
    assert found.help[-1] == "this is the expectation `central` in scene 0"
    assert found.span is not None
    assert found.span.line == 5


def test_traces_describe_themselves_in_a_line_and_notebooks_show_the_path() -> None:
    drive = drives(n=1)[0]
    assert repr(drive.trace).startswith("<trace of ego")
    assert repr(drive.trace.agents["ego"]) == f"<trace of ego: {len(drive.trace.time)} samples>"
    assert drive._repr_svg_() == drive.svg()


def test_a_formula_is_evaluated_on_the_columns_of_a_drive() -> None:
    drive = drives(n=1)[0]
    columns = drive.to_dict()
    formula = stl.parse("always (ego.speed < 12m/s)")
    assert formula.rho(columns["time"], columns) == drive.verdicts["slow"].robustness == 2.0


def test_the_worst_and_the_violating_of_several_drives_are_told() -> None:
    found = drives(TEXT.replace("expect central", "# expect central"))
    assert [drive.satisfied for drive in found] == [True, True, False, False]
    assert not found.satisfied
    (slow,) = found.expectations
    assert (slow.judged, slow.violated) == ((0, 1, 2, 3), (2, 3))
    assert slow.worst == pytest.approx(-1.0)


def test_a_table_of_drives_has_draws_and_robustness() -> None:
    table: dict[str, list[Any]] = drives().to_dict()
    assert table["scene"] == [0, 1, 2, 3]
    assert table["slow"] == pytest.approx([2.0, 1.0, 0.0, -1.0])
    assert table["slow satisfied"] == [True, True, False, False]
    assert table["central"] == [None] * 4
    assert len(set(table["ego/at"])) == 4


def test_drives_and_scenes_are_data_frames() -> None:
    pytest.importorskip("pandas")
    scenes = testing.sample(TEXT, 4, kinds=[Sled])
    found = scenes.run()
    frame = found.to_frame()
    assert list(frame.index) == list(scenes.to_frame().index) == [0, 1, 2, 3]
    assert frame["slow"].tolist() == pytest.approx([2.0, 1.0, 0.0, -1.0])
    assert frame.index.name == "scene"
    assert found[0].to_frame()["ego.x"].loc[2.0] == pytest.approx(20.0)


def test_what_becomes_a_data_frame_is_the_table_with_its_index(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Seen by a stand-in: pandas is no dependency of ours, and few machines of tests have it."""
    made: list[tuple[dict[str, Any], str]] = []

    def frame(columns: dict[str, Any]) -> Any:
        return SimpleNamespace(set_index=lambda index: made.append((columns, index)))

    monkeypatch.setitem(sys.modules, "pandas", SimpleNamespace(DataFrame=frame))
    scenes = testing.sample(TEXT, 2, kinds=[Sled])
    found = scenes.run()
    for table in (scenes, found, found[0]):
        table.to_frame()
    (of_scenes, _), (of_drives, _), (of_one, _) = made
    assert [index for _, index in made] == ["scene", "scene", "time"]
    assert of_scenes == scenes.to_dict()
    assert of_drives == found.to_dict()
    assert of_one["ego.x"][-1] == pytest.approx(20.0)


@dataclass(frozen=True)
class Words(DriveSignal):
    """Says how it goes."""

    name: ClassVar[str] = "words"
    member: ClassVar[bool] = False

    def values(self) -> Any:
        return np.array(["well"] * len(TIME))


def test_a_drive_signal_that_gives_no_numbers_is_at_fault() -> None:
    text = TEXT.replace("expect central", "expect talks: always (words() < 1)\nexpect central")
    (drive,) = testing.sample(text, kinds=[Sled, Words]).run()
    assert drive.verdicts["talks"].satisfied is None
    (found,) = [one for one in drive.diagnostics if "`talks`" in one.help[-1]]
    assert found.code == "RL474"
    assert "gave values as text, not as real numbers" in found.message


def test_a_figure_is_called_after_the_worst_expectation() -> None:
    found = drives(n=4)
    figures = [drive.svg() for drive in found]
    assert "scene 0: slow, robustness 2" in figures[0]
    assert "scene 3: slow, robustness -1" in figures[3]
    plain = drives("\n".join(line for line in TEXT.splitlines() if "expect" not in line), 1)
    (figure,) = [drive.svg() for drive in plain]
    assert "scene 0" in figure
    assert "robustness" not in figure


def test_a_figure_of_a_drive_shows_the_first_of_those_who_decide_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = TEXT.split("expect")[0] + "agent late is car on main at 90m\nsimulate with two\n"
    shown: list[str] = []
    monkeypatch.setattr(
        "roadlang.session.drives.drive_figure", lambda *given: shown.append(given[2])
    )
    for rule in ("", "expect near: always (gap(late, ego) < 1m)\n"):
        (drive,) = testing.sample(text + rule, 1, kinds=[Two]).run()
        drive.svg()
    assert shown == ["ego", "late"]
