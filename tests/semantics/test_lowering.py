"""What a scene file becomes: the scenario that the pipeline evaluates."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.ir.scenario import Scenario
from roadlang.ir.values import (
    Condition,
    ConstantValue,
    Items,
    Measure,
    Operation,
    PassCall,
    RandomValue,
    Reference,
    TextValue,
)
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

MAIN = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
BENT = MAIN + "road bent from main { perturb with sine { amplitude: 0m..8m, wavelength: 90m } }\n"


def lowered(text: str) -> Scenario:
    scenario, found = check_text(text, Path("scene.rl"), {}, load_registry())
    assert scenario is not None, [diagnostic.message for diagnostic in found]
    return scenario


def test_a_draw_is_keyed_by_its_place() -> None:
    [_, bent] = lowered(BENT).roads
    amplitude = bent.passes[0].option("amplitude")
    assert isinstance(amplitude, RandomValue)
    assert amplitude.place == "bent/perturb 1/amplitude"
    assert amplitude.per == "scene"
    assert amplitude.call.kind == "standard.uniform"
    assert [value.value for value in amplitude.call.options.values()] == [0.0, 8.0]  # type: ignore[union-attr]


def test_two_draws_in_one_option_have_places_of_their_own() -> None:
    scenario = lowered("param reach = (1m..2m) + (3m..4m)")
    value = scenario.values[0].value
    assert isinstance(value, Operation)
    assert [part.place for part in value.operands] == ["reach", "reach#2"]  # type: ignore[union-attr]


def test_another_statement_moves_no_draw() -> None:
    before = lowered(BENT).roads[1].passes
    after = lowered("param first = 1m..2m\n" + BENT + "agent ego is car on bent at 0%..9%\n")
    places = [call.option("amplitude").place for call in (before[0], after.roads[1].passes[0])]  # type: ignore[union-attr]
    assert places[0] == places[1]


def test_a_name_is_one_draw_and_fresh_draws_anew() -> None:
    scenario = lowered(
        MAIN
        + "param amplitude = 0m..8m\n"
        + "road left from main { perturb with sine { amplitude: amplitude, wavelength: 90m } }\n"
        + "road right from main {"
        + " perturb with sine { amplitude: fresh(amplitude), wavelength: 90m } }\n"
    )
    values = {road.name: road.passes[0].option("amplitude") for road in scenario.roads[1:]}
    assert values["left"] == Reference("amplitude")
    right = values["right"]
    assert isinstance(right, RandomValue)
    assert right.place == "right/perturb 1/amplitude"


def test_fresh_draws_what_a_name_depends_on_anew_as_well() -> None:
    scenario = lowered("param base = 0m..8m\nparam twice = 2 * base\nparam other = fresh(twice)\n")
    [other] = [named.value for named in scenario.values if named.name == "other"]
    assert isinstance(other, Operation)
    assert other.operands[0] == ConstantValue(2.0)
    draw = other.operands[1]
    assert isinstance(draw, RandomValue)
    assert draw.place == "other"


@pytest.mark.parametrize(
    ("text", "per"),
    [
        ("object trees is tree on main at 0%..100% { count: 9 }", "copy"),
        ("object tree_ is tree on main at 0%..100%", "scene"),
    ],
)
def test_a_draw_in_place_is_made_for_each_copy(text: str, per: str) -> None:
    [thing] = lowered(MAIN + text).objects
    assert isinstance(thing.at, RandomValue)
    assert thing.at.per == per
    assert thing.at_fraction


def test_a_draw_in_place_is_made_for_each_road_of_a_network() -> None:
    scenario = lowered(
        'image plan from """\n  ..#..\n  #####\n""" { scale: 8m/px, legend: { "#": road } }\n'
        "param amount = 1m..2m\n"
        "network town from plan\n"
        "network bent from town {\n"
        "  perturb with random_walk { amplitude: amount, correlation: 20m..60m }\n"
        "}\n"
    )
    town, bent = scenario.networks
    assert [call.kind for call in town.passes] == ["standard.auto"]
    amount, correlation = (bent.passes[0].option(name) for name in ("amplitude", "correlation"))
    assert amount == Reference("amount")
    assert isinstance(correlation, RandomValue)
    assert correlation.per == "road"


