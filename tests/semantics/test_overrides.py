"""What an override changes of a declaration, and what it leaves."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from roadlang.ir.scenario import Scenario
from roadlang.ir.values import ConstantValue, TextValue, Value
from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text

STREET = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] }
  perturb with sine { amplitude: 1m, wavelength: 60m }
  perturb with sine { amplitude: 2m, wavelength: 90m }
  lanes: 2, width: 7m
}
agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s }, lane: -1 }
"""


def scenario_of(text: str, folder: Path, registry: Registry) -> Scenario:
    (folder / "street.rl").write_text(STREET)
    scenario, found = check_text(text, folder / "scene.rl", {}, registry)
    assert scenario is not None, found
    return scenario


def kinds(scenario: Scenario, name: str = "main") -> list[str]:
    (road,) = (road for road in scenario.roads if road.name == name)
    return [f"{call.verb} {call.kind}".replace("standard.", "") for call in road.passes]


def agent(scenario: Scenario) -> tuple[Mapping[str, Value], str, Mapping[str, Value]]:
    """The options of the only agent, the kind that drives it and the options of that kind."""
    (actor,) = scenario.agents
    (call,) = actor.drive
    return actor.options, call.kind, call.options


def test_an_override_equals_the_declaration_written_so(tmp_path: Path, registry: Registry) -> None:
    override = "override ego { lane: 1, drive with stanley { speed: 9m/s } }"
    after = scenario_of(f'include "street.rl"\n{override}\n', tmp_path, registry)
    written = STREET.replace("lane: -1", "lane: 1").replace(
        "pure_pursuit { speed: 8m/s }", "stanley { speed: 9m/s }"
    )
    same, _ = check_text(written, tmp_path / "scene.rl", {}, registry)
    before = scenario_of('include "street.rl"\n', tmp_path, registry)
    assert same is not None
    assert agent(after) == agent(same)
    assert agent(after) != agent(before)
    assert after.roads == before.roads


def test_passes_replace_all_of_their_verb_where_these_stood(
    tmp_path: Path, registry: Registry
) -> None:
    text = 'include "street.rl"\noverride main {{ {} }}\n'
    bent = "perturb with sine { amplitude: 3m, wavelength: 80m }"
    straight = "draw with waypoints { points: [(0m, 0m), (90m, 0m)] }"
    before = kinds(scenario_of('include "street.rl"\n', tmp_path, registry))
    assert kinds(scenario_of(text.format(bent), tmp_path, registry)) == before[:2]
    assert kinds(scenario_of(text.format(straight), tmp_path, registry)) == before


def test_only_the_named_inclusion_is_overridden(tmp_path: Path, registry: Registry) -> None:
    text = (
        'include "street.rl" as left\ninclude "street.rl" as right\n'
        "override left.main { perturb with sine { amplitude: 3m, wavelength: 80m } }\n"
    )
    scenario = scenario_of(text, tmp_path, registry)
    assert len(kinds(scenario, "left.main")) == 2
    assert len(kinds(scenario, "right.main")) == 3


def test_the_outermost_file_wins(tmp_path: Path, registry: Registry) -> None:
    inner = 'include "street.rl"\noverride ego { lane: 1, drive with stanley { speed: 5m/s } }\n'
    (tmp_path / "inner.rl").write_text(inner)
    outer = "override town.ego { drive with stanley { speed: 9m/s } }\n"
    text = f'{outer}include "inner.rl" as town\n'
    both = "override town.ego { lane: 1, drive with stanley { speed: 9m/s } }\n"
    direct = f'include "street.rl" as town\n{both}'
    expected = agent(scenario_of(direct, tmp_path, registry))
    assert agent(scenario_of(text, tmp_path, registry)) == expected


def test_a_path_in_an_override_is_relative_to_the_file_that_overrides(
    tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "street.rl").write_text(STREET)
    (tmp_path / "policy.onnx").write_text("a network")
    text = 'include "parts/street.rl"\noverride ego { drive with onnx { model: "policy.onnx" } }\n'
    scenario = scenario_of(text, tmp_path, registry)
    (call,) = scenario.agents[0].drive
    assert call.options["model"] == TextValue(str(tmp_path / "policy.onnx"))


def test_a_sensor_is_replaced_by_name_and_others_are_added(
    tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "seeing.rl").write_text(
        STREET.replace("lane: -1", "sense with gps, sense with ranges as front { rays: 9 }")
    )
    text = """
    include "seeing.rl"
    override ego { sense with ranges as front { rays: 3 }, sense with gps as second }
    """
    scenario, found = check_text(text, tmp_path / "scene.rl", {}, registry)
    assert scenario is not None, found
    (actor,) = scenario.agents
    assert [sensor.name for sensor in actor.sensors] == ["gps", "front", "second"]
    assert actor.sensors[1].call.options["rays"] == ConstantValue(3.0)
    assert len(actor.drive) == 1
