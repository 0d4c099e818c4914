"""From a scene to what is sent: which roads are built, where agents drive, what they obey."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Scene, lane_guide
from roadlang_godot.build.agent_specs import MOST_OFFSETS
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.sky import sun_at, world_settings
from roadlang_godot.build.surface_table import surface_number, surface_table
from roadlang_godot.drive.simulate import Settings
from roadlang_godot.engines.engine import project
from roadlang_godot.faults import EngineError
from roadlang_godot.net.protocol import Message
from tests.godot.godot_scenes import bends, call, car, pieces, road, scene, straight, thing, town


def agent_spec(made: Scene, name: str) -> dict[str, Any]:
    layout = layout_of(made)
    body = next(t.body for t in layout.parts if t.key == (Message.AGENT, layout.agents[name]))
    return dict(json.loads(body))


def labels(made: Scene, kind: Message) -> list[str]:
    return [one.label for one in layout_of(made).parts if one.kind == kind]


def test_a_scene_without_roads_has_nothing_to_build() -> None:
    with pytest.raises(EngineError, match="RL509"):
        layout_of(scene())


def test_only_the_last_road_of_a_chain_is_built() -> None:
    main = road("main", pieces(straight(50)), derived=False)
    bent = road("bent", pieces(straight(50), start=(0.0, 3.0)))
    assert {label.split()[0] for label in labels(scene(main, bent), Message.SEGMENT)} == {"bent"}


def test_a_route_through_a_town_is_a_path_on_its_roads_and_no_second_road() -> None:
    roads, network = town()
    points = np.vstack([pieces(straight(119.5))[:-1], [[120.0, 0.0]]])
    tour = road("tour", points)
    made = scene(*roads, tour, networks=[network], agents=[car("ego", tour, 5.0)])
    assert not any("tour" in label for label in labels(made, Message.SEGMENT))
    assert labels(made, Message.PATH)[0].startswith("path of tour")


def test_the_origin_is_in_the_middle_of_the_scene() -> None:
    far = road("far", pieces(straight(100), start=(4e5, 5e6)))
    layout = layout_of(scene(far))
    assert (layout.frame.x, layout.frame.y) == (400050.0, 5000000.0)


def test_agents_follow_the_middle_of_their_lane() -> None:
    main = road("main", pieces(straight(80)))
    right = car("right", main, 5.0, lane=-1, offset=-1.75)
    left = car("left", main, 50.0, lane=1, offset=1.75, facing="back")
    made = scene(main, agents=[right, left])
    assert agent_spec(made, "right")["offset"] == pytest.approx(-1.75)
    assert agent_spec(made, "left")["offset"] == pytest.approx(1.75)
    assert agent_spec(made, "left")["direction"] == -1


def test_the_lines_of_long_lanes_that_change_their_width_fit_into_a_datagram() -> None:
    """24 tapers of 30 m, in one road of 9.6 km: each is still there."""
    text = "".join(
        f"road r{i} {{ draw with segments {{ pieces: [straight(400m)] }}, "
        f"left: [drive({width}m)], right: [drive({width}m)] }}\n"
        for i, width in enumerate([3.5, 2.75] * 12)
    )
    parts = ", ".join(f"r{i}" for i in range(1, 24))
    text += f"road street from r0 {{ then: [{parts}], taper: 30m }}\n"
    text += "agent ego is car on street at 20m { drive with lane_follow }"
    (made,) = testing.sample(text, 1)
    sent = np.array(agent_spec(made.record, "ego")["offsets"])
    road = next(road for road in made.record.roads if road.name == "street")
    guide = lane_guide(road, -1)
    assert guide is not None
    assert len(guide[0]) > MOST_OFFSETS >= len(sent)
    assert (np.diff(sent[:, 0]) > 0.0).all()
    stations = np.linspace(0.0, road.length, 20_000)
    assert np.abs(np.interp(stations, *sent.T) - np.interp(stations, *guide)).max() < 0.03


def test_a_condition_becomes_the_nested_lists_of_the_engine() -> None:
    main = bends()
    when = {
        "formula": {"once": {"<": ["d", 15.0]}, "interval": [0, 2]},
        "signals": {
            "d": {"kind": "roadlang.distance", "options": {"first": "ego", "second": "lead"}}
        },
    }
    ego = car("ego", main, 5.0, call("lane_follow", speed=9.0), call("brake", when=when))
    made = scene(main, agents=[ego, car("lead", main, 40.0)])
    drives = agent_spec(made, "ego")["drives"]
    assert drives[0] == {"kind": "lane_follow", "speed": 9.0}
    assert drives[1]["when"] == ["any", 0.0, 2.0, ["<", ["distance", "ego", "lead"], 15.0]]


def test_an_object_in_a_condition_is_told_by_its_outline() -> None:
    main = bends()
    when = {
        "formula": {"<": ["d", 5.0]},
        "signals": {"d": {"kind": "distance", "options": {"first": "van", "second": "ego"}}},
    }
    ego = car("ego", main, 5.0, call("brake", when=when))
    van = thing("parked_van", 50.0, 3.0, name="van")
    made = scene(main, agents=[ego], objects=[replace(van, length=6.0, width=2.0)])
    frame = layout_of(made).frame
    tree = agent_spec(made, "ego")["drives"][0]["when"]
    assert tree[1] == ["distance", "ego", 50.0 - frame.x, 3.0 - frame.y, 0.0, 6.0, 2.0]


def test_an_agent_with_a_condition_that_the_engine_cannot_evaluate_is_left_to_python() -> None:
    main = bends()
    signals = {"d": {"kind": "lane_offset", "options": {"agent": "ego"}}}
    when = {"formula": {"<": ["d", 5.0]}, "signals": signals}
    made = scene(main, agents=[car("ego", main, 5.0, call("brake", when=when))])
    assert layout_of(made).undriven == ("ego",)
    assert agent_spec(made, "ego")["drives"] == []
    assert layout_of(made, python_driven=["ego"]).undriven == ()


def test_the_sun_is_in_the_south_at_noon_and_in_the_east_at_six() -> None:
    assert sun_at(12.0)["sun_azimuth"] == pytest.approx(-math.pi / 2)
    assert sun_at(6.0) == pytest.approx({"sun_elevation": 0.0, "sun_azimuth": 0.0})
    assert sun_at(0.0)["sun_elevation"] < 0


def test_rain_is_measured_in_millimeters_an_hour() -> None:
    drizzle, downpour = (world_settings({"rain": mm / 3.6e6})["rain"] for mm in (1, 40))
    assert 0.05 < drizzle < 0.2
    assert downpour > 0.95
    assert world_settings({})["rain"] == 0


def test_a_sun_that_is_given_stands_where_it_is_put() -> None:
    settings = world_settings({"time_of_day": 12 * 3600.0, "sun": {"azimuth": 0.5}})
    assert settings["sun_azimuth"] == 0.5
    assert settings["sun_elevation"] == sun_at(12.0)["sun_elevation"]


def test_what_a_scene_says_goes_before_what_its_weather_implies() -> None:
    assert surface_table({"weather": "rain"})[0] < surface_table({})[0]
    assert surface_table({"weather": "rain", "friction": 0.5})[0] == (0.5, 0.0)


def test_the_ground_of_the_engine_is_grass() -> None:
    ground = (project() / "build" / "ground.gd").read_text(encoding="utf-8")
    assert f"const TURF := {surface_number('turf')}\n" in ground


@pytest.mark.parametrize(
    ("step", "every", "rate"),
    [(0.02, 2, 100), (1 / 60, 1, 60), (0.01, 1, 100), (0.1, 6, 60), (1.0, 60, 60)],
)
def test_physics_has_at_least_sixty_ticks_a_second(step: float, every: int, rate: int) -> None:
    """As many between two records as it takes, so that each record falls on a tick."""
    settings = Settings(duration=10, step=step)
    assert (settings.every, settings.rate, settings.ticks) == (every, rate, 10 * rate)