def test_values_come_before_what_depends_on_them() -> None:
    scenario = lowered(
        "agent second is car on bent at first.start + 9m\nagent first is car on bent at half\n"
        + "road bent from main\nlet half = length(main) / 2\n"
        + MAIN
    )
    assert [agent.name for agent in scenario.agents] == ["first", "second"]
    assert [road.name for road in scenario.roads] == ["main", "bent"]


def test_each_requirement_comes_once_in_the_order_of_the_file() -> None:
    text = MAIN + (
        "expect second: always (time >= 0s)\n"
        "require b: length(main) > 1m\nrequire a: length(main) > 2m\n"
        "expect first: always (time >= 0s)\nemit json\nemit svg\n"
    )
    scenario = lowered(text)
    assert [item.name for item in scenario.requirements] == ["b", "a"]
    assert [item.name for item in scenario.expectations] == ["second", "first"]
    assert [call.kind for call in scenario.emits] == ["standard.json", "standard.svg"]


def test_signals_are_variables_named_as_in_the_file() -> None:
    scenario = lowered(
        BENT
        + "let e1 = deviation(bent, main)\n"
        + "require phi: always (e1 < 10m and abs(curvature(bent)) < 0.1/m)\n"
    )
    condition = scenario.requirements[0].test
    assert isinstance(condition, Condition)
    assert condition.domain == "road"
    assert {signal.variable for signal in condition.signals} == {"e1", "curvature(bent)"}
    assert condition.formula.variables == {"e1", "curvature(bent)"}
    assert str(condition.formula) == "always (e1 < 10 and abs(curvature(bent)) < 0.1)"
    assert condition.text == "always (e1 < 10m and abs(curvature(bent)) < 0.1/m)"


def test_numbers_of_the_scene_are_variables_and_constants_are_not() -> None:
    scenario = lowered(
        BENT
        + "param fixed = 3m\nparam drawn = 1m..2m\n"
        + "agent ego is car on bent at 5m\n"
        + "require room: length(bent) - ego.start > drawn + fixed\n"
    )
    condition = scenario.requirements[0].test
    assert isinstance(condition, Condition)
    assert condition.domain == "scene"
    numbers = {number.variable: number.value for number in condition.numbers}
    assert numbers.keys() == {"length(bent)", "ego.start", "drawn"}
    assert numbers["drawn"] == Reference("drawn")
    assert isinstance(numbers["ego.start"], Measure)


def test_options_of_the_kind_go_to_each_kind_that_may_be_chosen() -> None:
    scenario = lowered(
        MAIN + "agent a is choice(car, truck, weights: [3, 1]) on main at 5m { mass: 2t }\n"
    )
    kind = scenario.agents[0].kind
    assert isinstance(kind, RandomValue)
    items = kind.call.option("items")
    assert isinstance(items, Items)
    calls = [item for item in items.items if isinstance(item, PassCall)]
    assert [call.kind for call in calls] == ["standard.car", "standard.truck"]
    assert all(call.option("mass") == items_mass for call, items_mass in zip(
        calls, [calls[0].option("mass")] * 2, strict=True))  # fmt: skip


def test_what_goes_without_saying_is_said() -> None:
    scenario = lowered("sample\n" + MAIN)
    assert scenario.sample is not None
    assert scenario.sample.kind == "standard.random"


def test_words_are_text_and_strings_do_as_well() -> None:
    assert dict(lowered("world { weather: rain }").world) == {"weather": TextValue("rain")}
    assert dict(lowered('world { weather: "rain" }').world) == {"weather": TextValue("rain")}


def test_the_header_is_that_of_the_including_file(tmp_path: Path) -> None:
    (tmp_path / "base.rl").write_text('scenario base "below"\n' + MAIN)
    text = 'include "base.rl"\nscenario mine "above"\n'
    scenario, _ = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert scenario is not None
    assert (scenario.header.name, scenario.header.title) == ("mine", "above")
    without, _ = check_text('include "base.rl"\n', tmp_path / "scene.rl", {}, load_registry())
    assert without is not None
    assert without.header.name == "base"
