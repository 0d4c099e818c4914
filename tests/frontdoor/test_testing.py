"""`roadlang.testing`: what authors of plugins try their kinds with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, testing
from roadlang.api import Backend, Length, Perturber, RoadBatch, Scene, option
from roadlang.plugins.discovery import registry_of
from roadlang.session.scene_set import SceneSet

TEXT = """\
road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } }
road moved from main { perturb with sidestep { by: 2m } }
"""


@dataclass(frozen=True)
class Shift(Perturber):
    """Move the road to the left."""

    name: ClassVar[str] = "sidestep"
    is_random: ClassVar[bool] = False
    by: Length = option(help="how far", minimum=0)

    def displacements(self, roads: Any, random: Any) -> Any:
        return np.broadcast_to(self.by, (roads.variants, len(roads.stations)))


def test_a_text_can_name_a_kind_under_test() -> None:
    (scene,) = testing.sample(TEXT, kinds=[Shift])
    np.testing.assert_allclose(scene.roads["moved"].y, 2.0)
    (scene,) = testing.sample(TEXT.replace("with sidestep", "with tested.sidestep"), kinds=[Shift])
    assert scene.provenance.plugins["tested"]


def test_a_seed_gives_draws_of_its_own() -> None:
    text = "param reach = 1m..3m\n" + TEXT

    reach = [
        testing.sample(text, kinds=[Shift], seed=seed)[0].draws["reach"] for seed in (0, 1, 2, 2)
    ]
    assert len(set(reach)) == 3
    assert reach[2] == reach[3]
    assert testing.sample(text, kinds=[Shift])[0].draws["reach"] == reach[0]


def test_its_faults_read_as_a_user_would_see_them() -> None:
    found = testing.check(TEXT.replace("by: 2m", "by: -2m"), kinds=[Shift])
    assert [diagnostic.code for diagnostic in found] == ["RL208"]
    with pytest.raises(DiagnosticError, match=r"RL210(.|\n)*sidestep"):
        testing.sample(TEXT)


@dataclass(frozen=True)
class Table(Backend):
    """Positions every so many meters."""

    name: ClassVar[str] = "table"
    every: Length = option(help="gap between positions", above=0)

    def files(self, scene: Scene) -> dict[str, str]:
        stations = np.arange(0.0, scene.roads[0].length, self.every)
        return {"txt": "\n".join(map(str, stations))}


def test_an_output_with_a_required_option_can_be_named_from_outside(tmp_path: Path) -> None:
    loaded = testing.scenario(TEXT, kinds=[Shift, Table])
    loaded.with_outputs(["table{every: 50m}"]).sample().emit(tmp_path)
    assert (tmp_path / "scene-0000.txt").read_text() == "0.0\n50.0"
    (found,) = loaded.with_outputs(["table"]).check()
    assert found.span is not None
    assert (found.code, found.span.text) == ("RL221", "table")
    assert "`every`: a length; gap between positions" in found.help[0]
    assert "write `--emit 'table{option: value}'`" in found.help[1]
    in_file = loaded.with_text(f"{TEXT}emit table {{ every: 40m }}\n")
    in_file.with_outputs(["table"]).sample().emit(tmp_path)
    assert (tmp_path / "scene-0000.txt").read_text() == "0.0\n40.0\n80.0"


def test_a_kind_that_no_plugin_could_bring_is_refused() -> None:
    class Nameless(Perturber):
        pass

    with pytest.raises(TypeError, match="Nameless"):
        testing.registry_with(Nameless)


@dataclass(frozen=True)
class Sine(Shift):
    """Named as a kind that ships with roadlang."""

    name: ClassVar[str] = "sine"


@dataclass(frozen=True)
class Tilt(Shift):
    """A kind of another plugin alone."""

    name: ClassVar[str] = "tilt"


def test_kinds_under_test_replace_installed_ones_but_none_that_ships(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    installed = {"other": testing.plugin_of(Shift, Sine, Tilt)}
    monkeypatch.setattr(
        testing, "registry_of", lambda tested, **_: registry_of({**installed, **tested})
    )
    registry = testing.registry_with(Shift, Sine)
    found = {
        name: sorted(e.origin.plugin for e in registry.entries if e.name == name)
        for name in ("sidestep", "tilt", "sine")
    }
    assert found == {"sidestep": ["tested"], "tilt": ["other"], "sine": ["standard", "tested"]}


def test_a_road_to_perturb_by_hand() -> None:
    road = testing.road_batch([(0, 0), (100, 0)], variants=3, width=[6.0, 7.0, 8.0])
    assert isinstance(road, RoadBatch)
    assert road.points.shape == (3, len(road.stations), 2)
    np.testing.assert_array_equal(road.width, [[6.0], [7.0], [8.0]])
    moved = Shift(by=1.0).displacements(road, testing.random(3))
    assert moved.shape == (3, len(road.stations))


def test_random_numbers_differ_between_variants_and_repeat() -> None:
    first = testing.random(4, seed=7).uniform(3)
    assert first.shape == (4, 3)
    assert len(np.unique(first)) == 12
    np.testing.assert_array_equal(first, testing.random(4, seed=7).uniform(3))
    assert (first != testing.random(4, seed=8).uniform(3)).all()


def test_the_fixture_finds_files_in_the_folder_of_the_test(
    roadlang_sample: Callable[..., SceneSet], tmp_path: Path
) -> None:
    (tmp_path / "line.csv").write_text("x,y\n0,0\n50,0\n100,0\n")
    (scene,) = roadlang_sample('road main from "line.csv"\n')
    assert scene.roads["main"].length == pytest.approx(100.0)


def test_a_trace_has_what_the_test_states_and_nan_for_the_rest() -> None:
    ego = testing.agent_trace(time=[0, 1, 2], speed=[1, 2, 3], x=5, width=2.0)
    np.testing.assert_array_equal(ego.speed, [1.0, 2.0, 3.0])
    np.testing.assert_array_equal(ego.x, [5.0, 5.0, 5.0])
    assert (ego.width, ego.length) == (2.0, 4.5)
    assert np.isnan(ego.steering).all()
    other = testing.agent_trace("other", time=ego.time)
    assert list(testing.trace(ego, other).agents) == ["ego", "other"]
    with pytest.raises(TypeError, match="sped"):
        testing.agent_trace(time=[0], sped=3)


def test_an_observation_is_of_an_agent_on_a_straight_line_along_x() -> None:
    seen = testing.observation(station=10.0, cross_track_error=1.5, heading_error=0.1)
    assert (seen.x, seen.y, seen.heading, seen.speed) == (10.0, 1.5, 0.1, 0.0)
    assert seen.line_ahead(5.0) == (15.0, 0.0, 0.0, 0.0)


def test_an_observation_that_nothing_is_said_of_is_at_rest_at_the_origin() -> None:
    seen = testing.observation()
    assert (seen.agent, seen.time, seen.step, seen.wheelbase) == ("ego", 0.0, 0.02, 2.7)
    assert (seen.x, seen.y, seen.heading, seen.speed, seen.steering) == (0.0,) * 5
    assert (seen.station, seen.cross_track_error, seen.heading_error) == (0.0,) * 3
    assert testing.observation(x=4.0, station=1.0).x == 4.0


def test_a_road_by_hand_has_a_station_every_meter_and_one_name() -> None:
    road = testing.road_batch([(0, 0), (100, 0)])
    assert (road.variants, road.name) == (1, "road")
    assert np.diff(road.stations) == pytest.approx(1.0, rel=0.05)
    np.testing.assert_array_equal(road.width, [[7.0]])
    ring = testing.road_batch([(0, 0), (50, 50), (0, 100), (-50, 50)], closed=True, name="ring")
    assert (ring.period is not None, ring.name) == (True, "ring")


def test_members_and_times_of_an_agent_are_checked() -> None:
    wrong: dict[str, dict[str, Any]] = {
        "`x` must be a number or of the shape": {"time": [0, 1], "x": [1, 2, 3]},
        "`length` must be a number, not": {"time": [0, 1], "length": [1, 2]},
        "`time` must be finite numbers in ascending order": {"time": [1, 0]},
        "of the shape": {"time": [[0, 1]]},
    }
    for told, members in wrong.items():
        with pytest.raises(ValueError, match=told):
            testing.agent_trace(**members)
    with pytest.raises(TypeError, match="did you mean `speed`"):
        testing.agent_trace(time=[0], sped=3)
    with pytest.raises(TypeError, match="did you mean `speed`"):
        testing.observation(sped=3)


def test_agents_of_a_trace_are_those_of_one_drive() -> None:
    ego = testing.agent_trace(time=[0, 1])
    wrong: list[tuple[type[Exception], str, tuple[Any, ...]]] = [
        (ValueError, "needs an agent", ()),
        (TypeError, "made by `agent_trace`, not 'ego'", ("ego",)),
        (ValueError, "the same `time`", (ego, testing.agent_trace("lead", time=[0, 2]))),
        (ValueError, "names of their own", (ego, ego)),
    ]
    for error, told, agents in wrong:
        with pytest.raises(error, match=told):
            testing.trace(*agents)


def test_there_is_at_least_one_variant() -> None:
    for call in (
        testing.random,
        lambda variants: testing.road_batch([(0, 0), (9, 0)], variants=variants),
    ):
        with pytest.raises(ValueError, match="`variants` must be at least 1, not 0"):
            call(0)


def test_kinds_are_classes_in_a_list() -> None:
    wrong: Any = Shift
    with pytest.raises(TypeError, match="`kinds` must be a list of classes"):
        testing.sample(TEXT, kinds=wrong)
